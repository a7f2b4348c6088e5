// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "manipulation/holding/guide_constraints.h"
#include "manipulation/session/session.h"
#include "tests/manipulation/session/test_cells.h"

namespace hapticell::manipulation {
namespace {

using haptic::Constraint;
using workcell::Guide;
using workcell::GuideKind;

Guide placedGuide(GuideKind kind) {
  Guide guide;
  guide.name = "guide";
  guide.kind = kind;
  guide.entity = "box";
  guide.X_WG = {dvec3(0.02, -0.01, 0.03), quaternionFromRotationVector({0.3, -0.2, 0.5})};
  guide.lower = -0.4;
  guide.upper = 0.5;
  guide.detents = {0.1};
  guide.detent_width = 0.5;
  guide.path = {dvec3(0.0), dvec3(0.3, 0.02, 0.0)};
  guide.help = 50.0;
  guide.locked = {true, false, true, true, false, true};
  return guide;
}

haptic::Vector6 unit(std::size_t i, double size) {
  haptic::Vector6 xi{};
  xi[i] = size;
  return xi;
}

Pose moved(const Pose& X, const haptic::Vector6& xi) {
  return displaced(X, {{xi[0], xi[1], xi[2]}, {xi[3], xi[4], xi[5]}});
}

TEST(GuideConstraints, TheirGradientsAreThoseOfTheirGaps) {
  const Pose X_WM0{dvec3(0.11, 0.04, 0.06), quaternionFromRotationVector({0.1, 0.0, 0.2})};
  const Pose X_WM = moved(X_WM0, {0.004, -0.003, 0.002, 0.01, 0.02, -0.01});
  const double h = 1e-6;
  for (int k = 0; k <= static_cast<int>(GuideKind::kLock); ++k) {
    const Guide guide = placedGuide(static_cast<GuideKind>(k));
    const auto rows = guideConstraints(guide, X_WM, X_WM0, 0);
    EXPECT_EQ(rows.empty(), guide.kind == GuideKind::kSurface);
    for (std::size_t i = 0; i < 6; ++i) {
      const auto after = guideConstraints(guide, moved(X_WM, unit(i, h)), X_WM0, 0);
      const auto before = guideConstraints(guide, moved(X_WM, unit(i, -h)), X_WM0, 0);
      ASSERT_EQ(after.size(), rows.size());
      for (std::size_t r = 0; r < rows.size(); ++r) {
        // Orientation rows are of first order about where the entity was taken: 0.03 rad away that is good to 3 %.
        EXPECT_NEAR((after[r].gap - before[r].gap) / (2.0 * h), rows[r].gradient[i], 0.03)
            << "kind " << k << ", row " << r << ", direction " << i;
      }
    }
  }
}

TEST(GuideConstraints, ACircleIsExactFarFromItsReference) {
  Guide guide = placedGuide(GuideKind::kCircle);
  guide.X_WG = Pose::identity();
  guide.radius = 0.1;
  const Pose X_WM = Pose::translation({0.1, 0.0, 0.0});
  const auto rows = guideConstraints(guide, X_WM, X_WM, 0);
  for (const double angle : {0.3, 1.0, 2.0}) {
    const haptic::Vector6 xi{0.1 * std::cos(angle) - 0.1, 0.1 * std::sin(angle), 0.0, 0.0, 0.0, 0.0};
    for (const Constraint& row : rows) EXPECT_NEAR(haptic::evaluate(row, xi), 0.0, 1e-12);
  }
}

TEST(GuideConstraints, ASlavedTurnIsThatOfTheDoor) {
  Guide guide = placedGuide(GuideKind::kHinge);
  const Pose X_WM0 = Pose::translation({0.11, 0.04, 0.06});
  const Pose X_WM = Pose::translation({0.10, 0.06, 0.06});
  const auto turn = guidedTurn(guide, X_WM, X_WM0);
  ASSERT_TRUE(turn.has_value());
  const double h = 1e-6;
  for (int i = 0; i < 3; ++i) {
    dvec3 step(0.0);
    step[i] = h;
    const auto after = guidedTurn(guide, Pose::translation(X_WM.p + step), X_WM0);
    const dvec3 turned = rotationVector(after->q_WM * glm::conjugate(turn->q_WM)) / h;
    EXPECT_NEAR(glm::distance(turned, turn->rate[i]), 0.0, 1e-3);
  }
  // A row about turning becomes one about places: f(x, rate x).
  Constraint row;
  row.gradient = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
  for (std::size_t k = 0; k < row.curvature.size(); ++k) row.curvature[k] = 1.0 + 0.1 * static_cast<double>(k);
  Constraint slaved = row;
  slaveTurning(turn->rate, slaved);
  const dvec3 x(0.01, -0.02, 0.005), w = turn->rate * x;
  EXPECT_NEAR(haptic::evaluate(slaved, {x.x, x.y, x.z, 0, 0, 0}), haptic::evaluate(row, {x.x, x.y, x.z, w.x, w.y, w.z}),
              1e-12);
}

TEST(GuideConstraints, ATubeIsFreeInsideAndNotOutside) {
  Guide guide = placedGuide(GuideKind::kTube);
  guide.radius = 0.02;
  guide.help = 0.0;
  for (const double y : {0.0, 0.015, 0.025}) {
    const Pose X_WM = Pose::translation({0.15, 0.01 + y, 0.0});
    const auto rows = guideConstraints(guide, X_WM, X_WM, 0);
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].gap > 0.0, y < 0.02);
  }
}

