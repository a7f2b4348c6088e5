// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/markup.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "geometry/system/listed.h"

namespace hapticell {
namespace {

TEST(EscapedMarkup, MayStandBetweenTagsAndInAttributes) {
  EXPECT_EQ(escapedMarkup("plain, 'quoted', é"), "plain, 'quoted', é");
  EXPECT_EQ(escapedMarkup("<a href=\"x\">A & B</a>"), "&lt;a href=&quot;x&quot;&gt;A &amp; B&lt;/a&gt;");
  EXPECT_EQ(escapedMarkup("&lt;"), "&amp;lt;") << "an entity in a text is text";
  EXPECT_EQ(escapedMarkup(""), "");
}

TEST(Listed, NamesAllWithCommas) {
  struct Item {
    std::string name;
    int number;
  };
  EXPECT_EQ(listed(std::vector<std::string>{}), "");
  EXPECT_EQ(listed(std::vector<std::string>{"a"}), "a");
  EXPECT_EQ(listed(std::vector<const char*>{"a", "b", "c"}), "a, b, c");
  const std::vector<Item> items = {{"one", 1}, {"two", 2}};
  EXPECT_EQ(listed(items, &Item::name), "one, two");
  EXPECT_EQ(listed(items, [](const Item& item) { return std::to_string(item.number); }), "1, 2");
}

}  // namespace
}  // namespace hapticell
