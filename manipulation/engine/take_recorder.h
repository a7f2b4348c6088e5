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

/// A trajectory of the entity without frames: names of its joints, and of the channels. A mannequin is recorded by its
/// root (moved "whole") with all its joints, whatever the hand drew, so that the posture is whole.
trajectory::Trajectory emptyRecording(const workcell::Entity& entity, const MovedBy& moved_by);

/// Everything that moves while a take is recorded, each entity as a trajectory of its own, all on one clock.
///
/// Beside pose and joints: the force on the hand, whether it touches, a six-axis arm's configuration; contacts as
/// touches by time. One thread (the manipulation loop's).
class TakeRecorder {
 public:
  explicit TakeRecorder(trajectory::RecordingOptions options, std::string take = {});

  /// Where an entity is in one step, and what was felt.
  struct Sample {
    double t = 0.0;  ///< s, any clock; the first sample's time is the take's zero.
    const workcell::Entity* entity = nullptr;
    const EntityConfiguration* at = nullptr;
    Pose X_WM;  ///< The moved frame.
    MovedBy moved_by;
    dvec3 force_W{0.0};
    /// What it touches: its part and the other ("robot/link_3", "fixture").
    std::vector<std::pair<std::string, std::string>> touching = {};
  };
  void add(const Sample& sample) { take(sample, false); }
  /// The user adds a frame here; kept in every mode.
  void mark(const Sample& sample) { take(sample, true); }
  void take(const Sample& sample, bool marked);
  /// Only what it touches, of an entity whose frames come from somebody else.
  void touch(const Sample& sample);
  std::size_t frames() const;
  /// The user's marks, however many entities each is a frame of.
  std::size_t framesByHand() const { return marks_; }
  double seconds(double now) const { return start_ ? now - *start_ : 0.0; }

  /// One trajectory for each entity that moved, in the order in which they were seen first. Time 0 is where the first
  /// of them began to move.
  std::vector<trajectory::Trajectory> finish();

 private:
  struct Track {
    trajectory::Recorder recorder;
    std::optional<kinematics::Chain> arm;                ///< A six-axis one whose configuration is told.
    std::vector<trajectory::Trajectory::Touch> touches;  ///< In the take's time.
  };
  static void follow(Track& track, const Sample& sample, double t);
  Track& trackOf(const Sample& sample);

  trajectory::RecordingOptions options_;
  std::string take_;
  std::optional<double> start_;
  std::size_t marks_ = 0;
  std::optional<double> marked_;  ///< Time of the newest.
  std::vector<workcell::EntityId> order_;
  std::map<workcell::EntityId, std::unique_ptr<Track>> tracks_;
};

}  // namespace hapticell::manipulation
