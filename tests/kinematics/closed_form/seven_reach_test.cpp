// SPDX-License-Identifier: Apache-2.0
// Proofs by intervals against joints that are known to reach a pose, and against the closed form at many places.
#include "kinematics/closed_form/seven_reach.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "geometry/shapes/pose.h"
#include "kinematics/model/turns.h"

namespace hapticell::kinematics {
namespace {

constexpr double kHalfTurn = std::numbers::pi;
using SevenJoints = std::array<double, 7>;

/// Lengths of the iiwa's and the Panda's data sheets (m).
kernels::SevenArm sphericalArm() {
  return {0.42, 0.0, 0.0, 0.4, 0.0, {}};
}
kernels::SevenArm offsetArm() {
  return {0.316, 0.0825, -0.0825, 0.384, 0.088, {}};
}

class SevenReachTest : public testing::TestWithParam<bool> {
 protected:
  SevenReachTest() : srs_(GetParam()), arm_(srs_ ? sphericalArm() : offsetArm()) {
    for (int k = 0; k < 7; ++k) {
      arm_.map.sign[k] = uniform(0, 1) < 0.5 ? -1.0 : 1.0;
      arm_.map.offset[k] = uniform(-1, 1);
    }
    bounds_.joints = 7;
    for (double& turn : bounds_.turn) turn = kTurn;
    limit(2.5);
  }
  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }
  void limit(double by) {
    for (int k = 0; k < 7; ++k) {
      bounds_.lower[k] = -by;
      bounds_.upper[k] = by;
    }
  }
  double canonical(const SevenJoints& q, std::size_t k) const { return arm_.map.sign[k] * q[k] + arm_.map.offset[k]; }

  /// Joint after joint, as kernels::SevenArm describes the arm.
  Pose poseOf(const SevenJoints& q) const {
    Pose X;
    for (std::size_t k = 0; k < 7; ++k) {
      if (k == 3) X = X * Pose::translation({arm_.a4, 0.0, arm_.d3});
      if (k == 4) X = X * Pose::translation({arm_.a5, 0.0, arm_.d5});
      if (k == 6) X = X * Pose::translation({arm_.a7, 0.0, 0.0});
      const dvec3 axis = k % 2 == 0 ? dvec3(0, 0, 1) : dvec3(0, 1, 0);
      X = X * Pose::rotation(glm::angleAxis(canonical(q, k), axis));
    }
    return X;
  }
  static kernels::ArmPose plain(const Pose& X) {
    kernels::ArmPose pose{};
    const dmat3 R = X.R();
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) pose.R[3 * row + column] = R[column][row];
      pose.p[row] = X.p[row];
    }
    return pose;
  }
  /// What the pose leaves free: joint 7, or the elbow's place on its circle, from the plane of the line from shoulder to
  /// wrist and the vertical.
  double freeOf(const SevenJoints& q) const {
    if (!srs_) return q[6];
    const dvec3 elbow =
        glm::angleAxis(canonical(q, 0), dvec3(0, 0, 1)) * (glm::angleAxis(canonical(q, 1), dvec3(0, 1, 0)) * dvec3(0, 0, 1));
    const dvec3 line = glm::normalize(poseOf(q).p), side = glm::normalize(glm::cross(dvec3(0, 0, 1), line));
    return std::atan2(glm::dot(elbow, side), glm::dot(elbow, glm::cross(line, side)));
  }
  SevenJoints randomJoints() {
    SevenJoints q{};
    for (std::size_t k = 0; k < 7; ++k) q[k] = uniform(bounds_.lower[k], bounds_.upper[k]);
    return q;
  }
  /// By the closed form, which knows nothing of intervals: at this value of the free parameter.
  bool reachesAt(const kernels::ArmPose& pose, double free) const {
    const SevenJoints previous{};
    kernels::Solutions solutions;
    const kernels::Table& table = kernels::table();
    (srs_ ? table.srs : table.panda)(arm_, pose, free, previous.data(), solutions);
    for (int k = 0; k < 8; ++k) {
      if ((solutions.valid >> k & 1u) != 0 && isWithin(solutions, k)) return true;
    }
    return false;
  }
  bool isWithin(const kernels::Solutions& solutions, int k) const {
    for (int joint = 0; joint < 7; ++joint) {
      const double middle = 0.5 * (bounds_.lower[joint] + bounds_.upper[joint]);
      if (std::abs(std::remainder(solutions.q[joint][k] - middle, kTurn)) > bounds_.upper[joint] - middle) return false;
    }
    return true;
  }

  std::mt19937_64 random_{13};
  bool srs_;
  kernels::SevenArm arm_;
  kernels::JointBounds bounds_{};
};

