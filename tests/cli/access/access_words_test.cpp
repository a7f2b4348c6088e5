// SPDX-License-Identifier: Apache-2.0
#include "cli/access/access_commands.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/kit/kept_words.h"

namespace hapticell::cli {
namespace {

TEST(AccessCommand, TakesItsWordsAndNeedsACell) {
  test::expectRefusals({addAccessCommand},
                       {{{"access", "a.hcell"}, "--part is required"},
                        {{"access", "a.hcell", "--part", "lid", "--percentile", "5,95", "--tool", "0.2,0.01"}, ""},
                        {{"access", "a.hcell", "--part", "lid", "--sex", "child"}, "--sex"},
                        {{"access", "a.hcell", "--part", "lid", "--glove", "0.06"}, "a number from 0 to 0.05"},
                        {{"access", "a.hcell", "--part", "lid", "--tool", "0.2"}, "--tool"},
                        {{"access", "a.hcell", "--part", "lid", "--mass", "nan"}, "--mass"}});
  test::OneCommand access({addAccessCommand});
  EXPECT_THAT(access.error({"access", "/none.hcell", "--part", "lid"}), ::testing::HasSubstr("none.hcell"));
}

}  // namespace
}  // namespace hapticell::cli
