// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/system/error.h"

namespace hapticell::manipulation {

/// What the hand holds of an entity: the frame M whose motion follows the stylus.
struct MovedBy {
  enum class Kind {
    kDefault,          ///< Robots: tcp; solids: self_origin.
    kTcp,              ///< Robots: the tool centre point; joints follow by the inverse model.
    kBase,             ///< Robots: the root link; the robot moves as a whole.
    kSelfOrigin,       ///< Solids: the origin of the entity.
    kGeometricCenter,  ///< Solids: the middle of its bounds.
    kFrame,            ///< The origin and axes of a frame by name: a robot's link or another entity.
    kWhole,            ///< Mannequins: the whole figure as it stands.
    kLeftHand,         ///< Mannequins: the hand's grip; the body follows.
    kRightHand,
    kBothHands,  ///< Mannequins: what both hands hold, rigidly.
    kHead,       ///< Mannequins: the head between its eyes; neck and trunk follow.
  };
  Kind kind = Kind::kDefault;
  std::string frame = {};  ///< kFrame only.
  bool keep_tcp = false;   ///< kBase only: the tool centre point stays in the cell, the joints follow; else they stand.
  /// kTcp only: the joints of what the robot stands on (a rail, a gantry, a rotary table) go along as external axes,
  /// where there are any that may move.
  bool with_axes = false;
  /// What yields at a singularity, as `robot.at_singularity` says it; empty: as configured.
  std::string at_singularity = {};
  bool lock_trunk = false;   ///< Mannequins drawn by a hand: pelvis and spine do not move.
  bool lock_pelvis = false;  ///< The pelvis does not move. Feet stand unless they may step.
  bool on_seat = false;      ///< As lock_pelvis, and the seat bears the body: the feet need not be under it.
  bool hands_apart = false;  ///< kBothHands: each hand goes by the stylus's motion about its own grip; else as one.
  bool joints_move = false;  ///< Something else moves the entity's joints meanwhile. Set by the engine itself.
  bool may_step = false;     ///< The feet may be put elsewhere where the hand is not reached from where they stand.
};

/// tcp, tcp_with_axes, base, base_keeping_tcp, self_origin, geometric_center, frame:NAME, whole, left_hand, right_hand,
/// both_hands, head; anything else is an error that lists them.
Expected<MovedBy> parseMovedBy(const std::string& text);

/// "trunk", "feet", "pelvis", "seat", several with commas between, or "none": sets the locks of `moved_by`. Feet stand
/// anyway.
Expected<void> parseLock(const std::string& text, MovedBy& moved_by);

/// "tcp", "frame:NAME", ...: what of an entity is moved, as files and INTERFACES say it. Robots: by default tcp, solids
/// self_origin.
std::string wordOf(const MovedBy& moved_by, bool is_robot);

}  // namespace hapticell::manipulation
