// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/packed_text.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace hapticell {
namespace {

void expectRoundTrip(const Text& text) {
  const std::string line = packed(text);
  EXPECT_EQ(line.find('\n'), std::string::npos) << "one line";
  const auto back = unpackedText(line);
  ASSERT_TRUE(back.has_value()) << english(text);
  EXPECT_EQ(*back, text) << english(*back) << " instead of " << english(text);
}

/// `depth` texts, each the argument of the next.
Text nested(int depth) {
  Text text("the innermost");
  for (int i = 1; i < depth; ++i) text = Text("%1 within", text);
  return text;
}

TEST(PackedText, EveryKindOfArgumentComesBack) {
  constexpr auto kMost = std::numeric_limits<std::int64_t>::max(), kLeast = std::numeric_limits<std::int64_t>::min();
  for (const Text& text :
       {Text(), Text("no places"), Text("%1 touches %2", "box", "table"), Text("an empty name ''%1''", ""),
        Text("%1 of %2", kLeast, kMost), Text("%1 and %2", Text::Length{0.1 + 0.2}, Text::Length{-1e-300, true}),
        Text("turned by %1", Text::Angle{1.0 / 3.0}), Text("a length of %1", Text::Length{1e300}),
        Text(std::string("50 %1 of it")), Text("pièce %1", "Gehäuse")})
    expectRoundTrip(text);
}

TEST(PackedText, TextsWithinTextsComeBack) {
  expectRoundTrip(Text("%1, %2", Text("line %1", 12), Text("vertex %1 of %2", 3, 4)));
  expectRoundTrip(Text("%1: %2", Text(), Text("%1", Text())));
  for (int depth = 1; depth <= 10; ++depth) expectRoundTrip(nested(depth));
}

TEST(PackedText, TheIdOutlivesTheLine) {
  std::string line = packed(Text("an id of %1 that no other test has", 7));
  const auto back = unpackedText(line);
  line.assign(line.size(), 'x');
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->id(), "an id of %1 that no other test has");
  EXPECT_EQ(english(*back), "an id of 7 that no other test has");
}

TEST(PackedText, ControlCharactersBecomeBlanks) {
  const std::string controls(
      "a\nb\0c\x01"
      "d\x02"
      "e\x03"
      "f\x1F",
      12);
  const std::string line = packed(Text("%1 and %2", controls, 5));
  EXPECT_EQ(line.find_first_of(std::string("\n\0", 2)), std::string::npos);
  const auto back = unpackedText(line);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(*back, Text("%1 and %2", "a b c d e f ", 5));
}

TEST(PackedText, DamagedLinesAreRefused) {
  const std::string line =
      packed(Text("%1 %2 %3 %4", "name", 12, Text::Length{0.5}, Text("%1 within", Text::Angle{0.25})));
  ASSERT_TRUE(unpackedText(line).has_value());
  for (std::size_t size = 0; size < line.size(); ++size)
    EXPECT_FALSE(unpackedText(line.substr(0, size)).has_value()) << "the first " << size << " bytes";
  EXPECT_FALSE(unpackedText(line + " ").has_value());
  EXPECT_FALSE(unpackedText(line + line).has_value());
  EXPECT_FALSE(unpackedText("plain words").has_value());
  for (const std::string argument :
       {"n", "n12x", "n1.5", "n99999999999999999999", "l", "l0.5m", "a ", "lnone", "x1", "sa\x01", "sa\nb"}) {
    EXPECT_FALSE(unpackedText("\x01id %1\x03" + argument + "\x03\x02").has_value()) << argument;
  }
  EXPECT_TRUE(unpackedText("\x01id %1\x03n12\x03\x02").has_value());
}

TEST(PackedText, ChangedBytesAreRefusedOrGiveAnotherText) {
  const std::string line = packed(Text("%1 at %2", Text("line %1", 12), Text::Length{0.25, true}));
  for (std::size_t at = 0; at < line.size(); ++at) {
    for (const char c : {'\x01', '\x02', '\x03', 's', 't', '0', '\xFF'}) {
      std::string changed = line;
      changed[at] = c;
      const auto text = unpackedText(changed);
      if (text) {
        EXPECT_EQ(*unpackedText(packed(*text)), *text) << at;
      }
    }
  }
}

TEST(PackedText, TooMuchIsRefused) {
  EXPECT_FALSE(unpackedText(packed(nested(40))).has_value()) << "too deep";
  std::string open;
  for (int i = 0; i < 100'000; ++i) open += "\x01%1\x03t";
  EXPECT_FALSE(unpackedText(open).has_value()) << "without end";
  std::string many = "\x01id\x03";
  for (int i = 0; i < 1000; ++i) many += "n1\x03";
  EXPECT_FALSE(unpackedText(many + "\x02").has_value()) << "a thousand arguments";
}

TEST(PackedError, ComesBackWithoutItsFile) {
  const Error error{.file = "a.step",
                    .place = Text("line %1", 12),
                    .found = Text("%1 faces", 3),
                    .expected = "a solid",
                    .fix = "Export it again."};
  const auto back = unpackedError(packed(error));
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->file, "");
  EXPECT_EQ(back->place, error.place);
  EXPECT_EQ(back->found, error.found);
  EXPECT_EQ(back->expected, error.expected);
  EXPECT_EQ(back->fix, error.fix);
  ASSERT_TRUE(unpackedError(packed(Error{})).has_value()) << "all parts empty";
}

TEST(PackedError, DamagedLinesAreRefused) {
  const std::string line = packed(Error{.place = "header", .found = Text("%1 bytes", 80)});
  for (std::size_t size = 0; size < line.size(); ++size)
    EXPECT_FALSE(unpackedError(line.substr(0, size)).has_value()) << "the first " << size << " bytes";
  EXPECT_FALSE(unpackedError(line + ".").has_value());
  EXPECT_FALSE(unpackedError(packed(Text("one text only"))).has_value());
}

}  // namespace
}  // namespace hapticell
