// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "geometry/system/error.h"
#include "kinematics/closures/joint_graph.h"
#include "workcell/scenes/sdf_content.h"

namespace hapticell::workcell {

/// An error of a model in an SDF file.
Error sdfRefusal(const std::filesystem::path& file, Text place, Text found, Text expected);

/// Makes the joints of a robot from those of an SDF file: one for each axis, with its own limits; screws as two; what
/// follows another.
class SdfJointReader {
 public:
  /// Graph and file must outlive this.
  SdfJointReader(kinematics::JointGraph& graph, const std::filesystem::path& file, Diagnostics& diagnostics)
      : graph_(graph), file_(file), diagnostics_(diagnostics) {}

  /// Adds the joints for one of the file. `joint` has its name, its links and its place in M, the robot's frame; the
  /// model that it is in has the pose X_MN, and its names begin with `scope`. Errors name `place`.
  Expected<void> add(const SdfJoint& source, kinematics::GraphJoint& joint, const std::string& scope, const Pose& X_MN,
                     const Text& place);
  /// Sets which joint follows which, once all are there; warns of those that cannot.
  void setMimics();

 private:
  /// An axis of a joint in the robot's frame M, with its own limits.
  struct SdfAxis {
    dvec3 axis_M{0.0};
    double lower = -std::numeric_limits<double>::infinity(), upper = std::numeric_limits<double>::infinity();
    double velocity = 0.0;
  };
  struct MimicOf {
    std::pair<std::string, unsigned> follower, leader;  // Joint, number of its axis.
    double multiplier = 1.0, offset = 0.0;
  };
  Expected<std::vector<SdfAxis>> axesOf(const SdfJoint& source, const std::string& scope, const Pose& X_MN,
                                        const Text& place);
  void addAxes(const kinematics::GraphJoint& prototype, const std::vector<SdfAxis>& axes, bool slides);
  Expected<void> addScrew(const SdfJoint& source, kinematics::GraphJoint& joint, const std::vector<SdfAxis>& axes,
                          const Text& place);
  void noteMimic(const SdfJointAxis& axis, const std::string& scope, const std::string& joint, unsigned number);

  kinematics::JointGraph& graph_;
  const std::filesystem::path& file_;
  Diagnostics& diagnostics_;
  std::vector<MimicOf> mimics_;
};

}  // namespace hapticell::workcell