TEST_P(SevenReachTest, NeverExcludesJointsThatReachThePose) {
  constexpr int kPieces = 32;
  int proven = 0, refuted = 0;
  for (int i = 0; i < 150; ++i) {
    for (int k = 0; k < 7; ++k) {  // Other limits each time, half as wide as the joints need or twice.
      bounds_.lower[k] = uniform(-3.0, -0.3);
      bounds_.upper[k] = uniform(0.3, 3.0);
    }
    const SevenJoints q = randomJoints();
    const kernels::ArmPose pose = plain(poseOf(q));
    const SevenReach reach(arm_, bounds_, pose, srs_);
    const double free = freeOf(q);
    ASSERT_TRUE(reachesAt(pose, free)) << i;
    EXPECT_FALSE(reach.provesNone(-kHalfTurn, kHalfTurn)) << i;
    for (int piece = 0; piece < kPieces; ++piece) {
      const double from = -kHalfTurn + kTurn * piece / kPieces, to = from + kTurn / kPieces;
      if (!reach.provesNone(from, to)) continue;
      EXPECT_FALSE(from <= free && free <= to) << i << " " << piece;
      for (int at = 0; at <= 8; ++at) refuted += reachesAt(pose, from + (to - from) * at / 8) ? 1 : 0;
      ++proven;
    }
  }
  EXPECT_EQ(refuted, 0);
  // For the spherical arm only joints 2, 4 and 6 are looked at.
  EXPECT_GT(proven, 150 * kPieces / 10) << "it proves something";
}

/// Poses of joints that may be anywhere, with narrow limits: what is proven is nowhere reached, and what is not proven
/// is mostly reached.
TEST_P(SevenReachTest, DecidesWhetherThereIsAnything) {
  int proven = 0, reached = 0, open = 0;
  for (int i = 0; i < 300; ++i) {
    limit(3.0);
    const SevenJoints q = randomJoints();
    const kernels::ArmPose pose = plain(poseOf(q));
    limit(1.6);
    const bool is_proven = SevenReach(arm_, bounds_, pose, srs_).provesNone(-kHalfTurn, kHalfTurn);
    bool is_reached = false;
    for (int at = 0; at < 720 && !is_reached; ++at) is_reached = reachesAt(pose, -kHalfTurn + kTurn * at / 720);
    EXPECT_FALSE(is_proven && is_reached) << i;
    proven += is_proven ? 1 : 0;
    reached += is_reached ? 1 : 0;
    open += !is_proven && !is_reached ? 1 : 0;
  }
  EXPECT_GT(proven, 100);
  EXPECT_GT(reached, 10);
  EXPECT_LT(open, 100);
}

TEST_P(SevenReachTest, ProvesThatAWristIsTooFarAway) {
  limit(10.0);  // More than a turn either way: no limit.
  const double longest = std::hypot(arm_.d3, arm_.a4) + std::hypot(arm_.d5, arm_.a5) + arm_.a7;
  for (int i = 0; i < 50; ++i) {
    Pose X = poseOf(randomJoints());
    const dvec3 ahead = glm::normalize(X.p);
    X.p = 1.001 * longest * ahead;
    const kernels::ArmPose far = plain(X);
    EXPECT_TRUE(SevenReach(arm_, bounds_, far, srs_).provesNone(-kHalfTurn, kHalfTurn)) << i;
    X.p = 0.6 * longest * ahead;
    const kernels::ArmPose near = plain(X);
    EXPECT_FALSE(SevenReach(arm_, bounds_, near, srs_).provesNone(-kHalfTurn, kHalfTurn)) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Arms, SevenReachTest, testing::Bool(),
                         [](const auto& parameter) { return parameter.param ? "spherical" : "offset"; });

/// Of an arm without offsets the distance from shoulder to wrist alone sets the elbow (law of cosines).
TEST(SevenReachElbow, DecidesByTheTriangle) {
  const kernels::SevenArm arm = sphericalArm();
  kernels::JointBounds bounds{};
  bounds.joints = 7;
  for (int k = 0; k < 7; ++k) {
    bounds.lower[k] = -10.0;
    bounds.upper[k] = 10.0;
  }
  const double bend = 1.2, squared_distance = 0.42 * 0.42 + 0.4 * 0.4 + 2.0 * 0.42 * 0.4 * std::cos(bend);
  kernels::ArmPose pose{{1, 0, 0, 0, 1, 0, 0, 0, 1}, {}};
  pose.p[0] = 0.6 * std::sqrt(squared_distance);
  pose.p[2] = 0.8 * std::sqrt(squared_distance);
  const auto provenWith = [&](double lower, double upper) {
    bounds.lower[3] = lower;
    bounds.upper[3] = upper;
    return SevenReach(arm, bounds, pose, true).provesNone(-kHalfTurn, kHalfTurn);
  };
  EXPECT_TRUE(provenWith(-1.19, 1.19));
  EXPECT_FALSE(provenWith(-1.19, 1.21));
  EXPECT_FALSE(provenWith(-1.21, 1.19));
  EXPECT_TRUE(provenWith(1.21, 3.0));
  EXPECT_FALSE(provenWith(1.19, 3.0));
  EXPECT_FALSE(provenWith(1.2 + kTurn - 0.01, 1.2 + kTurn + 0.01)) << "a turn further on";
}

}  // namespace
}  // namespace hapticell::kinematics
