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
#include "manipulation/engine/plan_source.h"
#include "manipulation/holding/motion_mapping.h"
#include "manipulation/manipulators/moved_by.h"
#include "trajectory/motion/recorder.h"
#include "workcell/entity/entity.h"
#include "workcell/entity/guide.h"

namespace hapticell::manipulation {

enum class ScaleLevel { kRough, kMedium, kFine, kScreen, kNumber };
struct ScaleChoice {
  ScaleLevel level = ScaleLevel::kMedium;
  double number = 1.0;  ///< Metres in the cell per metre of hand motion; kNumber only.
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

/// Commands from the window (or a session) to the manipulation loop. Values; queued, the caller does not wait.
namespace command {

/// The document has changed: all entities and the pairs to check. A held entity stays held.
struct SetDocument {
  std::vector<workcell::Entity> entities;
  workcell::PairPolicy pairs;
  std::uint64_t revision = 0;  ///< SceneSource::revision.
};
/// The entity that the next press of the stylus's button takes; 0: the one that the tip touches.
struct ChooseEntity {
  workcell::EntityId entity = 0;
};
/// All guides of the document; those of the held entity are felt.
struct SetGuides {
  std::vector<workcell::Guide> guides;
};
/// A planner that works beside this stylus while it holds something (null: none), and how much its way is felt (0 ..
/// 1); the same planner again changes the authority only.
struct SetPlan {
  std::shared_ptr<PlanSource> source;
  double authority = 0.0;
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
/// The view; `visible_width` is the width of the cell seen at the focus, metres.
struct SetCamera {
  Pose X_WCamera;  ///< Looks along its -z, x to the right, y up.
  double visible_width = 1.0;
  dvec3 p_WFocus{0.0};  ///< Middle of the view; a stylus that holds nothing is shown there.
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
/// Which parts of the hand's motion act on the entity; `axes` are the device's x, y, z: one for a line, two for a
/// plane.
struct SetFilter {
  bool translates = true;
  bool rotates = true;
  std::array<bool, 3> axes{true, true, true};
  std::array<bool, 3> turns{true, true, true};  ///< Rotation about the device's x, y, z; used if `rotates`.
};
/// If true, the hand moves without the entity.
struct SetClutch {
  bool on = false;
};
/// Target of the simulated hand; sent to the server.
struct SetHandTarget {
  haptic::HandTarget target;
};
/// Takes an entity without the button (0: the chosen one).
struct Grab {
  workcell::EntityId entity = 0;
};
struct Release {};

/// Moves an entity's joints to the glove's values as far as the way is free, each group of `fingers` (indices of
/// joints) independently, and keeps them there until the next command. The snapshot's pairs list what touches. The
/// stylus may hold the entity at the same time. An entity that does not exist (0), is locked or has another number of
/// joints ends it.
struct PoseJoints {
  workcell::EntityId entity = 0;
  std::vector<double> joints;  ///< One per variable.
  std::vector<std::vector<std::size_t>> fingers;
};

/// Starts recording everything that moves, once per step of the loop: held entities and those with their own motion,
/// each as a separate trajectory, all on one clock. A running recording is finished first.
struct StartRecording {
  trajectory::RecordingOptions options;
  std::string take;             ///< Name of the take.
  bool mark_by_button = false;  ///< The stylus's second button adds a frame (else it is the clutch).
};
/// Adds a frame by hand of the held entity, or of the chosen entity at its present pose.
struct MarkFrame {};
/// Ends the recording; result::Recorded reports it.
struct StopRecording {};

}  // namespace command

/// "all", "translation", "rotation", or the axes x, y, z of the hand that act: "x", "xz" ... (then without rotation).
Expected<command::SetFilter> parseFilter(const std::string& text);

using Command = std::variant<command::SetDocument, command::SetGuides, command::SetPlan, command::ChooseEntity, command::SetMovedBy,
                             command::SetAxes, command::SetScale, command::SetCamera, command::SetOnContact,
                             command::SetForceClass, command::SetForces, command::SetFilter, command::SetClutch,
                             command::SetHandTarget, command::Grab, command::Release, command::PoseJoints,
                             command::StartRecording, command::MarkFrame, command::StopRecording>;

/// Results from the loop, in order, each once.
namespace result {

/// An entity was taken.
struct Grabbed {
  workcell::EntityId entity = 0;
};
/// An entity was released at its present placement: make this one undo step of the document.
struct Moved {
  workcell::EntityId entity = 0;
  Pose X_WE;
  std::vector<double> joints;  ///< Robots: position of each variable.
  /// External axes that moved along, the bottom one first: set them before the entity, in the same undo step.
  struct Axis {
    workcell::EntityId entity = 0;
    Pose X_WE;
    std::vector<double> joints;
  };
  std::vector<Axis> axes = {};
};
/// A message to the user.
struct Notice {
  Text sentence;
};

/// A recording ended: one trajectory for each entity that moved, in the order of their first motion. Empty if none
/// moved.
struct Recorded {
  std::vector<trajectory::Trajectory> trajectories;
};

}  // namespace result

using Result = std::variant<result::Grabbed, result::Moved, result::Notice, result::Recorded>;

}  // namespace hapticell::manipulation
