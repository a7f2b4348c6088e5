// SPDX-License-Identifier: Apache-2.0
#include "workcell/text/xml_text.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace hapticell::workcell {
namespace {

TEST(XmlText, SoundTextStaysAsItIs) {
  const std::string text = "<a name=\"é\"/>\n<!-- 漢字 \xF0\x9F\xA6\xBE -->";
  const XmlText sound = soundXmlText(text);
  EXPECT_EQ(sound.text, text);
  EXPECT_EQ(sound.replaced, 0u);
  EXPECT_EQ(sound.line, 0u);
}

TEST(XmlText, WhatIsNoUtf8IsTakenForLatin1AndTold) {
  const XmlText sound = soundXmlText(
      "<a/>\n<!-- pi\xE8"
      "ce \xC3 \x80 -->\n");  // Latin-1, half a character, and a control of Latin-1
  EXPECT_EQ(sound.text, "<a/>\n<!-- pièce Ã ? -->\n");
  EXPECT_EQ(sound.replaced, 3u);
  EXPECT_EQ(sound.line, 2u);
}

TEST(XmlText, ATextThatEndsWithinACharacterIsEndedBeforeIt) {
  EXPECT_EQ(soundXmlText("ab\xF0\x9F\xA6").text, "abð?¦");
  EXPECT_EQ(soundXmlText("\xC0\x80").text, "À?") << "an overlong nought";
  EXPECT_EQ(soundXmlText("\xF5\x80\x80\x80").text, "õ???") << "beyond Unicode";
}

RC_GTEST_PROP(XmlTextProperty, ItIsSoundThen, (const std::string& text)) {
  const XmlText sound = soundXmlText(text);
  RC_ASSERT(sound.text.size() >= text.size() && sound.text.size() <= text.size() + sound.replaced);
  RC_ASSERT(soundXmlText(sound.text).replaced == 0u);
}

RC_GTEST_PROP(XmlTextProperty, WhatIsLatin1IsReadWhole, ()) {
  // Accented letters with a space behind each: no two of them make a character of UTF-8.
  const auto letters = *rc::gen::container<std::string>(
      rc::gen::map(rc::gen::inRange(0xA0, 0x100), [](int letter) { return static_cast<char>(letter); }));
  std::string text, expected;
  for (const char letter : letters) {
    const auto code = static_cast<unsigned char>(letter);
    text += letter;
    text += ' ';
    expected += code < 0xC0 ? '\xC2' : '\xC3';
    expected += static_cast<char>(code < 0xC0 ? code : code - 0x40);
    expected += ' ';
  }
  RC_ASSERT(soundXmlText(text).text == expected);
}

}  // namespace
}  // namespace hapticell::workcell
