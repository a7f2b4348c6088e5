// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QIcon>
#include <QString>

namespace hapticell::app {

/// One of the program's own line icons (app/style/icons/NAME.svg), painted in the text colour of the application's
/// palette at the time of drawing, so that it follows the theme; disabled: the third text colour. An unknown name gives
/// an empty icon.
QIcon icon(const QString& name);

/// The same in a fixed colour, for marks of state.
QIcon icon(const QString& name, const QColor& color);

}  // namespace hapticell::app
