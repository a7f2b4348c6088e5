// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "app/style/fonts.h"
#include "app/style/live_label.h"

class QBoxLayout;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QScrollArea;
class QVBoxLayout;
class QWidget;

namespace hapticell::app {

/// Width of the column of names in front of fields.
constexpr int kLabelColumn = 84;

/// A label; if `quiet`, in the second text colour. It follows the theme.
QLabel* makeLabel(const QString& text, TextRole role, bool quiet = false);

/// A label whose text changes while the panel is used: it always has the height of `lines` lines.
LiveLabel* makeLive(int lines, TextRole role, bool quiet = false);

/// A section of a panel: its own margins, a heading (empty: none), a line below.
QVBoxLayout* addSection(QVBoxLayout& column, const QString& heading);

/// Adds a row "name, field"; the name is for screen readers too. Returns the row's widget, so that it can be hidden.
QWidget* addRow(QVBoxLayout& section, const QString& name, QWidget* field, int label_width = kLabelColumn);

/// True if the user can see it: a dock behind another tab is not seen, though Qt calls it visible.
bool isSeen(const QWidget& widget);

/// A panel that scrolls vertically if its dock is too low, never narrower than `minimum_width` pixels.
QScrollArea* scrolledPanel(QWidget* content, int minimum_width = 332);

/// A button with its name for tests, and what it does as a tool tip.
QPushButton* makeButton(const char* name, const QString& text, const QString& tip = {});

/// Fields side by side in one row, equally wide.
QWidget* sideBySide(std::initializer_list<QWidget*> fields);

}  // namespace hapticell::app
