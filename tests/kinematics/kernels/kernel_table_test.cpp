// SPDX-License-Identifier: Apache-2.0
// Each function of the kernels' table against matrices multiplied in double, for every build of it: the plain one, AVX2
// where the processor has it, and one more compiled here.
#include "kinematics/kernels/kernel_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "geometry/shapes/pose.h"
#include "kinematics/kernels/kernels.h"

namespace hapticell::kinematics::kernels {
namespace {

constexpr double kHalfTurn = std::numbers::pi;

std::vector<const Table*> tableBuilds() {
  static const Table here = tableNamed("compiled by the test");
  std::vector<const Table*> all{&here, plainTable()};
  if (avx2Table() != nullptr) all.push_back(avx2Table());
  return all;
}

dmat3 turnAbout(int axis, double angle) {
  dvec3 along(0.0);
  along[axis] = 1.0;
  return glm::mat3_cast(glm::angleAxis(angle, along));
}
dmat3 Rx(double angle) {
  return turnAbout(0, angle);
}
dmat3 Ry(double angle) {
  return turnAbout(1, angle);
}
dmat3 Rz(double angle) {
  return turnAbout(2, angle);
}

struct FrameAt {
  dmat3 R{1.0};
  dvec3 p{0.0};
};

ArmPose armPose(const FrameAt& at) {
  ArmPose pose{};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) pose.R[3 * row + column] = at.R[column][row];
    pose.p[row] = at.p[row];
  }
  return pose;
}

double frameDifference(const FrameAt& a, const FrameAt& b) {
  double most = glm::length(a.p - b.p);
  for (int i = 0; i < 3; ++i) most = std::max(most, glm::length(a.R[i] - b.R[i]));
  return most;
}

using JointAngles = std::array<double, kMaxJoints>;

JointAngles anglesOf(const Solutions& solutions, int index, const JointMap& map) {
  JointAngles theta{};
  for (std::size_t j = 0; j < theta.size(); ++j) theta[j] = map.sign[j] * solutions.q[j][index] + map.offset[j];
  return theta;
}

// The arms as kernels.h describes them, matrix by matrix.
FrameAt opwAt(const OpwArm& arm, const JointAngles& t) {
  const double a2 = arm.k * std::sin(arm.psi), c3 = arm.k * std::cos(arm.psi);
  const dvec3 wrist = dvec3(arm.a1, 0, 0) + Ry(t[1]) * dvec3(0, 0, arm.c2) + Ry(t[1] + t[2]) * dvec3(a2, arm.b, c3);
  return {Rz(t[0]) * Ry(t[1] + t[2]) * Rz(t[3]) * Ry(t[4]) * Rz(t[5]), Rz(t[0]) * wrist};
}
FrameAt urAt(const UrArm& arm, const JointAngles& t) {
  const double t23 = t[1] + t[2], t234 = t23 + t[3];
  const dvec3 p = dvec3(arm.a1, arm.d4, 0) + Ry(t[1]) * dvec3(0, 0, arm.c2) + Ry(t23) * dvec3(0, 0, arm.c3) +
                  Ry(t234) * dvec3(0, 0, arm.d5);
  return {Rz(t[0]) * Ry(t234) * Rz(t[4]) * Rx(-0.5 * kHalfTurn) * Rz(t[5]), Rz(t[0]) * p};
}
FrameAt sevenAt(const SevenArm& arm, const JointAngles& t) {
  const dmat3 R13 = Rz(t[0]) * Ry(t[1]) * Rz(t[2]), R46 = Rz(t[4]) * Ry(t[5]);
  const dvec3 from_elbow = Ry(t[3]) * (dvec3(arm.a5, 0, arm.d5) + R46 * dvec3(arm.a7, 0, 0));
  return {R13 * Ry(t[3]) * R46 * Rz(t[6]), R13 * (dvec3(arm.a4, 0, arm.d3) + from_elbow)};
}

