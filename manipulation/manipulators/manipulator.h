// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "geometry/system/text.h"
#include "manipulation/manipulators/part_differential.h"
#include "workcell/entity/entity.h"

namespace hapticell::manipulation {

/// An entity's placement, and a robot's joints.
struct EntityConfiguration {
  Pose X_WE;
  std::vector<double> joints;
};

/// A part of the moved entity as the motion bounds need it: a sphere about it, in the part's own frame P.
struct PartSphere {
  dvec3 p_PS{0.0};
  double radius = 0.0;
};

/// Kind of a limit that holds an entity.
enum class LimitKind {
  kJoint,        ///< A joint's end.
  kReach,        ///< The edge of the workspace: the arm is stretched or folded.
  kSingularity,  ///< A pose at which the tool centre point loses a direction, if that is treated as a wall.
  kLoop,         ///< A passive joint, a leg or a rod of a parallel robot or mechanism.
  kSpeed,        ///< A joint moves at its greatest speed; only reported, never a constraint.
};

/// "joint", "reach", "singularity", "loop", "speed".
const char* toString(LimitKind kind);

/// A limit of the entity's own motion (a joint's end, the edge of the workspace), felt like a contact.
struct MotionLimit {
  haptic::Constraint constraint_W;  ///< Over the moved frame's xi in the cell; gap in metres of its motion.
  Text text;                        ///< "A5 is 1.2 deg from its upper limit"
  int joint = -1;                   ///< Index among the robot's joints; -1 if the limit is not a joint's.
  LimitKind kind = LimitKind::kJoint;
};

/// Least time of a motion, and the joint that determines it.
struct MotionTime {
  double seconds = 0.0;
  int joint = -1;  ///< Index among the robot's joints; -1 if no joint has a greatest speed.
};

class PostureFinder;

/// How an entity follows the hand: which frame M the hand moves, and how the entity's parts follow.
///
/// It models the entity only, not obstacles, the device or the scale. Its parts are those of the prepared scene (see
/// ScenePart), in their order. Used by the manipulation thread.
class Manipulator {
 public:
  virtual ~Manipulator() = default;

  /// Pose X_WM of the moved frame.
  virtual Pose movedFrame(const EntityConfiguration& configuration) const = 0;

  /// The configuration near `from` whose moved frame is at X_WM, or as near to it as the entity's own limits and speeds
  /// allow within `duration_s` (above 0; infinite: speeds do not count).
  virtual EntityConfiguration propose(const EntityConfiguration& from, const Pose& X_WM, double duration_s) const = 0;

  /// The least time that the entity's joints need for the motion; 0 if they have no greatest speeds.
  virtual MotionTime leastTime(const EntityConfiguration& /*from*/, const EntityConfiguration& /*to*/) const {
    return {};
  }

  /// The configuration at `s` in [0, 1] of the motion that leads from one to the other.
  virtual EntityConfiguration between(const EntityConfiguration& from, const EntityConfiguration& to,
                                      double s) const = 0;

  /// Poses X_WP of all parts, one for each entry of `X_WP`.
  virtual void partPoses(const EntityConfiguration& configuration, std::span<Pose> X_WP) const = 0;

  /// The same for one part: faster if there are many parts.
  virtual Pose partPose(const EntityConfiguration& configuration, std::size_t part) const = 0;

  /// True if between() and the bounds support joints that something else moves (a glove, another hand).
  virtual bool movesJoints() const { return true; }

  /// For each part an upper bound (m) of the length of the path of any of its points along between(from, to, 0..1).
  virtual void pathBounds(const EntityConfiguration& from, const EntityConfiguration& to,
                          std::span<const PartSphere> spheres, std::span<double> bounds) const = 0;

  /// Two parts of the entity itself, by index.
  struct OwnPair {
    std::uint32_t part = 0, other = 0;
  };
  /// Lowers each of `bounds` (m; one per pair, on entry the sum of both parts' pathBounds()) to the length of the
  /// longest path of a point of `other` relative to `part`, if the entity knows that this is less. For example, the
  /// motion of a trunk does not bring the parts that it carries nearer to each other.
  virtual void tightenOwnBounds(const EntityConfiguration& /*from*/, const EntityConfiguration& /*to*/,
                                std::span<const PartSphere> /*spheres*/, std::span<const OwnPair> /*pairs*/,
                                std::span<double> /*bounds*/) const {}

  /// Upper bound (rad) of the sum of rotations of all joints, or of the body, during that motion.
  virtual double turnBound(const EntityConfiguration& from, const EntityConfiguration& to) const = 0;

  /// How every part follows a small motion of the moved frame, to second order.
  virtual std::vector<PartDifferential> differentiate(const EntityConfiguration& configuration) const = 0;

  /// The entity's own limits nearer than `zone` (m of the moved frame's motion, rotation with the lever `lever`).
  virtual std::vector<MotionLimit> limits(const EntityConfiguration& configuration, double zone,
                                          double lever) const = 0;

  /// Resistance, N, of the joints' dry friction (N m or N, one per variable) to a slow motion of the moved frame in the
  /// hardest direction; 0 if the hand does not feel it.
  virtual double resistance(const EntityConfiguration& /*configuration*/, std::span<const double> /*friction*/) const {
    return 0.0;
  }

  /// Finds postures that no straight motion reaches; null unless the entity is a figure dragged by its hands. Lives as
  /// long as the manipulator.
  virtual const PostureFinder* postureFinder() const { return nullptr; }
};

}  // namespace hapticell::manipulation
