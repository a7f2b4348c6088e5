// SPDX-License-Identifier: Apache-2.0
#include "app/controls/strip_chart.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "app/kit/form.h"
#include "app/style/fonts.h"
#include "app/style/style_painting.h"
#include "app/style/theme.h"
#include "app/style/units.h"
#include "app/viewport/scene/strip_text.h"

namespace hapticell::app {

namespace {
constexpr double kRateTop = 1100.0;  // Hz at the top of the rates' strip.
constexpr int kRatesHeight = 30;
constexpr int kLevelsWidth = 48;  // Of the numbers at the left axis.

/// A round distance without needless decimals: "10 mm", "0.4 in".
QString gapText(double metres) {
  const Units units = unitsNow();
  return QString::number(units.perMetre() * metres, 'g', 3) + QLatin1Char(' ') + units.lengthUnit();
}
}  // namespace

/// Where values are in pixels.
struct StripChart::Axes {
  QRect plot;
  QRect rates;
  double begin_s = 0.0, end_s = 20.0;
  double gap_top = 0.060, force_top = 5.0;
  double x(double time_s) const { return plot.left() + (time_s - begin_s) / (end_s - begin_s) * plot.width(); }
  double time(double x) const { return begin_s + (x - plot.left()) / plot.width() * (end_s - begin_s); }
  double yGap(double metres) const { return plot.bottom() - std::clamp(metres / gap_top, 0.0, 1.0) * plot.height(); }
  double yRate(double hertz) const { return rates.bottom() - std::clamp(hertz / kRateTop, 0.0, 1.0) * rates.height(); }
  double yForce(double newtons) const {
    return plot.bottom() - std::clamp(newtons / force_top, 0.0, 1.0) * plot.height();
  }
};

StripChart::StripChart(double length_s, QWidget* parent) : QWidget(parent), history_(length_s) {
  setObjectName("stripChart");
  setAccessibleName(tr("Force and clearance over the last seconds"));
  setMouseTracking(true);
}

void StripChart::take(const std::optional<manipulation::SceneSnapshot>& snapshot) {
  if (!snapshot) return;
  if (snapshot->idle) return;  // It stands still while nothing happens.
  const double before = history_.now();
  history_.add(*snapshot);
  if (isSeen(*this) && history_.now() != before) update();
}

void StripChart::clear() {
  history_.clear();
  update();
}

void StripChart::setTimes(const StripTimes& times) {
  times_ = times;
  update();
}

void StripChart::setLevels(double near_miss_m, double peak_n) {
  near_miss_m_ = near_miss_m;
  peak_n_ = peak_n;
}

StripChart::Axes StripChart::axes() const {
  Axes axes;
  if (times_) {
    const int left = static_cast<int>(times_->left);
    axes.plot = QRect(left, 4, static_cast<int>(times_->right) - left, height() - 14);
    axes.begin_s = times_->begin_s;
    axes.end_s = times_->end_s;
  } else {
    axes.plot = rect().adjusted(200, 30, -60, -20 - kRatesHeight);
    axes.rates = QRect(axes.plot.left(), axes.plot.bottom() + 8, axes.plot.width(), kRatesHeight);
    axes.end_s = std::max(history_.now(), history_.length());
    axes.begin_s = axes.end_s - history_.length();
  }
  double gap = 0.0, force = 0.0;
  for (const StripSample& sample : history_.samples()) {
    if (std::isfinite(sample.gap_m)) gap = std::max(gap, sample.gap_m);
    force = std::max(force, sample.force_n);
  }
  axes.gap_top = axisTop(gap, 0.05);
  axes.force_top = peak_n_ > 0.0 ? 1.12 * peak_n_ : axisTop(force, 2.0);
  return axes;
}

void StripChart::paintTimes(QPainter& painter, const Axes& axes) const {
  const Theme& theme = themeOf(palette());
  painter.setFont(textFont(TextRole::kSecond));
  for (int second = static_cast<int>(std::ceil(axes.begin_s)); second <= axes.end_s; ++second) {
    const double x = axes.x(second);
    const bool named = second % 2 == 0;
    painter.fillRect(QRectF(x, axes.plot.top() - (named ? 10 : 6), 1, named ? 8 : 4), theme.text3);
    if (!named || std::abs(x - axes.x(history_.now())) < 36) continue;
    painter.setPen(theme.text2);
    painter.drawText(QRectF(x - 30, axes.plot.top() - 30, 60, 18), Qt::AlignCenter, tr("%1 s").arg(second));
  }
  painter.setPen(theme.text1);
  painter.drawText(QRectF(axes.x(history_.now()) - 30, axes.plot.top() - 30, 60, 18), Qt::AlignCenter, tr("now"));
}

void StripChart::paintLevels(QPainter& painter, const Axes& axes) const {
  const Theme& theme = themeOf(palette());
  const QRect& plot = axes.plot;
  painter.fillRect(plot, theme.field);
  QColor band = theme.near_miss;
  band.setAlpha(26);
  const double near = axes.yGap(near_miss_m_);
  painter.fillRect(QRectF(plot.left(), near, plot.width(), plot.bottom() - near), band);
  painter.setPen(QPen(theme.near_miss, 1.2, Qt::DashLine));
  painter.drawLine(QPointF(plot.left(), near), QPointF(plot.right(), near));
  painter.setFont(textFont(TextRole::kSecond));
  const QRectF left(plot.left() - kLevelsWidth, 0, kLevelsWidth - 8, 16);
  const auto word = [&](const QRectF& place, double y, const QColor& color, const QString& text, Qt::Alignment side) {
    painter.setPen(color);
    painter.drawText(place.translated(0, y - 8), side | Qt::AlignVCenter, text);
  };
  word(left, near, theme.words.near_miss, gapText(near_miss_m_), Qt::AlignRight);
  word(left, plot.top() + 4, theme.selection, gapText(axes.gap_top), Qt::AlignRight);
  word(left, plot.bottom(), theme.selection, QStringLiteral("0"), Qt::AlignRight);
  const QRectF right(plot.right() + 8, 0, 52, 16);
  word(right, plot.bottom(), theme.text1, QStringLiteral("0"), Qt::AlignLeft);
  word(right, axes.yForce(0.5 * axes.force_top), theme.text1, QString::number(0.5 * axes.force_top, 'f', 1),
       Qt::AlignLeft);
  if (peak_n_ > 0.0) {
    const double peak = axes.yForce(peak_n_);
    painter.setPen(QPen(theme.limit, 1.2));
    painter.drawLine(QPointF(plot.left(), peak), QPointF(plot.right(), peak));
    word(right, peak, theme.words.limit, tr("%1 N").arg(peak_n_, 0, 'f', 1), Qt::AlignLeft);
  } else {
    word(right, plot.top() + 4, theme.text1, tr("%1 N").arg(axes.force_top, 0, 'g', 3), Qt::AlignLeft);
  }
}

void StripChart::paintCurves(QPainter& painter, const Axes& axes) const {
  const Theme& theme = themeOf(palette());
  QPainterPath gap, force, area;
  bool drawing = false, first = true;
  for (const StripSample& sample : history_.samples()) {
    const double x = axes.x(sample.time_s);
    const QPointF force_at(x, axes.yForce(sample.force_n));
    if (first) area.moveTo(x, axes.plot.bottom());
    first ? force.moveTo(force_at) : force.lineTo(force_at);
    area.lineTo(force_at);
    first = false;
    const bool known = std::isfinite(sample.gap_m);
    const QPointF gap_at(x, axes.yGap(known ? sample.gap_m : 0.0));
    if (known) drawing ? gap.lineTo(gap_at) : gap.moveTo(gap_at);
    drawing = known;
  }
  if (first) return;
  area.lineTo(axes.x(history_.now()), axes.plot.bottom());
  painter.setClipRect(axes.plot.adjusted(0, -1, 0, 1));
  QColor fill = theme.text3;
  fill.setAlpha(90);
  painter.fillPath(area, fill);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme.selection, 1.8));
  painter.drawPath(gap);
  painter.setPen(QPen(theme.scene.force, 1.6));
  painter.drawPath(force);
  painter.setClipping(false);
}

