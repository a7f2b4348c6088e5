// SPDX-License-Identifier: Apache-2.0
#include "app/mannequin/hand_gizmo.h"

#include <cmath>

#include "app/host/hold_choice.h"
#include "app/host/host.h"
#include "app/mannequin/figure_drag.h"
#include "app/mannequin/mannequin_context.h"
#include "app/style/units.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

using manipulation::isSameWay;
using manipulation::MovedBy;
constexpr double kHandPixels = 84.0;  // Of an arrow.
// m that a hand is short and it is said: lengths are shown in mm. Half: said as 1 mm at the edge of reach; twice: 2 mm
// go unsaid.
constexpr double kShortShown = 1.5e-3;

}  // namespace

HandGizmo::HandGizmo(MannequinContext& context, FigureDrag& drag, QObject* parent)
    : QObject(parent), context_(context), figure_(drag) {
  connect(&context_, &MannequinContext::mannequinChanged, this, &HandGizmo::showNow);
  connect(&context_, &MannequinContext::documentChanged, this, &HandGizmo::showNow);
  connect(&context_.host().viewport(), &ViewportWidget::cameraChanged, this, &HandGizmo::showNow);
  connect(&context_.host().viewport(), &ViewportWidget::sceneChanged, this, &HandGizmo::showNow);
  connect(&context_.host().holdChoice(), &HoldChoice::changed, this, &HandGizmo::showNow);
  connect(&figure_, &FigureDrag::moved, this, &HandGizmo::showNow);
  connect(&figure_, &FigureDrag::ended, this, &HandGizmo::showNow);
}

HandGizmo::~HandGizmo() = default;

MovedBy HandGizmo::held() const {
  const HoldChoice& choice = context_.host().holdChoice();
  const workcell::Entity* entity = context_.entity();
  return entity ? choice.movedByFor(*entity) : choice.movedBy();
}

Pose HandGizmo::frame_W() const {
  const workcell::Entity& entity = *context_.entity();
  const SceneModel& scene = context_.host().viewport().scene();
  return movedFrame_W(entity, {scene.placement_W(entity), scene.joints(entity)}, held());
}

bool HandGizmo::isReady() const {
  return on_ && context_.entity() && context_.isFree();
}

Gizmo HandGizmo::gizmoNow(const Camera& camera, const ViewSize& view) const {
  Gizmo gizmo;
  gizmo.X_WG.p = frame_W().p;
  gizmo.size = kHandPixels * camera.metresPerPixel(gizmo.X_WG.p, view);
  return gizmo;
}

void HandGizmo::setOn(bool on) {
  if (on == on_) return;
  on_ = on;
  if (!on) cancel();
  over_.reset();
  showNow();
}

void HandGizmo::showNow() {
  ViewportWidget& viewport = context_.host().viewport();
  std::vector<SceneCurve> curves;
  if (isReady()) {
    const ViewSize view{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
    curves = gizmoNow(viewport.camera(), view).curves(drag_ ? drag_->handle : over_);
    const QString text = drag_ ? reachText(figure_, held()) : QString();
    if (!text.isEmpty())
      curves.push_back({{frame_W().p}, SceneCurve::Role::kLimit, SceneCurve::Style::kSolid, 2.0, text.toStdString()});
  }
  viewport.setCurves("hand", std::move(curves));
}

bool HandGizmo::press(const PointerEvent& event) {
  if (!isReady() || event.button != Qt::LeftButton || figure_.isOpen()) return false;
  const Gizmo gizmo = gizmoNow(event.camera, event.size);
  const auto handle = gizmo.hit(event.pixel, event.camera, event.size);
  const auto from = handle ? gizmo.valueOf(*handle, event.camera.rayThrough(event.pixel, event.size)) : std::nullopt;
  if (!from) return false;
  drag_ = Drag{gizmo, *handle, *from, frame_W()};
  figure_.begin(
      tr("Drag the %1 of %2").arg(nameOfHeld(held()).toLower(), QString::fromStdString(context_.entity()->name)),
      held(), handle->turns ? FigureDrag::Turn::kAsWanted : FigureDrag::Turn::kWithTheForearm);
  showNow();
  return true;
}

bool HandGizmo::move(const PointerEvent& event) {
  if (!on_) return false;
  if (!drag_) {
    const auto before = over_;
    over_ = isReady() ? gizmoNow(event.camera, event.size).hit(event.pixel, event.camera, event.size) : std::nullopt;
    if (over_ != before) showNow();
    return over_.has_value();
  }
  const auto value = drag_->gizmo.valueOf(drag_->handle, event.camera.rayThrough(event.pixel, event.size));
  if (value) figure_.moveTo(drag_->gizmo.dragged(drag_->handle, drag_->from, *value, drag_->X_WM));
  return true;
}

bool HandGizmo::release(const PointerEvent& event) {
  if (!drag_ || event.button != Qt::LeftButton) return false;
  drag_.reset();
  figure_.end();
  showNow();
  return true;
}

bool HandGizmo::cancel() {
  if (!drag_) return false;
  drag_.reset();
  figure_.end(false);
  showNow();
  return true;
}

QString HandGizmo::hint() const {
  if (drag_) return tr("Esc: cancel the drag");
  if (!over_) return {};
  return over_->turns ? tr("Drag to rotate it; the body follows") : tr("Drag to move it; the body follows");
}

QString nameOfHeld(const MovedBy& held) {
  if (isSameWay(held, by::Hand{mannequin::Side::kLeft})) return HandGizmo::tr("Left hand");
  if (isSameWay(held, by::Hand{mannequin::Side::kRight})) return HandGizmo::tr("Right hand");
  if (std::holds_alternative<by::BothHands>(held)) return HandGizmo::tr("Both hands");
  return std::holds_alternative<by::Head>(held) ? HandGizmo::tr("Head") : HandGizmo::tr("Whole mannequin");
}

QString reachText(const FigureDrag& drag, const MovedBy& held) {
  if (!drag.reach() || drag.reach()->short_m < kShortShown) return {};
  if (drag.isOwnBody()) {
    return HandGizmo::tr("%1: the body itself is in the way, %2 short of the target")
        .arg(nameOfHeld(held))
        .arg(lengthText(drag.reach()->short_m, 0));
  }
  if (!drag.reach()->obstacle.empty()) {
    return HandGizmo::tr("%1: %2 is in the way, %3 short of the target")
        .arg(nameOfHeld(held), QString::fromStdString(drag.reach()->obstacle))
        .arg(lengthText(drag.reach()->short_m, 0));
  }
  return HandGizmo::tr("%1: %2 short of the target").arg(nameOfHeld(held)).arg(lengthText(drag.reach()->short_m, 0));
}

}  // namespace hapticell::app
