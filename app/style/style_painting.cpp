// SPDX-License-Identifier: Apache-2.0
#include "app/style/style_painting.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QPainterPath>
#include <QRegularExpression>
#include <QToolButton>
#include <algorithm>

#include "app/style/fonts.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

constexpr int kLeastHandle = 28;                    ///< px of a scroll bar.
constexpr int kListMargin = 16, kWidestList = 480;  ///< px of a combo box's list.

bool has(const QStyleOption* option, QStyle::StateFlag flag) {
  return option->state.testFlag(flag);
}

QColor blended(const QColor& a, const QColor& b, double share) {
  return QColor::fromRgbF(static_cast<float>(a.redF() + (b.redF() - a.redF()) * share),
                          static_cast<float>(a.greenF() + (b.greenF() - a.greenF()) * share),
                          static_cast<float>(a.blueF() + (b.blueF() - a.blueF()) * share));
}

/// An icon's shape in a colour of the ground that it is drawn on; none stays none.
QIcon inOneColor(const QIcon& icon, const QSize& size, const QColor& color) {
  if (icon.isNull()) return icon;
  constexpr qreal kSharp = 2.0;  // Enough for screens of twice the pixels.
  QPixmap shape = icon.pixmap(size, kSharp);
  QPainter painter(&shape);
  painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
  painter.fillRect(QRect(QPoint(), size), color);
  painter.end();
  return QIcon(shape);
}

/// A panel's main button, or in a dialog the one that Enter presses.
bool isMain(const QStyleOption* option, const QWidget* widget) {
  const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
  return (button && button->features.testFlag(QStyleOptionButton::DefaultButton)) ||
         (widget && widget->property("main").toBool());
}

}  // namespace

std::array<float, 3> channelsOf(const QColor& color) {
  return {color.redF(), color.greenF(), color.blueF()};
}

void drawBox(QPainter* painter, const QRect& rect, const QColor& fill, const QColor& frame, double radius) {
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(frame.isValid() ? QPen(frame, 1.0) : QPen(Qt::NoPen));
  painter->setBrush(fill.isValid() ? QBrush(fill) : QBrush(Qt::NoBrush));
  const double inset = frame.isValid() ? 0.5 : 0.0;
  painter->drawRoundedRect(QRectF(rect).adjusted(inset, inset, -inset, -inset), radius, radius);
  painter->restore();
}

void drawButtonPanel(QPainter* painter, const QStyleOption* option, const QWidget* widget) {
  const Theme& theme = themeOf(option->palette);
  const bool main = isMain(option, widget);
  const bool quiet = widget && (widget->property("quiet").toBool() || qobject_cast<const QToolButton*>(widget));
  const bool enabled = has(option, QStyle::State_Enabled);
  const bool down = has(option, QStyle::State_Sunken);
  const bool on = has(option, QStyle::State_On);
  const bool hover = has(option, QStyle::State_MouseOver) && enabled;
  if (widget && widget->property("recording").toBool()) drawBox(painter, option->rect, QColor(), theme.contact);
  if (quiet && !down && !on && !hover) return;
  QColor fill = theme.button;
  QColor frame = theme.line;
  if (main && enabled) {
    fill = theme.on;
    frame = theme.on;
  }
  if (on) {
    fill = quiet ? theme.selected_row : theme.on;
    frame = quiet ? theme.selection : theme.on;
  }
  if (hover) fill = blended(fill, theme.text1, 0.08);
  if (down) fill = blended(fill, theme.window, 0.35);
  if (!enabled && !main) fill = theme.dock;
  if (!enabled && main) fill = blended(theme.dock, theme.on, 0.35), frame = fill;
  const bool pill = widget && widget->property("pill").toBool();
  drawBox(painter, option->rect, fill, frame, pill ? 0.5 * option->rect.height() : kRadius);
}

