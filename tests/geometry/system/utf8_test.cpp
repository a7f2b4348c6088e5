// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/utf8.h"

#include <gtest/gtest.h>

#include <string>

namespace hapticell {
namespace {

TEST(Utf8, ReadsCharactersOfAllLengths) {
  const std::string_view text = "aØ機😀";
  const char32_t expected[] = {'a', U'Ø', U'機', U'😀'};
  std::size_t at = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto [character, length] = characterAt(text, at);
    EXPECT_EQ(character, expected[i]);
    EXPECT_EQ(length, i + 1);
    at += length;
  }
  EXPECT_EQ(at, text.size());
  EXPECT_TRUE(isUtf8(text));
  EXPECT_TRUE(isUtf8(""));
}

TEST(Utf8, TakesNothingElseForACharacter) {
  for (const std::string_view bad :
       {"\x80", "\xC1\xBF", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xF5", "\xC3", "\xE6\xA9",
        "\xE6"
        "a"}) {
    EXPECT_EQ(characterAt(bad, 0).character, kNoCharacter);
    EXPECT_FALSE(isUtf8(bad));
    EXPECT_FALSE(isUtf8("a" + std::string(bad)));
  }
}

TEST(Utf8, PassesOverOnlyWhatIsNoCharacter) {
  EXPECT_EQ(characterAt("\xE6"
                        "a",
                        0)
                .length,
            1U);
  EXPECT_EQ(characterAt("\xE6\xA9"
                        "a",
                        0)
                .length,
            2U);
  EXPECT_EQ(characterAt("\xF5\x80", 0).length, 1U);
}

}  // namespace
}  // namespace hapticell
