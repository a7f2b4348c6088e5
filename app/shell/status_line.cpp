// SPDX-License-Identifier: Apache-2.0
#include "app/shell/status_line.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/controls/severity_face.h"
#include "app/style/fonts.h"
#include "app/style/icon.h"
#include "app/style/plain_lines.h"
#include "app/style/theme.h"
#include "app/style/units.h"
#include "app/viewport/overlay/overlay_painter.h"

namespace hapticell::app {
namespace {

// ms that a message stays, time to read two lines; all are in the panel Messages. Half: long ones are missed; twice:
// old ones stand beside new work.
constexpr int kMessageMilliseconds = 8000;
constexpr int kRateWidth = 152;
/// ms: quicker nobody reads them, and each painting composes the whole window. Half: twice that; twice: rates of the
/// past.
constexpr int kRatesMilliseconds = 500;

}  // namespace

StatusLine::StatusLine(QWidget* parent) : QStatusBar(parent) {
  setSizeGripEnabled(false);
  setFixedHeight(26);
  setObjectName("statusLine");
  setAttribute(Qt::WA_OpaquePaintEvent);  // The window behind it need not be painted when a rate changes.
  message_timer_.setSingleShot(true);
  connect(&message_timer_, &QTimer::timeout, this, &StatusLine::clearMessage);
}

void StatusLine::setSentence(Mark mark, const QString& sentence) {
  if (mark == mark_ && sentence == sentence_) return;
  mark_ = mark;
  sentence_ = sentence;
  setAccessibleDescription(sentence);
  update();
}

void StatusLine::setRates(const Rates& rates) {
  const bool full = rates.haptic_full == rates_.haptic_full && rates.collision_full == rates_.collision_full &&
                    rates.window_full == rates_.window_full;
  const bool began = rates.idle != rates_.idle || (rates.haptic_hz > 0.0) != (rates_.haptic_hz > 0.0) ||
                     (rates.collision_hz > 0.0) != (rates_.collision_hz > 0.0);
  if (full && !began && rates_shown_.isValid() && !rates_shown_.hasExpired(kRatesMilliseconds)) return;
  const bool haptic = haptic_.take(rates.haptic_hz, rates.idle ? SteadyNumber::kAtRest : 1.0);
  const bool collision = !rates.idle && collision_.take(rates.collision_hz);
  const bool window = !rates.idle && window_.take(rates.window_hz);
  if (!window && !haptic && !collision && full && !began) return;
  rates_ = rates;
  rates_.haptic_hz = haptic_.shown();
  rates_.collision_hz = collision_.shown();
  rates_.window_hz = window_.shown();
  rates_shown_.start();
  update();
}

void StatusLine::setDevice(const QString& text, bool works) {
  if (text == device_ && works == device_works_) return;
  device_ = text;
  device_works_ = works;
  update();
}

void StatusLine::setSound(const QString& text, bool on) {
  if (text == sound_ && on == sound_on_) return;
  sound_ = text;
  sound_on_ = on;
  update();
}

void StatusLine::show(const Message& message) {
  severity_ = message.severity;
  message_ = plainLines(message.text.isEmpty() ? message.title : message.title + ". " + message.text);
  setToolTip(QStringLiteral("<qt>%1</qt>").arg(message_.toHtmlEscaped()));  // So that it is wrapped.
  setCursor(Qt::PointingHandCursor);
  message_timer_.start(kMessageMilliseconds);
  update();
}

void StatusLine::clearMessage() {
  message_.clear();
  setToolTip({});
  unsetCursor();
  update();
}

void StatusLine::mouseReleaseEvent(QMouseEvent* event) {
  const bool clicked = event->button() == Qt::LeftButton;
  if (clicked && !message_.isEmpty() && rect().contains(event->position().toPoint())) emit messageClicked();
}

int StatusLine::paintRate(QPainter& painter, int right, const QString& name, double value, double full,
                          bool idle) const {
  const Theme& theme = themeOf(palette());
  const int left = right - kRateWidth;
  painter.fillRect(QRect(left, 6, 1, height() - 12), theme.line);
  painter.setPen(theme.text2);
  painter.drawText(QRect(left + 12, 0, 60, height()), Qt::AlignVCenter | Qt::AlignLeft, name);
  if (idle) value = 0.0;
  const QString resting = idle ? tr("idle") : tr("off");
  const QString number = value > 0.0 ? tr("%1 Hz").arg(std::lround(value)) : resting;
  painter.setPen(value > 0.0 ? theme.text1 : theme.text3);
  painter.drawText(QRect(left + 50, 0, 58, height()), Qt::AlignVCenter | Qt::AlignRight, number);
  const QRectF bar(left + 114, 0.5 * height() - 2.0, 28, 4);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.line);
  painter.drawRoundedRect(bar, 2, 2);
  if (value > 0.0) {
    painter.setBrush(theme.scene.axis_z);
    painter.drawRoundedRect(
        QRectF(bar.left(), bar.top(), bar.width() * std::clamp(value / full, 0.08, 1.0), bar.height()), 2, 2);
  }
  return left;
}

