// SPDX-License-Identifier: Apache-2.0
#include "cli/access/access_json.h"

#include <gtest/gtest.h>

#include <atomic>

#include "tests/access/access_cell.h"

namespace hapticell::cli {
namespace {

nlohmann::ordered_json asked(const access::AccessCell& cell, const std::string& part) {
  access::AccessQuestion question;
  question.scene = cell.scene();
  question.part = part;
  const std::atomic<bool> cancel{false};
  const auto answer = access::accessOf(question, {}, cancel);
  EXPECT_TRUE(answer) << (answer ? "" : answer.error().message());
  return answer ? accessJson(question, *answer) : nlohmann::ordered_json();
}

TEST(AccessJson, OfAPartThatComesOutNamesItsWay) {
  const auto answer = asked(access::boxedIn(0.002, false), "block");
  EXPECT_EQ(answer["part"], "block");
  EXPECT_TRUE(answer["removable"].get<bool>());
  EXPECT_TRUE(answer["blocked_by"].empty());
  EXPECT_EQ(answer["order"], nlohmann::ordered_json::array({"block"}));
  ASSERT_EQ(answer["steps"].size(), 1U);
  EXPECT_NEAR(answer["steps"][0]["direction"][2].get<double>(), 1.0, 1e-9) << "the box is open at the top";
  EXPECT_GT(answer["steps"][0]["length_m"].get<double>(), 0.1) << "higher than the walls";
  EXPECT_FALSE(answer.contains("path"));
  EXPECT_TRUE(answer["reach"].empty()) << "nobody was asked for";
  EXPECT_TRUE(answer["scores"].is_object());
}

TEST(AccessJson, OfAPartUnderALidTellsTheOrder) {
  const auto answer = asked(access::boxedIn(0.002, true), "block");
  EXPECT_FALSE(answer["removable"].get<bool>());
  EXPECT_EQ(answer["blocked_by"], nlohmann::ordered_json::array({"lid"}));
  EXPECT_EQ(answer["order"], nlohmann::ordered_json::array({"lid", "block"}));
  EXPECT_TRUE(answer["order_is_shortest"].get<bool>());
  EXPECT_EQ(answer["steps"].size(), 2U);
  bool is_up_blocked_by_lid = false;
  for (const auto& way : answer["straight_ways"]) {
    EXPECT_FALSE(way["blocked_by"].empty()) << "no straight way is free";
    if (way["direction"][2].get<double>() < 0.999) continue;
    is_up_blocked_by_lid = way["blocked_by"] == nlohmann::ordered_json::array({"lid"}) && !way["by_fixed"].get<bool>();
  }
  EXPECT_TRUE(is_up_blocked_by_lid) << answer["straight_ways"];
  EXPECT_NE(answer["result"].get<std::string>().find("once lid has gone"), std::string::npos) << answer["result"];
}

}  // namespace
}  // namespace hapticell::cli
