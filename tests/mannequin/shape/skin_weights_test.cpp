// SPDX-License-Identifier: Apache-2.0
#include "mannequin/shape/skin_weights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "tests/mannequin/body/median_man.h"

namespace hapticell::mannequin {
namespace {

class WeighedSkin : public ::testing::Test {
 protected:
  const Figure figure = medianMan();
  const SkinShape shape{figure};
  const SkinWeighing weighing{figure, shape};

  /// A point of a segment's frame, in the bind posture.
  dvec3 point(Segment segment, const dvec3& p_S) const { return shape.places()[indexOf(segment)].point(p_S); }

  /// Near the bare surface, from the neck to the ankles and wrists.
  dvec3 anyPoint(std::mt19937_64& random) const {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (;;) {
      const dvec3 p = shape.places()[0].p_WS + dvec3(0.3, 0.7, 0.9) * dvec3(unit(random), unit(random), unit(random));
      if (std::abs(shape.body(p)) < 0.01) return p;
    }
  }
};

std::size_t mirroredBody(std::size_t body) {
  if (body >= kSegmentCount) {
    const std::size_t of_one_hand = kDigits * kPhalanges, i = body - kSegmentCount;
    return kSegmentCount + (i + of_one_hand) % (2 * of_one_hand);
  }
  const Segment segment = static_cast<Segment>(body);
  if (segment < Segment::kLeftClavicle) return body;
  if (segment < Segment::kLeftThigh) return segment < Segment::kRightClavicle ? body + 5 : body - 5;
  return segment < Segment::kRightThigh ? body + 4 : body - 4;
}

TEST_F(WeighedSkin, TheMiddleOfALimbIsItsOwn) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const auto share = [&](Segment of, const dvec3& p_S) { return weighing.at(point(of, p_S)).of(indexOf(of)); };
    EXPECT_GT(share(legSegment(side, Segment::kLeftThigh), {0.0, 0.0, -0.5 * figure.thighLength()}), 0.99f);
    EXPECT_GT(share(legSegment(side, Segment::kLeftShank), {0.0, 0.0, -0.5 * figure.shankLength()}), 0.99f);
    EXPECT_GT(share(armSegment(side, Segment::kLeftUpperArm), {0.0, 0.0, -0.6 * figure.upperArmLength()}), 0.95f);
    const SkinWeights fore =
        weighing.at(point(armSegment(side, Segment::kLeftForearm), {0.0, 0.0, -0.5 * figure.forearmLength()}));
    EXPECT_NEAR(fore.of(indexOf(armSegment(side, Segment::kLeftForearm))), 0.5f, 0.05f)
        << "half way down, half of the pronation";
    EXPECT_NEAR(fore.of(indexOf(armSegment(side, Segment::kLeftWrist))), 0.5f, 0.05f);
    EXPECT_EQ(fore.straight(), 0.0f) << "an arm alone";
  }
  EXPECT_EQ(weighing.at(point(Segment::kHead, {0.0, 0.0, 0.1})).owner(), indexOf(Segment::kHead));
  EXPECT_EQ(weighing.at(point(Segment::kPelvis, {0.0, 0.0, 0.0})).owner(), indexOf(Segment::kPelvis));
}

TEST_F(WeighedSkin, SharesSumToOneAndAreTheSameOnTheOtherSide) {
  std::mt19937_64 random(12);
  for (int n = 0; n < 400; ++n) {
    const dvec3 p = anyPoint(random);
    const SkinWeights here = weighing.at(p), there = weighing.at({p.x, -p.y, p.z});
    EXPECT_NEAR(std::accumulate(here.share.begin(), here.share.end(), 0.0f), 1.0f, 1e-5f);
    EXPECT_TRUE(std::is_sorted(here.share.rbegin(), here.share.rend())) << "the largest first";
    EXPECT_GE(here.share.back(), 0.0f);
    for (std::size_t body = 0; body < kBodies; ++body)
      EXPECT_NEAR(here.of(body), there.of(mirroredBody(body)), 2e-4f)
          << body << " at " << p.x << " " << p.y << " " << p.z;
  }
}

TEST_F(WeighedSkin, NeighboursMoveTogether) {
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  float worst = 0.0f;
  for (int n = 0; n < 800; ++n) {
    const dvec3 p = anyPoint(random), q = p + 1e-4 * dvec3(unit(random), unit(random), unit(random));
    const SkinWeights here = weighing.at(p), there = weighing.at(q);
    for (std::size_t body = 0; body < kSegmentCount; ++body)
      worst = std::max(worst, std::abs(here.of(body) - there.of(body)));
  }
  EXPECT_LT(worst, 0.02f) << "of a tenth of a millimetre";
}

TEST(SkinWeights, FramesOfABodyCountAsThatBody) {
  EXPECT_EQ(bodyOfBone(3), 3u);
  EXPECT_EQ(bodyOfBone(kEyeBones), indexOf(Segment::kHead));
  EXPECT_EQ(bodyOfBone(kEyeBones + 1), indexOf(Segment::kHead));
  EXPECT_EQ(bodyOfBone(kSwungArms), indexOf(Segment::kLeftUpperArm));
  EXPECT_EQ(bodyOfBone(kSwungArms + 1), indexOf(Segment::kRightUpperArm));
  SkinWeights weights;
  weights.bone = {static_cast<std::uint8_t>(Segment::kThorax), static_cast<std::uint8_t>(Segment::kLeftUpperArm),
                  static_cast<std::uint8_t>(kSwungArms), 0, 0};
  weights.share = {0.4f, 0.35f, 0.25f, 0.0f, 0.0f};
  EXPECT_NEAR(weights.of(indexOf(Segment::kLeftUpperArm)), 0.6f, 1e-6f);
  EXPECT_EQ(weights.owner(), indexOf(Segment::kLeftUpperArm)) << "by both of its frames";
  EXPECT_NEAR(weights.straight(), 4.0f * 0.6f * 0.4f, 1e-6f);
}

}  // namespace
}  // namespace hapticell::mannequin
