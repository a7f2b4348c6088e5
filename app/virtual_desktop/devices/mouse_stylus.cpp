// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/devices/mouse_stylus.h"

#include <QObject>
#include <algorithm>
#include <cmath>
#include <limits>

namespace hapticell::app {
namespace {

// So near counts as on the pen, thin as it is. Half: hard to meet; twice: parts behind it cannot be clicked.
constexpr double kPenPixels = 14.0;
// 260 pixels are a quarter turn; our choice. Half, twice: more or less of the table.
constexpr double kRadiansPerPixel = 0.006;
// A step of the wheel is so many pixels of depth. Half: many steps; twice: it leaps into parts.
constexpr double kDepthPixelsPerStep = 24.0;
// The hand may press a little beyond the device's edge, so that its stop is felt. Half: hardly; twice: the pen stays
// behind the mouse for longer.
constexpr double kOvershoot = 1.05;

double distanceToSegment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 along = b - a;
  const double length2 = glm::dot(along, along);
  const double s = length2 > 0.0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) : 0.0;
  return glm::length(p - (a + s * along));
}

}  // namespace

void MouseStylus::tell() {
  if (listener_) listener_(target_);
}

void MouseStylus::hold(bool holding) {
  target_ = {};
  target_.holding = holding;
  dragging_ = false;
  tell();
}

void MouseStylus::setButton(bool pressed) {
  target_.buttons = pressed ? target_.buttons | 1u : target_.buttons & ~1u;
  tell();
}

double MouseStylus::pixelsToPen(const PointerEvent& event) const {
  const auto tip = event.camera.project(state_.p_WTip, event.size);
  const auto tail = event.camera.project(state_.p_WTip + state_.pen_length * state_.d_WPen, event.size);
  const bool drawn = state_.usable && tip && tail;
  return drawn ? distanceToSegment(event.pixel, *tip, *tail) : std::numeric_limits<double>::infinity();
}

bool MouseStylus::hitsPen(const PointerEvent& event) const {
  return pixelsToPen(event) <= kPenPixels;
}

void MouseStylus::shift(const dvec3& motion_W) {
  const dvec3 motion_D = glm::inverse(state_.q_WD) * motion_W / std::max(state_.scale, 1e-6);
  target_.X_DH.p =
      glm::clamp(target_.X_DH.p + motion_D, kOvershoot * state_.workspace_min, kOvershoot * state_.workspace_max);
  tell();
}

void MouseStylus::turn(const dvec3& rotation_W) {
  const dvec3 rotation_D = glm::inverse(state_.q_WD) * rotation_W;
  target_.X_DH.q = glm::normalize(quaternionFromRotationVector(rotation_D) * target_.X_DH.q);
  tell();
}

void MouseStylus::drive(const Twist& motion_D) {
  if (!state_.usable) return;
  target_.holding = true;
  target_.X_DH.p = glm::clamp(target_.X_DH.p + motion_D.linear, kOvershoot * state_.workspace_min,
                              kOvershoot * state_.workspace_max);
  target_.X_DH.q = glm::normalize(quaternionFromRotationVector(motion_D.angular) * target_.X_DH.q);
  tell();
}

bool MouseStylus::press(const PointerEvent& event) {
  if (!state_.usable) return false;
  if (dragging_ && event.button == Qt::RightButton) {
    setButton(true);
    return true;
  }
  if (follow_ && (event.button == Qt::LeftButton || event.button == Qt::RightButton)) {
    setButton(true);
    return true;
  }
  if (event.button != Qt::LeftButton || !hitsPen(event)) return false;
  if (!target_.holding) hold(true);
  dragging_ = has_last_ = true;
  last_ = event.pixel;
  return true;
}

bool MouseStylus::move(const PointerEvent& event) {
  over_pen_ = hitsPen(event);
  const bool driving = state_.usable && (dragging_ || (follow_ && !event.buttons.testFlag(Qt::MiddleButton)));
  const glm::dvec2 step = has_last_ ? event.pixel - last_ : glm::dvec2(0.0);
  last_ = event.pixel;
  has_last_ = true;
  if (!driving) return false;
  if (event.modifiers.testFlag(Qt::ControlModifier)) {
    turn(kRadiansPerPixel * (step.x * event.camera.up_W() + step.y * event.camera.right_W()));
  } else {
    const double metres = event.camera.metresPerPixel(state_.p_WTip, event.size);
    shift(metres * (step.x * event.camera.right_W() - step.y * event.camera.up_W()));
  }
  return true;
}

bool MouseStylus::release(const PointerEvent& event) {
  const bool right = event.button == Qt::RightButton, left = event.button == Qt::LeftButton;
  const bool stylus_button = (right && (dragging_ || follow_)) || (left && follow_);
  if (stylus_button) setButton(false);
  if (event.button == Qt::LeftButton) dragging_ = false;
  return true;
}

bool MouseStylus::wheel(const PointerEvent& event) {
  if (!state_.usable || !(dragging_ || follow_)) return false;
  const double metres = event.camera.metresPerPixel(state_.p_WTip, event.size);
  shift(event.wheel_steps * kDepthPixelsPerStep * metres * event.camera.forward_W());
  return true;
}

QString MouseStylus::hint() const {
  if (!state_.usable) return {};
  const QString verb = state_.holding_entity ? QObject::tr("release") : QObject::tr("hold");
  if (follow_)
    return QObject::tr("The stylus follows the mouse · wheel: depth · Ctrl: rotate · left button: %1 · H: end")
        .arg(verb);
  if (dragging_) return QObject::tr("Drag: move · wheel: depth · Ctrl: rotate · right button or B: %1").arg(verb);
  if (over_pen_) return QObject::tr("Drag the stylus to move it · B: %1 · H: follow the mouse").arg(verb);
  return {};
}

}  // namespace hapticell::app
