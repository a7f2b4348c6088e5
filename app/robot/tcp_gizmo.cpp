// SPDX-License-Identifier: Apache-2.0
#include "app/robot/tcp_gizmo.h"

#include <limits>

#include "app/host/host.h"
#include "app/robot/joint_mover.h"
#include "app/robot/robot_context.h"
#include "app/style/library_text.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

// Of the inverse model for one place of the mouse, each a bounded step; ends where nothing is won. Half: fast mice
// leave the tool behind; twice: time of a picture.
constexpr int kMostShots = 60;
// m that a radian counts like, as FitTask::lever of kernels.h. Half, twice: only which of two errors ends the shots.
constexpr double kLever = 0.25;
constexpr double kPixels = 96.0;  // Of an arrow.
// As kSoonLimit of robot_stop.cpp.
constexpr double kTcpNearLimit = 0.0349065850398866;

}  // namespace

TcpGizmo::TcpGizmo(RobotContext& context, JointMover& mover, QObject* parent)
    : QObject(parent), context_(context), mover_(mover) {
  connect(&context_.host().viewport(), &ViewportWidget::cameraChanged, this, &TcpGizmo::showNow);
  connect(&context_.host().viewport(), &ViewportWidget::sceneChanged, this, &TcpGizmo::showNow);
}

TcpGizmo::~TcpGizmo() = default;

void TcpGizmo::setOn(bool on) {
  if (on == on_) return;
  on_ = on;
  if (!on) cancel();
  over_.reset();
  showNow();
}

void TcpGizmo::setFrame(kinematics::JogFrame frame, const dquat& R_WF) {
  frame_ = frame;
  R_WF_ = R_WF;
  showNow();
}

Gizmo TcpGizmo::gizmoNow(const Camera& camera, const ViewSize& view) const {
  const Pose X_WT = context_.tool_W();
  Gizmo gizmo;
  gizmo.X_WG.p = X_WT.p;
  if (frame_ == kinematics::JogFrame::kTool) gizmo.X_WG.q = X_WT.q;
  if (frame_ == kinematics::JogFrame::kGiven) gizmo.X_WG.q = R_WF_;
  if (frame_ == kinematics::JogFrame::kBase) gizmo.X_WG.q = context_.base_W().q;
  gizmo.size = kPixels * camera.metresPerPixel(X_WT.p, view);
  return gizmo;
}

void TcpGizmo::showNow() {
  ViewportWidget& viewport = context_.host().viewport();
  std::vector<SceneCurve> curves;
  if (on_ && context_.robot() && context_.inverse() && context_.isFree()) {
    const ViewSize view{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
    curves = gizmoNow(viewport.camera(), view).curves(drag_ ? drag_->handle : over_);
    if (drag_ && !why_.isEmpty())
      curves.push_back(
          {{context_.tool_W().p}, SceneCurve::Role::kLimit, SceneCurve::Style::kSolid, 2.0, why_.toStdString()});
  }
  viewport.setCurves("gizmo", std::move(curves));
}

bool TcpGizmo::press(const PointerEvent& event) {
  if (!on_ || event.button != Qt::LeftButton || !context_.isFree() || !context_.inverse()) return false;
  const Gizmo gizmo = gizmoNow(event.camera, event.size);
  const auto handle = gizmo.hit(event.pixel, event.camera, event.size);
  const auto from = handle ? gizmo.valueOf(*handle, event.camera.rayThrough(event.pixel, event.size)) : std::nullopt;
  if (!from) return false;
  drag_ = Drag{gizmo, *handle, *from, context_.tool_W(), context_.robot()->joints()};
  why_.clear();
  mover_.begin(tr("Drag the TCP of %1").arg(QString::fromStdString(context_.robot()->name)));
  showNow();
  return true;
}

bool TcpGizmo::move(const PointerEvent& event) {
  if (!on_) return false;
  if (!drag_) {
    const auto before = over_;
    over_ = context_.isFree() && context_.inverse()
                ? gizmoNow(event.camera, event.size).hit(event.pixel, event.camera, event.size)
                : std::nullopt;
    if (over_ != before) showNow();
    return over_.has_value();
  }
  const auto value = drag_->gizmo.valueOf(drag_->handle, event.camera.rayThrough(event.pixel, event.size));
  if (value) follow(drag_->gizmo.dragged(drag_->handle, drag_->from, *value, drag_->X_WT));
  return true;
}

void TcpGizmo::follow(const Pose& X_WT) {
  const workcell::Entity* robot = context_.robot();
  const kinematics::InverseModel* inverse = context_.inverse();
  if (!robot || !inverse) return;
  // The mouse comes in leaps; the model's bounded shots follow each other until they rest.
  kinematics::InverseSolution solution;
  const Pose X_BT = robot->X_WE.inverse() * X_WT;
  double before = std::numeric_limits<double>::infinity();
  for (int shot = 0; shot < kMostShots; ++shot) {
    inverse->solveNearest(X_BT, drag_->joints, kinematics::kUnboundedDuration, solution);
    if (solution.q.size() != robot->joints().size()) return;
    drag_->joints = solution.q;
    const double left = solution.position_error + kLever * solution.orientation_error;
    if (solution.status == kinematics::InverseStatus::kSolved || left > 0.999 * before) break;
    before = left;
  }
  why_.clear();
  if (solution.status != kinematics::InverseStatus::kSolved) {
    const Text limit = kinematics::nearestLimitText(*robot->robot(), solution.q, kTcpNearLimit);
    why_ = limit.empty() ? tr("The arm is at the edge of its reach") : shownText(limit);
  }
  emit held(why_);
  mover_.moveTo(solution.q);
  showNow();
}

bool TcpGizmo::release(const PointerEvent& event) {
  if (!drag_ || event.button != Qt::LeftButton) return false;
  drag_.reset();
  mover_.end();
  showNow();
  return true;
}

bool TcpGizmo::cancel() {
  if (!drag_) return false;
  drag_.reset();
  mover_.end(false);
  showNow();
  return true;
}

QString TcpGizmo::hint() const {
  if (drag_) return tr("Esc: cancel the drag");
  if (!over_) return {};
  return over_->turns ? tr("Drag to turn the tool") : tr("Drag to move the tool");
}

}  // namespace hapticell::app
