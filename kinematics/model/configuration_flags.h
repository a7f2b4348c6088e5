// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>

#include "kinematics/model/chain.h"
#include "kinematics/model/robot_model.h"

namespace hapticell::kinematics {

/// The configuration, one of eight, of a six-axis arm with parallel axes 2 and 3.
struct ArmShape {
  bool front = true;     ///< The wrist centre is on the side of axis 1 that the arm faces.
  bool elbow_up = true;  ///< The elbow is above the line from axis 2 to the wrist centre (for an arm that faces it).
  bool flipped = false;  ///< Joint 5 is on its negative side: axes 4, 5 and 6 form a left-handed system.
  bool wrist_forward = true;  ///< The wrist centre is in front of the line of the lower arm (axis 2 to axis 3).
};

/// Computes the shapes of one chain; data that does not depend on its joints is computed once.
///
/// Const functions allocate nothing and are thread-safe.
class ArmShapes {
 public:
  ArmShapes() = default;  ///< Without a chain: never returns a shape.
  explicit ArmShapes(const Chain& chain);

  /// The shape at `x` of the chain given to the constructor; empty for chains without such branches (see classify():
  /// opw, ur, offset_wrist).
  std::optional<ArmShape> at(const Chain& chain, const ChainPositions& x) const;
  /// The same from the present lines of the arm's six axes (leading slides omitted; origins relative to any one point).
  std::optional<ArmShape> of(const dvec3* axis_B, const dvec3* origin_B) const;
  bool any() const { return any_; }

 private:
  bool any_ = false;
  bool three_parallel_ = false;
  std::size_t rails_ = 0;
  dvec3 up_B_{0.0};
  double forward_sign_ = 1.0;
};

/// ArmShapes(chain).at(chain, x).
std::optional<ArmShape> armShape(const Chain& chain, const ChainPositions& x);

/// "front, elbow up, wrist flipped".
std::string toString(const ArmShape& shape);

/// Maker of a robot, derived from the names of the model and its links.
enum class Maker { kUnknown, kKuka, kAbb, kFanuc };
Maker makerOf(const RobotModel& model);

/// KUKA's status and turn. Status bit 0: wrist centre behind axis 1; bit 1: axis 3 beyond the angle at which the wrist
/// centre, axis 3 and axis 2 are in line; bit 2: axis 5 below zero. Turn bit n: axis n + 1 below zero.
struct KukaFlags {
  int status = 0;
  int turn = 0;
};
KukaFlags kukaFlags(const ArmShape& shape, const std::array<double, 6>& q);

/// ABB's confdata: quadrants floor(angle / 90 deg) of axes 1, 4 and 6, and cfx 0..7, the sum of: 4 if the wrist centre
/// is behind axis 1, 2 if it is behind the lower arm, 1 if axis 5 is negative.
struct AbbFlags {
  int cf1 = 0, cf4 = 0, cf6 = 0, cfx = 0;
};
AbbFlags abbFlags(const ArmShape& shape, const std::array<double, 6>& q);

/// FANUC's configuration: flip (N if joint 5 is negative in FANUC's own convention, otherwise F), elbow U or D, T
/// (toward the front) or B, and how many times joints 1, 4 and 6 passed 180 deg.
struct FanucFlags {
  char wrist = 'N';
  char elbow = 'U';
  char base = 'T';
  std::array<int, 3> turns{};
};
FanucFlags fanucFlags(const ArmShape& shape, const std::array<double, 6>& q);

/// The maker's notation: "S 2, T 35", "cf1 0, cf4 -1, cf6 0, cfx 1", "N U T, 0, 0, 0"; empty for an unknown maker. `q`
/// are the six joints of the arm in the convention of the file.
std::string makerFlags(Maker maker, const ArmShape& shape, const std::array<double, 6>& q);

}  // namespace hapticell::kinematics
