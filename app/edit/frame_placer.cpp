// SPDX-License-Identifier: Apache-2.0
#include "app/edit/frame_placer.h"

#include <QMouseEvent>

#include "app/edit/snap.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/viewport/frame_triads.h"
#include "app/viewport/viewport_widget.h"
#include "workcell/entity_source.h"

namespace hapticell::app {
namespace {

constexpr const char* kPlacedFrame = "placed frame";
constexpr double kFloorReach = 200.0;       // m along the ray: beyond, the pointer is near the horizon.
constexpr double kFrameClickPixels = 4.0;   // As the viewport tells a click from a drag.
constexpr QSizeF kFrameViewCube{130, 130};  // Pixels at the right top, where a click turns the view.

}  // namespace

FramePlacer::FramePlacer(Host& host, QObject* parent) : QObject(parent), host_(host) {}

FramePlacer::~FramePlacer() = default;

void FramePlacer::begin() {
  if (on_) return;
  host_.viewport().startPick(
      {{.faces = true, .edges = true, .vertices = true},
       tr("Click where the frame shall be: a corner, an edge, a face or the floor; Esc: not now"),
       [this](const std::optional<PickedFeature>& feature) {
         const bool on = on_;
         const auto shown = X_WF_;
         forget();
         if (feature && on) insert(shown.value_or(featureFrame_W(*feature)));
       }});
  on_ = true;
  host_.viewport().installEventFilter(this);
}

void FramePlacer::forget() {
  on_ = false;
  host_.viewport().removeEventFilter(this);
  showAt(std::nullopt);
}

void FramePlacer::insert(const Pose& X_WF) {
  DocumentModel& document = host_.documentModel();
  const std::string name = document.document().uniqueName(tr("Frame").toStdString());
  if (!document.execute(workcell::AddEntity{workcell::makeFrame(name, X_WF)})) return;
  if (const workcell::Entity* made = document.document().findByName(name)) host_.selection().set(made->id);
}

std::optional<Pose> FramePlacer::poseAt(const QPointF& position) const {
  ViewportWidget& viewport = host_.viewport();
  const QRectF cube(QPointF(viewport.width() - kFrameViewCube.width(), 0.0), kFrameViewCube);
  if (viewport.viewStrip().cellAt(position) >= 0 || cube.contains(position)) return std::nullopt;
  if (const auto snapped = snapAt(viewport, position, {})) return snapped->X_WS;
  const ViewSize size{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
  const Ray ray_W = viewport.camera().rayThrough({position.x(), position.y()}, size);
  const double along = -ray_W.origin_W.z / ray_W.direction_W.z;
  if (!(along > 0.0 && along < kFloorReach)) return std::nullopt;
  const dvec3 p_W = ray_W.origin_W + along * ray_W.direction_W;
  return Pose::translation({p_W.x, p_W.y, 0.0});
}

void FramePlacer::showAt(const std::optional<Pose>& X_WF) {
  X_WF_ = X_WF;
  ViewportWidget& viewport = host_.viewport();
  std::vector<SceneCurve> curves;
  if (X_WF) {
    const ViewSize size{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
    curves = triadCurves(*X_WF, triadLength(X_WF->p, viewport.camera(), size), {}, true, 3.0);
  }
  viewport.setCurves(kPlacedFrame, std::move(curves));
}

bool FramePlacer::eventFilter(QObject* watched, QEvent* event) {
  const auto* mouse = dynamic_cast<const QMouseEvent*>(event);
  if (event->type() == QEvent::Leave) showAt(std::nullopt);
  if (mouse && event->type() == QEvent::MouseMove && mouse->buttons() == Qt::NoButton)
    showAt(poseAt(mouse->position()));
  if (mouse && event->type() == QEvent::MouseButtonPress) {
    pressed_ = mouse->position();
    if (mouse->button() == Qt::LeftButton) showAt(poseAt(pressed_));
  }
  const bool click = mouse && event->type() == QEvent::MouseButtonRelease && mouse->button() == Qt::LeftButton &&
                     (mouse->position() - pressed_).manhattanLength() <= kFrameClickPixels;
  // A part that is clicked answers the pick itself; what is left is the floor and frames.
  if (click && X_WF_)
    QMetaObject::invokeMethod(
        this,
        [this, X_WF = *X_WF_] {
          if (!on_) return;
          host_.viewport().cancelPick();
          insert(X_WF);
        },
        Qt::QueuedConnection);
  return QObject::eventFilter(watched, event);
}

}  // namespace hapticell::app
