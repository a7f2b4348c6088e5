// SPDX-License-Identifier: Apache-2.0
// Every kind of guide through a whole session: what is shown stays on it, and it is felt.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "manipulation/session/session.h"
#include "tests/manipulation/session/test_cells.h"
#include "tests/support/test_data.h"
#include "workcell/format/document_io.h"

namespace hapticell::manipulation {
namespace {

using workcell::Guide;
using workcell::GuideKind;

struct Case {
  const char* name;
  Guide guide;
  /// m (a turn counts with 50 mm): how far the moved frame is off the guide.
  std::function<double(const Pose& X_WM)> off;
  double least_travel = 0.01;  ///< m that the box must have gone (0: it is held fast).
};

Guide guideOf(GuideKind kind) {
  Guide guide;
  guide.name = "guide";
  guide.kind = kind;
  guide.entity = "box";
  return guide;
}

double turnOf(const Pose& X_WM) {
  return 0.05 * glm::length(rotationVector(X_WM.q));
}

std::vector<Case> cases() {
  std::vector<Case> all;
  all.push_back({"point", guideOf(GuideKind::kPoint), [](const Pose& X) { return glm::length(X.p); }, 0.0});
  Guide line = guideOf(GuideKind::kLine);
  line.X_WG.q = quaternionFromRotationVector({0.0, std::numbers::pi / 2, 0.0});
  line.upper = 0.02;
  all.push_back({"line", line, [](const Pose& X) { return std::max(std::hypot(X.p.y, X.p.z), X.p.x - 0.02); }});
  all.push_back({"plane", guideOf(GuideKind::kPlane), [](const Pose& X) { return std::abs(X.p.z); }});
  Guide circle = guideOf(GuideKind::kCircle);
  circle.radius = 0.08;
  circle.X_WG.p = {-0.08, 0.0, 0.0};
  all.push_back({"circle", circle, [](const Pose& X) {
                   return std::max(std::abs(std::hypot(X.p.x + 0.08, X.p.y) - 0.08), std::abs(X.p.z));
                 }});
  Guide slider = guideOf(GuideKind::kSlider);
  slider.X_WG.q = quaternionFromRotationVector({-std::numbers::pi / 2, 0.0, 0.0});  // Along y.
  all.push_back({"slider", slider, [](const Pose& X) { return std::max(std::hypot(X.p.x, X.p.z), turnOf(X)); }});
  Guide screw = guideOf(GuideKind::kScrew);
  screw.pitch = 0.02;
  all.push_back({"screw", screw,
                 [](const Pose& X) {
                   const double angle = rotationVector(X.q).z;
                   return std::max(std::hypot(X.p.x, X.p.y), std::abs(X.p.z - 0.02 * angle / (2.0 * std::numbers::pi)));
                 },
                 0.0005});
  Guide tube = guideOf(GuideKind::kTube);
  tube.path = {dvec3(-0.1, 0, 0), dvec3(0.1, 0, 0)};
  tube.radius = 0.005;
  tube.help = 40.0;
  all.push_back({"tube", tube, [](const Pose& X) { return std::max(0.0, std::hypot(X.p.y, X.p.z) - 0.005); }});
  Guide surface = guideOf(GuideKind::kSurface);
  surface.surface = "floor";
  surface.offset = 0.01;
  // The lowest corner of the box of 40 mm over the floor at z = -0.03.
  all.push_back({"surface", surface, [](const Pose& X) {
                   double lowest = 1.0;
                   for (int k = 0; k < 8; ++k) {
                     const dvec3 corner(k & 1 ? 0.02 : -0.02, k & 2 ? 0.02 : -0.02, k & 4 ? 0.02 : -0.02);
                     lowest = std::min(lowest, (X * corner).z);
                   }
                   return std::abs(lowest + 0.02);
                 }});
  Guide lock = guideOf(GuideKind::kLock);
  lock.locked = {true, false, true, true, true, true};
  all.push_back({"lock", lock, [](const Pose& X) { return std::max({std::abs(X.p.x), std::abs(X.p.z), turnOf(X)}); }});
  return all;
}

SessionOptions guided(const Case& c, double rate, double latency) {
  std::vector<workcell::Entity> cell{
      test::solid(1, "floor", geometry::makeBox({0.6, 0.6, 0.1}), Pose::translation({0, 0, -0.08})),
      test::solid(2, "box", geometry::makeBox(dvec3(0.04)))};
  const auto hand = test::handThrough({{0.0, dvec3(0.0)},
                                       {1.4, dvec3(0.0)},
                                       {2.2, {0.006, 0.02, 0.004}, {0.05, 0.02, 0.15}},
                                       {3.0, {0.03, 0.012, -0.004}, {-0.05, 0.0, 0.3}},
                                       {3.6, {0.03, 0.012, -0.004}, {-0.05, 0.0, 0.3}}});
  SessionOptions options = test::sessionOf(cell, "box", hand, rate, latency);
  options.guides = {c.guide};
  return options;
}

TEST(GuideKinds, EachHoldsWhatIsShownAndIsFelt) {
  for (const Case& c : cases()) {
    for (const auto& [rate, latency] : {std::pair{10.0, 0.05}, {60.0, 0.01}}) {
      SCOPED_TRACE(std::string(c.name) + " at " + std::to_string(rate));
      double off = 0.0, travel = 0.0;
      const auto report = runSession(guided(c, rate, latency), [&](const TraceRow& row) {
        if (row.t < 0.3) return;
        off = std::max(off, c.off(row.X_WM));
        travel = std::max(travel, glm::length(row.X_WM.p));
      });
      ASSERT_TRUE(report.has_value()) << report.error().message();
      // The surface is followed by one tangent at the nearest points a step, while the wrist turns.
      EXPECT_LT(off, c.guide.kind == GuideKind::kSurface ? 1.5e-3 : 0.06e-3);
      EXPECT_GE(travel, c.least_travel);
      EXPECT_GT(report->forces.force_max_n, 0.3);
      EXPECT_GE(report->forces.energy_min_j, -1e-3);
    }
  }
}

/// The example of a car door as it ships: resists, meets its stop, snaps shut.
TEST(GuideKinds, TheCarDoorOpensToItsStopAndSnapsShut) {
  Diagnostics diagnostics;
  const auto document =
      workcell::loadDocument(hapticell::test::sourceFile("config/workcells/car_door.hcell"), diagnostics);
  ASSERT_TRUE(document) << document.error().message();
  const auto hand = haptic::readHandPath(hapticell::test::sourceFile("config/workcells/car_door-hand.csv"));
  ASSERT_TRUE(hand) << hand.error().message();
  for (const auto& [rate, latency] : {std::pair{10.0, 0.05}, {100.0, 0.01}}) {
    SessionOptions options = test::sessionOf(document->snapshotEntities(), "door", *hand, rate, latency);
    options.pairs.sets = document->state().pair_sets;
    options.guides = document->state().guides;
    options.moved_by = *parseMovedBy("frame:handle");
    options.scale = *parseScale("8");
    double widest = 0.0, off = 0.0, resisted = 1e9, at_stop = 0.0, last = 0.0;
    const auto report = runSession(options, [&](const TraceRow& row) {
      if (row.t < 0.3) return;
      const dvec3 p = row.X_WM.p;
      const double angle = std::atan2(p.y, p.x) - std::atan2(0.03, 0.83);
      widest = std::max(widest, angle);
      off = std::max({off, std::abs(std::hypot(p.x, p.y) - std::hypot(0.83, 0.03)), std::abs(p.z - 0.6)});
      const double force = glm::length(row.force_D);
      if (row.t > 2.6 && row.t < 2.7) resisted = std::min(resisted, force);
      if (row.t > 5.2 && row.t < 5.6) at_stop = std::max(at_stop, force);
      last = angle;
    });
    ASSERT_TRUE(report.has_value()) << report.error().message();
    EXPECT_LT(off, 0.05e-3 * 8.0) << "0.05 mm of hand";
    EXPECT_NEAR(widest, 0.7, 2e-3) << "its stop";
    EXPECT_GT(resisted, 0.2) << "friction";
    EXPECT_GT(at_stop, 1.0) << "the stop is felt";
    EXPECT_NEAR(last, 0.0, 2e-3) << "shut";
    EXPECT_LE(report->forces.penetration_max_m, 1e-4);
  }
}

}  // namespace
}  // namespace hapticell::manipulation
