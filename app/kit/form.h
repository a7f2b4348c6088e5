// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "app/style/fonts.h"
#include "app/style/live_label.h"

class QBoxLayout;
class QHBoxLayout;
class QLabel;
class QScrollArea;
class QVBoxLayout;
class QWidget;

namespace hapticell::app {

/// Width of the column of names in front of fields.
constexpr int kLabelColumn = 84;

/// A label; quiet ones have the second text colour and follow the theme.
QLabel* makeLabel(const QString& text, TextRole role, bool quiet = false);

/// A label whose words change while the panel is used: it keeps the room of so many lines.
LiveLabel* makeLive(int lines, TextRole role, bool quiet = false);

/// A section of a panel: its own margins, a heading (empty: none), a line below.
QVBoxLayout* addSection(QVBoxLayout& column, const QString& heading);

/// A row "name, field". The field gets the name for screen readers. Returns the row's widget, so that it can be hidden.
QWidget* addRow(QVBoxLayout& section, const QString& name, QWidget* field, int label_width = kLabelColumn);

/// True while the user can see it: a dock that lies behind another tab is not, though Qt calls it visible.
bool isSeen(const QWidget& widget);

/// A panel that scrolls up and down where its dock is too low, never narrower than `minimum_width` pixels.
QScrollArea* scrolledPanel(QWidget* content, int minimum_width = 332);

/// Fields side by side in one row, equally wide.
QWidget* sideBySide(std::initializer_list<QWidget*> fields);

}  // namespace hapticell::app
