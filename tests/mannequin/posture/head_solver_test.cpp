// SPDX-License-Identifier: Apache-2.0
#include "mannequin/posture/head_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mannequin/shape/figure_outline.h"
#include "mannequin/posture/work_zones.h"
#include "tests/support/same_bits.h"

namespace hapticell::mannequin {
namespace {

Figure woman() {
  return *makeFigure({Sex::kFemale, *statureOfPercentile(Sex::kFemale, 50)});
}

Posture standing(const Figure& figure) {
  return *libraryPosture(figure, "standing");
}

Pose eyesOf(const Figure& figure, const Posture& posture) {
  return eyesFrame(figure, forwardKinematics(figure, posture));
}

TEST(HeadSolver, TheEyesComeToWhereAPostureHasThem) {
  const Figure figure = woman();
  Posture wanted = standing(figure);
  wanted[Dof::kVl1Flexion] = 0.15;
  wanted[Dof::kVc4LeftTurn] = 0.2;
  wanted[Dof::kSkullbaseFlexion] = 0.1;
  const Pose target = eyesOf(figure, wanted);
  Posture posture = standing(figure);
  for (int tick = 0; tick < 400; ++tick) posture = followHead(figure, posture, target, false).posture;
  const Twist off = difference(target, eyesOf(figure, posture));
  EXPECT_LT(glm::length(off.linear), 1e-3);
  EXPECT_LT(glm::length(off.angular), 5e-3);
  EXPECT_TRUE(limitViolations(posture).empty());
  EXPECT_EQ(posture.X_WR.p, standing(figure).X_WR.p) << "the pelvis stays";
}

TEST(HeadSolver, NeverGetsWorseNeverLeavesLimitsAndIsTheSameEachTime) {
  const Figure figure = woman();
  std::mt19937 random(4);
  std::uniform_real_distribution<double> far(-0.5, 0.5);
  for (int n = 0; n < 20; ++n) {
    Posture posture = standing(figure);
    Pose target = eyesOf(figure, posture);
    target.p += dvec3(far(random), far(random), 0.3 * far(random));
    target.q = glm::normalize(quaternionFromRotationVector({far(random), far(random), far(random)}) * target.q);
    double before = 1e9;
    for (int tick = 0; tick < 60; ++tick) {
      const HeadResult result = followHead(figure, posture, target, n % 2 == 0);
      const HeadResult again = followHead(figure, posture, target, n % 2 == 0);
      EXPECT_TRUE(test::sameBits(result.posture.angles, again.posture.angles));
      const double error = std::hypot(result.position_error, 0.2 * result.orientation_error);
      EXPECT_LE(error, before + 1e-12);
      before = error;
      for (std::size_t i = 0; i < kDofCount; ++i)
        EXPECT_LT(std::abs(result.posture.angles[i] - posture.angles[i]), 0.0315) << "1.8 degrees a tick";
      posture = result.posture;
    }
    EXPECT_TRUE(limitViolations(posture).empty());
    if (n % 2 == 0) {
      for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(posture.angles[i], standing(figure).angles[i]) << "trunk locked";
    }
  }
}

TEST(FigureOutline, ShowsEverySegmentAndIsAsTallAsTheFigure) {
  const Figure figure = woman();
  const Posture posture = standing(figure);
  const auto parts = outlineOf(figure, posture, fleshOf(figure), OutlineView::besides(posture));
  ASSERT_EQ(parts.size(), kSegmentCount);
  double low = 1e9, high = -1e9;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) {
      EXPECT_GE(parts[i].depth, parts[i - 1].depth) << "furthest first";
    }
    for (const auto& shape : parts[i].shapes) {
      for (const auto& p : shape) {
        low = std::min(low, p.y);
        high = std::max(high, p.y);
      }
    }
  }
  EXPECT_NEAR(high - low, figure.body[Dimension::kStature], 0.05);
}

/// Volume of a closed mesh by the divergence theorem.
double volumeOf(const geometry::TriangleMesh& mesh) {
  double volume = 0.0;
  for (const auto& t : mesh.triangles) {
    const dvec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
    volume += glm::dot(a, glm::cross(b, c)) / 6.0;
  }
  return volume;
}

TEST(WorkZones, AreClosedAndThePreferredOneIsTheSmaller) {
  const Figure figure = woman();
  const Posture posture = standing(figure);
  const double preferred = volumeOf(workZone(figure, posture, WorkZone::kPreferred));
  const double acceptable = volumeOf(workZone(figure, posture, WorkZone::kAcceptable));
  EXPECT_GT(preferred, 0.01);
  EXPECT_GT(acceptable, 2.0 * preferred);
  EXPECT_LT(acceptable, 0.6);
  const FigurePose pose = forwardKinematics(figure, posture);
  double before = 0.0;
  for (const VisionZone zone : {VisionZone::kPreferred, VisionZone::kEyes, VisionZone::kHead}) {
    const double volume = std::abs(volumeOf(visionVolume(figure, pose, {}, zone, 1.0)));
    EXPECT_GT(volume, before);
    before = volume;
  }
}

}  // namespace
}  // namespace hapticell::mannequin
