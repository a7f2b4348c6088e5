// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QPalette>
#include <array>

namespace hapticell::app {

/// Colours of the scene and of what is drawn over it.
struct SceneTheme {
  QColor axis_x, axis_y, axis_z;
  QColor guide, force;
  QColor background_top, background_bottom;
  QColor grid, crease;  ///< Lines of the floor and of parts.
  QColor halo;          ///< Behind everything that is drawn over the scene.
  QColor label_box;     ///< Boxes over the scene, 12 % transparent.
};

/// State words: coloured in the dark theme, text colour in the light one.
struct StateWordTheme {
  QColor contact, near_miss, limit;
};

/// Every colour of the program, by role. A value.
struct Theme {
  bool dark = true;
  QColor window, dock, header, field;
  QColor line, button, selected_row;
  QColor text1, text2, text3;  ///< Text, second lines, disabled.
  QColor on, on_text;          ///< Switched on and main buttons.
  QColor contact, near_miss, limit, selection;
  StateWordTheme words;
  std::array<QColor, 4> score;  ///< 1-2, 3-4, 5-6, 7.
  SceneTheme scene;
};

const Theme& darkTheme();
const Theme& lightTheme();

/// The theme that a palette belongs to: by the lightness of its window colour, so no global state is needed.
const Theme& themeOf(const QPalette& palette);

/// The role for the second text colour (QPalette has no role for it): labels and second lines.
constexpr QPalette::ColorRole kQuietText = QPalette::LinkVisited;

/// The Qt palette of a theme, all three colour groups.
QPalette paletteOf(const Theme& theme);

}  // namespace hapticell::app
