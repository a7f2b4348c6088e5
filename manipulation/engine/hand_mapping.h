// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "config/configuration.h"
#include "haptic/protocol/messages.h"
#include "manipulation/engine/manipulation_command.h"
#include "manipulation/holding/motion_mapping.h"

namespace hapticell::manipulation {

/// How the user wants the hand's motion to be mapped, and the mapping that comes of it: axes, scale, filter, clutch,
/// and the drift at the edge of the workspace. The manipulation thread's.
class HandMapping {
 public:
  using Device = std::optional<haptic::DeviceDescription>;
  /// A camera in front of the cell: screen axes are then the cell's own.
  HandMapping();

  const MotionMapping& mapping() const { return mapping_; }
  const AxesChoice& axes() const { return axes_; }

  /// Each counts after the next update().
  void setAxes(AxesChoice axes) { axes_ = std::move(axes); }
  void setScale(const ScaleChoice& scale) { scale_ = scale; }
  void setCamera(const command::SetCamera& camera) { camera_ = camera; }
  /// Counts after the next anchor().
  void setFilter(const command::SetFilter& filter);
  /// Makes the mapping anew; `X_WF`: the frame that the axes name. False where nothing has changed.
  bool update(const Pose& X_WF, const Device& device, const config::Configuration::Scale& levels);

  /// From now on the stylus at X_DP means the moved frame at X_WM.
  void anchor(const Pose& X_DP, const Pose& X_WM) { mapping_.anchor(X_DP, X_WM); }
  /// The device's middle means the middle of the view: nothing is held.
  void anchorToView() { mapping_.anchor(Pose::identity(), Pose::translation(camera_.p_WFocus)); }
  void lookFrom(const Pose& X_DP) { mapping_.lookFrom(X_DP); }

  /// The hand moves without the entity: by the command, or by the button.
  bool isClutched() const { return clutched_; }
  bool isClutchedByCommand() const { return clutch_command_; }
  void setClutchCommand(bool on) { clutch_command_ = on; }
  /// True where that changes something.
  bool setClutched(bool clutched);

  /// Where the hand leans on the edge of its workspace the entity goes on in that direction, `fastest` (m/s) at most
  /// (rate control at the rim: L. Dominjon's "bubble", 2005). For the force loop everything then moves the other way.
  /// `device` is null where nothing drifts. True where the speed has changed from what a set foresees.
  bool drift(const haptic::DeviceDescription* device, const dvec3& p_DP, double fastest, std::int64_t now_ns);
  /// m/s at which the mapping drifts now.
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
