// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory {

enum class RecordingMode {
  kEveryStep,   ///< Whatever is offered.
  kByTime,      ///< A frame every so many seconds.
  kByDistance,  ///< A frame whenever the entity has moved or turned so far since the last.
  kByHand,      ///< Only frames that the user marks.
};

struct RecordingOptions {
  RecordingMode mode = RecordingMode::kByTime;
  double interval_s = 0.01;                           ///< kByTime.
  PathTolerance spacing{0.005, 0.08726646259971647};  ///< kByDistance: 5 mm, 5 deg.
  /// Nothing is recorded before the entity moves by this: the pause between pressing and moving is no part of it.
  PathTolerance soft_start{0.0005, 0.008726646259971648};
  /// Where times count from; nothing: from the first frame kept. Several recorders with the same one share a clock.
  std::optional<double> clock_start = {};
};

/// Takes the steps of a motion as they come and keeps the frames that the mode asks for. Times count from the first
/// frame kept, or from the clock that is given. The last step is kept when recording ends, so that the motion is whole.
/// One thread.
class Recorder {
 public:
  /// `empty`: name, entity and joint names of what is recorded, without frames.
  Recorder(Trajectory empty, const RecordingOptions& options);

  /// Offers a step; times must increase, a step that does not is dropped.
  void add(double t, const Pose& X_WT, std::span<const double> joints = {}, std::span<const double> channels = {});
  /// The user marks this step: it is kept in every mode, as set by hand.
  void mark(double t, const Pose& X_WT, std::span<const double> joints = {}, std::span<const double> channels = {});

  const Trajectory& soFar() const { return trajectory_; }
  /// The recording; the recorder is empty then.
  Trajectory finish();

 private:
  struct Step {
    double t;
    Pose X_WT;
    std::vector<double> joints, channels;
  };
  bool hasStarted(const Step& step);
  bool isWanted(const Step& step) const;
  void keep(const Step& step, bool by_hand);

  Trajectory trajectory_;
  RecordingOptions options_;
  std::optional<Step> first_;  ///< While nothing has moved yet.
  std::optional<Step> last_;   ///< Offered last, kept or not.
  double t_start_ = 0.0;
  bool started_ = false;
};

}  // namespace hapticell::trajectory