class KernelTable : public testing::Test {
 protected:
  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }
  dmat3 rotation() { return Rz(uniform(-3, 3)) * Ry(uniform(-1.5, 1.5)) * Rz(uniform(-3, 3)); }
  dvec3 vector(double size) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }
  JointAngles joints() {
    JointAngles q{};
    for (double& each : q) each = uniform(-2.8, 2.8);
    return q;
  }
  JointMap map() {
    JointMap map;
    for (int j = 0; j < kMaxJoints; ++j) {
      map.sign[j] = uniform(0, 1) < 0.5 ? -1.0 : 1.0;
      map.offset[j] = uniform(-1, 1);
    }
    return map;
  }
  OpwArm opwArm() {
    const double a2 = uniform(-0.3, 0.3), c3 = uniform(0.4, 1.2);
    OpwArm arm{
        uniform(-0.3, 0.5), uniform(-0.2, 0.2), uniform(0.4, 1.2), std::hypot(a2, c3), std::atan2(a2, c3), 0, 0, map()};
    arm.sin_psi = std::sin(arm.psi);
    arm.cos_psi = std::cos(arm.psi);
    return arm;
  }
  static JointAngles thetaOf(const JointAngles& q, const JointMap& map) {
    JointAngles theta{};
    for (std::size_t j = 0; j < q.size(); ++j) theta[j] = map.sign[j] * q[j] + map.offset[j];
    return theta;
  }
  /// Every valid one of the first `count` solutions reaches the pose, and one of them has the joints `theta`.
  template <typename Forward>
  void expectAll(const Solutions& solutions, int count, int joints, const JointMap& map, const JointAngles& theta,
                 const Forward& forward) {
    const FrameAt wanted = forward(theta);
    int valid = 0;
    bool is_found = false;
    for (int k = 0; k < count; ++k) {
      if ((solutions.valid >> k & 1u) == 0) continue;
      ++valid;
      const JointAngles found = anglesOf(solutions, k, map);
      EXPECT_LT(frameDifference(forward(found), wanted), 1e-9) << "solution " << k;
      double apart = 0.0;
      for (int j = 0; j < joints; ++j) {
        const auto at = static_cast<std::size_t>(j);
        apart = std::max(apart, std::abs(std::remainder(found[at] - theta[at], 2.0 * kHalfTurn)));
      }
      is_found = is_found || apart < 1e-6;
    }
    EXPECT_GT(valid, 0);
    EXPECT_TRUE(is_found) << "the joints that made the pose are not among " << valid << " solutions";
  }
  std::mt19937_64 random_{11};
};

TEST_F(KernelTable, MapTakesATipIntoTheCanonicalFrames) {
  for (const Table* build : tableBuilds()) {
    for (int i = 0; i < 20; ++i) {
      const FrameAt X_B0{rotation(), vector(2.0)}, X_BT{rotation(), vector(2.0)}, X_TN{rotation(), vector(0.5)};
      ArmFrames frames;
      for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
          frames.R_0B[column][row] = X_B0.R[row][column];  // the transpose's columns
          frames.R_TN[3 * row + column] = X_TN.R[column][row];
        }
        frames.p_B0[row] = X_B0.p[row];
        frames.p_TN[row] = X_TN.p[row];
      }
      ArmPose found{};
      build->map(frames, &X_BT.R[0][0], &X_BT.p[0], found);
      const dmat3 R_0B = glm::transpose(X_B0.R);
      const ArmPose wanted = armPose({R_0B * X_BT.R * X_TN.R, R_0B * (X_BT.p + X_BT.R * X_TN.p - X_B0.p)});
      for (int k = 0; k < 9; ++k) EXPECT_NEAR(found.R[k], wanted.R[k], 1e-14) << build->name;
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(found.p[k], wanted.p[k], 1e-14) << build->name;
    }
  }
}

TEST_F(KernelTable, OpwReachesThePoseWithEverySolution) {
  for (const Table* build : tableBuilds()) {
    for (int i = 0; i < 100; ++i) {
      const OpwArm arm = opwArm();
      const JointAngles q = joints(), theta = thetaOf(q, arm.map);
      const auto forward = [&](const JointAngles& t) { return opwAt(arm, t); };
      const ArmPose pose = armPose(forward(theta));
      Solutions solutions;
      build->opw(arm, pose, q.data(), solutions);
      expectAll(solutions, 8, 6, arm.map, theta, forward);
      EXPECT_LT(build->opwError(arm, pose, solutions), 1e-9) << build->name;
    }
  }
}