void drawSwitch(QPainter* painter, const QStyleOption* option) {
  const Theme& theme = themeOf(option->palette);
  const bool on = has(option, QStyle::State_On);
  const bool enabled = has(option, QStyle::State_Enabled);
  QColor track = on ? theme.on : theme.button;
  QColor frame = on ? theme.on : theme.text3;
  QColor knob = on ? theme.on_text : theme.text2;
  if (!enabled) track = theme.dock, frame = theme.line, knob = theme.text3;
  const QRectF rect = QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(QPen(frame, 1.0));
  painter->setBrush(track);
  painter->drawRoundedRect(rect, rect.height() / 2, rect.height() / 2);
  const double radius = rect.height() / 2 - 2.5;
  const double x = on ? rect.right() - radius - 2.5 : rect.left() + radius + 2.5;
  painter->setPen(Qt::NoPen);
  painter->setBrush(knob);
  painter->drawEllipse(QPointF(x, rect.center().y()), radius, radius);
  const double cue_x = on ? rect.left() + rect.height() * 0.5 : rect.right() - rect.height() * 0.5;
  painter->setPen(QPen(on ? theme.on_text : theme.text3, 1.5, Qt::SolidLine, Qt::RoundCap));
  painter->setBrush(Qt::NoBrush);
  const double cue = rect.height() * 0.17;
  if (on) painter->drawLine(QPointF(cue_x, rect.center().y() - cue), QPointF(cue_x, rect.center().y() + cue));
  if (!on) painter->drawEllipse(QPointF(cue_x, rect.center().y()), cue, cue);
  painter->restore();
}

