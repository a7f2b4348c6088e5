// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "manipulation/engine/plan_source.h"

namespace hapticell::manipulation {

/// Records where the held entity goes, for a planner: what the hand has shown is a way that is known to be free.
/// Manipulation thread only.
class HandTrail {
 public:
  void clear();
  /// Adds the configuration when its moved frame X_WM is `spacing` (m; 0.1 m a radian) or more from the last one. A
  /// trail that becomes too long is thinned.
  void add(const EntityConfiguration& at, const Pose& X_WM, double spacing);
  /// Never null.
  const std::shared_ptr<const Trail>& trail() const { return trail_; }

 private:
  std::shared_ptr<const Trail> trail_ = std::make_shared<const Trail>();
  Pose X_WLast_;
};

}  // namespace hapticell::manipulation