TEST_F(KernelTable, OpwErrorIsTheLargestOfTheValidSolutionsOnly) {
  for (const Table* build : tableBuilds()) {
    const OpwArm arm = opwArm();
    const JointAngles q = joints();
    const FrameAt wanted = opwAt(arm, thetaOf(q, arm.map));
    const ArmPose pose = armPose(wanted);
    Solutions solutions;
    build->opw(arm, pose, q.data(), solutions);
    ASSERT_NE(solutions.valid, 0u);
    const int spoiled = std::countr_zero(solutions.valid);
    solutions.q[5][spoiled] += 0.1;
    const dmat3 off = opwAt(arm, anglesOf(solutions, spoiled, arm.map)).R - wanted.R;
    double largest = 0.0;
    for (int column = 0; column < 3; ++column) {
      for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(off[column][row]));
    }
    // Seen from the elbow the numbers are others, but none is larger than the turn.
    const double error = build->opwError(arm, pose, solutions);
    EXPECT_GT(error, 0.5 * largest) << build->name;
    EXPECT_LT(error, 0.1) << build->name;
    solutions.valid &= ~(1u << spoiled);
    EXPECT_LT(build->opwError(arm, pose, solutions), 1e-9) << build->name;
  }
}

TEST_F(KernelTable, OutOfReachNothingIsValid) {
  for (const Table* build : tableBuilds()) {
    const OpwArm opw = opwArm();
    UrArm ur{0.0, 0.4, 0.4, 0.13, 0.1, {}};
    SevenArm seven{0.42, 0.0, 0.0, 0.4, 0.0, {}};
    const ArmPose far = armPose({dmat3(1.0), dvec3(9.0, 2.0, 3.0)});
    const JointAngles rest{};
    Solutions solutions;
    build->opw(opw, far, rest.data(), solutions);
    EXPECT_EQ(solutions.valid, 0u) << build->name;
    build->ur(ur, far, rest.data(), solutions);
    EXPECT_EQ(solutions.valid, 0u) << build->name;
    build->srs(seven, far, 0.3, rest.data(), solutions);
    EXPECT_EQ(solutions.valid, 0u) << build->name;
    SwivelRing ring;
    build->srsRing(seven, far, 0.3, rest.data(), ring);
    EXPECT_FALSE(ring.reached) << build->name;
    build->panda({0.316, 0.0825, -0.0825, 0.384, 0.088, {}}, far, 0.3, rest.data(), solutions);
    EXPECT_EQ(solutions.valid, 0u) << build->name;
  }
}

TEST_F(KernelTable, UrReachesThePoseWithEverySolution) {
  for (const Table* build : tableBuilds()) {
    for (int i = 0; i < 100; ++i) {
      const UrArm arm{uniform(-0.1, 0.1), uniform(0.3, 0.7),  uniform(0.3, 0.7),
                      uniform(-0.2, 0.2), uniform(0.05, 0.2), map()};
      const JointAngles q = joints(), theta = thetaOf(q, arm.map);
      const auto forward = [&](const JointAngles& t) { return urAt(arm, t); };
      Solutions solutions;
      build->ur(arm, armPose(forward(theta)), q.data(), solutions);
      expectAll(solutions, 8, 6, arm.map, theta, forward);
    }
  }
}

TEST_F(KernelTable, PandaReachesThePoseWithEverySolutionOfItsSeventhJoint) {
  for (const Table* build : tableBuilds()) {
    for (int i = 0; i < 100; ++i) {
      const SevenArm arm{0.316, 0.0825, -0.0825, 0.384, 0.088, map()};
      JointAngles q = joints();
      JointAngles theta = thetaOf(q, arm.map);
      const auto forward = [&](const JointAngles& t) { return sevenAt(arm, t); };
      Solutions solutions;
      build->panda(arm, armPose(forward(theta)), q[6], q.data(), solutions);
      expectAll(solutions, 8, 7, arm.map, theta, forward);
    }
  }
}

