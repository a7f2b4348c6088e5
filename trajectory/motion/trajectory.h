// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/shapes/pose.h"

namespace hapticell::trajectory {

/// A recorded or processed motion of one entity: frames in time, each with the pose of the moved frame and, for a
/// robot, its joints. A value; recordings are kept unchanged and edited as copies.
///
/// Times increase strictly (addFrame enforces it). Joints are stored in one block so that hours of frames fit in
/// memory.
class Trajectory {
 public:
  std::string name;
  std::string entity;  ///< The entity that moves; may be empty.
  std::string moved;   ///< "tcp", "base", "self_origin", ... as it was recorded; may be empty.
  /// Motions recorded together, on the same clock, have the same take; empty: recorded alone.
  std::string take;
  std::vector<std::string> joint_names;  ///< Empty for a solid. Fixed before the first frame.
  /// False: only the joints are known (a JointTrajectory of ROS). All poses are then identity and have no meaning,
  /// until forward kinematics of the robot sets them (manipulation/robot_poses.h).
  bool has_poses = true;
  /// Further numbers for each frame, with names that isChannel() accepts: forces, contacts, the configuration. Fixed
  /// before the first frame. They belong to a recording; copies with other frames have none.
  std::vector<std::string> channel_names;
  /// Contacts during the recording, ordered by start; like channels, only recordings have them.
  struct Touch {
    double t_in = 0.0, t_out = 0.0;  ///< s
    std::string first, second;       ///< "robot/link_3", "fixture"
    double max_force = 0.0;          ///< N on the hand.
    bool operator==(const Touch&) const = default;
  };
  std::vector<Touch> touches;

  struct Frame {
    double t = 0.0;  ///< Seconds.
    Pose X_WT;       ///< The pose of the moved frame in the world (or in the frame that the file states).
    /// Set by hand: kept by simplification and followed closely by smoothing.
    bool by_hand = false;
    double dwell = 0.0;  ///< Dwell of a program here, s.
    /// The user's name of the point, such as "above the clamp"; null: no name. Shared, so that hours of frames stay
    /// small.
    std::shared_ptr<const std::string> name = nullptr;
    /// Pose and joints were computed separately (between frames, without the robot): the joints need not give this
    /// pose. Forward or inverse kinematics clears it.
    bool is_pose_apart = false;

    /// A point that a person set, not a sample: set by hand, with a dwell or with a name. Edits that choose frames keep
    /// it.
    bool isSet() const { return by_hand || dwell > 0.0 || name; }
    std::string nameText() const { return name ? *name : std::string(); }
  };

  std::size_t size() const { return frames_.size(); }
  bool empty() const { return frames_.empty(); }
  const Frame& operator[](std::size_t i) const { return frames_[i]; }
  std::span<const Frame> frames() const { return frames_; }
  std::span<const double> joints(std::size_t i) const;
  std::span<const double> channels(std::size_t i) const;
  /// Index of a channel by name; empty if it does not exist.
  std::optional<std::size_t> findChannel(std::string_view channel) const;
  bool hasJoints() const { return !joint_names.empty(); }
  /// True if all frames are waypoints: a program and not a recording. False without frames.
  bool isTaught() const;
  /// From the first frame to the last, seconds.
  double duration() const { return empty() ? 0.0 : frames_.back().t - frames_.front().t; }

  /// Adds a frame at the end. Returns false, and adds nothing, if its time is not after the last one.
  /// @pre joints.size() == joint_names.size(); channels likewise, or none (all zero).
  bool addFrame(const Frame& frame, std::span<const double> joints = {}, std::span<const double> channels = {});
  /// Replaces pose and joints at the same time.
  /// @pre as addFrame()
  void replaceFrame(std::size_t i, const Pose& X_WT, bool is_pose_apart, std::span<const double> joints);
  void reserve(std::size_t frames);

  /// An empty trajectory of the same entity, take and joints, without channels and touches.
  Trajectory emptyCopy() const;
  /// The same with the channels, for copies that keep frames unchanged.
  Trajectory emptyRecording() const;

  /// Pose and joints at time t (clamped to the ends): positions on a line, rotations about a fixed axis, joints linear
  /// between frames.
  Pose poseAt(double t) const;
  std::vector<double> jointsAt(double t) const;

 private:
  struct Place {
    std::size_t before;
    double share;
  };
  Place placeOf(double t) const;

  std::vector<Frame> frames_;
  std::vector<double> joints_;
  std::vector<double> channels_;
};

/// Names that channels may have: force_x, force_y, force_z (N on the hand, in the axes of the cell), contact (0 or 1),
/// configuration (branch of a six-axis arm, sum of: 1 back, 2 elbow down, 4 wrist flipped).
bool isChannel(std::string_view name);

/// The distance between two poses.
struct PoseDistance {
  double position = 0.0;  ///< m
  double angle = 0.0;     ///< rad
};
PoseDistance distanceBetween(const Pose& a, const Pose& b);

/// The allowed deviation.
struct PathTolerance {
  double position = 0.001;              ///< m
  double angle = 0.017453292519943295;  ///< rad
  /// Of each joint, rad (m for slides): one milliradian moves a tool at a distance of one metre by one millimetre.
  /// Infinite: joints do not count.
  double joint = 0.001;
  /// The larger of both shares; above 1 is out of tolerance.
  double shareOf(const PoseDistance& distance) const;
};

}  // namespace hapticell::trajectory
