// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/report_budget.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "haptic/server/clock.h"

namespace hapticell::haptic {
namespace {

using Kind = ReportBudget::Kind;
using ::testing::HasSubstr;

struct Log {
  std::vector<std::string> lines;
  ReportBudget budget{[this](const std::string& line) { lines.push_back(line); }};
};

TEST(ReportBudget, AFewEventsAreAllTold) {
  Log log;
  for (int i = 0; i < 10; ++i) log.budget.tell(Kind::kRefused, "line " + std::to_string(i), toNanoseconds(1.0 + i));
  log.budget.summarize(toNanoseconds(100.0));
  EXPECT_EQ(log.lines.size(), 10u);
}

TEST(ReportBudget, AMinuteOfRefusalsIsAFewLinesThatSayHowMany) {
  Log log;
  std::size_t told = 0, bytes = 0;
  for (int ms = 0; ms < 60'000; ++ms) {
    const std::int64_t now = toNanoseconds(1000.0 + 1e-3 * ms);
    for (int k = 0; k < 10; ++k) log.budget.tell(Kind::kRefused, "Refused a program at 127.0.0.1:53412: why.", now);
    log.budget.summarize(now);
  }
  log.budget.summarize(toNanoseconds(1100.0));
  std::uint64_t counted = 0;
  for (const std::string& line : log.lines) {
    bytes += line.size();
    const std::string head = "Besides, since the last such line: ";
    if (line.starts_with(head))
      counted += std::stoull(line.substr(head.size()));
    else
      ++told;
  }
  EXPECT_EQ(told, 10u + 11u) << "ten at once and one every five seconds";
  EXPECT_EQ(told + counted, 600'000u) << "none is lost";
  EXPECT_LE(log.lines.size(), 21u + 8u);
  EXPECT_LT(bytes, 5000u);
}

TEST(ReportBudget, WatchersThatComeAndGoHideNothingOfTheController) {
  Log log;
  for (int i = 0; i < 1000; ++i) log.budget.tell(Kind::kWatcher, "w watches.", toNanoseconds(5.0));
  log.budget.tell(Kind::kController, "c controls the stylus.", toNanoseconds(5.0));
  EXPECT_EQ(log.lines.back(), "c controls the stylus.");
  log.budget.summarize(toNanoseconds(20.0));
  EXPECT_THAT(log.lines.back(), HasSubstr("990 comings and goings"));
}

}  // namespace
}  // namespace hapticell::haptic
