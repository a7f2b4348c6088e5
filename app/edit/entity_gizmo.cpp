// SPDX-License-Identifier: Apache-2.0
#include "app/edit/entity_gizmo.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "app/host/document_model.h"
#include "app/host/hold_choice.h"
#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/style/units.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

constexpr double kPixels = 96.0;  // Of an arrow.
constexpr const char* kGizmoCurves = "entity gizmo";

}  // namespace

EntityGizmo::EntityGizmo(Host& host, QObject* parent) : QObject(parent), host_(host) {
  connect(&host_.viewport(), &ViewportWidget::cameraChanged, this, &EntityGizmo::showNow);
  connect(&host_.viewport(), &ViewportWidget::sceneChanged, this, &EntityGizmo::showNow);
  connect(&host_.selection(), &Selection::allChanged, this, &EntityGizmo::showNow);
  connect(&host_.holdChoice(), &HoldChoice::changed, this, &EntityGizmo::showNow);
}

EntityGizmo::~EntityGizmo() = default;

void EntityGizmo::setMode(Mode mode) {
  if (mode == mode_) return;
  cancel();
  mode_ = mode;
  over_.reset();
  emit modeChanged();
  showNow();
}

void EntityGizmo::setAxes(EditAxes axes, const dquat& R_WF) {
  axes_ = axes;
  R_WF_ = R_WF;
  showNow();
}

bool EntityGizmo::isShownElsewhere(const std::vector<workcell::EntityId>& ids) const {
  const auto& snapshot = host_.snapshot();
  const SceneModel& scene = host_.viewport().scene();
  return std::any_of(ids.begin(), ids.end(), [&](workcell::EntityId id) {
    const Pose& X_WE = host_.documentModel().document().find(id)->X_WE;
    const workcell::Entity* shown = scene.find(id);
    const Pose X_WShown = shown ? scene.placement_W(*shown) : X_WE;
    return (snapshot && snapshot->stylus.held == id) || X_WShown.p != X_WE.p || X_WShown.q != X_WE.q;
  });
}

std::vector<workcell::EntityId> EntityGizmo::moved() const {
  const auto ids = movedTogether(host_.documentModel().document().state(), host_.selection().all());
  return isShownElsewhere(ids) ? std::vector<workcell::EntityId>{} : ids;
}

std::optional<Pose> EntityGizmo::pose_W() const {
  const auto& state = host_.documentModel().document().state();
  const std::vector<workcell::EntityId> ids = moved();
  if (ids.empty()) return std::nullopt;
  const auto current = host_.selection().current();
  const bool among = std::find(ids.begin(), ids.end(), current) != ids.end();
  const workcell::Entity& entity = *state.find(among ? current : ids.back());
  Pose X_WG = entity.X_WE;
  const HoldChoice& hold = host_.holdChoice();
  if (hold.is<by::Center>()) {
    const auto bounds = entity.mesh() ? entity.mesh()->bounds() : geometry::Bounds();
    X_WG.p = entity.mesh() ? X_WG * bounds.center() : host_.viewport().scene().boundsOf_W(entity.id).center();
  }
  for (const workcell::Frame& frame : entity.frames)
    if (hold.is<by::Frame>() && frame.name == hold.frame()) X_WG = entity.X_WE * frame.X_EF;
  if (axes_ == EditAxes::kWorld) X_WG.q = dquat(1, 0, 0, 0);
  if (axes_ == EditAxes::kFrame) X_WG.q = R_WF_;
  if (axes_ == EditAxes::kParent) X_WG.q = parentPose_W(state, entity).q;
  return X_WG;
}

Gizmo EntityGizmo::gizmoAt(const Pose& X_WG, const Camera& camera, const ViewSize& view) const {
  Gizmo gizmo;
  gizmo.X_WG = X_WG;
  gizmo.size = kPixels * camera.metresPerPixel(X_WG.p, view);
  gizmo.arrows = gizmo.middle = mode_ == Mode::kMove;
  gizmo.rings = mode_ == Mode::kRotate;
  return gizmo;
}

