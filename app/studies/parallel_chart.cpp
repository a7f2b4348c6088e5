// SPDX-License-Identifier: Apache-2.0
#include "app/studies/parallel_chart.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/studies/result_table.h"
#include "app/studies/variant_map.h"
#include "app/style/fonts.h"
#include "app/style/theme.h"

namespace hapticell::app {

namespace {

/// Pixels from a line that still mean it, as kPointReach of scatter_chart.cpp.
constexpr double kLineReach = 12.0;
constexpr double kSide = 46.0;  // Pixels for the names of the first and last axis; half: they are cut, twice: less chart.

}  // namespace

ParallelChart::ParallelChart(const ResultTable& table, QWidget* parent) : QWidget(parent), table_(table) {
  setObjectName("parallelChart");
  setAccessibleName(tr("All variants: varied values and results"));
  setFocusPolicy(Qt::StrongFocus);
  connect(&table_, &ResultTable::rowsChanged, this, &ParallelChart::scale);
  connect(&table_, &ResultTable::chosenChanged, this, [this] { update(); });
}

void ParallelChart::setColorColumn(int column) {
  color_ = column;
  scale();
}

void ParallelChart::scale() {
  axes_.clear();
  color_axis_ = {};
  if (!table_.isEmpty()) {
    std::vector<int> columns;
    for (std::size_t i = 0; i < table_.head().values.size(); ++i)
      columns.push_back(ResultTable::kFirstValue + static_cast<int>(i));
    const auto document = studies::StudyDocument::parse(table_.head().study, "study.hstudy");
    std::vector<std::string> names;
    if (document) {
      for (const auto& one : document->requirements) names.push_back(one.value);
      for (const auto& one : document->objectives) names.push_back(one.value);
    }
    for (const std::string& name : names) columns.push_back(table_.columnNamed(name));
    for (const int column : columns) {
      const bool there = std::any_of(axes_.begin(), axes_.end(), [&](const ChartAxis& a) { return a.column == column; });
      if (column >= 0 && !there) axes_.push_back(ChartAxis::over(table_, column));
    }
    if (color_ >= 0) color_axis_ = ChartAxis::over(table_, color_);
  }
  update();
}

QRectF ParallelChart::plot() const {
  return QRectF(rect()).adjusted(kSide, 24, -kSide, -10);
}

QPointF ParallelChart::placeOf(std::size_t row, std::size_t axis) const {
  const QRectF box = plot();
  const double step = axes_.size() > 1 ? box.width() / static_cast<double>(axes_.size() - 1) : 0.0;
  // Rows without a value go below the axis.
  const double share = std::max(-0.04, axes_[axis].shareOf(table_, row));
  return {box.left() + step * static_cast<double>(axis), box.bottom() - share * box.height()};
}

QPolygonF ParallelChart::lineOf(std::size_t row) const {
  QPolygonF line;
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) line << placeOf(row, axis);
  return line;
}

QColor ParallelChart::colorOf(std::size_t row) const {
  const Theme& theme = themeOf(palette());
  if (!table_.rows()[row].feasible) return theme.line;
  if (color_axis_.column < 0) return theme.selection;
  const double share = color_axis_.shareOf(table_, row);
  if (share < 0.0) return theme.line;
  return heatColor(table_.isGreaterBetter(color_).value_or(true) ? share : 1.0 - share);
}

void ParallelChart::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || axes_.empty()) return;
  const QPointF place = event->position();
  const auto away = [&](std::size_t row) {
    double least = 1e9;
    const QPolygonF line = lineOf(row);
    for (int i = 0; i + 1 < std::max(2, static_cast<int>(line.size())); ++i) {
      const QPointF from = line[i], to = line.size() > 1 ? line[i + 1] : line[i], along = to - from;
      const double square = std::max(1e-9, QPointF::dotProduct(along, along));
      const double share = std::clamp(QPointF::dotProduct(place - from, along) / square, 0.0, 1.0);
      const QPointF off = place - (from + share * along);
      least = std::min(least, std::hypot(off.x(), off.y()));
    }
    return least;
  };
  std::optional<std::size_t> found;
  double least = kLineReach;
  for (std::size_t row = 0; row < table_.rows().size(); ++row) {
    // Feasible lines lie on top.
    const double distance = away(row) + (table_.rows()[row].feasible ? 0.0 : 2.0);
    if (distance >= least) continue;
    least = distance;
    found = row;
  }
  if (found) emit chose(table_.rows()[*found].number);
}

void ParallelChart::keyPressEvent(QKeyEvent* event) {
  const bool back = event->key() == Qt::Key_Left || event->key() == Qt::Key_Up;
  const bool on = event->key() == Qt::Key_Right || event->key() == Qt::Key_Down;
  const auto row = table_.chosen();
  if (!row || (!back && !on)) return QWidget::keyPressEvent(event);
  if (back && *row > 0) emit chose(table_.rows()[*row - 1].number);
  if (on && *row + 1 < table_.rows().size()) emit chose(table_.rows()[*row + 1].number);
}

void ParallelChart::paintAxes(QPainter& painter) const {
  const Theme& theme = themeOf(palette());
  const QRectF box = plot();
  const double room = axes_.size() > 1 ? box.width() / static_cast<double>(axes_.size() - 1) : box.width();
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const double x = placeOf(0, i).x();
    painter.fillRect(QRectF(x, box.top(), 1, box.height()), theme.text3);
    painter.setFont(textFont(TextRole::kKeyCap));
    painter.setPen(theme.text2);
    const double wide = std::min(room - 4.0, 2.0 * kSide);
    const QString name = table_.headerData(axes_[i].column, Qt::Horizontal, Qt::DisplayRole).toString();
    painter.drawText(QRectF(x - wide / 2, 2, wide, 18), Qt::AlignCenter,
                     painter.fontMetrics().elidedText(name, Qt::ElideMiddle, static_cast<int>(wide)));
    double last = 1e9;
    for (const double tick : axes_[i].ticks) {
      const double y = box.bottom() - axes_[i].share(tick) * box.height();
      if (last - y < 12.0) continue;
      last = y;
      const QRectF place(x + 3, y - 7, std::max(8.0, std::min(room - 8.0, 90.0)), 14);
      painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter,
                       painter.fontMetrics().elidedText(axes_[i].tickText(tick), Qt::ElideRight,
                                                        static_cast<int>(place.width())));
    }
  }
}

void ParallelChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme& theme = themeOf(palette());
  if (axes_.empty()) {
    painter.setPen(theme.text2);
    painter.setFont(textFont(TextRole::kSecond));
    painter.drawText(rect(), Qt::AlignCenter, tr("No results yet"));
    return;
  }
  painter.fillRect(plot(), theme.field);
  for (const bool feasible : {false, true}) {
    for (std::size_t row = 0; row < table_.rows().size(); ++row) {
      if (table_.rows()[row].feasible != feasible) continue;
      painter.setPen(QPen(colorOf(row), feasible ? 1.4 : 1.0));
      painter.drawPolyline(lineOf(row));
    }
  }
  if (table_.chosen()) {
    painter.setPen(QPen(theme.scene.force, 3));
    painter.drawPolyline(lineOf(*table_.chosen()));
  }
  paintAxes(painter);
}

}  // namespace hapticell::app
