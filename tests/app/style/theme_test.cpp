// SPDX-License-Identifier: Apache-2.0
#include "app/style/theme.h"

#include <gtest/gtest.h>

#include <vector>

#include "app/viewport/scene/pen_look.h"
#include "tests/app/style/colour_difference.h"

namespace hapticell::app {
namespace {

TEST(ColourDifference, AgreesWithThePublishedPairs) {
  // Sharma, Wu and Dalal 2005, table 1: pairs 1, 7, 17 and 25.
  EXPECT_NEAR(ciede2000Lab({50.0, 2.6772, -79.7751}, {50.0, 0.0, -82.7485}), 2.0425, 1e-4);
  EXPECT_NEAR(ciede2000Lab({50.0, 0.0, 0.0}, {50.0, -1.0, 2.0}), 2.3669, 1e-4);
  EXPECT_NEAR(ciede2000Lab({50.0, 2.5, 0.0}, {73.0, 25.0, -18.0}), 27.1492, 1e-4);
  EXPECT_NEAR(ciede2000Lab({60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}), 1.2644, 1e-4);
}

class Themes : public testing::TestWithParam<bool> {
 protected:
  const Theme& theme() const { return GetParam() ? darkTheme() : lightTheme(); }
};

TEST_P(Themes, StateColoursAreToldApartWithProtanAndDeutanVision) {
  const std::vector<std::pair<const char*, QColor>> states{
      {"contact", theme().contact},     {"near miss", theme().near_miss}, {"limit", theme().limit},
      {"selection", theme().selection}, {"guide", theme().scene.guide},   {"force", theme().scene.force}};
  for (const Vision vision : {Vision::kNormal, Vision::kProtan, Vision::kDeutan})
    for (std::size_t i = 0; i < states.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_GE(ciede2000(linearSeenBy(vision, states[i].second), linearSeenBy(vision, states[j].second)), 10.0)
            << states[i].first << " and " << states[j].first << " for vision " << static_cast<int>(vision);
}

TEST_P(Themes, TextIsReadableOnEveryGround) {
  for (const QColor& ground : {theme().dock, theme().header}) {
    EXPECT_GE(contrast(theme().text1, ground), 9.9);
    EXPECT_GE(contrast(theme().text2, ground), 5.9);
    EXPECT_GE(contrast(theme().text3, ground), 4.0);
  }
  EXPECT_GE(contrast(theme().on_text, theme().on), 4.5);
}

TEST_P(Themes, ThePaletteKnowsItsTheme) {
  EXPECT_EQ(themeOf(paletteOf(theme())).dark, GetParam());
}

TEST(PenColour, IsToldApartFromTheOtherPenItsBandAndTheGround) {
  for (const bool dark : {true, false}) {
    const Theme& theme = dark ? darkTheme() : lightTheme();
    const auto color = [&](bool second) {
      const auto rgb = penColor(second, dark);
      return QColor::fromRgbF(rgb[0], rgb[1], rgb[2]);
    };
    for (const Vision vision : {Vision::kNormal, Vision::kProtan, Vision::kDeutan}) {
      const auto apart = [&](const QColor& a, const QColor& b) {
        return ciede2000(linearSeenBy(vision, a), linearSeenBy(vision, b));
      };
      EXPECT_GE(apart(color(true), color(false)), 20.0);
      for (const QColor& other : {theme.selection, theme.scene.background_top, theme.scene.background_bottom}) {
        EXPECT_GE(apart(color(true), other), 20.0) << dark << other.name().toStdString();
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(DarkAndLight, Themes, testing::Bool());

}  // namespace
}  // namespace hapticell::app
