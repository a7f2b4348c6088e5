// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "manipulation/holding/held_model.h"

namespace hapticell::manipulation {

/// Dry friction of a mechanism's joints as the hand feels it. One thread.
class JointFriction {
 public:
  explicit JointFriction(const HeldModel& model);

  /// Computes it for the entity's present configuration.
  void update(const Manipulator& manipulator, const EntityConfiguration& at);
  /// N, in steps of 0.05; 0 without friction.
  double felt() const { return felt_; }

 private:
  std::vector<double> friction_;  ///< Of the model's variables, N m or N; empty if there is no friction.
  double felt_ = 0.0;
};

}  // namespace hapticell::manipulation