TEST_F(KernelTable, SrsReachesThePoseForEverySwivelAndARingIsTheSame) {
  for (const Table* build : tableBuilds()) {
    for (int i = 0; i < 20; ++i) {
      const SevenArm arm{0.42, 0.0, 0.0, 0.4, 0.0, map()};
      const JointAngles q = joints();
      const FrameAt wanted = sevenAt(arm, thetaOf(q, arm.map));
      const ArmPose pose = armPose(wanted);
      const double first = uniform(-3, 3);
      SwivelRing ring;
      build->srsRing(arm, pose, first, q.data(), ring);
      ASSERT_TRUE(ring.reached);
      for (int k = 0; k < kRingSize; k += 13) {
        Solutions of_ring, alone;
        build->srsOfRing(arm, ring, k, of_ring);
        build->srs(arm, pose, first + 2.0 * kHalfTurn * k / kRingSize, q.data(), alone);
        ASSERT_EQ(of_ring.valid & 0xffu, 0xffu);
        ASSERT_EQ(alone.valid & 0xffu, 0xffu);
        for (int s = 0; s < 8; ++s) {
          EXPECT_LT(frameDifference(sevenAt(arm, anglesOf(of_ring, s, arm.map)), wanted), 1e-9);
          EXPECT_LT(frameDifference(sevenAt(arm, anglesOf(alone, s, arm.map)), wanted), 1e-9);
        }
      }
    }
  }
}

TEST_F(KernelTable, ChooseAgreesWithTryingEachTurn) {
  for (const Table* build : tableBuilds()) {
    for (int i = 0; i < 300; ++i) {
      JointBounds bounds{};
      JointAngles previous{};
      for (int j = 0; j < bounds.joints; ++j) {
        bounds.lower[j] = uniform(-6.0, -1.0);
        bounds.upper[j] = uniform(1.0, 6.0);
        bounds.turn[j] = j % 3 == 0 ? 0.0 : 2.0 * kHalfTurn;
        previous[static_cast<std::size_t>(j)] = uniform(bounds.lower[j], bounds.upper[j]);
      }
      Solutions solutions{};
      for (auto& row : solutions.q) {
        for (double& each : row) each = uniform(-kHalfTurn, kHalfTurn);
      }
      solutions.valid = static_cast<unsigned>(random_()) & 0xffu;
      const Solutions before = solutions;
      const Choice choice = build->choose(bounds, previous.data(), 2, solutions);
      unsigned within = 0;
      double least = 1e300;
      int nearest = -1;
      for (int s = 0; s < 8; ++s) {
        bool is_within = (before.valid >> s & 1u) != 0;
        double squared = 0.0;
        for (int j = 0; j < bounds.joints; ++j) {
          double best = 1e300;
          for (int turns = bounds.turn[j] > 0.0 ? -3 : 0; turns <= (bounds.turn[j] > 0.0 ? 3 : 0); ++turns) {
            const double at = before.q[j][s] + turns * 2.0 * kHalfTurn;
            if (at < bounds.lower[j] - 1e-9 || at > bounds.upper[j] + 1e-9) continue;
            best = std::min(best, std::abs(at - previous[static_cast<std::size_t>(j)]));
          }
          is_within = is_within && best < 1e300;
          squared += best * best;
        }
        if (!is_within) continue;
        within |= 1u << s;
        if (squared < least) {
          least = squared;
          nearest = s;
        }
      }
      EXPECT_EQ(choice.within, within) << build->name;
      EXPECT_EQ(choice.nearest, nearest) << build->name;
      if (nearest >= 0) {
        EXPECT_NEAR(choice.distance_squared, least, 1e-9);
      }
    }
  }
}

