// SPDX-License-Identifier: Apache-2.0
#include "manipulation/mannequin_own_pairs.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "mannequin/skeleton.h"

namespace hapticell::manipulation {
namespace {

using mannequin::Segment;
using mannequin::Side;

bool is(const std::string& link, Segment segment) {
  return link == mannequin::segmentInfo(segment).name;
}

bool isReaching(const std::string& link, Side side) {
  return is(link, armSegment(side, Segment::kLeftForearm)) || is(link, armSegment(side, Segment::kLeftWrist)) ||
         is(link, armSegment(side, Segment::kLeftHand));
}

/// What a reaching arm of that side is kept out of. Its own hip and leg are not among it: a hanging hand brushes them.
bool isBody(const std::string& link, Side side) {
  constexpr std::array<Segment, 5> kBody{Segment::kLowerBack, Segment::kUpperBack, Segment::kThorax,
                                         Segment::kUpperNeck, Segment::kHead};
  const Side far = mannequin::other(side);
  if (is(link, legSegment(far, Segment::kLeftThigh)) || is(link, legSegment(far, Segment::kLeftShank))) return true;
  return std::any_of(kBody.begin(), kBody.end(), [&](Segment segment) { return is(link, segment); });
}

bool meets(const std::string& reaching, const std::string& other) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    if (!isReaching(reaching, side)) continue;
    const Side far = mannequin::other(side);
    return isBody(other, side) || isReaching(other, far) || is(other, armSegment(far, Segment::kLeftUpperArm));
  }
  return false;
}

}  // namespace

bool isOwnPairOfMannequin(const std::string& first, const std::string& second) {
  return meets(first, second) || meets(second, first);
}

}  // namespace hapticell::manipulation
