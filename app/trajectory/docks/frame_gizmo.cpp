// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/docks/frame_gizmo.h"

#include "app/host/host.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

constexpr double kPixels = 84.0;  // Of an arrow.
constexpr const char* kOwner = "motion gizmo";

}  // namespace

FrameGizmo::FrameGizmo(Host& host, QObject* parent) : QObject(parent), host_(host) {
  host_.viewport().setPointerTool(this, ToolChain::kMotion);
  connect(&host_.viewport(), &ViewportWidget::cameraChanged, this, &FrameGizmo::draw);
}

// Nothing is taken back: the viewport may be gone before, it is the window's child as well.
FrameGizmo::~FrameGizmo() = default;

void FrameGizmo::setFrame(const std::optional<Pose>& X_WT) {
  if (drag_) return;
  X_WT_ = X_WT;
  over_.reset();
  draw();
}

Gizmo FrameGizmo::gizmoAt(const Pose& X_WT, const Camera& camera, const ViewSize& view) const {
  Gizmo gizmo;
  gizmo.X_WG = X_WT;
  gizmo.size = kPixels * camera.metresPerPixel(X_WT.p, view);
  return gizmo;
}

void FrameGizmo::draw() {
  ViewportWidget& viewport = host_.viewport();
  std::vector<SceneCurve> curves;
  if (X_WT_) {
    const ViewSize view{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
    curves = gizmoAt(*X_WT_, viewport.camera(), view).curves(drag_ ? drag_->handle : over_);
  }
  viewport.setCurves(kOwner, std::move(curves));
}

bool FrameGizmo::press(const PointerEvent& event) {
  if (!X_WT_ || event.button != Qt::LeftButton) return false;
  const Gizmo gizmo = gizmoAt(*X_WT_, event.camera, event.size);
  const auto handle = gizmo.hit(event.pixel, event.camera, event.size);
  const auto from = handle ? gizmo.valueOf(*handle, event.camera.rayThrough(event.pixel, event.size)) : std::nullopt;
  if (!from) return false;
  drag_ = Drag{gizmo, *handle, *from, *X_WT_};
  draw();
  return true;
}

bool FrameGizmo::move(const PointerEvent& event) {
  if (!X_WT_) return false;
  if (!drag_) {
    const auto before = over_;
    over_ = gizmoAt(*X_WT_, event.camera, event.size).hit(event.pixel, event.camera, event.size);
    if (over_ != before) draw();
    return over_.has_value();
  }
  const auto value = drag_->gizmo.valueOf(drag_->handle, event.camera.rayThrough(event.pixel, event.size));
  if (!value) return true;
  X_WT_ = drag_->gizmo.dragged(drag_->handle, drag_->from, *value, drag_->X_WT);
  draw();
  emit dragged(*X_WT_);
  return true;
}

bool FrameGizmo::release(const PointerEvent& event) {
  if (!drag_ || event.button != Qt::LeftButton) return false;
  drag_.reset();
  draw();
  emit dropped(*X_WT_);
  return true;
}

bool FrameGizmo::cancel() {
  if (!drag_) return false;
  X_WT_ = drag_->X_WT;
  drag_.reset();
  draw();
  emit dragged(*X_WT_);
  return true;
}

QString FrameGizmo::hint() const {
  if (drag_) return tr("Esc: cancel the drag");
  if (!over_) return {};
  return over_->turns ? tr("Drag to turn the frame") : tr("Drag to move the frame");
}

}  // namespace hapticell::app
