// SPDX-License-Identifier: Apache-2.0
#include "app/edit/frame_placer.h"

#include <QMouseEvent>

#include "app/edit/snap.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/viewport/widget/floor_point.h"
#include "app/viewport/scene/frame_triads.h"
#include "app/viewport/widget/viewport_widget.h"
#include "workcell/import/entity_source.h"

namespace hapticell::app {
namespace {

constexpr const char* kPlacedFrame = "placed frame";

}  // namespace

FramePlacer::FramePlacer(Host& host, QObject* parent) : QObject(parent), host_(host) {}

FramePlacer::~FramePlacer() = default;

void FramePlacer::begin() {
  if (on_) return;
  host_.viewport().startPick({{.faces = true, .edges = true, .vertices = true},
                              tr("Click a corner, an edge, a face or the floor to place the frame; Esc: cancel"),
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
  if (isOverViewControls(viewport, position)) return std::nullopt;
  if (const auto snapped = snapAt(viewport, position, {})) return snapped->X_WS;
  const auto p_W = floorPoint(viewport, position);
  return p_W ? std::optional(Pose::translation(*p_W)) : std::nullopt;
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
  // A part that is clicked answers the pick itself; what is left is the floor and frames.
  if (mouse && endsClick(*mouse, pressed_) && X_WF_)
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