TEST_F(KernelTable, NearestSeedsAreTheBestOfEachGroupNearestFirst) {
  constexpr int kCount = 10 * kSeedGroups;
  std::array<std::vector<float>, 7> values;
  for (auto& each : values) each.resize(kCount);
  SeedPoses seeds{.count = kCount};
  for (int s = 0; s < kCount; ++s) {
    const auto at = static_cast<std::size_t>(s);
    for (std::size_t i = 0; i < 3; ++i) values[i][at] = static_cast<float>(uniform(-1, 1));
    const dquat q = glm::quat_cast(rotation());
    const std::array<double, 4> parts{q.w, q.x, q.y, q.z};
    for (std::size_t i = 0; i < 4; ++i) values[3 + i][at] = static_cast<float>(parts[i]);
  }
  for (std::size_t i = 0; i < 7; ++i) seeds.values[i] = values[i].data();
  const std::array<float, 7> wanted{0.2f, -0.1f, 0.4f, 0.5f, 0.5f, -0.5f, 0.5f};
  constexpr double kScale = 2.5;
  const auto cost = [&](int s) {
    double away = 0.0, cosine = 0.0;
    for (std::size_t i = 0; i < 7; ++i) {
      const double value = double{values[i][static_cast<std::size_t>(s)]};
      if (i < 3) {
        away += kScale * kScale * (value - wanted[i]) * (value - wanted[i]);
      } else {
        cosine += value * wanted[i];
      }
    }
    return away + 4.0 * (1.0 - cosine * cosine);
  };
  for (const Table* build : tableBuilds()) {
    std::array<int, kSeedGroups> order{};
    build->nearestSeeds(seeds, wanted.data(), static_cast<float>(kScale), order.data());
    std::array<bool, kSeedGroups> seen{};
    for (std::size_t i = 0; i < order.size(); ++i) {
      const int group = order[i] % kSeedGroups;
      EXPECT_FALSE(seen[static_cast<std::size_t>(group)]);
      seen[static_cast<std::size_t>(group)] = true;
      for (int s = group; s < kCount; s += kSeedGroups) EXPECT_GE(cost(s), cost(order[i]) - 1e-5) << build->name;
      if (i > 0) {
        EXPECT_GE(cost(order[i]), cost(order[i - 1]) - 1e-5) << build->name;
      }
    }
  }
}

/// A random arm of turning and sliding joints, as TrueArm says it.
class TrueArms : public KernelTable {
 protected:
  static void put(const FrameAt& X, double* R, double* p) {
    const ArmPose pose = armPose(X);
    std::copy_n(pose.R, 9, R);
    std::copy_n(pose.p, 3, p);
  }
  TrueArm arm(int joints, bool with_slide) {
    TrueArm arm;
    arm.joints = joints;
    for (int j = 0; j < joints; ++j) {
      steps_[static_cast<std::size_t>(j)] = {rotation(), vector(0.4)};
      put(steps_[static_cast<std::size_t>(j)], arm.R[j], arm.p[j]);
      arm.slides[j] = with_slide && j == 2;
    }
    tip_ = {rotation(), vector(0.2)};
    put(tip_, arm.R_tip, arm.p_tip);
    return arm;
  }
  /// Frames after each joint, and the tip last.
  std::vector<FrameAt> frames(const TrueArm& arm, const JointAngles& q) const {
    std::vector<FrameAt> found;
    FrameAt at;
    for (int j = 0; j < arm.joints; ++j) {
      const auto i = static_cast<std::size_t>(j);
      at = {at.R * steps_[i].R, at.p + at.R * steps_[i].p};
      if (arm.slides[j]) {
        at.p += at.R * dvec3(0, 0, q[i]);
      } else {
        at.R = at.R * Rz(q[i]);
      }
      found.push_back(at);
    }
    found.push_back({at.R * tip_.R, at.p + at.R * tip_.p});
    return found;
  }
  std::array<FrameAt, kMaxJoints> steps_;
  FrameAt tip_;
};

