// SPDX-License-Identifier: Apache-2.0
#include "cli/live/live_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/live/live_options.h"
#include "tests/cli/kit/kept_words.h"

namespace hapticell::cli {
namespace {

TEST(LiveCommand, TakesItsWordsAndNeedsACell) {
  test::expectRefusals({addLiveCommand},
                       {{{"live"}, "--workcell is required"},
                        {{"live", "--workcell", "a.hcell", "--rate", "0.5"}, "--rate"},
                        {{"live", "--workcell", "a.hcell", "--port", "65536"}, "--port"},
                        {{"live", "--workcell", "a.hcell", "--motion", "a.csv", "--repeat", "--seconds", "1"}, ""}});
  test::OneCommand live({addLiveCommand});
  EXPECT_THAT(live.error({"live", "--workcell", "/none.hcell"}), ::testing::HasSubstr("none.hcell"));
}

TEST(LiveView, SaysWhereViewersConnect) {
  test::KeptWords kept;
  const ListenerOfThread listening(kept);
  auto live = LiveView::open({"127.0.0.1", 0});
  ASSERT_TRUE(live) << live.error().message();
  EXPECT_EQ(live->address(), "ws://127.0.0.1:" + std::to_string(live->server().port()));
  ASSERT_EQ(kept.warnings.size(), 1U);
  EXPECT_THAT(english(kept.warnings[0]), ::testing::HasSubstr(live->address()));
  const auto taken = LiveView::open({"127.0.0.1", live->server().port()});
  ASSERT_FALSE(taken) << "somebody listens there";
  EXPECT_EQ(kept.warnings.size(), 1U);
}

TEST(LiveView, OtherMachinesNeedACode) {
  test::KeptWords kept;
  const ListenerOfThread listening(kept);
  const auto live = LiveView::open({"0.0.0.0", 0});
  ASSERT_TRUE(live) << live.error().message();
  const std::string& address = live->address();
  const std::size_t slash = address.rfind(char(47));
  EXPECT_GT(slash, address.find("0.0.0.0")) << address;
  EXPECT_GE(address.size() - slash, 9U) << "a code that is not guessed";
  ASSERT_EQ(kept.warnings.size(), 2U);
  EXPECT_THAT(english(kept.warnings[1]), ::testing::HasSubstr("not encrypted"));
}

}  // namespace
}  // namespace hapticell::cli
