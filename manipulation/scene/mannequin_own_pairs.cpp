// SPDX-License-Identifier: Apache-2.0
#include "manipulation/scene/mannequin_own_pairs.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "mannequin/shape/hand_shape.h"
#include "mannequin/body/skeleton.h"

namespace hapticell::manipulation {
namespace {

using mannequin::Segment;
using mannequin::Side;

bool is(const std::string& link, Segment segment) {
  return link == mannequin::segmentInfo(segment).name;
}

bool isFinger(const std::string& link, Side side) {
  for (std::size_t d = 0; d < mannequin::kDigits; ++d) {
    for (std::size_t k = 0; k < mannequin::kPhalanges; ++k) {
      if (link == mannequin::phalanxName(side, static_cast<mannequin::Digit>(d), k)) return true;
    }
  }
  return false;
}

bool isReaching(const std::string& link, Side side) {
  return is(link, armSegment(side, Segment::kLeftForearm)) || is(link, armSegment(side, Segment::kLeftWrist)) ||
         is(link, armSegment(side, Segment::kLeftHand));
}

/// What a reaching arm of that side, and its fingers, are kept out of.
bool isBody(const std::string& link) {
  constexpr std::array<Segment, 6> kBody{Segment::kPelvis, Segment::kLowerBack, Segment::kUpperBack,
                                         Segment::kThorax, Segment::kUpperNeck, Segment::kHead};
  for (const Side side : {Side::kLeft, Side::kRight}) {
    for (const Segment left : {Segment::kLeftThigh, Segment::kLeftShank, Segment::kLeftFoot}) {
      if (is(link, legSegment(side, left))) return true;
    }
  }
  return std::any_of(kBody.begin(), kBody.end(), [&](Segment segment) { return is(link, segment); });
}

bool meets(const std::string& reaching, const std::string& other) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const bool finger = isFinger(reaching, side);
    if (!finger && !isReaching(reaching, side)) continue;
    const Side far = mannequin::other(side);
    return isBody(other) || isReaching(other, far) || is(other, armSegment(far, Segment::kLeftUpperArm)) ||
           (!finger && isFinger(other, far));
  }
  return false;
}

}  // namespace

bool isOwnPairOfMannequin(const std::string& first, const std::string& second) {
  return meets(first, second) || meets(second, first);
}

}  // namespace hapticell::manipulation
