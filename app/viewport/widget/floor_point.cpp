// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/widget/floor_point.h"

#include <QMouseEvent>
#include <QRectF>

#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

constexpr QSizeF kViewCube{130, 130};  // Pixels at the right top, where a click turns the view.
// m along the ray: beyond, the pointer is near the horizon. Half: not to the end of large halls; twice: a pixel is
// metres.
constexpr double kFarthest = 200.0;
// As kPointerClickPixels of view_pointer.cpp.
constexpr double kClickPixels = 4.0;

}  // namespace

bool isOverViewControls(const ViewportWidget& viewport, const QPointF& position) {
  const QRectF cube(QPointF(viewport.width() - kViewCube.width(), 0.0), kViewCube);
  return viewport.viewStrip().cellAt(position) >= 0 || cube.contains(position);
}

std::optional<dvec3> floorPoint(const ViewportWidget& viewport, const QPointF& position) {
  const ViewSize size{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
  const Ray ray_W = viewport.camera().rayThrough({position.x(), position.y()}, size);
  const double along = -ray_W.origin_W.z / ray_W.direction_W.z;
  if (!(along > 0.0 && along < kFarthest)) return std::nullopt;
  const dvec3 p_W = ray_W.origin_W + along * ray_W.direction_W;
  return dvec3(p_W.x, p_W.y, 0.0);
}

bool endsClick(const QMouseEvent& event, const QPointF& pressed) {
  return event.type() == QEvent::MouseButtonRelease && event.button() == Qt::LeftButton &&
         (event.position() - pressed).manhattanLength() <= kClickPixels;
}

}  // namespace hapticell::app
