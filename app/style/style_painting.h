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
constexpr int kHeaderMargin = 4;  ///< On either side of a heading.
constexpr int kRowHeight = 24;
constexpr double kRadius = 4.0;

/// Red, green and blue, 0 to 1, as in workcell::Entity::color.
std::array<float, 3> channelsOf(const QColor& color);

/// A box with a one-pixel frame whose lines are on whole pixels.
void drawBox(QPainter* painter, const QRect& rect, const QColor& fill, const QColor& frame, double radius = kRadius);

/// Push buttons and tool buttons: flat, framed, filled while down or on.
void drawButtonPanel(QPainter* painter, const QStyleOption* option, const QWidget* widget);

/// The switch: knob position and I / O show its state without colour too.
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

/// The small triangle of combo boxes and menus, pointing down.
void drawChevron(QPainter* painter, const QRect& rect, const QColor& color);

/// The options for drawing a button's label: the text of a button that is on, and the icon of a main button too, in the
/// colour that contrasts with the fill.
QStyleOptionButton buttonLabel(const QStyleOptionButton& button, const QWidget* widget);

/// A part of a scroll bar without buttons; its handle is 28 px long or more if there is room. Empty: no such part.
QRect scrollBarPart(const QStyleOptionSlider& bar, QStyle::SubControl part);

/// Rectangle from which a combo box at `field` opens its list: as wide as the words in it, within limits, and at least
/// as wide as `field`. `box` may be null.
QRect choiceList(const QRect& field, const QComboBox* box);

/// A narrow scroll bar without buttons.
void drawScrollBar(QPainter* painter, const QStyleOptionSlider* option, const QRect& handle);

}  // namespace hapticell::app
