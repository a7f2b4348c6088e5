// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/system/error.h"
#include "trajectory/programs/reading/program_reader.h"

namespace hapticell::trajectory {

/// Collects the targets of a program while it is read and makes a trajectory of them.
///
/// After the first error nothing more is added. Poses are given in the present frame F of the program (setFrame()).
class ProgramPath {
 public:
  using Joints = std::array<double, 6>;  ///< rad

  explicit ProgramPath(const ProgramReadOptions& options) : options_(options) {}

  void setLinearSpeed(double meters_per_second);
  void setAngularSpeed(double radians_per_second);
  void setJointShare(double share);  ///< As a share of the robot's greatest speed, 0 to 1.
  /// The frame of the following targets, in the robot's base. Empty: the file does not give the pose of `name`.
  void setFrame(const std::optional<Pose>& X_BF, const Text& name);
  const std::optional<Pose>& frame() const { return X_BF_; }

  void moveTo(std::size_t line, const Pose& X_FT, bool is_joint_move);
  /// An arc through `via` to `end`, or, if `angle` is given (KRL's CA), along this circle for `angle` radians in all.
  void moveArc(std::size_t line, const Pose& via_FT, const Pose& end_FT, std::optional<double> angle = {});
  /// `pose` if the program gives it in addition to the joints.
  void moveJoints(std::size_t line, const Joints& joints, const std::optional<Pose>& pose = {});
  /// A target that the file does not give. At the start or end it is left out with a note, in the middle it is an
  /// error.
  void missTarget(std::size_t line, const Text& why);
  void wait(double seconds);

  /// The last target in the present frame; empty if it is not known.
  std::optional<Pose> current() const;
  const std::optional<Joints>& currentJoints() const { return joints_; }

  void note(const Text& sentence);                        ///< Each sentence once.
  void noteLine(std::size_t line, const Text& sentence);  ///< "line 12: ..."; at most twenty.
  void skip(std::size_t line);                            ///< A statement without motion that is left out.
  void fail(std::size_t line, const Text& found, const Text& expected, const Text& fix);
  bool hasFailed() const { return error_.has_value(); }

  Expected<ReadProgram> finish(const std::string& name);

 private:
  struct Target {
    Pose X;
    std::optional<Joints> joints;
    double duration = 0.0;
    double dwell = 0.0;
  };
  void add(std::size_t line, const Pose& X_B, const std::optional<Joints>& joints, bool is_joint_move);
  double durationTo(const Pose& X_B, bool is_joint_move) const;
  bool checkFrame(std::size_t line);
  void noteMissed();
  void noteLines();

  const ProgramReadOptions& options_;
  std::vector<Target> targets_;
  std::optional<Pose> X_BF_ = Pose::identity();
  Text frame_name_;
  std::vector<std::pair<Text, std::size_t>> frames_;  // by English name, the first line with a target; empty: known
  std::optional<Pose> here_;                          // the last target, in the base or in the one unknown frame
  std::optional<Joints> joints_;
  double linear_ = 0.25, angular_ = 3.0, share_ = 1.0;
  std::vector<std::pair<std::size_t, Text>> missed_;  // since the last target: line, why
  std::vector<std::size_t> skipped_;
  std::vector<Text> notes_;
  std::size_t line_notes_ = 0;
  std::optional<Error> error_;
};

}  // namespace hapticell::trajectory
