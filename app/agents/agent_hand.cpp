// SPDX-License-Identifier: Apache-2.0
#include "app/agents/agent_hand.h"

#include <QMouseEvent>
#include <algorithm>
#include <cmath>

#include "app/host/host.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {

namespace {

/// Pixels (at 100 %) around the moved frame where a press takes it. Half: missed by a hurried hand; twice: clicks meant for parts.
constexpr double kTakes = 24.0;
/// 1/s: the frame goes this share of the way to the pointer a second, and m/s at most. Half: lags behind; twice: jerks.
constexpr double kPull = 4.0, kFastest = 0.4;
/// m/s and rad/s of the stylus below which it rests.
constexpr double kRests = 0.002, kRestsTurning = 0.02;

}  // namespace

AgentHand::AgentHand(Host& host, QObject* parent) : QObject(parent), host_(host) {
  host_.viewport().installEventFilter(this);
}

void AgentHand::setOn(bool on) {
  if (on == on_) return;
  on_ = on;
  target_.reset();
  stylus_.reset();
  stylus_velocity_.reset();
}

void AgentHand::setStylusLeads(bool leads) {
  stylus_leads_ = leads;
  stylus_.reset();
  stylus_velocity_.reset();
}

std::optional<Twist> AgentHand::velocity() {
  if (target_) {
    dvec3 v = kPull * (*target_ - X_WM_.p);
    const double fast = glm::length(v);
    if (fast > kFastest) v *= kFastest / fast;
    return Twist{v, dvec3(0.0)};
  }
  const auto& snapshot = host_.snapshot();
  if (!on_ || !stylus_leads_ || !snapshot || !snapshot->stylus.connected || snapshot->stylus.held != 0) {
    stylus_.reset();
    return std::nullopt;
  }
  const StylusAt now{snapshot->time_s, snapshot->stylus.X_WStylus};
  if (stylus_ && now.t > stylus_->t) {
    const Twist way = difference(now.X_WS, stylus_->X_WS);
    const double dt = now.t - stylus_->t;
    Twist velocity{way.linear / dt, way.angular / dt};
    stylus_velocity_ = velocity;
    if (glm::length(velocity.linear) < kRests && glm::length(velocity.angular) < kRestsTurning)
      stylus_velocity_.reset();  // A hand that rests leaves the way to the agents.
  }
  if (!stylus_ || now.t > stylus_->t) stylus_ = now;
  return stylus_velocity_;
}

std::optional<dvec3> AgentHand::underPointer(const QPointF& place, const dvec3& p_W) const {
  const Camera& camera = host_.viewport().camera();
  const Ray ray = camera.rayThrough({place.x(), place.y()}, host_.viewport().viewSize());
  const dvec3 n = camera.forward_W();
  const double slope = glm::dot(ray.direction_W, n);
  if (std::abs(slope) < 1e-6) return std::nullopt;
  return ray.origin_W + (glm::dot(p_W - ray.origin_W, n) / slope) * ray.direction_W;
}

bool AgentHand::take(const QPointF& place) {
  const auto seen = host_.viewport().camera().project(X_WM_.p, host_.viewport().viewSize());
  if (!seen || glm::length(*seen - glm::dvec2(place.x(), place.y())) > kTakes) return false;
  const auto at = underPointer(place, X_WM_.p);
  if (!at) return false;
  grip_ = X_WM_.p - *at;
  target_ = X_WM_.p;
  return true;
}

void AgentHand::pull(const QPointF& place) {
  if (const auto at = underPointer(place, *target_)) target_ = *at + grip_;
}

bool AgentHand::eventFilter(QObject* watched, QEvent* event) {
  const auto type = event->type();
  const bool is_mouse =
      type == QEvent::MouseButtonPress || type == QEvent::MouseMove || type == QEvent::MouseButtonRelease;
  if (!on_ || !is_mouse) return QObject::eventFilter(watched, event);
  const auto& mouse = static_cast<QMouseEvent&>(*event);
  if (type == QEvent::MouseButtonPress) return mouse.button() == Qt::LeftButton && take(mouse.position());
  if (!target_) return false;
  if (type == QEvent::MouseMove) pull(mouse.position());
  if (type == QEvent::MouseButtonRelease && mouse.button() == Qt::LeftButton) target_.reset();
  return true;
}

}  // namespace hapticell::app
