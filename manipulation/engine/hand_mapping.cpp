// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/hand_mapping.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace hapticell::manipulation {

namespace {

/// Of the workspace's half width, where drifting begins: the last 12 mm of 160. Half: it drifts in the middle; nearer
/// to 1: from rest to full speed within a millimetre or two.
constexpr double kEdgeBegins = 0.85;
/// s that one step of the drift can stand for: what stood still does not leap (kLongestScriptStep). Half: at 10 Hz it
/// is slower than asked for; twice: leaps of twice the length.
constexpr double kLongestDrift = 0.1;
/// m: width of a device that has not reported its own, the Phantom Desktop's. Half and twice: the scale of the screen
/// is twice or half.
constexpr double kUsualWorkspace = 0.16;

}  // namespace

HandMapping::HandMapping() {
  camera_.X_WCamera = {dvec3(0.0, -1.0, 0.0), quaternionFromRotationVector(dvec3(0.5 * std::numbers::pi, 0.0, 0.0))};
}

void HandMapping::setFilter(const command::SetFilter& filter) {
  mapping_.setFilter(filter.translates, filter.rotates);
  mapping_.setAxisFilter(filter.axes[0], filter.axes[1], filter.axes[2]);
  mapping_.setTurnFilter(filter.turns[0], filter.turns[1], filter.turns[2]);
}

double HandMapping::scaleInForce(const Device& device, const config::Configuration::Scale& levels) const {
  switch (scale_.level) {
    case ScaleLevel::kRough:
      return levels.rough;
    case ScaleLevel::kMedium:
      return levels.medium;
    case ScaleLevel::kFine:
      return levels.fine;
    case ScaleLevel::kNumber:
      return scale_.number;
    case ScaleLevel::kScreen:
      break;
  }
  const double width = device ? device->workspace_max.x - device->workspace_min.x : kUsualWorkspace;
  return levels.screen * screenScale(camera_.visible_width, width);
}

bool HandMapping::update(const Pose& X_WF, const Device& device, const config::Configuration::Scale& levels) {
  const dquat q_WD = deviceAxes(axes_.mode, camera_.X_WCamera, X_WF);
  const double scale = scaleInForce(device, levels);
  // Turning the view a little all the time must not make new sets all the time.
  const bool same = std::abs(glm::dot(q_WD, mapping_.axes())) > 1.0 - 1e-12 && scale == mapping_.scale();
  mapping_.setAxes(q_WD);
  mapping_.setScale(scale);
  mapping_.setRotationScale(levels.rotation);
  return !same;
}

bool HandMapping::setClutched(bool clutched) {
  return std::exchange(clutched_, clutched) != clutched;
}

bool HandMapping::drift(const haptic::DeviceDescription* device, const dvec3& p_DP, double fastest,
                        std::int64_t now_ns) {
  const double dt =
      drift_ns_ > 0 ? std::clamp(1e-9 * static_cast<double>(now_ns - drift_ns_), 0.0, kLongestDrift) : 0.0;
  drift_ns_ = now_ns;
  const dvec3 before = std::exchange(drift_D_, dvec3(0.0));
  for (int i = 0; device != nullptr && fastest > 0.0 && i < 3; ++i) {
    const double middle = 0.5 * (device->workspace_max[i] + device->workspace_min[i]);
    const double half = 0.5 * (device->workspace_max[i] - device->workspace_min[i]);
    if (half <= 0.0) continue;
    const double at = (p_DP[i] - middle) / half;
    const double lean = std::clamp((std::abs(at) - kEdgeBegins) / (1.0 - kEdgeBegins), 0.0, 1.0);
    drift_D_[i] = std::copysign(fastest * lean, at);
  }
  mapping_.drift(dt * drift_D_);
  return glm::distance(drift_D_, before) > 0.1 * fastest;
}

}  // namespace hapticell::manipulation
