// SPDX-License-Identifier: Apache-2.0
#include "app/mannequin/figure_sketch.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "app/style/pattern.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

constexpr double kMargin = 6.0;

QColor colorOf(const std::array<float, 3>& rgb) {
  return QColor::fromRgbF(rgb[0], rgb[1], rgb[2]);
}

QRectF boundsOf(const std::vector<mannequin::OutlinePart>& parts) {
  double left = 1e9, right = -1e9, low = 1e9, high = -1e9;
  for (const auto& part : parts) {
    for (const auto& shape : part.shapes) {
      for (const auto& p : shape) {
        left = std::min(left, p.x), right = std::max(right, p.x);
        low = std::min(low, p.y), high = std::max(high, p.y);
      }
    }
  }
  return {left, low, right - left, high - low};
}

}  // namespace

void drawFigure(QPainter& painter, const QRectF& area, const std::vector<mannequin::OutlinePart>& parts,
                const BodyFill& fill, const QColor& line) {
  const QRectF size = boundsOf(parts);
  if (size.width() <= 0.0 || size.height() <= 0.0) return;
  const double scale =
      std::min((area.width() - 2.0 * kMargin) / size.width(), (area.height() - 2.0 * kMargin) / size.height());
  const double x0 = area.center().x() - scale * (size.left() + 0.5 * size.width());
  const double y0 = area.bottom() - kMargin + scale * size.top();
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  for (const auto& part : parts) {
    QPainterPath path;
    path.setFillRule(Qt::WindingFill);
    for (const auto& shape : part.shapes) {
      QPolygonF polygon;
      for (const auto& p : shape) polygon << QPointF(x0 + scale * p.x, y0 - scale * p.y);
      path.addPolygon(polygon);
      path.closeSubpath();
    }
    painter.strokePath(path, QPen(line, 2.2));
    const LinkLook look = fill(part.body);
    fillWithPattern(painter, path, colorOf(look.color), look.pattern);
  }
  painter.restore();
}

FigureSketch::FigureSketch(QWidget* parent) : QWidget(parent) {
  setMinimumSize(100, 150);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
  setMaximumWidth(170);
  setAccessibleName(tr("The mannequin in its posture"));
}

void FigureSketch::setFigure(std::shared_ptr<const mannequin::Figure> figure) {
  if (figure == figure_) return;
  figure_ = std::move(figure);
  flesh_ = figure_ ? mannequin::fleshOf(*figure_) : std::vector<mannequin::Flesh>{};
  update();
}

void FigureSketch::setPosture(const mannequin::Posture& posture) {
  posture_ = posture;
  update();
}

void FigureSketch::setHeld(std::vector<std::size_t> bodies) {
  held_ = std::move(bodies);
  update();
}

void FigureSketch::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const Theme& theme = themeOf(palette());
  QLinearGradient back(0, 0, 0, height());
  back.setColorAt(0, theme.scene.background_top);
  back.setColorAt(1, theme.scene.background_bottom);
  painter.fillRect(rect(), back);
  if (!figure_) return;
  const auto parts = mannequin::outlineOf(*figure_, posture_, flesh_, mannequin::OutlineView::besides(posture_));
  const auto quiet = quietened({0.72f, 0.75f, 0.78f});
  const QColor selection = theme.selection;
  const BodyFill fill = [&](std::size_t body) -> LinkLook {
    const bool held = std::find(held_.begin(), held_.end(), body) != held_.end();
    if (!held) return {quiet, 0};
    return {{selection.redF(), selection.greenF(), selection.blueF()}, 0};
  };
  drawFigure(painter, rect(), parts, fill, theme.scene.background_bottom.darker(160));
}

}  // namespace hapticell::app
