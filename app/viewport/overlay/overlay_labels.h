// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/viewport/scene/camera.h"
#include "app/viewport/scene/scene_model.h"
#include "app/viewport/scene/strip_text.h"

namespace hapticell::app {

/// A label for a point of the scene: a mark and a number first, then the names.
struct OverlayLabel {
  std::uint64_t key = 0;
  Mark mark = Mark::kNone;
  std::string number;   ///< "6.4 mm", "Contact"
  std::string names;    ///< "Gripper G2 – Clamp tower B"
  dvec3 p_WQ{0.0};      ///< Where the leader points.
  std::string title{};  ///< Next to the number; empty: none.
  int band = -1;        ///< A patch in a score's colour and pattern (0 to 3) replaces the mark.
  bool operator==(const OverlayLabel&) const = default;
};

/// At most three of the snapshot: the contact, the nearest free pair, the limit.
std::vector<OverlayLabel> overlayLabels(const SceneModel& scene);

/// Length of the force arrow in pixels at 100 %: 40 plus 80 per newton, at most 200; 0 below 0.05 N, where
/// forceArrowOpacity() has faded it out.
double forceArrowLength(double newtons);
double forceArrowOpacity(double newtons);

/// Keys of the texts without a leader: the force's number, and the texts of curves, one after the other.
inline constexpr std::uint64_t kForceKey = 4, kCurveKeys = std::uint64_t{1} << 32;

/// The force arrow as drawn: pixels at 100 %.
struct ForceArrow {
  glm::dvec2 from{0.0}, tip{0.0};
  double opacity = 1.0;
  std::string number;  ///< "1.4 N"
};
/// Empty if there is no force, or if it is behind the eye.
std::optional<ForceArrow> forceArrow(const manipulation::SceneSnapshot& snapshot, const Camera& camera,
                                     const ViewSize& size);

/// Start of the force arrow: the nearest contact, or the stylus's tip if nothing touches.
dvec3 forceArrowStart_W(const manipulation::SceneSnapshot& snapshot);

}  // namespace hapticell::app
