// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "geometry/shapes/pose.h"
#include "geometry/system/error.h"

namespace hapticell::kinematics {

class InverseModel;
struct RobotModel;

/// Distance to a limit that no variable sets directly (a passive joint, the ball joint of a rod, a singularity);
/// negative beyond it.
struct ClosureMargin {
  Text what;           ///< "rod 3's ball joint", for a sentence such as "... is 2.1 deg from its limit".
  double value = 0.0;  ///< rad, m or (singularities) dimensionless.
  enum class Kind { kAngle, kLength, kSingularity } kind = Kind::kAngle;
};

/// Closes the loops of a robot that is not a tree of joints: computes the poses of all links from the variables.
///
/// The variables of a model with a closure are only the joints that users set (the motors of a Delta, the legs of a
/// hexapod). Immutable; const methods are thread-safe.
class Closure {
 public:
  virtual ~Closure() = default;

  /// The class of the inverse model: "delta", "hexapod", "loops".
  virtual std::string name() const = 0;

  /// Poses X_BL of all links in the root link's frame B for `q`, one number per variable, in the assembly of the home
  /// position. False if the loops cannot be closed at `q`: the poses are then the nearest ones found.
  virtual bool pose(const std::vector<double>& q, std::vector<Pose>& X_BL) const = 0;

  /// Limits at `q` in addition to those of the variables. Always the same number in the same order.
  virtual void margins(const std::vector<double>& q, std::vector<ClosureMargin>& out) const = 0;

  /// The inverse model for the tool centre point X_LT on `tip_link`. Errors: nothing moves that link.
  virtual Expected<std::unique_ptr<InverseModel>> inverse(const RobotModel& model, int tip_link,
                                                          const Pose& X_LT) const = 0;
};

}  // namespace hapticell::kinematics
