// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bitset>
#include <cstddef>
#include <span>
#include <vector>

#include "manipulation/manipulators/manipulator.h"

namespace hapticell::planning {

/// A motion whose parts' poses are asked for, mostly where it is halved again and again: those are found once for all
/// parts. What it is made of must outlive it. One thread.
class PlannedMotion {
 public:
  /// `parts`: how many the manipulator moves.
  PlannedMotion(const manipulation::Manipulator& manipulator, const manipulation::EntityConfiguration& from, const manipulation::EntityConfiguration& to,
                std::size_t parts)
      : manipulator_(manipulator), from_(from), to_(to), parts_(parts), X_WP_((kKept + 1) * parts) {}

  /// X_WP of a part at `s` in [0, 1].
  Pose poseOf(std::size_t part, double s) {
    const double place = s * static_cast<double>(kKept);
    const auto index = static_cast<std::size_t>(place);
    if (static_cast<double>(index) != place) return manipulator_.partPose(placed(s), part);
    const std::span<Pose> all(X_WP_.data() + index * parts_, parts_);
    if (!is_known_[index]) manipulator_.partPoses(manipulator_.between(from_, to_, s), all);
    is_known_[index] = true;
    return all[part];
  }

 private:
  /// Half: poses are computed again for each part in pieces of a 32nd; twice: more memory is filled a motion.
  static constexpr std::size_t kKept = 64;

  const manipulation::EntityConfiguration& placed(double s) {
    if (s != s_) at_ = manipulator_.between(from_, to_, s);
    s_ = s;
    return at_;
  }

  const manipulation::Manipulator& manipulator_;
  const manipulation::EntityConfiguration& from_;
  const manipulation::EntityConfiguration& to_;
  std::size_t parts_;
  std::vector<Pose> X_WP_;  ///< At s of i / kKept, one part after the other.
  std::bitset<kKept + 1> is_known_;
  double s_ = -1.0;
  manipulation::EntityConfiguration at_;
};

}  // namespace hapticell::planning