TEST_F(TrueArms, AxesStandWhereMatricesBringThem) {
  for (const Table* build : tableBuilds()) {
    const TrueArm arm = this->arm(7, true);
    Solutions solutions{};
    for (auto& row : solutions.q) {
      for (double& each : row) each = uniform(-2, 2);
    }
    for (int group = 0; group < 2; ++group) {
      FourAxes axes{};
      build->axes(arm, solutions, group, axes);
      for (int lane = 0; lane < 4; ++lane) {
        const auto expected = frames(arm, anglesOf(solutions, 4 * group + lane, {}));
        for (int j = 0; j < arm.joints; ++j) {
          const FrameAt& at = expected[static_cast<std::size_t>(j)];
          dvec3 axis, origin;
          for (int i = 0; i < 3; ++i) {
            axis[i] = axes.axis[j][i][lane];
            origin[i] = axes.origin[j][i][lane];
          }
          EXPECT_LT(glm::distance(axis, at.R[2]), 1e-13) << build->name;
          EXPECT_LT(glm::length(glm::cross(origin - at.p, axis)), 1e-13) << "a point of the axis";
        }
      }
    }
  }
}

TEST_F(TrueArms, PolishBringsNearSolutionsOntoThePoseAndMeasuresThem) {
  for (const Table* build : tableBuilds()) {
    const TrueArm arm = this->arm(6, false);
    const JointAngles q = joints();
    const FrameAt wanted = frames(arm, q).back();
    const ArmPose pose = armPose(wanted);
    Solutions solutions{};
    for (int lane = 0; lane < 4; ++lane) {
      for (int j = 0; j < arm.joints; ++j) {
        solutions.q[j][lane] = q[static_cast<std::size_t>(j)] + (lane == 3 ? 0.0 : uniform(-1e-3, 1e-3));
      }
    }
    solutions.valid = 0b1011u;
    const Solutions before = solutions;
    double errors[4];
    build->polish(arm, pose.R, pose.p, 0, 0, solutions, errors);
    for (int lane = 0; lane < 4; ++lane) {
      const FrameAt at = frames(arm, anglesOf(before, lane, {})).back();
      if (lane != 2) {
        const double angle = glm::length(rotationVector(glm::quat_cast(at.R * glm::transpose(wanted.R))));
        EXPECT_NEAR(errors[lane], std::max(glm::distance(at.p, wanted.p), std::sin(angle)), 1e-8) << "without a step";
      }
      for (int j = 0; j < arm.joints; ++j) EXPECT_EQ(solutions.q[j][lane], before.q[j][lane]);
    }
    build->polish(arm, pose.R, pose.p, 0, 5, solutions, errors);
    for (const int lane : {0, 1, 3}) {
      EXPECT_LT(errors[lane], 1e-10) << build->name;
      EXPECT_LT(frameDifference(frames(arm, anglesOf(solutions, lane, {})).back(), wanted), 1e-9) << build->name;
    }
  }
}

TEST_F(TrueArms, FitEndsAtThePoseOrAtItsBounds) {
  for (const Table* build : tableBuilds()) {
    const TrueArm arm = this->arm(6, false);
    const JointAngles q = joints();
    const FrameAt wanted = frames(arm, q).back();
    FitTask task{};
    put(wanted, task.R, task.p);
    for (int j = 0; j < arm.joints; ++j) {
      const auto i = static_cast<std::size_t>(j);
      task.lower[j] = -10.0;
      task.upper[j] = 10.0;
      task.start[j] = q[i] + uniform(-0.05, 0.05);
    }
    FitAnswer answer;
    build->fit(arm, task, answer);
    JointAngles found{};
    std::copy_n(answer.x, arm.joints, found.begin());
    EXPECT_LT(frameDifference(frames(arm, found).back(), wanted), 1e-6) << build->name;
    EXPECT_LT(answer.position_error, 1e-6);
    EXPECT_LT(answer.orientation_error, 1e-6);
    EXPECT_FALSE(answer.held);
    EXPECT_LE(answer.iterations, task.max_iterations);
    // Joint 2 may not go where the pose has it: the descent rests on that bound and says so.
    task.upper[1] = q[1] - 0.02;
    task.start[1] = q[1] - 0.05;
    build->fit(arm, task, answer);
    std::copy_n(answer.x, arm.joints, found.begin());
    EXPECT_LE(found[1], task.upper[1] + 1e-12) << build->name;
    const FrameAt at = frames(arm, found).back();
    EXPECT_NEAR(answer.position_error, glm::distance(at.p, wanted.p), 1e-9);
  }
}

}  // namespace
}  // namespace hapticell::kinematics::kernels
