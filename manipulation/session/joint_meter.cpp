// SPDX-License-Identifier: Apache-2.0
#include "manipulation/session/joint_meter.h"

#include <algorithm>
#include <cmath>

namespace hapticell::manipulation {

void JointMeter::add(double t, const ManipulationEngine& engine) {
  const HeldEntity* held = engine.held();
  const workcell::Entity* entity = held ? engine.scene()->find(held->id()) : nullptr;
  if (!entity || !entity->robot() || entity->figure()) {
    id_ = 0;
    return;
  }
  const std::vector<double> now = held->standing().joints;
  const bool goes_on = id_ == held->id() && before_.size() == now.size() && t > t_before_;
  if (joints_.size() != now.size()) joints_.assign(now.size(), {});
  for (std::size_t i = 0; i < now.size(); ++i) {
    JointUse& use = joints_[i];
    const int joint = entity->robot()->moving[i];
    if (use.joint < 0) {
      use = {joint, now[i], now[i], 0.0,
             kinematics::greatestSpeed(entity->robot()->joints[static_cast<std::size_t>(joint)])};
    }
    use.lowest = std::min(use.lowest, now[i]);
    use.highest = std::max(use.highest, now[i]);
    if (goes_on) use.max_speed = std::max(use.max_speed, std::abs(now[i] - before_[i]) / (t - t_before_));
  }
  before_ = now;
  t_before_ = t;
  id_ = held->id();
}

}  // namespace hapticell::manipulation
