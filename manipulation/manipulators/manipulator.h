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

/// Where an entity stands: its placement, and a robot's joints.
struct EntityConfiguration {
  Pose X_WE;
  std::vector<double> joints;
};

/// A part of the moved entity as the motion bounds need it: a sphere about it, in the part's own frame P.
struct PartSphere {
  dvec3 p_PS{0.0};
  double radius = 0.0;
};

/// What kind of limit it is that holds an entity.
enum class LimitKind {
  kJoint,        ///< A joint's end.
  kReach,        ///< The edge of the workspace: the arm is stretched or folded.
  kSingularity,  ///< A position where a direction of the tool centre point is lost, where that is a wall.
  kLoop,         ///< A passive joint, a leg or a rod of a parallel robot or mechanism.
  kSpeed,        ///< A joint moves as fast as it can; never a constraint, only told.
};

/// "joint", "reach", "singularity", "loop", "speed".
const char* toString(LimitKind kind);

/// A limit of the entity's own motion (a joint's end, the edge of the workspace), felt like a contact.
struct MotionLimit {
  haptic::Constraint constraint_W;  ///< Over the moved frame's xi in the cell; gap in metres of its motion.
  Text text;                        ///< "A5 is 1.2 deg from its upper limit"
  int joint = -1;                   ///< Index among the robot's joints; -1 for what is no joint's.
  LimitKind kind = LimitKind::kJoint;
};

/// How long a motion takes at the least, and which joint is the reason.
struct MotionTime {
  double seconds = 0.0;
  int joint = -1;  ///< Index among the robot's joints; -1 where nothing has a greatest speed.
};

class PostureFinder;

/// How an entity follows the hand: which frame M the hand moves, and what the entity's parts do then.
///
/// A model of the entity only; it knows nothing of obstacles, of the device or of scale. Its parts are those of the
/// prepared scene (see ScenePart), in their order. Used by the manipulation thread.
class Manipulator {
 public:
  virtual ~Manipulator() = default;

  /// Pose X_WM of the moved frame.
  virtual Pose movedFrame(const EntityConfiguration& configuration) const = 0;

  /// The configuration near `from` whose moved frame is at X_WM, or as near to it as the entity's own limits and speeds
  /// allow within `duration_s` (above 0; infinite: speeds do not count).
  virtual EntityConfiguration propose(const EntityConfiguration& from, const Pose& X_WM, double duration_s) const = 0;

  /// The least time that the entity's joints need from one to the other; 0 for what has no greatest speeds.
  virtual MotionTime leastTime(const EntityConfiguration& /*from*/, const EntityConfiguration& /*to*/) const {
    return {};
  }

  /// The configuration at `s` in [0, 1] of the motion that leads from one to the other.
  virtual EntityConfiguration between(const EntityConfiguration& from, const EntityConfiguration& to,
                                      double s) const = 0;

  /// Poses X_WP of all parts, one for each entry of `X_WP`.
  virtual void partPoses(const EntityConfiguration& configuration, std::span<Pose> X_WP) const = 0;

  /// The same of one part: cheaper where the other parts are many.
  virtual Pose partPose(const EntityConfiguration& configuration, std::size_t part) const = 0;

  /// True where between() and the bounds go along with joints that something else moves (a glove, another hand).
  virtual bool movesJoints() const { return true; }

  /// For each part an upper bound (m) of the length of the path of any of its points along between(from, to, 0..1).
  virtual void pathBounds(const EntityConfiguration& from, const EntityConfiguration& to,
                          std::span<const PartSphere> spheres, std::span<double> bounds) const = 0;

  /// Two parts of the entity itself, by index.
  struct OwnPair {
    std::uint32_t part = 0, other = 0;
  };
  /// Lowers each of `bounds` (m; one a pair, on entry the sum of both parts' pathBounds()) to the length of the longest
  /// path of a point of `other` as seen from `part`, where the entity knows that to be less: two parts that one trunk
  /// carries along do not meet by that.
  virtual void tightenOwnBounds(const EntityConfiguration& /*from*/, const EntityConfiguration& /*to*/,
                                std::span<const PartSphere> /*spheres*/, std::span<const OwnPair> /*pairs*/,
                                std::span<double> /*bounds*/) const {}

  /// Upper bound (rad) of how much all joints, or the body, turn in all on that motion.
  virtual double turnBound(const EntityConfiguration& from, const EntityConfiguration& to) const = 0;

  /// How every part follows a small motion of the moved frame, to second order.
  virtual std::vector<PartDifferential> differentiate(const EntityConfiguration& configuration) const = 0;

  /// The entity's own limits nearer than `zone` (m of the moved frame's motion, rotation with the lever `lever`).
  virtual std::vector<MotionLimit> limits(const EntityConfiguration& configuration, double zone,
                                          double lever) const = 0;

  /// What the joints' dry friction (N m or N, one a variable of the entity's joints) holds against a slow motion of the
  /// moved frame along the direction in which it is hardest, N; 0 where it is not felt by what the hand holds.
  virtual double resistance(const EntityConfiguration& /*configuration*/, std::span<const double> /*friction*/) const {
    return 0.0;
  }

  /// Who finds postures of the entity that lie on no straight way; null for what is no figure drawn by its hands. It
  /// lives as long as the manipulator.
  virtual const PostureFinder* postureFinder() const { return nullptr; }
};

}  // namespace hapticell::manipulation
