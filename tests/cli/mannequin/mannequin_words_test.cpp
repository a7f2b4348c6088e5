// SPDX-License-Identifier: Apache-2.0
#include "cli/mannequin/mannequin_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/kit/kept_words.h"

namespace hapticell::cli {
namespace {

TEST(MannequinCommand, TakesItsWordsAndRefusesOthers) {
  test::expectRefusals({addMannequinCommand},
                       {{{"mannequin"}, "--sex is required"},
                        {{"mannequin", "--sex", "male", "--percentile", "50", "--lock", "trunk", "feet"}, ""},
                        {{"mannequin", "--sex", "male", "--stature", "tall"}, "--stature"}});
  test::OneCommand mannequin({addMannequinCommand});
  EXPECT_THAT(mannequin.error({"mannequin", "--sex", "child", "--percentile", "50"}), ::testing::HasSubstr("male or female"));
  test::OneCommand sizeless({addMannequinCommand});
  EXPECT_THAT(sizeless.error({"mannequin", "--sex", "male"}), ::testing::HasSubstr("no body size"));
  test::OneCommand twice({addMannequinCommand});
  EXPECT_THAT(twice.error({"mannequin", "--sex", "male", "--percentile", "50", "--stature", "1.8"}),
              ::testing::HasSubstr("both --percentile and --stature"));
  test::OneCommand tall({addMannequinCommand});
  EXPECT_EQ(tall.run({"mannequin", "--sex", "female", "--stature", "1.7"}), ExitStatus::kDone);
  ASSERT_EQ(tall.kept.results.size(), 1U);
  EXPECT_THAT(tall.kept.results[0].dump(), ::testing::HasSubstr("1.7"));
}

}  // namespace
}  // namespace hapticell::cli
