// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "config/configuration.h"
#include "haptic/protocol/messages.h"
#include "manipulation/engine/manipulation_command.h"
#include "manipulation/holding/motion_mapping.h"

namespace hapticell::manipulation {

/// The user's choices for mapping the hand's motion, and the resulting mapping: axes, scale, filter, clutch, and the
/// drift at the edge of the workspace. Manipulation thread only.
class HandMapping {
 public:
  using Device = std::optional<haptic::DeviceDescription>;
  /// Starts with a camera in front of the cell, so screen axes equal the cell's axes.
  HandMapping();

  const MotionMapping& mapping() const { return mapping_; }
  const AxesChoice& axes() const { return axes_; }

  /// Each takes effect at the next update().
  void setAxes(AxesChoice axes) { axes_ = std::move(axes); }
  void setScale(const ScaleChoice& scale) { scale_ = scale; }
  void setCamera(const command::SetCamera& camera) { camera_ = camera; }
  /// Takes effect at the next anchor().
  void setFilter(const command::SetFilter& filter);
  /// Updates the mapping; `X_WF`: the frame of the chosen axes. False if nothing has changed.
  bool update(const Pose& X_WF, const Device& device, const config::Configuration::Scale& levels);

  /// From now on the stylus at X_DP corresponds to the moved frame at X_WM.
  void anchor(const Pose& X_DP, const Pose& X_WM) { mapping_.anchor(X_DP, X_WM); }
  /// Nothing is held: the device's middle corresponds to the middle of the view.
  void anchorToView() { mapping_.anchor(Pose::identity(), Pose::translation(camera_.p_WFocus)); }
  /// See MotionMapping::turn().
  void turn(const dquat& q_W, const Pose& X_DP) { mapping_.turn(q_W, X_DP); }
  /// See MotionMapping::shift().
  void shift(const dvec3& way_W) { mapping_.shift(way_W); }
  void lookFrom(const Pose& X_DP) { mapping_.lookFrom(X_DP); }

  /// Whether the hand moves without the entity, by the command or by the button.
  bool isClutched() const { return clutched_; }
  bool isClutchedByCommand() const { return clutch_command_; }
  void setClutchCommand(bool on) { clutch_command_ = on; }
  /// Returns true if that changes something.
  bool setClutched(bool clutched);

  /// If the hand presses against the edge of its workspace, the entity continues in that direction, at most at
  /// `fastest` (m/s) (rate control at the rim: L. Dominjon's "bubble", 2005). For the force loop everything then moves
  /// in the opposite direction. `device` is null if nothing drifts. Returns true if the speed differs from that assumed
  /// in the set.
  bool drift(const haptic::DeviceDescription* device, const dvec3& p_DP, double fastest, std::int64_t now_ns);
  /// Present drift of the mapping, m/s.
  const dvec3& drift_D() const { return drift_D_; }

 private:
  double scaleInForce(const Device& device, const config::Configuration::Scale& levels) const;

  MotionMapping mapping_;
  AxesChoice axes_;
  ScaleChoice scale_;
  command::SetCamera camera_;
  bool clutched_ = false;
  bool clutch_command_ = false;
  dvec3 drift_D_{0.0};
  std::int64_t drift_ns_ = 0;
};

}  // namespace hapticell::manipulation
