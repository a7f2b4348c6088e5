// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>

#include "geometry/system/error.h"
#include "mannequin/body/skeleton.h"

namespace hapticell::manipulation {

/// The parts of a mannequin that do not move while another part is dragged. The feet stay in any case, unless they may
/// step.
struct BodyLocks {
  bool trunk = false;   ///< Pelvis and spine do not move.
  bool pelvis = false;  ///< The pelvis does not move.
  bool seat = false;    ///< As pelvis, and the seat bears the body: the feet need not be under it.
  bool any() const { return trunk || pelvis || seat; }
  bool operator==(const BodyLocks&) const = default;
};

/// Ways to move an entity, by the part that the hand holds; its frame M follows the stylus. Each has its own options.
namespace by {

/// Robots: the tool centre point; the joints follow by the inverse model.
struct Tool {
  /// The joints of the robot's carrier (a rail, a gantry, a rotary table) move along as external axes, if there are any
  /// that may move.
  bool with_axes = false;
  /// What yields at a singularity, a value of `robot.at_singularity`; empty: as configured.
  std::string at_singularity = {};
  bool operator==(const Tool&) const = default;
};
/// The default: robots by their tool, a free hand by its base, all others by their origin.
struct Default {
  Tool tool = {};
  BodyLocks locks = {};  ///< Stored for a later choice; for mannequins only.
  bool operator==(const Default&) const = default;
};
/// Robots: the root link; the robot moves as a whole.
struct Base {
  bool keeps_tool = false;          ///< The tool centre point stays in the cell and the joints follow; else the joints
                                    ///< do not move.
  std::string at_singularity = {};  ///< As in Tool, if the tool stays.
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
  std::string at_singularity = {};  ///< As in Tool, for a robot's link.
  bool operator==(const Frame&) const = default;
};
/// Mannequins: the whole figure in its present posture.
struct Whole {
  bool operator==(const Whole&) const = default;
};
/// Mannequins: the hand's grip; the body follows.
struct Hand {
  mannequin::Side side = mannequin::Side::kRight;
  bool may_step = false;  ///< The feet may step if the hand's target is out of reach.
  BodyLocks locks = {};
  bool operator==(const Hand&) const = default;
};
/// Mannequins: what both hands hold.
struct BothHands {
  bool apart = false;     ///< Each hand makes the stylus's motion about its own grip; else both move as one rigid body.
  bool may_step = false;  ///< As in Hand.
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

/// True for the same way (and the same side for a hand), whatever the options and the frame's name.
bool isSameWay(const MovedBy& a, const MovedBy& b);
/// True for ways that apply to mannequins only.
bool isOfBody(const MovedBy& moved_by);
/// The name of the held frame; empty: not a named frame.
std::string frameOf(const MovedBy& moved_by);
/// The options of by::Tool; null for other ways.
by::Tool* toolOf(MovedBy& moved_by);
const by::Tool* toolOf(const MovedBy& moved_by);
/// The locks; null for ways that do not move a part of a body.
BodyLocks* locksOf(MovedBy& moved_by);
const BodyLocks* locksOf(const MovedBy& moved_by);

/// tcp, tcp_with_axes, base, base_keeping_tcp, self_origin, geometric_center, frame:NAME, whole, left_hand, right_hand,
/// both_hands, head; anything else is an error that lists them.
Expected<MovedBy> parseMovedBy(const std::string& text);

/// The error for a `text` that is not one of `choices`; `key` names the choice.
tl::unexpected<Error> unknownWord(const std::string& key, const std::string& text, Text choices);

/// "trunk", "feet", "pelvis", "seat", several with commas between, or "none". The feet stay in any case.
Expected<BodyLocks> parseLock(const std::string& text);

/// Sets the locks. Error: `locks` is not empty but `moved_by` has no locks.
Expected<void> setLocks(MovedBy& moved_by, const BodyLocks& locks);

/// "tcp", "frame:NAME", ...: how an entity is moved, as written in files and INTERFACES. Defaults: tcp for robots,
/// self_origin for solids.
std::string wordOf(const MovedBy& moved_by, bool is_robot);

}  // namespace hapticell::manipulation