void EntityGizmo::showNow() {
  ViewportWidget& viewport = host_.viewport();
  std::vector<SceneCurve> curves;
  const auto X_WG = mode_ != Mode::kSelect ? pose_W() : std::nullopt;
  if (X_WG) {
    const ViewSize view{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
    curves = gizmoAt(*X_WG, viewport.camera(), view).curves(drag_ ? drag_->handle : over_);
    using Role = SceneCurve::Role;
    if (drag_ && drag_->snap)
      curves.push_back(
          {{drag_->snap->X_WS.p}, Role::kGuide, SceneCurve::Style::kSolid, 2.0, drag_->snap->text.toStdString()});
    if (drag_ && !drag_->number.isEmpty())
      curves.push_back({{X_WG->p}, Role::kSelection, SceneCurve::Style::kSolid, 1.5, drag_->number.toStdString()});
  }
  viewport.setCurves(kGizmoCurves, std::move(curves));
}

bool EntityGizmo::press(const PointerEvent& event) {
  if (mode_ == Mode::kSelect || event.button != Qt::LeftButton || drag_) return false;
  const auto X_WG = pose_W();
  if (!X_WG) return false;
  const Gizmo gizmo = gizmoAt(*X_WG, event.camera, event.size);
  const auto handle = gizmo.hit(event.pixel, event.camera, event.size);
  if (!handle) return false;
  const Ray ray = event.camera.rayThrough(event.pixel, event.size);
  Drag drag{gizmo, *handle, 0.0, gizmo.freePoint_W(ray, event.camera), moved(), {}, {}, {}};
  if (handle->axis != Gizmo::kFree) {
    const auto from = gizmo.valueOf(*handle, ray);
    if (!from) return false;
    drag.from = *from;
  }
  const auto& state = host_.documentModel().document().state();
  for (const auto id : drag.ids) drag.X_WE.push_back(state.find(id)->X_WE);
  drag_ = std::move(drag);
  host_.documentModel().beginStep(stepText(handle->turns));
  showNow();
  return true;
}

QString EntityGizmo::stepText(bool turns) const {
  const std::vector<workcell::EntityId> ids = moved();
  if (ids.size() != 1)
    return (turns ? tr("Rotate %n entities", nullptr, static_cast<int>(ids.size()))
                  : tr("Move %n entities", nullptr, static_cast<int>(ids.size())));
  const QString name = QString::fromStdString(host_.documentModel().document().find(ids.front())->name);
  return turns ? tr("Rotate %1").arg(name) : tr("Move %1").arg(name);
}

/// A value on the grid: of world or parent where these are the axes, else of the motion.
double EntityGizmo::snappedValue(double value) const {
  const bool turns = drag_->handle.turns;
  const double moved = value - drag_->from;
  if (turns) return drag_->from + stepped(std::remainder(moved, glm::two_pi<double>()), steps_.angle);
  if (axes_ == EditAxes::kOwn) return drag_->from + stepped(moved, steps_.length);
  const dvec3 p_G =
      drag_->gizmo.X_WG.q * dvec3(drag_->handle.axis == 0, drag_->handle.axis == 1, drag_->handle.axis == 2);
  const double start = glm::dot(drag_->gizmo.X_WG.p, p_G);
  return drag_->from + stepped(start + moved, steps_.length) - start;
}

double EntityGizmo::valueNow(const PointerEvent& event, double otherwise) {
  if (drag_->snap) {
    // The grabbed handle's zero goes to the point: an arrow's along, a ring's towards it.
    const double at = drag_->gizmo.valueAt(drag_->handle, drag_->snap->X_WS.p);
    return drag_->handle.turns ? at : drag_->from + at;
  }
  const auto value = drag_->gizmo.valueOf(drag_->handle, event.camera.rayThrough(event.pixel, event.size));
  return value ? snappedValue(*value) : otherwise;
}

Pose EntityGizmo::dragPose(const PointerEvent& event) {
  const Gizmo& gizmo = drag_->gizmo;
  if (drag_->handle.axis != Gizmo::kFree) {
    const double value = valueNow(event, drag_->from);
    const double moved = value - drag_->from;
    drag_->number = drag_->handle.turns ? angleText(std::remainder(moved, glm::two_pi<double>())) : lengthText(moved);
    return gizmo.dragged(drag_->handle, drag_->from, value, gizmo.X_WG);
  }
  dvec3 p_W = drag_->snap
                  ? drag_->snap->X_WS.p
                  : gizmo.X_WG.p + gizmo.freePoint_W(event.camera.rayThrough(event.pixel, event.size), event.camera) -
                        drag_->p_WFrom;
  if (!drag_->snap && steps_.length > 0.0) {
    dvec3 p_G = glm::conjugate(gizmo.X_WG.q) * p_W;
    for (int axis = 0; axis < 3; ++axis) p_G[axis] = stepped(p_G[axis], steps_.length);
    p_W = gizmo.X_WG.q * p_G;
  }
  drag_->number = lengthText(glm::length(p_W - gizmo.X_WG.p));
  return {p_W, gizmo.X_WG.q};
}

bool EntityGizmo::move(const PointerEvent& event) {
  if (mode_ == Mode::kSelect) return false;
  if (!drag_) {
    const auto before = over_;
    const auto X_WG = event.buttons == Qt::NoButton ? pose_W() : std::nullopt;
    over_ = X_WG ? gizmoAt(*X_WG, event.camera, event.size).hit(event.pixel, event.camera, event.size) : std::nullopt;
    if (over_ != before) showNow();
    return over_.has_value();
  }
  const bool snaps = snapping_ != event.modifiers.testFlag(Qt::ControlModifier);
  drag_->snap = snaps ? snapAt(host_.viewport(), QPointF(event.pixel.x, event.pixel.y), drag_->ids) : std::nullopt;
  const Pose X_WNow = dragPose(event);
  follow(X_WNow * drag_->gizmo.X_WG.inverse());
  const Pose X_GNow = drag_->gizmo.X_WG.inverse() * X_WNow;
  emit dragged({X_GNow.p, rotationVector(X_GNow.q)});
  return true;
}

void EntityGizmo::follow(const Pose& M_W) {
  std::vector<workcell::Command> commands;
  for (std::size_t i = 0; i < drag_->ids.size(); ++i)
    commands.push_back(workcell::SetPlacement{drag_->ids[i], M_W * drag_->X_WE[i]});
  host_.documentModel().executeWithin(commands);
}

bool EntityGizmo::release(const PointerEvent& event) {
  if (!drag_ || event.button != Qt::LeftButton) return false;
  drag_.reset();
  host_.documentModel().endStep();
  showNow();
  return true;
}

bool EntityGizmo::cancel() {
  if (!drag_) return false;
  drag_.reset();
  host_.documentModel().cancelStep();
  showNow();
  return true;
}

void EntityGizmo::applyMotion(const Pose& M_W, const QString& text) {
  const auto ids = moved();
  if (ids.empty() || drag_) return;
  host_.documentModel().executeAll(text, moveCommands(host_.documentModel().document().state(), ids, M_W));
}

void EntityGizmo::moveBy(const Twist& motion_G) {
  const auto X_WG = pose_W();
  if (!X_WG) return;
  const Pose X_GMoved{motion_G.linear, quaternionFromRotationVector(motion_G.angular)};
  applyMotion(*X_WG * X_GMoved * X_WG->inverse(), stepText(glm::length(motion_G.linear) == 0.0));
}

QString EntityGizmo::hint() const {
  if (drag_)
    return snapping_ ? tr("Snapping to corners, edges, faces and frames · Ctrl: free · Esc: cancel")
                     : tr("Ctrl: snap to corners, edges, faces and frames · Esc: cancel");
  if (!over_) return {};
  if (over_->axis == Gizmo::kFree) return tr("Drag to move parallel to the screen");
  return over_->turns ? tr("Drag to rotate") : tr("Drag to move");
}

}  // namespace hapticell::app
