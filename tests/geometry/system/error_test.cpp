// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/error.h"

#include <gtest/gtest.h>

namespace hapticell {
namespace {

TEST(Error, NamesFilePlaceFoundExpectedAndFix) {
  const Error error{.file = "door.stl",
                    .place = "line 12",
                    .found = "end of file",
                    .expected = "three numbers",
                    .fix = "Export the file again."};
  EXPECT_EQ(error.message(), "door.stl, line 12: end of file; expected three numbers. Export the file again.");
}

TEST(Error, LeavesOutWhatIsEmpty) {
  EXPECT_EQ((Error{.file = "door.stl", .found = "the file is empty"}).message(), "door.stl: the file is empty");
  EXPECT_EQ((Error{.expected = "a port from 1 to 65535"}).message(), "expected a port from 1 to 65535");
}

TEST(Error, IsOneReadableLineWhateverTheFileHeld) {
  EXPECT_EQ((Error{.file = "a.toml", .place = "line 1", .found = "key 'a\nb\tc\x7F'"}).message(),
            "a.toml, line 1: key 'a b c '");
  const std::string message =
      Error{.file = "a.toml", .found = std::string(299, 'x') + "\xC3\xA4" + "end", .expected = "a word"}.message();
  EXPECT_EQ(message, "a.toml: " + std::string(299, 'x') + "...; expected a word") << "no half of a character";
}

TEST(Error, AsATextSaysTheSame) {
  const Error whole{.file = "a.stl",
                    .place = Text("line %1", 12),
                    .found = "end of file",
                    .expected = "three numbers",
                    .fix = "Export the file again."};
  for (const Error& error : {whole, Error{.file = "a.stl", .found = "no text"},
                             Error{.place = "header", .fix = "Do it."}, Error{.expected = "a port"}, Error{}})
    EXPECT_EQ(english(error.text()), error.message());
}

}  // namespace
}  // namespace hapticell
