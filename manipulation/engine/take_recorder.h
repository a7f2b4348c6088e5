// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/model/chain.h"
#include "manipulation/manipulators/manipulator.h"
#include "manipulation/manipulators/moved_by.h"
#include "trajectory/motion/recorder.h"

namespace hapticell::manipulation {

/// A trajectory of the entity without frames, with the names of its joints and channels. A mannequin is always recorded
/// by its root (moved "whole") with all joints, so that the posture is complete.
trajectory::Trajectory emptyRecording(const workcell::Entity& entity, const MovedBy& moved_by);

/// Records everything that moves during a take, each entity as its own trajectory, all on one clock.
///
/// Apart from pose and joints it records the force on the hand, whether the entity touches something, a six-axis arm's
/// configuration, and contacts by time. One thread (the manipulation loop's).
class TakeRecorder {
 public:
  explicit TakeRecorder(trajectory::RecordingOptions options, std::string take = {});

  /// State of an entity in one step, and the force.
  struct Sample {
    double t = 0.0;  ///< s, any clock; the first sample's time is the take's zero.
    const workcell::Entity* entity = nullptr;
    const EntityConfiguration* at = nullptr;
    Pose X_WM;  ///< The moved frame.
    MovedBy moved_by;
    dvec3 force_W{0.0};
    /// Its contacts: its part and the other ("robot/link_3", "fixture").
    std::vector<std::pair<std::string, std::string>> touching = {};
  };
  void add(const Sample& sample) { take(sample, false); }
  /// Adds a frame by the user; kept in every mode.
  void mark(const Sample& sample) { take(sample, true); }
  void take(const Sample& sample, bool marked);
  /// Adds only the contacts of an entity whose frames come from another stylus.
  void touch(const Sample& sample);
  std::size_t frames() const;
  /// Number of the user's marks; a mark of several entities counts once.
  std::size_t framesByHand() const { return marks_; }
  double seconds(double now) const { return start_ ? now - *start_ : 0.0; }

  /// One trajectory for each entity that moved, in the order of their first samples. Time 0 is when the first of them
  /// began to move.
  std::vector<trajectory::Trajectory> finish();

 private:
  struct Track {
    trajectory::Recorder recorder;
    std::optional<kinematics::Chain> arm;                ///< A six-axis arm whose configuration is recorded.
    std::vector<trajectory::Trajectory::Touch> touches;  ///< In the take's time.
  };
  static void follow(Track& track, const Sample& sample, double t);
  Track& trackOf(const Sample& sample);

  trajectory::RecordingOptions options_;
  std::string take_;
  std::optional<double> start_;
  std::size_t marks_ = 0;
  std::optional<double> marked_;  ///< Time of the newest mark.
  std::vector<workcell::EntityId> order_;
  std::map<workcell::EntityId, std::unique_ptr<Track>> tracks_;
};

}  // namespace hapticell::manipulation
