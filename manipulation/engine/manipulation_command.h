// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "geometry/shapes/pose.h"
#include "geometry/system/error.h"
#include "geometry/system/text.h"
#include "haptic/protocol/messages.h"
#include "manipulation/holding/motion_mapping.h"
#include "manipulation/manipulators/moved_by.h"
#include "trajectory/motion/recorder.h"
#include "workcell/entity/entity.h"
#include "workcell/entity/guide.h"

namespace hapticell::manipulation {

enum class ScaleLevel { kRough, kMedium, kFine, kScreen, kNumber };
struct ScaleChoice {
  ScaleLevel level = ScaleLevel::kMedium;
  double number = 1.0;  ///< Metres of the cell a metre of hand; kNumber only.
};

/// rough, medium, fine, screen or a number in 1e-3 .. 1e3; anything else is an error.
Expected<ScaleChoice> parseScale(const std::string& text);

struct AxesChoice {
  AxesMode mode = AxesMode::kScreen;
  std::string frame;  ///< kFrame only: an entity's or a robot link's name.
};

/// screen, cell, frame:NAME; anything else is an error.
Expected<AxesChoice> parseAxes(const std::string& text);
Expected<workcell::OnContact> parseOnContact(const std::string& text);
Expected<workcell::ForceClass> parseForceClass(const std::string& text);

/// What the window (or a session) asks of the manipulation loop. Values; queued, never waited for.
namespace command {

/// The document has changed: all entities and what is checked against what, as they stand now. What is held goes on
/// being held.
struct SetDocument {
  std::vector<workcell::Entity> entities;
  workcell::PairPolicy pairs;
  std::uint64_t revision = 0;  ///< SceneSource::revision.
};
/// The entity that the next press of the stylus's button takes; 0: whatever the stylus's tip touches.
struct ChooseEntity {
  workcell::EntityId entity = 0;
};
/// All guides of the document; those of what is held are felt.
struct SetGuides {
  std::vector<workcell::Guide> guides;
};
struct SetMovedBy {
  MovedBy moved_by;
};
struct SetAxes {
  AxesChoice axes;
};
struct SetScale {
  ScaleChoice scale;
};
/// What the view shows; `visible_width` is the width of the cell seen at the focus, metres.
struct SetCamera {
  Pose X_WCamera;  ///< Looks along its -z, x to the right, y up.
  double visible_width = 1.0;
  dvec3 p_WFocus{0.0};  ///< Middle of the view: there the stylus stands that holds nothing.
};
/// Overrides the entity's own choice until the next document; for the held or chosen entity.
struct SetOnContact {
  workcell::OnContact on_contact = workcell::OnContact::kSlide;
};
struct SetForceClass {
  workcell::ForceClass force_class = workcell::ForceClass::kContact;
};
struct SetForces {
  bool on = false;
};
/// What of the hand's motion is let through; `axes` are the device's x, y, z: one for a line, two for a plane.
struct SetFilter {
  bool translates = true;
  bool rotates = true;
  std::array<bool, 3> axes{true, true, true};
  std::array<bool, 3> turns{true, true, true};  ///< Turning about the device's x, y, z; where `rotates`.
};
/// While true the hand moves without the entity.
struct SetClutch {
  bool on = false;
};
/// Where the simulated hand shall bring the stylus; passed on to the server.
struct SetHandTarget {
  haptic::HandTarget target;
};
/// Takes an entity without the button (0: the chosen one).
struct Grab {
  workcell::EntityId entity = 0;
};
struct Release {};

/// Brings an entity's joints where a glove has them, as far as the way is free, each of `fingers` (indices of joints)
/// by itself, and keeps them there until told otherwise; what touches is told in the snapshot's pairs. The stylus may
/// hold the entity meanwhile. An entity that is not there (0), is locked or has another number of joints ends it.
struct PoseJoints {
  workcell::EntityId entity = 0;
  std::vector<double> joints;  ///< Of all variables.
  std::vector<std::vector<std::size_t>> fingers;
};

/// From now on what moves is recorded, a step of the loop at a time: what is held, what goes by itself; each by itself,
/// all on one clock. A recording that goes on is finished first.
struct StartRecording {
  trajectory::RecordingOptions options;
  std::string take;             ///< Its name, and that of what is recorded together.
  bool mark_by_button = false;  ///< The stylus's second button adds a frame (else it is the clutch).
};
/// Adds a frame by hand of what is held, or of the chosen entity where it stands.
struct MarkFrame {};
/// Ends it; result::Recorded tells.
struct StopRecording {};

}  // namespace command

/// "all", "translation", "rotation", or what of x, y, z is let through: "x", "xz" ... (the hand's axes; rotation is
/// not).
Expected<command::SetFilter> parseFilter(const std::string& text);

using Command = std::variant<command::SetDocument, command::SetGuides, command::ChooseEntity, command::SetMovedBy,
                             command::SetAxes, command::SetScale, command::SetCamera, command::SetOnContact,
                             command::SetForceClass, command::SetForces, command::SetFilter, command::SetClutch,
                             command::SetHandTarget, command::Grab, command::Release, command::PoseJoints,
                             command::StartRecording, command::MarkFrame, command::StopRecording>;

/// What the loop tells back, in order; each is told once.
namespace result {

/// An entity was taken.
struct Grabbed {
  workcell::EntityId entity = 0;
};
/// An entity was let go where it stands now: to be made one undoable step of the document.
struct Moved {
  workcell::EntityId entity = 0;
  Pose X_WE;
  std::vector<double> joints;  ///< Robots: position of each variable.
  /// External axes that went along, the one at the bottom first: to be set before the entity, in the same step.
  struct Axis {
    workcell::EntityId entity = 0;
    Pose X_WE;
    std::vector<double> joints;
  };
  std::vector<Axis> axes = {};
};
/// Something that the user should read.
struct Notice {
  Text sentence;
};

/// A recording ended: one trajectory for each entity that moved, those that moved first first. None moved: empty.
struct Recorded {
  std::vector<trajectory::Trajectory> trajectories;
};

}  // namespace result

using Result = std::variant<result::Grabbed, result::Moved, result::Notice, result::Recorded>;

}  // namespace hapticell::manipulation
