// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/training/progress_plot.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <numeric>

#include "app/style/fonts.h"
#include "app/style/theme.h"

namespace hapticell::app {

std::vector<std::size_t> shownOrder(const std::vector<trajectory::TrainingAttempt>& attempts) {
  std::vector<std::size_t> order(attempts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return attempts[a].kind < attempts[b].kind; });
  return order;
}

ProgressPlot::ProgressPlot(QWidget* parent) : QWidget(parent) {
  setObjectName("progressPlot");
  setAccessibleName(tr("Points and guidance by run"));
}

void ProgressPlot::setAttempts(std::vector<trajectory::TrainingAttempt> attempts, double pass) {
  attempts_ = std::move(attempts);
  pass_ = pass;
  setAccessibleDescription(attempts_.empty() ? tr("No run yet")
                                             : tr("Runs: %1, the last with %2 points")
                                                   .arg(attempts_.size())
                                                   .arg(attempts_.back().score.points, 0, 'f', 0));
  update();
}

void ProgressPlot::paint(QPainter& painter, const QRect& rect, const std::vector<trajectory::TrainingAttempt>& attempts,
                         double pass, const QPalette& palette) {
  const Theme& theme = themeOf(palette);
  const QRect plot = rect.adjusted(30, 8, -34, -20);
  painter.fillRect(plot, theme.field);
  painter.setFont(textFont(TextRole::kSecond));
  const auto y = [&](double share) { return plot.bottom() - share * plot.height(); };
  for (const int points : {0, 50, 100}) {
    painter.fillRect(QRectF(plot.left(), y(0.01 * points), plot.width(), 1), theme.line);
    painter.setPen(theme.text2);
    painter.drawText(QRectF(rect.left(), y(0.01 * points) - 8, 26, 16), Qt::AlignRight | Qt::AlignVCenter,
                     QString::number(points));
    painter.drawText(QRectF(plot.right() + 4, y(0.01 * points) - 8, 34, 16), Qt::AlignLeft | Qt::AlignVCenter,
                     tr("%1 %").arg(points));
  }
  painter.setPen(QPen(theme.text2, 1, Qt::DashLine));
  painter.drawLine(QPointF(plot.left(), y(0.01 * pass)), QPointF(plot.right(), y(0.01 * pass)));
  if (attempts.empty()) {
    // Between the lines of the chart, in the half that the dashed one leaves free.
    const double top = pass < 50.0 ? 1.0 : 0.5;
    painter.setPen(theme.text2);
    painter.drawText(QRectF(plot.left(), y(top), plot.width(), y(0.0) - y(0.5)), Qt::AlignCenter, tr("No run yet"));
    return;
  }
  // The newest forty.
  std::vector<std::size_t> order = shownOrder(attempts);
  const std::size_t oldest = attempts.size() > 40 ? attempts.size() - 40 : 0;
  std::erase_if(order, [oldest](std::size_t i) { return i < oldest; });
  const double places = static_cast<double>(order.size()) + 1.0;  // One to stand apart.
  const double width = std::min(26.0, static_cast<double>(plot.width()) / places);
  QPainterPath help;
  for (std::size_t place = 0; place < order.size(); ++place) {
    const std::size_t i = order[place];
    const bool led = attempts[i].kind == trajectory::RunKind::kPractice;
    const QColor colour = led ? theme.selection : theme.scene.force;
    const double left = plot.left() + width * (static_cast<double>(place) + (led || place == 0 ? 0.0 : 1.0));
    const double top = y(std::clamp(0.01 * attempts[i].score.points, 0.0, 1.0));
    const QRectF bar(left + 2, top, std::max(1.0, width - 4), plot.bottom() - top + 1);
    painter.fillRect(bar, attempts[i].success ? QBrush(colour) : QBrush(colour, Qt::BDiagPattern));
    painter.setPen(colour);
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(bar);
    if (led) {
      const double h = y(attempts[i].help);
      place == 0 ? help.moveTo(left, h) : help.lineTo(left, h);
      help.lineTo(left + width, h);
    }
    if (width >= 16 || place % 5 == 0) {
      painter.setPen(theme.text2);
      painter.drawText(QRectF(left - 10, plot.bottom() + 2, width + 20, 16), Qt::AlignCenter, QString::number(i + 1));
    }
  }
  painter.setPen(QPen(theme.scene.guide, 2, Qt::SolidLine));
  painter.drawPath(help);
}

void ProgressPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paint(painter, rect(), attempts_, pass_, palette());
}

}  // namespace hapticell::app
