// SPDX-License-Identifier: Apache-2.0
#include "cli/agents/run_report.h"

#include <gtest/gtest.h>

#include "tests/manipulation/session/test_cells.h"

namespace hapticell::cli {
namespace {

using agents::RunMode;
using agents::RunResult;

/// A box with a goal aside of it, high above a table.
std::shared_ptr<const agents::AgentCell> boxCell() {
  auto task = agents::AgentTask::parse(
      "cell = \"c\"\nentity = \"box\"\n[goal]\nposition = [0.3, 0.0, 0.53]\n[[agent]]\nwhat = \"goal\"\n", "/t.toml");
  EXPECT_TRUE(task);
  auto scene = manipulation::PreparedScene::prepare(manipulation::test::boxOverTable(0.5), {}, {});
  const auto cell = agents::AgentCell::create(std::move(*task), scene, {});
  EXPECT_TRUE(cell) << (cell ? "" : cell.error().message());
  return cell ? *cell : nullptr;
}

RunResult resultOf(RunMode mode, bool solved, double time_s, double clearance_m, int deadlocks) {
  RunResult run;
  run.mode = mode;
  run.solved = solved;
  run.time_s = time_s;
  run.way_m = 0.1 * time_s;
  run.clearance_m = clearance_m;
  run.deadlocks = deadlocks;
  return run;
}

TEST(RunReport, SumsUpOneMode) {
  const auto cell = boxCell();
  ASSERT_NE(cell, nullptr);
  const std::vector<RunResult> runs{
      resultOf(RunMode::kBoth, true, 4.0, 0.05, 0), resultOf(RunMode::kBoth, true, 1.0, 0.03, 1),
      resultOf(RunMode::kBoth, false, 60.0, 0.02, 3), resultOf(RunMode::kAgents, true, 9.0, 0.001, 7)};
  const auto both = summaryOf(*cell, RunMode::kBoth, runs);
  EXPECT_EQ(both["mode"], "both");
  EXPECT_EQ(both["runs"], 3);
  EXPECT_EQ(both["solved"], 2);
  EXPECT_EQ(both["median_time_s"], 2.5) << "between the two that are solved";
  EXPECT_NEAR(both["median_way_m"].get<double>(), 0.25, 1e-12);
  EXPECT_EQ(both["least_clearance_m"], 0.02) << "of all, solved or not";
  EXPECT_EQ(both["deadlocks"], 4);
  EXPECT_FALSE(both.contains("median_rula")) << "a box has no posture";
  const auto none = summaryOf(*cell, RunMode::kOperator, runs);
  EXPECT_EQ(none["runs"], 0);
  EXPECT_TRUE(none["median_time_s"].is_null()) << "no run, no median";
}

TEST(RunReport, OfOneRunHasWhatItEndedWith) {
  const auto cell = boxCell();
  ASSERT_NE(cell, nullptr);
  RunResult run = resultOf(RunMode::kAgents, false, 60.0, 0.02, 3);
  run.number = 12;
  run.reason = Text("it is stuck");
  run.strengths = {{"goal", 0.5}};
  const auto report = runJson(*cell, run);
  EXPECT_EQ(report["run"], 12);
  EXPECT_EQ(report["mode"], "agents");
  EXPECT_FALSE(report["solved"].get<bool>());
  EXPECT_EQ(report["reason"], "it is stuck");
  EXPECT_EQ(report["strengths"]["goal"], 0.5);
  EXPECT_FALSE(report.contains("rula"));
  EXPECT_FALSE(report.contains("seen"));
}

}  // namespace
}  // namespace hapticell::cli
