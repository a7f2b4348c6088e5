// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/widgets/force_meter.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/style/fonts.h"
#include "app/style/theme.h"
#include "app/viewport/scene/strip_text.h"

namespace hapticell::app {

ForceMeter::ForceMeter(QWidget* parent) : QWidget(parent) {
  setFixedHeight(34);
  setAccessibleName(tr("Force on the hand"));
}

void ForceMeter::setDevice(double continuous_n, double peak_n) {
  if (continuous_n == continuous_ && peak_n == peak_) return;
  continuous_ = continuous_n;
  peak_ = peak_n;
  update();
}

void ForceMeter::setForce(double newtons_now) {
  if (std::abs(newtons_now - force_) < 0.01) return;
  force_ = newtons_now;
  update();
}

void ForceMeter::paintEvent(QPaintEvent*) {
  const Theme& theme = themeOf(palette());
  QPainter painter(this);
  const QRect bar(0, 4, width() - 1, 9);
  painter.fillRect(bar, theme.field);
  if (peak_ > 0.0) {
    const int reach = static_cast<int>(bar.width() * std::clamp(force_ / peak_, 0.0, 1.0));
    painter.fillRect(QRect(bar.left(), bar.top(), reach, bar.height()), theme.scene.force);
    const int x = static_cast<int>(bar.width() * continuous_ / peak_);
    painter.fillRect(QRect(x, bar.top() - 3, 2, bar.height() + 6), theme.limit);
    painter.fillRect(QRect(bar.right() - 1, bar.top() - 3, 2, bar.height() + 6), theme.limit);
    painter.setFont(textFont(TextRole::kSecond));
    painter.setPen(theme.text2);
    const QRect words(0, 18, width(), 16);
    painter.drawText(words, Qt::AlignLeft, tr("0 N"));
    painter.drawText(words.adjusted(std::max(x - 20, 34), 0, 0, 0), Qt::AlignLeft,
                     tr("%1 continuous").arg(continuous_, 0, 'f', 1));
    painter.drawText(words, Qt::AlignRight, tr("%1 peak").arg(peak_, 0, 'f', 1));
  } else {
    painter.setFont(textFont(TextRole::kSecond));
    painter.setPen(theme.text3);
    painter.drawText(QRect(0, 18, width(), 16), Qt::AlignLeft, tr("no device"));
  }
}

WorkspaceView::WorkspaceView(QWidget* parent) : QWidget(parent) {
  setFixedSize(150, 110);
  setAccessibleName(tr("Stylus in the device's workspace"));
}

void WorkspaceView::setState(const double (&min)[3], const double (&max)[3], const double (&tip)[3], bool known) {
  // m: less does not move the dot by a pixel. Half: painted for nothing; twice: it moves in steps.
  constexpr double kSeen = 2e-4;
  const auto same = [](const double(&a)[3], const double(&b)[3]) {
    return std::equal(std::begin(a), std::end(a), std::begin(b),
                      [](double x, double y) { return std::abs(x - y) < kSeen; });
  };
  if (known == known_ && same(min, min_) && same(max, max_) && same(tip, tip_)) return;
  std::copy(std::begin(min), std::end(min), min_);
  std::copy(std::begin(max), std::end(max), max_);
  std::copy(std::begin(tip), std::end(tip), tip_);
  known_ = known;
  update();
}

QPointF WorkspaceView::place(double x, double y, double z) const {
  const double wide = std::max(max_[0] - min_[0], 1e-6);
  const double deep = std::max(max_[1] - min_[1], 1e-6);
  const double high = std::max(max_[2] - min_[2], 1e-6);
  // Cabinet projection: what lies away goes up and to the right, at half its length.
  const double unit = 100.0 / wide;
  const double right = (x - min_[0]) * unit + 0.40 * (y - min_[1]) * unit;
  const double up = (z - min_[2]) * unit + 0.22 * (y - min_[1]) * unit;
  const double total = high * unit + 0.22 * deep * unit;
  return {4.0 + right, 0.5 * (height() + total) - up};
}

void WorkspaceView::paintEvent(QPaintEvent*) {
  const Theme& theme = themeOf(palette());
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const auto line = [&](const QPointF& a, const QPointF& b) { painter.drawLine(a, b); };
  const double x[2]{min_[0], max_[0]}, y[2]{min_[1], max_[1]}, z[2]{min_[2], max_[2]};
  painter.setPen(QPen(theme.line, 1.0, Qt::DashLine));
  line(place(x[0], y[1], z[0]), place(x[1], y[1], z[0]));
  line(place(x[0], y[1], z[0]), place(x[0], y[0], z[0]));
  line(place(x[0], y[1], z[0]), place(x[0], y[1], z[1]));
  painter.setPen(QPen(theme.text3, 1.2));
  painter.drawPolygon(
      QPolygonF({place(x[0], y[0], z[0]), place(x[1], y[0], z[0]), place(x[1], y[0], z[1]), place(x[0], y[0], z[1])}));
  painter.drawPolyline(QPolygonF({place(x[0], y[0], z[1]), place(x[0], y[1], z[1]), place(x[1], y[1], z[1]),
                                  place(x[1], y[1], z[0]), place(x[1], y[0], z[0])}));
  line(place(x[1], y[0], z[1]), place(x[1], y[1], z[1]));
  if (!known_) return;
  const double tx = std::clamp(tip_[0], x[0], x[1]), ty = std::clamp(tip_[1], y[0], y[1]),
               tz = std::clamp(tip_[2], z[0], z[1]);
  painter.setPen(QPen(theme.text2, 1.0, Qt::DotLine));
  line(place(tx, ty, tz), place(tx, ty, z[0]));
  painter.setPen(QPen(theme.window, 1.5));
  painter.setBrush(theme.scene.force);
  painter.drawEllipse(place(tx, ty, tz), 5.0, 5.0);
}

}  // namespace hapticell::app