void StatusLine::paintSentence(QPainter& painter, const QRect& rect) const {
  const Theme& theme = themeOf(palette());
  const bool telling = !message_.isEmpty();
  const QPointF mark_at(rect.left() + 8.0, rect.center().y() + 0.5);
  if (!telling && mark_ != Mark::kNone) {
    paintMark(painter, mark_, mark_at, 10, theme);
  } else {
    const Severity severity = telling ? severity_ : Severity::kInformation;
    const bool notes = severity == Severity::kInformation;
    icon(severityIcon(severity), notes ? theme.text2 : severityColor(severity, theme))
        .paint(&painter, QRect(rect.left(), rect.center().y() - 7, 16, 16));
  }
  const QString text = telling ? message_ : sentence_;
  const QRect text_rect = rect.adjusted(24, 0, 0, 0);
  painter.setPen(theme.text1);
  painter.drawText(text_rect, Qt::AlignVCenter | Qt::AlignLeft,
                   painter.fontMetrics().elidedText(text, Qt::ElideRight, text_rect.width()));
}

void StatusLine::paintEvent(QPaintEvent*) {
  const Theme& theme = themeOf(palette());
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), theme.window);
  painter.fillRect(QRect(0, 0, width(), 1), theme.line);
  painter.setFont(textFont(TextRole::kSecond));
  int right = width();
  const auto cell = [&](const QString& whole, const QString& icon_name = {}, const QColor& color = {}) {
    // The sentence of state is what the line is for: what stands beside it is cut first.
    const QString text = painter.fontMetrics().elidedText(whole, Qt::ElideRight, width() / 5);
    const int room = icon_name.isEmpty() ? 12 : 34;
    const int wide = painter.fontMetrics().horizontalAdvance(text) + room + 12;
    painter.setPen(icon_name.isEmpty() ? theme.text2 : theme.text1);
    painter.fillRect(QRect(right - wide, 6, 1, height() - 12), theme.line);
    painter.drawText(QRect(right - wide + room, 0, wide, height()), Qt::AlignVCenter | Qt::AlignLeft, text);
    if (!icon_name.isEmpty())
      icon(icon_name, color).paint(&painter, QRect(right - wide + 12, height() / 2 - 8, 16, 16));
    right -= wide;
  };
  cell(unitsNow().lengthUnit() + QStringLiteral(" · ") + unitsNow().angleUnit() + QStringLiteral(" · N"));
  if (!sound_.isEmpty()) cell(sound_, sound_on_ ? "sound" : "mute", theme.text2);
  if (!device_.isEmpty())
    device_works_ ? cell(device_, "check", theme.scene.axis_z) : cell(device_, "warning", theme.near_miss);
  right = paintRate(painter, right, tr("Window"), rates_.window_hz, rates_.window_full, rates_.idle);
  right = paintRate(painter, right, tr("Collision"), rates_.collision_hz, rates_.collision_full, rates_.idle);
  right = paintRate(painter, right, tr("Haptic"), rates_.haptic_hz, rates_.haptic_full);
  paintSentence(painter, QRect(10, 0, right - 20, height()));
}

}  // namespace hapticell::app
