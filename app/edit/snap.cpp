// SPDX-License-Identifier: Apache-2.0
#include "app/edit/snap.h"

#include <QCoreApplication>
#include <algorithm>

namespace hapticell::app {
namespace {

// Pixels to a frame's origin, as kVertexPixels of feature_picker.h. Half: it is hard to meet; twice: corners beside it
// cannot be taken.
constexpr double kFramePixels = 10.0;
// m: a corner that is the frame's origin but for rounding. Half, twice: no effect.
constexpr double kSamePlace = 1e-6;

struct Snap {
  Q_DECLARE_TR_FUNCTIONS(Snap)
};

}  // namespace

std::optional<SnapPoint> snapAt(ViewportWidget& viewport, const QPointF& position,
                                const std::vector<workcell::EntityId>& without) {
  const glm::dvec2 pixel(position.x(), position.y());
  const ViewSize size{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
  std::optional<SnapPoint> nearest;
  double nearest_pixels = kFramePixels;
  bool is_origin = false;
  const auto look = [&](const Pose& X_WF, const QString& text, bool origin) {
    const auto seen = viewport.camera().project(X_WF.p, size);
    const double pixels = seen ? glm::length(*seen - pixel) : 2.0 * kFramePixels;
    if (pixels < nearest_pixels) nearest_pixels = pixels, is_origin = origin, nearest = SnapPoint{X_WF, text};
  };
  for (const workcell::Entity& entity : viewport.scene().entities()) {
    if (!entity.visible || std::find(without.begin(), without.end(), entity.id) != without.end()) continue;
    const Pose X_WE = viewport.scene().placement_W(entity);
    const QString name = QString::fromStdString(entity.name);
    for (const workcell::Frame& frame : entity.frames)
      look(X_WE * frame.X_EF, Snap::tr("Frame %1 of %2").arg(QString::fromStdString(frame.name), name), false);
    if (entity.kind() == workcell::EntityKind::kFrame)
      look(X_WE, Snap::tr("Frame %1").arg(name), false);
    else if (entity.kind() != workcell::EntityKind::kAssembly)
      look(X_WE, Snap::tr("Origin of %1").arg(name), true);
  }
  if (nearest && !is_origin) return nearest;
  const auto feature = viewport.featureNear(position, without);
  // An origin may lie unseen within its part: a corner that is seen there comes first.
  const bool is_corner = feature && feature->kind == FeatureKind::kVertex;
  if (nearest && (!is_corner || glm::distance(feature->p_WQ, nearest->X_WS.p) < kSamePlace)) return nearest;
  if (!feature) return std::nullopt;
  SnapPoint point{featureFrame_W(*feature), QString::fromStdString(featureText(*feature))};
  // On a face or an edge the place is the pointer's; an axis or a centre is meant only where it is round.
  if (feature->kind == FeatureKind::kFace || feature->edge != EdgeShape::kCircle) point.X_WS.p = feature->p_WQ;
  return point;
}

}  // namespace hapticell::app
