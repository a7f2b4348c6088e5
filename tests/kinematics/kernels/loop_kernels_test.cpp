// SPDX-License-Identifier: Apache-2.0
#include "kinematics/kernels/loop_kernels.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "geometry/shapes/pose.h"

namespace hapticell::kinematics::kernels {
namespace {

std::vector<const LoopTable*> loopBuilds() {
  std::vector<const LoopTable*> all{plainLoopTable(), &loopTable()};
  if (avx2LoopTable() != nullptr) all.push_back(avx2LoopTable());
  return all;
}

constexpr double kThird = 2.0943951023931953;  // rad

DeltaArms deltaArms(double down) {
  DeltaArms arms{};
  for (int k = 0; k < 4; ++k) {
    arms.cosine[k] = std::cos(kThird * std::min(k, 2));
    arms.sine[k] = std::sin(kThird * std::min(k, 2));
  }
  arms.base = 0.2;
  arms.upper = 0.3;
  arms.lower = 0.7;
  arms.platform = 0.06;
  arms.down = down;
  return arms;
}

/// From the knee at a motor angle to the platform's joint: what the lower arm must be long.
double kneeToPlatform(const DeltaArms& arms, int k, double theta, const dvec3& p) {
  const dvec3 outward(arms.cosine[k], arms.sine[k], 0.0);
  const dvec3 knee =
      (arms.base + arms.upper * std::cos(theta)) * outward + dvec3(0, 0, arms.down * arms.upper * std::sin(theta));
  return glm::distance(knee, p + arms.platform * outward);
}

TEST(LoopKernels, BothKneesOfADeltaAreALowerArmFromThePlatform) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-0.2, 0.2);
  for (const LoopTable* build : loopBuilds()) {
    for (int i = 0; i < 100; ++i) {
      const DeltaArms arms = deltaArms(i % 2 == 0 ? -1.0 : 1.0);
      const dvec3 p(uniform(random), uniform(random), arms.down * (0.7 + uniform(random)));
      alignas(32) double outer[4], inner[4];
      const unsigned reached = build->deltaInverse(arms, &p[0], outer, inner);
      for (int k = 0; k < 3; ++k) {
        if ((reached >> k & 1u) == 0) {
          EXPECT_TRUE(std::isnan(outer[k]) && std::isnan(inner[k])) << build->name;
          continue;
        }
        EXPECT_NEAR(kneeToPlatform(arms, k, outer[k], p), arms.lower, 1e-12) << build->name;
        EXPECT_NEAR(kneeToPlatform(arms, k, inner[k], p), arms.lower, 1e-12) << build->name;
        EXPECT_GE(std::cos(outer[k]), std::cos(inner[k]) - 1e-12) << "the outer knee is farther out";
      }
    }
  }
}

TEST(LoopKernels, OutOfReachArmsAreNumberlessOneByOne) {
  for (const LoopTable* build : loopBuilds()) {
    const DeltaArms arms = deltaArms(-1.0);
    const dvec3 aside(0.75, 0.0, -0.55);  // only arm 0 comes there
    alignas(32) double outer[4], inner[4];
    const unsigned reached = build->deltaInverse(arms, &aside[0], outer, inner);
    EXPECT_EQ(reached & 7u, 1u) << build->name;
    EXPECT_FALSE(std::isnan(outer[0]) || std::isnan(inner[0])) << build->name;
    for (int k = 1; k < 3; ++k) EXPECT_TRUE(std::isnan(outer[k]) && std::isnan(inner[k])) << build->name;
  }
}

TEST(LoopKernels, AnglesOfThreeMotorsAreThoseOfTheLibrary) {
  const std::array<double, 4> theta{0.3, -1.2, 2.9, 0.0};
  for (const LoopTable* build : loopBuilds()) {
    alignas(32) double sine[4], cosine[4];
    build->deltaAngles(theta.data(), sine, cosine);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(sine[k], std::sin(theta[k]), 1e-15) << build->name;
      EXPECT_NEAR(cosine[k], std::cos(theta[k]), 1e-15) << build->name;
    }
  }
}