/// A door of 60 mm held 0.1 m from its hinge, which is the z axis.
SessionOptions doorSession(std::vector<test::Waypoint> way, double rate, double latency) {
  std::vector<workcell::Entity> entities{
      test::solid(1, "box", geometry::makeBox(dvec3(0.06)), Pose::translation({0.1, 0.0, 0.0}))};
  SessionOptions options = test::sessionOf(std::move(entities), "box", test::handThrough(way), rate, latency);
  Guide hinge;
  hinge.name = "hinge";
  hinge.kind = GuideKind::kHinge;
  hinge.entity = "box";
  hinge.upper = 0.35;
  options.guides = {hinge};
  return options;
}

TEST(GuideSession, ADoorTurnsOnItsHingeAndMeetsItsStop) {
  for (const auto& [rate, latency] : {std::pair{10.0, 0.05}, {100.0, 0.01}}) {
    SessionOptions options = doorSession(
        {{0.0, {0, 0, 0}}, {1.5, {0, 0, 0}}, {2.5, {0.01, 0.055, 0.004}}, {3.0, {0.01, 0.055, 0.004}}}, rate, latency);
    double off = 0.0, farthest = 0.0, turned_off = 0.0;
    const auto report = runSession(options, [&](const TraceRow& row) {
      if (row.t < 0.3 || glm::length(row.X_WM.p) < 0.01) return;
      const double phi = std::atan2(row.X_WM.p.y, row.X_WM.p.x);
      off = std::max({off, std::abs(std::hypot(row.X_WM.p.x, row.X_WM.p.y) - 0.1), std::abs(row.X_WM.p.z)});
      farthest = std::max(farthest, phi);
      const dvec3 turn = rotationVector(row.X_WM.q);
      turned_off = std::max(turned_off, glm::length(turn - dvec3(0, 0, phi)));
    });
    ASSERT_TRUE(report.has_value()) << report.error().message();
    EXPECT_LT(off, 0.05e-3) << rate;
    EXPECT_LT(turned_off, 1e-3) << "the door's own turn follows the hinge";
    EXPECT_GT(farthest, 0.34) << "it came to its stop";
    EXPECT_LT(farthest, 0.3505);
    EXPECT_GT(report->forces.force_max_n, 1.0) << "the stop is felt";
    EXPECT_GE(report->forces.energy_min_j, -3e-3);
  }
}

TEST(GuideSession, WithoutTheGuideItGoesAnywhere) {
  SessionOptions options = doorSession({{0.0, {0, 0, 0}}, {1.5, {0, 0, 0}}, {2.5, {0.02, 0.05, 0.0}}}, 60.0, 0.01);
  options.guides[0].enabled = false;
  const auto report = runSession(options);
  ASSERT_TRUE(report.has_value());
  EXPECT_NEAR(report->end.X_WM.p.x, 0.12, 0.003);
}

}  // namespace
}  // namespace hapticell::manipulation
