// SPDX-License-Identifier: Apache-2.0
#include "geometry/error.h"

#include <gtest/gtest.h>

namespace hapticell {
namespace {

TEST(Error, namesFilePlaceFoundExpectedAndFix) {
  const Error error{"door.stl", "line 12", "end of file", "three numbers", "Export the file again."};
  EXPECT_EQ(error.message(), "door.stl, line 12: end of file; expected three numbers. Export the file again.");
}

TEST(Error, leavesOutWhatIsEmpty) {
  EXPECT_EQ((Error{"door.stl", "", "the file is empty", "", ""}).message(), "door.stl: the file is empty");
  EXPECT_EQ((Error{"", "", "", "a port from 1 to 65535", ""}).message(), "expected a port from 1 to 65535");
}

}  // namespace
}  // namespace hapticell
