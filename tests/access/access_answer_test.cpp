// SPDX-License-Identifier: Apache-2.0
#include "access/access_answer.h"

#include <algorithm>

#include "access/access_report.h"
#include "tests/access/access_cell.h"

namespace hapticell::access {
namespace {

AccessAnswer ask(const AccessQuestion& question) {
  const std::atomic<bool> cancel{false};
  auto answer = accessOf(question, {}, cancel);
  EXPECT_TRUE(answer) << answer.error().message();
  return std::move(*answer);
}

/// A block under a plate that `screws` screws hold: shanks in sockets, heads on the plate's rim.
AccessCell screwedDown(int screws) {
  AccessCell cell = boxedIn(0.002, true);
  // The lid cannot slide away under the heads.
  for (const double side : {-1.0, 1.0}) {
    cell.box(side < 0.0 ? "stop front" : "stop back", {0.1, 0.01, 0.01}, {0.0, 0.156 * side, 0.055}, true);
    cell.box(side < 0.0 ? "stop left" : "stop right", {0.005, 0.05, 0.01}, {0.153 * side, 0.1, 0.055}, true);
  }
  for (int i = 0; i < screws; ++i) {
    const double x = (i % 2 == 0 ? -1.0 : 1.0) * 0.165, y = 0.1 * (i / 2) - 0.1;
    const std::string name = "screw " + std::to_string(i + 1);
    cell.add("socket " + std::to_string(i + 1), geometry::makePipe(0.012, 0.0063, 0.1), {x, y, 0.01}, true);
    workcell::Entity& head = cell.add(name, geometry::makeCylinder(0.02, 0.01), {x, y, 0.065});
    const workcell::EntityId id = head.id;
    workcell::Entity& shank = cell.add(name + " shank", geometry::makeCylinder(0.006, 0.08), {x, y, 0.02});
    shank.attachment.to = name;
    shank.attachment.X_LE = Pose::translation({0.0, 0.0, -0.045});
    EXPECT_NE(id, shank.id);
  }
  return cell;
}

TEST(AccessAnswer, APartUnderAPlateThatScrewsHoldHasTheseFirst) {
  AccessQuestion question;
  question.scene = screwedDown(4).scene();
  question.part = "block";
  const AccessAnswer answer = ask(question);
  EXPECT_FALSE(answer.removable);
  EXPECT_EQ(answer.blocked_by, std::vector<std::string>{"lid"});
  ASSERT_EQ(answer.order.size(), 6u);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(answer.order[static_cast<std::size_t>(i)].name.substr(0, 5), "screw");
  EXPECT_EQ(answer.order[4].name, "lid");
  EXPECT_EQ(answer.order[5].name, "block");
  EXPECT_TRUE(answer.is_shortest);
  ASSERT_NE(answer.nearest(), nullptr);
  EXPECT_NEAR(answer.nearest()->least_m, 0.002, 1e-9);
  EXPECT_EQ(english(resultText("block", answer)), "block can be taken out once 5 parts have gone.");
  AccessAnswer short_order = answer;
  short_order.order.erase(short_order.order.begin(), short_order.order.begin() + 4);
  EXPECT_EQ(english(resultText("block", short_order)), "block can be taken out once lid has gone.");
}

TEST(AccessAnswer, WithoutTheLidItGoesAtOnce) {
  AccessQuestion question;
  question.scene = boxedIn(0.002, false).scene();
  question.part = "block";
  const AccessAnswer answer = ask(question);
  EXPECT_TRUE(answer.removable);
  EXPECT_TRUE(answer.blocked_by.empty());
  EXPECT_EQ(answer.order.size(), 1u);
}

TEST(AccessAnswer, BehindALockedLidThereIsNoWay) {
  AccessCell cell = boxedIn(0.002, false);
  cell.box("lid", {0.3, 0.3, 0.01}, {0.0, 0.0, 0.055}, true);
  AccessQuestion question;
  question.scene = cell.scene();
  question.part = "block";
  const AccessAnswer answer = ask(question);
  EXPECT_FALSE(answer.removable);
  EXPECT_TRUE(answer.order.empty());
  EXPECT_EQ(answer.step(), nullptr);
  EXPECT_NE(std::find(answer.blocked_by.begin(), answer.blocked_by.end(), "lid"), answer.blocked_by.end());
}

TEST(AccessAnswer, ARuleOfTheCellLeavesOutAPair) {
  AccessQuestion question;
  question.scene = boxedIn(0.002, true).scene({{.first = "block", .second = "lid", .checked = false}});
  question.part = "block";
  EXPECT_TRUE(ask(question).removable);
}

TEST(AccessAnswer, WrongQuestionsAreRefusedWithASentence) {
  const std::atomic<bool> cancel{false};
  AccessQuestion question;
  question.scene = boxedIn(0.002, true).scene();
  for (const auto& [part, words] : {std::pair("nothing", "no part is named"), std::pair("floor", "is locked")}) {
    question.part = part;
    const auto answer = accessOf(question, {}, cancel);
    ASSERT_FALSE(answer);
    EXPECT_NE(answer.error().message().find(words), std::string::npos) << answer.error().message();
  }
}

TEST(AccessReport, SaysOrderAndBlockers) {
  AccessQuestion question;
  question.scene = boxedIn(0.002, true).scene();
  question.part = "block";
  const auto page = accessReport(question, ask(question), {"cell", "2026-01-01", "en"},
                                 [](const Text& text) { return english(text); });
  const std::string csv = ergonomics::reportCsv(page);
  for (const char* words : {"Order of removal", "lid", "What blocks it", "wall left", "2.0 mm"})
    EXPECT_NE(csv.find(words), std::string::npos) << words << "\n" << csv;
}

}  // namespace
}  // namespace hapticell::access