void StripChart::paintRates(QPainter& painter, const Axes& axes) const {
  const Theme& theme = themeOf(palette());
  painter.fillRect(axes.rates, theme.field);
  QPolygonF haptic, collision;
  for (const StripSample& sample : history_.samples()) {
    haptic.append({axes.x(sample.time_s), axes.yRate(sample.haptic_hz)});
    collision.append({axes.x(sample.time_s), axes.yRate(sample.manipulation_hz)});
  }
  painter.setClipRect(axes.rates);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme.text1, 1.2));
  painter.drawPolyline(haptic);
  painter.setPen(QPen(theme.text2, 1.4, Qt::DashLine));  // Dashed: told apart without colour.
  painter.drawPolyline(collision);
  painter.setClipping(false);
  const StripSample* now = history_.samples().empty() ? nullptr : &history_.samples().back();
  painter.setFont(textFont(TextRole::kSecond));
  const auto word = [&](int line, const QColor& color, const QString& text, double hertz) {
    painter.setPen(color);
    const QString rate = now ? tr("%1 Hz").arg(std::lround(hertz)) : QString();
    painter.drawText(QRect(12, axes.rates.top() - 2 + 16 * line, 176, 16), Qt::AlignVCenter | Qt::AlignLeft, text);
    painter.drawText(QRect(12, axes.rates.top() - 2 + 16 * line, 176, 16), Qt::AlignVCenter | Qt::AlignRight, rate);
  };
  word(0, theme.text1, tr("Force loop"), now ? now->haptic_hz : 0.0);
  word(1, theme.text2, tr("Manipulation loop, dashed"), now ? now->manipulation_hz : 0.0);
}

