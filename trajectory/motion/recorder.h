// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory {

enum class RecordingMode {
  kEveryStep,   ///< Every offered step.
  kByTime,      ///< One frame per time interval.
  kByDistance,  ///< One frame each time the entity has moved or turned by a set amount since the last.
  kByHand,      ///< Only frames that the user marks.
};

struct RecordingOptions {
  RecordingMode mode = RecordingMode::kByTime;
  double interval_s = 0.01;                           ///< kByTime.
  PathTolerance spacing{0.005, 0.08726646259971647};  ///< kByDistance: 5 mm, 5 deg.
  /// Recording starts when the entity has moved by this amount: the pause between pressing and moving is not recorded.
  PathTolerance soft_start{0.0005, 0.008726646259971648};
  /// Time origin; empty: the first kept frame. Several recorders with the same origin share a clock.
  std::optional<double> clock_start = {};
};

/// Takes the steps of a motion as they come and keeps the frames that the mode asks for. Times count from the first
/// kept frame, or from the given origin. The last step is always kept when recording ends. One thread.
class Recorder {
 public:
  /// `empty`: name, entity and joint names of the recording, without frames.
  Recorder(Trajectory empty, const RecordingOptions& options);

  /// Offers a step; times must increase, otherwise the step is dropped.
  void add(double t, const Pose& X_WT, std::span<const double> joints = {}, std::span<const double> channels = {});
  /// The user marks this step: it is kept in every mode, as set by hand.
  void mark(double t, const Pose& X_WT, std::span<const double> joints = {}, std::span<const double> channels = {});

  const Trajectory& soFar() const { return trajectory_; }
  /// Returns the recording; the recorder is empty afterwards.
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
  std::optional<Step> first_;  ///< Until the entity has moved.
  std::optional<Step> last_;   ///< The last step offered, kept or not.
  double t_start_ = 0.0;
  bool started_ = false;
};

}  // namespace hapticell::trajectory