class HexapodKernels : public ::testing::Test {
 protected:
  HexapodKernels() {
    for (int k = 0; k < 8; ++k) {
      const int leg = std::min(k, 5);
      const double base = kThird * (leg / 2) + (leg % 2 == 0 ? -0.2 : 0.2);
      const double top = kThird * (leg / 2) + (leg % 2 == 0 ? -0.8 : 0.8);
      const dvec3 a(0.5 * std::cos(base), 0.5 * std::sin(base), 0.02),
          c(0.3 * std::cos(top), 0.3 * std::sin(top), -0.03);
      for (int i = 0; i < 3; ++i) {
        hinges_.base[i][k] = a[i];
        hinges_.top[i][k] = c[i];
      }
    }
  }
  dvec3 hinge(const double (&at)[3][8], int leg) const { return {at[0][leg], at[1][leg], at[2][leg]}; }
  std::array<double, 8> lengthsByGlm(const Pose& X_BP) const {
    std::array<double, 8> lengths{};
    for (int k = 0; k < 8; ++k) {
      lengths[static_cast<std::size_t>(k)] = glm::distance(X_BP * hinge(hinges_.top, k), hinge(hinges_.base, k));
    }
    return lengths;
  }
  static std::array<double, 9> rows(const Pose& X) {
    std::array<double, 9> R{};
    const dmat3 columns = X.R();
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) R[static_cast<std::size_t>(3 * row + column)] = columns[column][row];
    }
    return R;
  }
  Pose pose(double size) {
    std::uniform_real_distribution<double> uniform(-size, size);
    const dvec3 turned(uniform(random_), uniform(random_), uniform(random_));
    return {dvec3(uniform(random_), uniform(random_), 0.6 + uniform(random_)), quaternionFromRotationVector(turned)};
  }
  HexapodHinges hinges_{};
  std::mt19937_64 random_{5};
};

TEST_F(HexapodKernels, LegsAreAsLongAsTheirHingesAreApart) {
  for (const LoopTable* build : loopBuilds()) {
    for (int i = 0; i < 50; ++i) {
      const Pose X_BP = pose(0.2);
      alignas(32) double lengths[8];
      build->legLengths(hinges_, rows(X_BP).data(), &X_BP.p[0], lengths);
      const auto expected = lengthsByGlm(X_BP);
      for (std::size_t k = 0; k < 8; ++k) EXPECT_NEAR(lengths[k], expected[k], 1e-14) << build->name;
    }
  }
}

TEST_F(HexapodKernels, ANewtonStepIsTheSolutionOfTheLinearEquations) {
  for (const LoopTable* build : loopBuilds()) {
    for (int i = 0; i < 50; ++i) {
      const Pose X_BP = pose(0.15), X_goal = pose(0.15);
      const auto wanted = lengthsByGlm(X_goal), now = lengthsByGlm(X_BP);
      alignas(32) double goal[8];
      std::copy(wanted.begin(), wanted.end(), goal);
      double step[6] = {}, determinant = 0.0;
      const double error = build->hexapodStep(hinges_, rows(X_BP).data(), &X_BP.p[0], goal, step, &determinant);
      Eigen::Matrix<double, 6, 6> J;
      Eigen::Matrix<double, 6, 1> missing;
      double largest = 0.0;
      for (int k = 0; k < 6; ++k) {
        const dvec3 arm = X_BP.rotate(hinge(hinges_.top, k));
        const dvec3 along = glm::normalize(X_BP.p + arm - hinge(hinges_.base, k)), moment = glm::cross(arm, along);
        for (int c = 0; c < 3; ++c) {
          J(k, c) = along[c];
          J(k, 3 + c) = moment[c];
        }
        missing(k) = wanted[static_cast<std::size_t>(k)] - now[static_cast<std::size_t>(k)];
        largest = std::max(largest, std::abs(missing(k)));
      }
      EXPECT_NEAR(error, largest, 1e-13) << build->name;
      EXPECT_NEAR(determinant, J.determinant(), 1e-12) << build->name;
      const Eigen::Matrix<double, 6, 1> expected = J.fullPivLu().solve(missing);
      for (int c = 0; c < 6; ++c) EXPECT_NEAR(step[c], expected(c), 1e-8) << build->name;
    }
  }
}

}  // namespace
}  // namespace hapticell::kinematics::kernels
