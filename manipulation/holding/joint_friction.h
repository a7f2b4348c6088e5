// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "manipulation/holding/held_model.h"

namespace hapticell::manipulation {

/// Dry friction of a mechanism's joints as the hand feels it. One thread.
class JointFriction {
 public:
  explicit JointFriction(const HeldModel& model);

  /// Works it out anew for where the entity is.
  void update(const Manipulator& manipulator, const EntityConfiguration& at);
  /// N, in steps of 0.05; 0 for what has no friction.
  double felt() const { return felt_; }

 private:
  std::vector<double> friction_;  ///< Of the model's variables, N m or N; empty where none has any.
  double felt_ = 0.0;
};

}  // namespace hapticell::manipulation
