// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/scores/score_words.h"

#include <gtest/gtest.h>

namespace hapticell::ergonomics {
namespace {

TEST(ScoreWords, FrenchIsThatOfTheCatalogue) {
  EXPECT_EQ(word("trunk forward", Language::kEnglish), "trunk forward");
  EXPECT_EQ(word("trunk forward", Language::kFrench), "tronc en avant");
  EXPECT_EQ(word("upper_arm", Language::kFrench), "upper_arm") << "what nobody translates stays";
  EXPECT_EQ(word("", Language::kFrench), "");
}

TEST(ScoreWords, APhraseHasTheSignsOfItsLanguage) {
  EXPECT_EQ(phrase("%1: %2", {"a", "%1"}, Language::kEnglish), "a: %1");
  EXPECT_EQ(phrase("%1: %2", {"a", "%1"}, Language::kFrench), "a : %1");
}

TEST(ScoreWords, PartsOfAnArmAreSaidWithTheirSide) {
  EXPECT_EQ(rulaPart(Rula::kWristTwist, mannequin::Side::kRight, Language::kEnglish), "right wrist twist");
  EXPECT_EQ(rulaPart(Rula::kLowerArm, mannequin::Side::kLeft, Language::kFrench), "avant-bras gauche");
  EXPECT_EQ(rulaPart(Rula::kForceBody, mannequin::Side::kLeft, Language::kEnglish), "force, body");
  EXPECT_EQ(rebaPart(Reba::kWrist, mannequin::Side::kLeft, Language::kFrench), "poignet gauche");
  EXPECT_EQ(rebaPart(Reba::kActivity, mannequin::Side::kLeft, Language::kEnglish), "activity");
}

TEST(ScoreWords, ALanguageIsKnownByItsCode) {
  for (const Language language : {Language::kEnglish, Language::kFrench})
    EXPECT_EQ(languageOf(codeOf(language)), language);
  EXPECT_EQ(languageOf("fr_CA"), Language::kFrench);
  EXPECT_EQ(languageOf("C"), Language::kEnglish);
}

}  // namespace
}  // namespace hapticell::ergonomics
