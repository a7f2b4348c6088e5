// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/widgets/rate_graph.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/style/fonts.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

constexpr int kLeft = 0, kNumbers = 58;
constexpr double kSamples = 600.0;  // A minute.

}  // namespace

RateGraph::RateGraph(QWidget* parent) : QWidget(parent) {
  setObjectName("rateGraph");
  setFixedHeight(sizeHint().height());
}

void RateGraph::setSamples(const std::deque<DeviceWatch::RateSample>& samples) {
  samples_ = samples;
  if (samples_.empty())
    setAccessibleDescription(tr("No data yet"));
  else
    setAccessibleDescription(
        tr("%1 Hz, late %2 ms").arg(std::lround(samples_.back().rate_hz)).arg(samples_.back().late_p99_ms, 0, 'f', 2));
  update();
}

void RateGraph::paintEvent(QPaintEvent*) {
  const Theme& theme = themeOf(palette());
  QPainter painter(this);
  const QRect plot(kLeft, 8, width() - 2 * kLeft - kNumbers, height() - 28);
  painter.fillRect(plot, theme.field);
  double most_late = 1.0, most_rate = 1000.0;
  for (const auto& sample : samples_) {
    most_late = std::max(most_late, sample.late_max_ms);
    most_rate = std::max(most_rate, sample.rate_hz);
  }
  const double per = plot.width() / kSamples;
  const double first = plot.right() - per * static_cast<double>(samples_.size());
  const auto level = [&](double part) { return plot.bottom() - part * (plot.height() - 4); };
  QPolygonF rate;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const double x = first + per * static_cast<double>(i);
    const double late = samples_[i].late_p99_ms / most_late;
    painter.fillRect(QRectF(x, level(late), std::max(1.0, per), plot.bottom() - level(late)), theme.near_miss);
    rate << QPointF(x, level(samples_[i].rate_hz / (1.1 * most_rate)));
  }
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme.text1, 1.5));
  painter.drawPolyline(rate);
  painter.setFont(textFont(TextRole::kSecond));
  painter.setPen(theme.text2);
  const QRect numbers(plot.right() + 6, plot.top(), kNumbers, plot.height());
  if (!samples_.empty()) {
    painter.setPen(theme.text1);
    painter.drawText(numbers, Qt::AlignTop | Qt::AlignLeft, tr("%1 Hz").arg(std::lround(samples_.back().rate_hz)));
    painter.setPen(theme.text2);
    painter.drawText(numbers, Qt::AlignBottom | Qt::AlignLeft, tr("%1 ms").arg(samples_.back().late_p99_ms, 0, 'f', 2));
  }
  painter.drawText(QRect(kLeft, height() - 18, width() - 2 * kLeft, 16), Qt::AlignLeft,
                   tr("Line: rate. Bars: lateness (99th percentile), full height %1 ms").arg(most_late, 0, 'f', 1));
}

RangeView::RangeView(QWidget* parent) : QWidget(parent) {
  setObjectName("rangeView");
  setFixedHeight(sizeHint().height());
}

void RangeView::setTest(const RangeTest& test, const std::optional<haptic::DeviceDescription>& device) {
  covered_ = device ? test.covered(device->workspace_min, device->workspace_max) : dvec3(0.0);
  buttons_ = device ? std::min(device->buttons, 16) : 0;
  pressed_ = test.pressedOnce();
  now_ = test.pressedNow();
  setAccessibleDescription(tr("Reached: width %1 %, depth %2 %, height %3 %")
                               .arg(std::lround(100 * covered_.x))
                               .arg(std::lround(100 * covered_.y))
                               .arg(std::lround(100 * covered_.z)));
  update();
}

void RangeView::paintEvent(QPaintEvent*) {
  const Theme& theme = themeOf(palette());
  QPainter painter(this);
  painter.setFont(textFont(TextRole::kSecond));
  const QString names[3]{tr("X, width"), tr("Y, depth"), tr("Z, height")};
  const QColor colors[3]{theme.scene.axis_x, theme.scene.axis_y, theme.scene.axis_z};
  for (int i = 0; i < 3; ++i) {
    const int top = 4 + 22 * i;
    painter.setPen(theme.text2);
    painter.drawText(QRect(kLeft, top, 70, 18), Qt::AlignVCenter, names[i]);
    const QRect bar(kLeft + 76, top + 4, width() - 2 * kLeft - 76 - kNumbers, 10);
    painter.fillRect(bar, theme.field);
    painter.fillRect(QRect(bar.left(), bar.top(), static_cast<int>(bar.width() * covered_[i]), bar.height()),
                     colors[i]);
    painter.drawText(QRect(bar.right() + 6, top, kNumbers, 18), Qt::AlignVCenter,
                     tr("%1 %").arg(std::lround(100.0 * covered_[i])));
  }
  painter.drawText(QRect(kLeft, 74, 70, 18), Qt::AlignVCenter, tr("Buttons"));
  painter.setRenderHint(QPainter::Antialiasing);
  for (int i = 0; i < buttons_; ++i) {
    const QRectF dot(kLeft + 76 + 26 * i, 74, 18, 18);
    const bool now = (now_ >> i & 1u) != 0, once = (pressed_ >> i & 1u) != 0;
    painter.setPen(QPen(once ? theme.selection : theme.text3, now ? 3.0 : 1.5));
    painter.setBrush(once ? QBrush(theme.selected_row) : QBrush(Qt::NoBrush));
    painter.drawEllipse(dot);
    painter.setPen(theme.text1);
    painter.drawText(dot, Qt::AlignCenter, QString::number(i + 1));
  }
}

}  // namespace hapticell::app
