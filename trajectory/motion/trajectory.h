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
/// robot, its joints. A value; recordings are kept as they are and edited as copies.
///
/// Times increase strictly (addFrame sees to it). Joints lie in one block so that hours of frames fit in memory.
class Trajectory {
 public:
  std::string name;
  std::string entity;  ///< Whose motion it is; may be empty.
  std::string moved;   ///< "tcp", "base", "self_origin", ... as it was recorded; may be empty.
  /// What was recorded together with it, on the same clock, has the same take; empty: by itself.
  std::string take;
  std::vector<std::string> joint_names;  ///< Empty for a solid. Fixed before the first frame.
  /// False: only the joints are known (a JointTrajectory of ROS). All poses are identity then and mean nothing, until a
  /// robot's forward kinematics gives them (manipulation/robot_poses.h).
  bool has_poses = true;
  /// Further numbers of each frame, of isChannel()'s names: forces, contacts, the configuration. Fixed before the first
  /// frame. They belong to a recording; copies whose frames are others have none.
  std::vector<std::string> channel_names;
  /// What was touched meanwhile, by time of coming; like the channels of recordings only.
  struct Touch {
    double t_in = 0.0, t_out = 0.0;  ///< s
    std::string first, second;       ///< "robot/link_3", "fixture"
    double max_force = 0.0;          ///< N on the hand.
    bool operator==(const Touch&) const = default;
  };
  std::vector<Touch> touches;

  struct Frame {
    double t = 0.0;  ///< Seconds.
    Pose X_WT;       ///< The moved frame in the world (or in what the file says).
    /// Set by hand: kept by simplifying and met closely by smoothing.
    bool by_hand = false;
    double dwell = 0.0;  ///< Seconds that a program waits here.
    /// What users call the point, "above the clamp"; null: nothing. Shared, so that hours of frames stay small.
    std::shared_ptr<const std::string> name = nullptr;
    /// Pose and joints were made each by itself (between frames, without the robot): the joints need not bring the tool
    /// to the pose. Forward or inverse kinematics clears it.
    bool is_pose_apart = false;

    /// A point that somebody set, not a sample: by hand, with a wait or with a name. Edits that choose frames keep it.
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
  /// True if all frames are waypoints: a program rather than a recording. False without frames.
  bool isTaught() const;
  /// From the first frame to the last, seconds.
  double duration() const { return empty() ? 0.0 : frames_.back().t - frames_.front().t; }

  /// Adds a frame at the end. Returns false, and adds nothing, when its time is not after the last one's.
  /// @pre joints.size() == joint_names.size(); channels likewise, none at all mean zeros.
  bool addFrame(const Frame& frame, std::span<const double> joints = {}, std::span<const double> channels = {});
  /// Another pose and other joints at the same time. @pre as addFrame()
  void replaceFrame(std::size_t i, const Pose& X_WT, bool is_pose_apart, std::span<const double> joints);
  void reserve(std::size_t frames);

  /// A trajectory of the same entity, take and joints without frames, channels and touches.
  Trajectory emptyCopy() const;
  /// The same with the channels, for copies that keep frames as they are.
  Trajectory emptyRecording() const;

  /// Pose and joints at time t (clamped to the ends): positions straight, rotations about a fixed axis, joints straight
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

/// Names that channels may have: force_x, force_y, force_z (N on the hand, in the cell's axes), contact (0 or 1),
/// configuration (which branch of a six-axis arm: 1 back, 2 elbow down, 4 wrist flipped, added).
bool isChannel(std::string_view name);

/// How far two poses are apart.
struct PoseDistance {
  double position = 0.0;  ///< m
  double angle = 0.0;     ///< rad
};
PoseDistance distanceBetween(const Pose& a, const Pose& b);

/// What a deviation may be.
struct PathTolerance {
  double position = 0.001;              ///< m
  double angle = 0.017453292519943295;  ///< rad
  /// Of each joint, rad (m for slides): a milliradian moves a tool a metre away by a millimetre. Infinite: joints do
  /// not count.
  double joint = 0.001;
  /// The larger of both shares; over 1 is out of tolerance.
  double shareOf(const PoseDistance& distance) const;
};

}  // namespace hapticell::trajectory