void StripChart::paintLegend(QPainter& painter, const Axes& axes) const {
  const Theme& theme = themeOf(palette());
  const int top = axes.plot.top();
  painter.setFont(textFont(TextRole::kSection));
  const auto write = [&](int y, const QColor& color, const QString& text) {
    // Beside no word of the axis there is more room.
    const auto beside = [&](double word) { return std::abs(word - (y + 10)) < 18; };
    const bool narrow = beside(top + 4) || beside(axes.yGap(near_miss_m_)) || beside(axes.plot.bottom());
    const int room = axes.plot.left() - 12 - (narrow ? kLevelsWidth : 8);
    painter.setPen(color);
    painter.drawText(QRect(12, y, room, 20), Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(text, Qt::ElideRight, room));
  };
  write(top - 4, theme.selection, tr("Clearance, nearest pair"));
  write(top + 18, theme.text1, tr("Force on the hand"));
  painter.setFont(textFont(TextRole::kSecond));
  write(top + 40, theme.words.near_miss, tr("Near miss below %1").arg(gapText(near_miss_m_)));
  if (!history_.samples().empty()) return;
  painter.setPen(theme.text2);
  painter.drawText(axes.plot, Qt::AlignCenter, tr("No measurements yet. Connect a stylus and hold an entity."));
}

void StripChart::paintCursor(QPainter& painter, const Axes& axes) const {
  const Theme& theme = themeOf(palette());
  const bool pointed = cursor_ >= axes.plot.left() && cursor_ <= axes.plot.right();
  const double x = pointed ? cursor_ : axes.x(history_.now());
  const StripSample* sample = history_.at(axes.time(x));
  if (!sample) return;
  const int above = std::min(8, axes.plot.top());
  painter.fillRect(QRectF(x - 0.75, axes.plot.top() - above, 1.5, axes.plot.height() + above), theme.text1);
  if (!pointed) return;
  const QString gap =
      std::isfinite(sample->gap_m) ? QString::fromStdString(millimetres(sample->gap_m)) : tr("no clearance");
  const QString force = tr("%1 N at %2 s").arg(sample->force_n, 0, 'f', 1).arg(sample->time_s, 0, 'f', 2);
  painter.setFont(textFont(TextRole::kSecond));
  const int gap_width = painter.fontMetrics().horizontalAdvance(gap) + 12;
  const int width = gap_width + painter.fontMetrics().horizontalAdvance(force) + 16;
  const int left = x + 10 + width > axes.plot.right() ? static_cast<int>(x) - 10 - width : static_cast<int>(x) + 10;
  const QRect box(left, axes.plot.top() + 14, width, 22);
  drawBox(&painter, box, theme.header, theme.line);
  painter.setPen(theme.selection);
  painter.drawText(box.adjusted(8, 0, 0, 0), Qt::AlignVCenter, gap);
  painter.setPen(theme.text1);
  painter.drawText(box.adjusted(8 + gap_width, 0, 0, 0), Qt::AlignVCenter, force);
}

void StripChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Axes at = axes();
  if (at.plot.width() < 40 || at.plot.height() < 30) return;
  paintLevels(painter, at);
  if (!times_) paintTimes(painter, at);
  paintCurves(painter, at);
  if (!times_) paintRates(painter, at);
  paintLegend(painter, at);
  paintCursor(painter, at);
}

void StripChart::mouseMoveEvent(QMouseEvent* event) {
  cursor_ = event->pos().x();
  update();
}

void StripChart::leaveEvent(QEvent*) {
  cursor_ = -1;
  update();
}

}  // namespace hapticell::app
