// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFont>

namespace hapticell::app {

/// The text sizes of the program. Sizes are pixels at 100 %.
enum class TextRole { kText, kSecond, kKeyCap, kDockTitle, kSection, kNumberOverScene, kPanelState, kPanelNumber, kScore };

/// Roboto if it is installed (its digits are equally wide, so numbers do not jump), else Noto Sans or DejaVu Sans.
QFont textFont(TextRole role);

}  // namespace hapticell::app
