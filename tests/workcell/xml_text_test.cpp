// SPDX-License-Identifier: Apache-2.0
#include "workcell/xml_text.h"

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

TEST(XmlText, WhatIsNoUtf8BecomesQuestionMarksAndIsTold) {
  const XmlText sound = soundXmlText(
      "<a/>\n<!-- pi\xE8"
      "ce \xC3 -->\n");  // Latin-1, and half a character
  EXPECT_EQ(sound.text, "<a/>\n<!-- pi?ce ? -->\n");
  EXPECT_EQ(sound.replaced, 2u);
  EXPECT_EQ(sound.line, 2u);
}

TEST(XmlText, ATextThatEndsWithinACharacterIsEndedBeforeIt) {
  EXPECT_EQ(soundXmlText("ab\xF0\x9F\xA6").text, "ab???");
  EXPECT_EQ(soundXmlText("\xC0\x80").text, "??") << "an overlong nought";
  EXPECT_EQ(soundXmlText("\xF5\x80\x80\x80").text, "????") << "beyond Unicode";
}

RC_GTEST_PROP(XmlTextProperty, itIsSoundThenAndAsLong, (const std::string& text)) {
  const XmlText sound = soundXmlText(text);
  RC_ASSERT(sound.text.size() == text.size());
  RC_ASSERT(soundXmlText(sound.text).replaced == 0u);
}

}  // namespace
}  // namespace hapticell::workcell