void drawIndicator(QPainter* painter, const QStyleOption* option, bool round) {
  const Theme& theme = themeOf(option->palette);
  const bool on = has(option, QStyle::State_On);
  const bool enabled = has(option, QStyle::State_Enabled);
  const QColor fill = on && enabled ? theme.on : theme.field;
  const QColor frame_off = enabled ? theme.text3 : theme.line;
  const QColor frame = on && enabled ? theme.on : frame_off;
  const QRect rect = option->rect;
  drawBox(painter, rect, fill, frame, round ? rect.height() / 2.0 : 3.0);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  const QColor mark = enabled ? theme.on_text : theme.text3;
  const QRectF r(rect);
  if (on && round) {
    painter->setPen(Qt::NoPen);
    painter->setBrush(mark);
    painter->drawEllipse(r.center(), r.width() * 0.2, r.width() * 0.2);
  } else if (on) {
    painter->setPen(QPen(mark, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter->drawPolyline(QPolygonF({QPointF(r.left() + 0.24 * r.width(), r.top() + 0.52 * r.height()),
                                     QPointF(r.left() + 0.43 * r.width(), r.top() + 0.70 * r.height()),
                                     QPointF(r.left() + 0.77 * r.width(), r.top() + 0.32 * r.height())}));
  }
  painter->restore();
}

void drawTabShape(QPainter* painter, const QStyleOptionTab* option) {
  const Theme& theme = themeOf(option->palette);
  const bool selected = has(option, QStyle::State_Selected);
  const bool hover = has(option, QStyle::State_MouseOver);
  const QColor behind = hover ? blended(theme.header, theme.text1, 0.05) : theme.header;
  painter->fillRect(option->rect, selected ? theme.dock : behind);
  if (selected)
    painter->fillRect(QRect(option->rect.left(), option->rect.top(), option->rect.width(), 2), theme.selection);
}

QString plainTabText(const QString& text) {
  static const QRegularExpression count(QStringLiteral(" \\(\\d+\\)$"));
  return QString(text).remove(count);
}

void drawTabLabel(QPainter* painter, const QStyleOptionTab* option, bool compact) {
  const Theme& theme = themeOf(option->palette);
  if (compact && !has(option, QStyle::State_Selected)) {
    const QPoint center = option->rect.center() + QPoint(0, 1);
    option->icon.paint(painter, QRect(center.x() - 8, center.y() - 8, 16, 16));
    return;
  }
  if (compact) {
    painter->setPen(theme.text1);
    const QRect room = option->rect.adjusted(4, 1, -4, 0);
    painter->drawText(room, Qt::AlignCenter,
                      painter->fontMetrics().elidedText(plainTabText(option->text), Qt::ElideRight, room.width()));
    return;
  }
  static const QRegularExpression counted(QStringLiteral("^(.*) \\((\\d+)\\)$"));
  const auto match = counted.match(option->text);
  const QString words = match.hasMatch() ? match.captured(1) : option->text;
  const QString count = match.hasMatch() && match.captured(2) != QStringLiteral("0") ? match.captured(2) : QString();
  const QRect rect = option->rect.adjusted(0, 1, 0, 0);
  painter->setPen(has(option, QStyle::State_Selected) ? theme.text1 : theme.text2);
  if (!match.hasMatch()) {
    painter->drawText(rect, Qt::AlignCenter, words);
    return;
  }
  const int left = rect.left() + 14;
  painter->drawText(QRect(left, rect.top(), rect.width(), rect.height()), Qt::AlignVCenter | Qt::AlignLeft, words);
  if (count.isEmpty()) return;
  const QRectF badge(left + painter->fontMetrics().horizontalAdvance(words) + 6, rect.center().y() - 7.5, 16, 16);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(Qt::NoPen);
  painter->setBrush(theme.near_miss);
  painter->drawEllipse(badge);
  painter->setFont(textFont(TextRole::kKeyCap));
  painter->setPen(theme.dark ? theme.window : theme.on_text);
  painter->drawText(badge, Qt::AlignCenter, count.size() > 1 ? QStringLiteral("9+") : count);
  painter->restore();
}

void drawChevron(QPainter* painter, const QRect& rect, const QColor& color) {
  const QPointF c = QRectF(rect).center();
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(QPen(color, 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter->drawPolyline(QPolygonF({c + QPointF(-3.5, -1.7), c + QPointF(0, 1.8), c + QPointF(3.5, -1.7)}));
  painter->restore();
}

void drawScrollBar(QPainter* painter, const QStyleOptionSlider* option, const QRect& handle) {
  const Theme& theme = themeOf(option->palette);
  if (option->maximum <= option->minimum) return;
  const bool hover = has(option, QStyle::State_MouseOver) || has(option, QStyle::State_Sunken);
  const QRect bar = option->orientation == Qt::Vertical ? handle.adjusted(3, 1, -3, -1) : handle.adjusted(1, 3, -1, -3);
  const double radius = std::min(bar.width(), bar.height()) / 2.0;
  drawBox(painter, bar, hover ? theme.text3 : theme.line, QColor(), radius);
}

QStyleOptionButton buttonLabel(const QStyleOptionButton& button, const QWidget* widget) {
  QStyleOptionButton label = button;
  const bool main = isMain(&button, widget);
  if ((!main && !has(&button, QStyle::State_On)) || !has(&button, QStyle::State_Enabled)) return label;
  const QColor color = themeOf(button.palette).on_text;
  label.palette.setColor(QPalette::ButtonText, color);
  if (main) label.icon = inOneColor(label.icon, label.iconSize, color);
  return label;
}

QRect scrollBarPart(const QStyleOptionSlider& bar, QStyle::SubControl part) {
  const bool vertical = bar.orientation == Qt::Vertical;
  const QRect groove = bar.rect;
  const int length = vertical ? groove.height() : groove.width();
  const int range = qMax(1, bar.maximum - bar.minimum);
  const int share = static_cast<int>(static_cast<qint64>(length) * bar.pageStep / (range + bar.pageStep));
  const int handle = bar.maximum > bar.minimum ? qMin(length, qMax(kLeastHandle, share)) : length;
  const int start =
      QStyle::sliderPositionFromValue(bar.minimum, bar.maximum, bar.sliderPosition, length - handle, bar.upsideDown);
  const auto along = [&](int from, int size) {
    return vertical ? QRect(groove.left(), from, groove.width(), size)
                    : QRect(from, groove.top(), size, groove.height());
  };
  switch (part) {
    case QStyle::SC_ScrollBarGroove:
      return groove;
    case QStyle::SC_ScrollBarSlider:
      return along(start, handle);
    case QStyle::SC_ScrollBarSubPage:
      return along(0, start);
    case QStyle::SC_ScrollBarAddPage:
      return along(start + handle, length - start - handle);
    default:
      return {};
  }
}

QRect choiceList(const QRect& field, const QComboBox* box) {
  if (box == nullptr) return field;
  const int words = box->view()->sizeHintForColumn(box->modelColumn()) + kListMargin;
  return QRect(field.left(), field.top(), qMax(field.width(), qMin(words, kWidestList)), field.height());
}

}  // namespace hapticell::app
