// SPDX-License-Identifier: Apache-2.0
#include "manipulation/holding/joint_friction.h"

#include <algorithm>
#include <cmath>

#include "workcell/entity/mechanism.h"

namespace hapticell::manipulation {

JointFriction::JointFriction(const HeldModel& model) {
  for (const workcell::Entity* one : model.members()) {
    if (!one->robot()) continue;
    const auto own = one->mechanism() ? workcell::frictionOf(*one->mechanism(), *one->robot())
                                      : std::vector<double>(one->robot()->dof(), 0.0);
    friction_.insert(friction_.end(), own.begin(), own.end());
  }
  const bool any = std::any_of(friction_.begin(), friction_.end(), [](double friction) { return friction > 0.0; });
  if (!any) friction_.clear();
}

/// Rounded, so that the server is not told of every hair's breadth.
void JointFriction::update(const Manipulator& manipulator, const EntityConfiguration& at) {
  /// N: rounded to what is not noticed (7 % of 0.7 N), so that the server does not get each hair's breadth; and what
  /// the server takes (kMostFriction). Half: twice the messages; twice: steps are felt.
  constexpr double kStep = 0.05, kMost = 3.0;
  if (friction_.empty()) return;
  felt_ = std::min(kMost, kStep * std::round(manipulator.resistance(at, friction_) / kStep));
}

}  // namespace hapticell::manipulation
