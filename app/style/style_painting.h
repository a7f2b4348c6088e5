// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QPainter>
#include <QRect>
#include <QStyleOption>
#include <array>

class QComboBox;

namespace hapticell::app {

constexpr int kFieldHeight = 26;
constexpr int kHeaderMargin = 4;  ///< Either side of a heading.
constexpr int kRowHeight = 24;
constexpr double kRadius = 4.0;

/// Red, green and blue, 0 .. 1, as workcell::Entity::color has them.
std::array<float, 3> channelsOf(const QColor& color);

/// A box with one-pixel frame whose lines lie on whole pixels.
void drawBox(QPainter* painter, const QRect& rect, const QColor& fill, const QColor& frame, double radius = kRadius);

/// Push buttons and tool buttons: flat, framed, filled while down or on.
void drawButtonPanel(QPainter* painter, const QStyleOption* option, const QWidget* widget);

/// The switch: knob position and I / O are its second cue.
void drawSwitch(QPainter* painter, const QStyleOption* option);

/// A check box or radio button.
void drawIndicator(QPainter* painter, const QStyleOption* option, bool round);

/// A tab with a line on top while it is the current one.
void drawTabShape(QPainter* painter, const QStyleOptionTab* option);

/// Draws a tab's text; a number in brackets at the end becomes a badge, except 0. `compact`: only the current tab shows
/// its name, the others their icon.
void drawTabLabel(QPainter* painter, const QStyleOptionTab* option, bool compact);
/// The name without the count at its end.
QString plainTabText(const QString& text);

/// The little triangle of combo boxes and menus, pointing down.
void drawChevron(QPainter* painter, const QRect& rect, const QColor& color);

/// How a button's label is drawn: the letters of what is on, and the icon of a main button too, in the colour that
/// stands on theirs.
QStyleOptionButton buttonLabel(const QStyleOptionButton& button, const QWidget* widget);

/// A part of a scroll bar without buttons, whose handle is 28 px long or more where there is room; empty: it has none.
QRect scrollBarPart(const QStyleOptionSlider& bar, QStyle::SubControl part);

/// Where a combo box at `field` opens its list: as wide as the words in it, within reason, and as itself. `box` may be
/// null.
QRect choiceList(const QRect& field, const QComboBox* box);

/// A narrow scroll bar without buttons.
void drawScrollBar(QPainter* painter, const QStyleOptionSlider* option, const QRect& handle);

}  // namespace hapticell::app
