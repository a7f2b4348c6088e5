// SPDX-License-Identifier: Apache-2.0
// What of the largest changes of the force is the plan's, where a hand strikes in spite of it.
#include <gtest/gtest.h>

#include <algorithm>

#include "config/program_folders.h"
#include "manipulation/session/session.h"
#include "planning/live/live_planner.h"
#include "trajectory/files/trajectory_io.h"
#include "workcell/format/document_io.h"

namespace hapticell::planning {
namespace {

/// m/s: faster than the hand's own wish, since it leans on the pull until that goes.
constexpr double kStrike = 0.25;

/// The extraction exercise as bench/assisted_bench.cpp has it.
manipulation::SessionOptions extraction(std::uint64_t seed, double authority) {
  manipulation::SessionOptions options;
  Diagnostics notes;
  const auto document = workcell::loadDocument(*config::findShippedFile("exercises/extraction.hcell"), notes);
  const auto expert = trajectory::readTrajectory(*config::findShippedFile("exercises/extraction-expert.htraj"));
  EXPECT_TRUE(document.has_value() && expert.has_value());
  const Pose X_WFrom = (*expert)[0].X_WT, X_WG = (*expert)[expert->size() - 1].X_WT;
  options.entities = document->snapshotEntities();
  options.pairs = document->state().pairPolicy();
  options.entity = "filter unit";
  options.configuration.manipulation.rate_hz = 250.0;
  options.configuration.manipulation.edge_drift = 0.1;
  options.axes.mode = manipulation::AxesMode::kCell;
  const double scale = std::max(1.0, glm::distance(X_WFrom.p, X_WG.p) / 0.05);
  options.scale = {manipulation::ScaleLevel::kNumber, scale};
  options.straight_hand = manipulation::seededHand(seed);
  options.straight_hand->X_WG = X_WG;
  options.straight_hand->scale = scale;
  dvec3 way(0.0);
  for (const workcell::Entity& entity : options.entities)
    if (entity.name == options.entity) way = X_WG.p - entity.X_WE.p;
  const Pose X_DStart = Pose::translation(-0.5 * way / scale);
  options.hand = haptic::HandPath({{0.0, X_DStart, 0}, {8.0, X_DStart, 0}});
  LiveOptions live;
  live.goal = goal::ToPose{X_WG};
  live.seed = seed;
  live.in_virtual_time = true;
  live.most_checks = 50'000;
  live.cost_s = [](const PlanResult& result) { return 100e-6 * static_cast<double>(result.checks); };
  options.assistance = {std::make_shared<LivePlanner>(std::move(live)), authority};
  return options;
}

struct Steps {
  double all = 0.0, contacts = 0.0, fastest = 0.0;
};

manipulation::SessionReport run(const manipulation::SessionOptions& options, Steps& steps) {
  manipulation::TraceRow last;
  auto report = manipulation::runSession(options, [&](const manipulation::TraceRow& row) {
    const dvec3 step_D = row.force_D - last.force_D, pull_D = row.pull_D - last.pull_D;
    steps.all = std::max(steps.all, glm::length(step_D));
    steps.contacts = std::max(steps.contacts, glm::length(step_D - pull_D));
    if (row.t > 0.0) steps.fastest = std::max(steps.fastest, 1e3 * glm::distance(row.X_DS.p, last.X_DS.p));
    last = row;
  });
  EXPECT_TRUE(report.has_value());
  return report ? std::move(*report) : manipulation::SessionReport{};
}

/// Seeds whose hand insists, so that the entity is its own again, and strikes (docs/dev/performance.md).
TEST(StruckContact, IsTheHandsAndNotThePlans) {
  for (const std::uint64_t seed : {34U, 73U, 89U}) {
    Steps with, without;
    const auto led = run(extraction(seed, 1.0), with);
    const auto alone = run(extraction(seed, 0.0), without);
    ASSERT_TRUE(led.plan.has_value());
    EXPECT_TRUE(led.plan->solved) << seed;
    EXPECT_GE(led.plan->insistences, 1U) << seed;
    EXPECT_LE(led.plan->pull_max_step_n_per_ms, 0.05) << seed << ": the plan's part";
    EXPECT_LE(with.all, std::max(0.10, with.contacts)) << seed << ": the plan adds nothing to a strike";
    EXPECT_LE(with.all, without.all) << seed << ": the hand alone strikes harder";
    EXPECT_GT(without.all, 0.10) << seed;
    EXPECT_LT(with.fastest, kStrike) << seed;
    EXPECT_GE(led.forces.energy_min_j, -1.0e-3) << seed << ": the bound of taps (M3)";
    EXPECT_EQ(alone.plan->pull_max_step_n_per_ms, 0.0) << seed;
  }
}

}  // namespace
}  // namespace hapticell::planning
