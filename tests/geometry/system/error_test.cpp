// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/error.h"

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

TEST(Error, isOneReadableLineWhateverTheFileHeld) {
  EXPECT_EQ((Error{"a.toml", "line 1", "key 'a\nb\tc\x7F'", "", ""}).message(), "a.toml, line 1: key 'a b c '");
  const std::string message = Error{"a.toml", "", std::string(299, 'x') + "\xC3\xA4" + "end", "a word", ""}.message();
  EXPECT_EQ(message, "a.toml: " + std::string(299, 'x') + "...; expected a word") << "no half of a character";
}

}  // namespace
}  // namespace hapticell
