// SPDX-License-Identifier: Apache-2.0
#include "app/studies/scatter_chart.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "app/studies/result_table.h"
#include "app/style/fonts.h"
#include "app/style/theme.h"

namespace hapticell::app {

namespace {

/// Pixels from a point that still mean it. Half: hard to hit; twice: neighbours are taken.
constexpr double kPointReach = 12.0;
constexpr double kRadius = 3.5, kChosenRadius = 7.0;  // Pixels; half: dots, twice: they hide each other.

}  // namespace

ScatterChart::ScatterChart(const ResultTable& table, QWidget* parent) : QWidget(parent), table_(table) {
  setObjectName("scatterChart");
  setAccessibleName(tr("Two results of all variants"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  connect(&table_, &ResultTable::rowsChanged, this, &ScatterChart::scale);
  connect(&table_, &ResultTable::chosenChanged, this, [this] { update(); });
}

void ScatterChart::setColumns(int across, int up) {
  across_ = across;
  up_ = up;
  scale();
}

void ScatterChart::scale() {
  x_ = y_ = {};
  if (!table_.isEmpty() && across_ >= 0 && up_ >= 0) {
    x_ = ChartAxis::over(table_, across_);
    y_ = ChartAxis::over(table_, up_);
  }
  update();
}

QRectF ScatterChart::plot() const {
  return QRectF(rect()).adjusted(62, 8, -12, -34);
}

std::optional<QPointF> ScatterChart::placeOf(std::size_t row) const {
  if (x_.column < 0) return std::nullopt;
  const double x = x_.shareOf(table_, row), y = y_.shareOf(table_, row);
  if (x < 0.0 || y < 0.0) return std::nullopt;
  const QRectF box = plot();
  return QPointF(box.left() + x * box.width(), box.bottom() - y * box.height());
}

std::optional<std::size_t> ScatterChart::nearest(const QPointF& place) const {
  std::optional<std::size_t> found;
  double least = kPointReach;
  for (std::size_t row = 0; row < table_.rows().size(); ++row) {
    const auto at = placeOf(row);
    if (!at) continue;
    const double away = std::hypot(at->x() - place.x(), at->y() - place.y());
    if (away < least || (found && away == least && table_.front().count(row) > 0)) {
      least = away;
      found = row;
    }
  }
  return found;
}

void ScatterChart::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  if (const auto row = nearest(event->position())) emit chose(table_.rows()[*row].number);
}

void ScatterChart::mouseMoveEvent(QMouseEvent* event) {
  const auto row = nearest(event->position());
  if (!row) return QToolTip::hideText();
  QToolTip::showText(event->globalPosition().toPoint(), tr("Variant %1\n%2: %3\n%4: %5")
                                                            .arg(table_.rows()[*row].number)
                                                            .arg(table_.columnName(across_), table_.word(*row, across_),
                                                                 table_.columnName(up_), table_.word(*row, up_)),
                     this);
}

/// To the next point in the direction of the arrow.
void ScatterChart::keyPressEvent(QKeyEvent* event) {
  const QPointF way = [&]() -> QPointF {
    if (event->key() == Qt::Key_Left) return {-1.0, 0.0};
    if (event->key() == Qt::Key_Right) return {1.0, 0.0};
    if (event->key() == Qt::Key_Up) return {0.0, -1.0};
    if (event->key() == Qt::Key_Down) return {0.0, 1.0};
    return {};
  }();
  const auto from = table_.chosen() ? placeOf(*table_.chosen()) : std::nullopt;
  if (way.isNull() || !from) return QWidget::keyPressEvent(event);
  std::optional<std::size_t> found;
  double least = 0.0;
  for (std::size_t row = 0; row < table_.rows().size(); ++row) {
    const auto at = placeOf(row);
    if (!at) continue;
    const QPointF off = *at - *from;
    const double along = QPointF::dotProduct(off, way), across = std::abs(off.x() * way.y() - off.y() * way.x());
    const double cost = along + 2.0 * across;
    if (along < 0.5 || (found && cost >= least)) continue;
    least = cost;
    found = row;
  }
  if (found) emit chose(table_.rows()[*found].number);
}

void ScatterChart::paintAxes(QPainter& painter) const {
  const Theme& theme = themeOf(palette());
  const QRectF box = plot();
  painter.fillRect(box, theme.field);
  painter.setFont(textFont(TextRole::kKeyCap));
  for (const double tick : x_.ticks) {
    const double x = box.left() + x_.share(tick) * box.width();
    painter.fillRect(QRectF(x, box.top(), 1, box.height()), theme.line);
    painter.setPen(theme.text2);
    painter.drawText(QRectF(x - 40, box.bottom() + 2, 80, 14), Qt::AlignCenter, x_.tickText(tick));
  }
  for (const double tick : y_.ticks) {
    const double y = box.bottom() - y_.share(tick) * box.height();
    painter.fillRect(QRectF(box.left(), y, box.width(), 1), theme.line);
    painter.setPen(theme.text2);
    painter.drawText(QRectF(2, y - 8, box.left() - 6, 16), Qt::AlignRight | Qt::AlignVCenter, y_.tickText(tick));
  }
  painter.setPen(theme.text2);
  painter.setFont(textFont(TextRole::kSecond));
  const auto title = [&](int column) { return table_.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString(); };
  painter.drawText(QRectF(box.left(), height() - 18, box.width(), 16), Qt::AlignRight | Qt::AlignVCenter,
                   title(across_) + QStringLiteral(" →"));
  painter.drawText(QRectF(box.left() + 4, box.top() + 2, box.width() - 8, 16), Qt::AlignLeft | Qt::AlignVCenter,
                   QStringLiteral("↑ ") + title(up_));
}

void ScatterChart::paintPoints(QPainter& painter) const {
  const Theme& theme = themeOf(palette());
  QPolygonF front;
  for (const std::size_t row : table_.front())
    if (const auto at = placeOf(row)) front << *at;
  std::sort(front.begin(), front.end(), [](const QPointF& a, const QPointF& b) { return a.x() < b.x(); });
  for (const bool feasible : {false, true}) {
    for (std::size_t row = 0; row < table_.rows().size(); ++row) {
      const auto at = placeOf(row);
      if (!at || table_.rows()[row].feasible != feasible) continue;
      painter.setPen(QPen(feasible ? theme.selection : theme.text3, 1.2));
      painter.setBrush(feasible ? QBrush(theme.selection) : QBrush(Qt::NoBrush));
      painter.drawEllipse(*at, kRadius, kRadius);
    }
  }
  painter.setPen(QPen(theme.scene.guide, 2));
  painter.setBrush(theme.scene.guide);
  painter.drawPolyline(front);
  for (const QPointF& at : front) painter.drawEllipse(at, kRadius + 1.0, kRadius + 1.0);
  const auto chosen = table_.chosen() ? placeOf(*table_.chosen()) : std::nullopt;
  if (!chosen) return;
  painter.setPen(QPen(theme.scene.force, 2.5));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(*chosen, kChosenRadius, kChosenRadius);
}

void ScatterChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (x_.column < 0) {
    painter.setPen(themeOf(palette()).text2);
    painter.setFont(textFont(TextRole::kSecond));
    painter.drawText(rect(), Qt::AlignCenter, tr("No results yet"));
    return;
  }
  paintAxes(painter);
  paintPoints(painter);
}

}  // namespace hapticell::app
