// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/nesting_limit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hapticell::geometry {
namespace {

using ::testing::HasSubstr;

std::string repeated(const std::string& text, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) result += text;
  return result;
}

std::string said(const std::string& text, NestedText kind) {
  const auto checked = checkNesting(text, kind, "file");
  return checked ? "" : checked.error().message();
}

TEST(NestingLimit, Json) {
  const auto json = NestedText::kJson;
  EXPECT_EQ(said(repeated("[", 200) + repeated("]", 200), json), "");
  EXPECT_THAT(said("{\n\"a\":\n" + repeated("[", 200), json), HasSubstr("file, line 3: lists and objects nested deeper than 200"));
  EXPECT_NE(said(repeated("{\"a\":", 1'000'000), json), "");
  EXPECT_EQ(said("[\"" + repeated("[", 300) + "\\\"" + repeated("{", 300) + "\"]", json), "") << "brackets in a text";
  EXPECT_NE(said("[\"]\",[\"]\"," + repeated("[\"]\",", 300), json), "") << "closing ones in texts";
  EXPECT_EQ(said(repeated("[]", 100'000), json), "") << "side by side";
  EXPECT_NE(said(repeated("]", 1000) + repeated("[", 201), json), "") << "closed before it is open";
}

TEST(NestingLimit, MembersOfOneObject) {
  const std::string many = "{" + repeated("\"a\":1,", 2001) + "}";
  EXPECT_EQ(said(many, NestedText::kJson), "");
  EXPECT_THAT(said(many, NestedText::kOrderedJson), HasSubstr("more than 2000 members"));
  EXPECT_EQ(said("[" + repeated("{\"a\":1},", 10'000) + "]", NestedText::kOrderedJson), "") << "of many objects";
}

TEST(NestingLimit, Xml) {
  const auto xml = NestedText::kXml;
  EXPECT_EQ(said(repeated("<a>", 200) + repeated("</a>", 200), xml), "");
  EXPECT_THAT(said("<?xml?>\n" + repeated("<a>", 201), xml), HasSubstr("line 2: elements nested deeper than 200"));
  EXPECT_EQ(said("<a>" + repeated("<b/>", 10'000) + repeated("<b c='>'/>", 10'000) + "</a>", xml), "");
  EXPECT_EQ(said("<!--" + repeated("<a>", 300) + "--><a><![CDATA[" + repeated("<a>", 300) + "]]></a>", xml), "");
  EXPECT_NE(said(repeated("</a>", 1000) + repeated("<a>", 201), xml), "") << "closed before it is open";
  EXPECT_NE(said(repeated("<a b='/>'>", 201), xml), "") << "an end in a value";
  EXPECT_NE(said(repeated("<!-- </a> --><a>", 201), xml), "") << "an end in a comment";
  EXPECT_THAT(said("<a" + repeated(" b='c'", 201) + "/>", xml), HasSubstr("more than 200 attributes"));
  std::string wide;
  for (const char c : repeated("<a></a>", 300)) wide += {c, '\0'};
  EXPECT_EQ(said(wide, xml), "") << "UTF-16";
}

TEST(NestingLimit, Toml) {
  const auto toml = NestedText::kToml;
  EXPECT_THAT(said("# a.b\n" + repeated("a.", 50) + "a = 1", toml), HasSubstr("line 2: tables and lists nested deeper than 50"));
  EXPECT_NE(said(repeated("a .", 500'000) + "a=1", toml), "");
  EXPECT_NE(said("[" + repeated("'a'.", 50) + "a]", toml), "");
  EXPECT_NE(said("a = " + repeated("[", 51), toml), "");
  EXPECT_NE(said("a = " + repeated("{ a = ", 51), toml), "");
  EXPECT_EQ(said("a = [" + repeated("1.5, ", 1000) + "]\nb.c = 1.0\n" + repeated("c = 1.5\n", 100), toml), "");
  EXPECT_EQ(said("a = '" + repeated(".[", 100) + "'\nb = \"" + repeated("\\\".", 100) + "\" # " + repeated("..[", 100), toml), "");
  EXPECT_EQ(said("a = \"\"\"\n" + repeated(".[\"", 100) + "\"\"\"\nb = '''" + repeated("[.'", 100) + "'''\n", toml), "");
  EXPECT_NE(said("a = 'it\n" + repeated("b.", 50) + "b = 1", toml), "") << "behind a text without its end";
}

}  // namespace
}  // namespace hapticell::geometry
