// SPDX-License-Identifier: Apache-2.0
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

QColor withAlpha(const char* name, int alpha) {
  QColor color(name);
  color.setAlpha(alpha);
  return color;
}

constexpr int kLabelAlpha = 224;  // 12 % transparent.

Theme makeDark() {
  Theme theme;
  theme.dark = true;
  theme.window = "#22262B", theme.dock = "#272C32", theme.header = "#2E343B", theme.field = "#1B1F24";
  theme.line = "#3B434C", theme.button = "#363E47", theme.selected_row = "#234563";
  theme.text1 = "#E6EAEE", theme.text2 = "#AEB7C1", theme.text3 = "#8C97A3";
  theme.on = "#1B67AD", theme.on_text = "#FFFFFF";
  theme.contact = "#FF6A45", theme.near_miss = "#FFDD66", theme.limit = "#FFB8F0";
  theme.selection = "#3A9BFF", theme.scene.guide = "#1FC7A0", theme.scene.force = "#FFFFFF";
  theme.words.contact = theme.contact, theme.words.near_miss = theme.near_miss, theme.words.limit = theme.limit;
  theme.scene.axis_x = "#FF8A7A", theme.scene.axis_y = "#B6D44C", theme.scene.axis_z = "#7DB4FF";
  theme.score = {QColor("#8FB4D6"), QColor("#F2D35E"), QColor("#F09038"), QColor("#DB4417")};
  theme.scene.background_top = "#3B444F", theme.scene.background_bottom = "#20262D";
  theme.scene.grid = withAlpha("#8FA0B2", 72), theme.scene.crease = withAlpha("#0C0F12", 204);
  theme.scene.halo = withAlpha("#101418", 190);
  theme.scene.label_box = withAlpha("#1B1F24", kLabelAlpha);
  return theme;
}

Theme makeLight() {
  Theme theme;
  theme.dark = false;
  theme.window = "#E4E8EC", theme.dock = "#F4F6F8", theme.header = "#E7EBEF", theme.field = "#FFFFFF";
  theme.line = "#BCC5CE", theme.button = "#FFFFFF", theme.selected_row = "#CFE5FA";
  theme.text1 = "#1A2027", theme.text2 = "#45515D", theme.text3 = "#5F6C79";
  theme.on = "#0A6FCC", theme.on_text = "#FFFFFF";
  theme.contact = "#B82600", theme.near_miss = "#B98500", theme.limit = "#8A1F86";
  theme.selection = "#0A6FCC", theme.scene.guide = "#00806B", theme.scene.force = "#10151A";
  theme.words.contact = theme.text1, theme.words.near_miss = "#6E5000", theme.words.limit = theme.text1;
  theme.scene.axis_x = "#C0341D", theme.scene.axis_y = "#5B7A00", theme.scene.axis_z = "#1C5FC4";
  theme.score = {QColor("#8FB4D6"), QColor("#F2D35E"), QColor("#F09038"), QColor("#DB4417")};
  theme.scene.background_top = "#F4F6F8", theme.scene.background_bottom = "#D3DAE1";
  theme.scene.grid = withAlpha("#6B7885", 90), theme.scene.crease = withAlpha("#14181D", 204);
  theme.scene.halo = withAlpha("#FFFFFF", 210);
  theme.scene.label_box = withAlpha("#FFFFFF", kLabelAlpha);
  return theme;
}

}  // namespace

const Theme& darkTheme() {
  static const Theme theme = makeDark();
  return theme;
}

const Theme& lightTheme() {
  static const Theme theme = makeLight();
  return theme;
}

const Theme& themeOf(const QPalette& palette) {
  return palette.color(QPalette::Active, QPalette::Window).lightness() < 128 ? darkTheme() : lightTheme();
}

QPalette paletteOf(const Theme& theme) {
  QPalette palette;
  palette.setColor(QPalette::Window, theme.dock);
  palette.setColor(QPalette::WindowText, theme.text1);
  palette.setColor(QPalette::Base, theme.field);
  palette.setColor(QPalette::AlternateBase, theme.dock);
  palette.setColor(QPalette::ToolTipBase, theme.header);
  palette.setColor(QPalette::ToolTipText, theme.text1);
  palette.setColor(QPalette::PlaceholderText, theme.text3);
  palette.setColor(QPalette::Text, theme.text1);
  palette.setColor(QPalette::Button, theme.button);
  palette.setColor(QPalette::ButtonText, theme.text1);
  palette.setColor(QPalette::BrightText, theme.contact);
  palette.setColor(QPalette::Light, theme.header);
  palette.setColor(QPalette::Midlight, theme.header);
  palette.setColor(QPalette::Mid, theme.line);
  palette.setColor(QPalette::Dark, theme.line);
  palette.setColor(QPalette::Shadow, theme.window);
  palette.setColor(QPalette::Highlight, theme.on);
  palette.setColor(QPalette::HighlightedText, theme.on_text);
  palette.setColor(QPalette::Link, theme.selection);
  palette.setColor(kQuietText, theme.text2);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, theme.text3);
  palette.setColor(QPalette::Disabled, QPalette::Highlight, theme.line);
  palette.setColor(QPalette::Disabled, QPalette::HighlightedText, theme.text2);
  return palette;
}

}  // namespace hapticell::app
