// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/text_case.h"

#include <gtest/gtest.h>

namespace hapticell {
namespace {

TEST(TextCase, ChangesLettersOfAsciiOnly) {
  EXPECT_EQ(lowerCase("Tool_0 [@Z`{]"), "tool_0 [@z`{]");
  EXPECT_EQ(upperCase("Tool_0 [@z`{]"), "TOOL_0 [@Z`{]");
  EXPECT_EQ(lowerCase("K\xC3\x9CHLER"), "k\xC3\x9Chler") << "bytes of other letters stay, so UTF-8 does";
}

TEST(TextCase, ComparesWithoutIt) {
  EXPECT_TRUE(sameButForCase("HIERARCHY", "Hierarchy"));
  EXPECT_FALSE(sameButForCase("root", "roots"));
  EXPECT_FALSE(sameButForCase("[", "{"));
}

TEST(TextCase, GivesTheExtensionSmall) {
  EXPECT_EQ(lowerExtension("/a.b/Cell.STEP"), ".step");
  EXPECT_EQ(lowerExtension("Makefile"), "");
}

}  // namespace
}  // namespace hapticell
