// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>

#include "geometry/system/error.h"
#include "mannequin/body/skeleton.h"

namespace hapticell::manipulation {

/// What of a mannequin stands still while a part of it is drawn. Feet stand anyway, unless they may step.
struct BodyLocks {
  bool trunk = false;   ///< Pelvis and spine do not move.
  bool pelvis = false;  ///< The pelvis does not move.
  bool seat = false;    ///< As pelvis, and the seat bears the body: the feet need not be under it.
  bool any() const { return trunk || pelvis || seat; }
  bool operator==(const BodyLocks&) const = default;
};

/// Ways of moving an entity: what the hand holds of it, whose frame M then follows the stylus. Each with what can be
/// chosen of it.
namespace by {

/// Robots: the tool centre point; joints follow by the inverse model.
struct Tool {
  /// The joints of what the robot stands on (a rail, a gantry, a rotary table) go along as external axes, where there
  /// are any that may move.
  bool with_axes = false;
  /// What yields at a singularity, as `robot.at_singularity` says it; empty: as configured.
  std::string at_singularity = {};
  bool operator==(const Tool&) const = default;
};
/// What is usual: robots by their tool, a free hand by its base, all else by its origin.
struct Default {
  Tool tool = {};
  BodyLocks locks = {};  ///< Kept for what is chosen later; only mannequins have them.
  bool operator==(const Default&) const = default;
};
/// Robots: the root link; the robot moves as a whole.
struct Base {
  bool keeps_tool = false;          ///< The tool centre point stays in the cell, the joints follow; else they stand.
  std::string at_singularity = {};  ///< As Tool's, where the tool stays.
  bool operator==(const Base&) const = default;
};
/// Solids: the origin of the entity.
struct Origin {
  bool operator==(const Origin&) const = default;
};
/// Solids: the middle of its bounds.
struct Center {
  bool operator==(const Center&) const = default;
};
/// The origin and axes of a frame by name: a robot's link, a frame of an entity, or another entity.
struct Frame {
  std::string name = {};
  std::string at_singularity = {};  ///< As Tool's, for a robot's link.
  bool operator==(const Frame&) const = default;
};
/// Mannequins: the whole figure as it stands.
struct Whole {
  bool operator==(const Whole&) const = default;
};
/// Mannequins: the hand's grip; the body follows.
struct Hand {
  mannequin::Side side = mannequin::Side::kRight;
  bool may_step = false;  ///< The feet may be put elsewhere where the hand is not reached from where they stand.
  BodyLocks locks = {};
  bool operator==(const Hand&) const = default;
};
/// Mannequins: what both hands hold.
struct BothHands {
  bool apart = false;     ///< Each hand goes by the stylus's motion about its own grip; else both as one, rigidly.
  bool may_step = false;  ///< As Hand's.
  BodyLocks locks = {};
  bool operator==(const BothHands&) const = default;
};
/// Mannequins: the head between its eyes; neck and trunk follow.
struct Head {
  BodyLocks locks = {};
  bool operator==(const Head&) const = default;
};

}  // namespace by

/// How an entity is moved. A new way is a struct above, a manipulator with its line in manipulator_kinds.cpp, and what
/// the compiler then asks for.
using MovedBy = std::variant<by::Default, by::Tool, by::Base, by::Origin, by::Center, by::Frame, by::Whole, by::Hand,
                             by::BothHands, by::Head>;

/// The same thing is held, whatever its options and the frame's name.
bool isSameWay(const MovedBy& a, const MovedBy& b);
/// Mannequins alone are moved so.
bool isOfBody(const MovedBy& moved_by);
/// The name of the frame that is held; empty: no named one is.
std::string frameOf(const MovedBy& moved_by);
/// What counts where it is a robot's tool that is held; null for ways that hold something else.
by::Tool* toolOf(MovedBy& moved_by);
const by::Tool* toolOf(const MovedBy& moved_by);
/// What stands still; null for ways that move no part of a body.
BodyLocks* locksOf(MovedBy& moved_by);
const BodyLocks* locksOf(const MovedBy& moved_by);

/// tcp, tcp_with_axes, base, base_keeping_tcp, self_origin, geometric_center, frame:NAME, whole, left_hand, right_hand,
/// both_hands, head; anything else is an error that lists them.
Expected<MovedBy> parseMovedBy(const std::string& text);

/// The error of a choice's `text` that is none of `choices`; `key` names the choice.
tl::unexpected<Error> unknownWord(const std::string& key, const std::string& text, const std::string& choices);

/// "trunk", "feet", "pelvis", "seat", several with commas between, or "none". Feet stand anyway.
Expected<BodyLocks> parseLock(const std::string& text);

/// Locks what of a body does not move. An error where `moved_by` moves something else and there is anything to lock.
Expected<void> setLocks(MovedBy& moved_by, const BodyLocks& locks);

/// "tcp", "frame:NAME", ...: what of an entity is moved, as files and INTERFACES say it. Robots: by default tcp, solids
/// self_origin.
std::string wordOf(const MovedBy& moved_by, bool is_robot);

}  // namespace hapticell::manipulation
