// SPDX-License-Identifier: Apache-2.0
#include "workcell/entity/import_options.h"

#include <gtest/gtest.h>

namespace hapticell::workcell {
namespace {

TEST(ImportOptions, AxesAreReadAsTheyAreWritten) {
  for (const UpAxis axis : {UpAxis::kX, UpAxis::kY, UpAxis::kZ}) {
    const auto read = parseAxis(axisName(axis));
    ASSERT_TRUE(read.has_value()) << axisName(axis);
    EXPECT_EQ(*read, axis);
  }
  EXPECT_STREQ(axisName(UpAxis::kY), "y");
  for (const char* bad : {"", "Z", "-z", "w", "xy"}) EXPECT_FALSE(parseAxis(bad).has_value()) << bad;
  EXPECT_LT(parseAxis(std::string(5000, 'q')).error().message().size(), 200u) << "a long word is cut in the sentence";
}

}  // namespace
}  // namespace hapticell::workcell
