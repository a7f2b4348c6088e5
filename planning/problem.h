// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "manipulation/holding/held_model.h"
#include "manipulation/scene/prepared_scene.h"

namespace hapticell::planning {

using manipulation::EntityConfiguration;

/// Goals of a plan.
namespace goal {

/// The tool centre point of a robot at X_WT, in any of its configurations; a solid's own frame, or the grip of a
/// mannequin's hand, at X_WT.
struct ToPose {
  Pose X_WT;
};
/// A robot's joints, one number a variable (rad or m); with its external axes, theirs first.
struct ToJoints {
  std::vector<double> joints;
};
/// The tool (a solid's own frame) anywhere within a box and a cone of turns around X_WT.
struct ToRegion {
  Pose X_WT;
  dvec3 half{0.0};    ///< m to both sides of X_WT's origin, along its axes.
  double turn = 0.0;  ///< rad: greatest rotation away from X_WT's axes.
};
/// A solid wholly outside of the box around all that it could meet, by `margin` (m) more than the clearance.
struct OutOfCell {
  double margin = 0.0;
};

}  // namespace goal

using Goal = std::variant<goal::ToPose, goal::ToJoints, goal::ToRegion, goal::OutOfCell>;

/// How a motion may leave what is in contact with the entity, or nearer than the clearance, at its start, and reach such
/// things at its goal. A pair is left so: it is no deeper than `deepest` at the start; until it is beyond the clearance
/// the entity stays within nearness(), and the gap is never smaller by more than `may_close` than it was before. From
/// then on the clearance holds. Goals are reached in the same way, backwards.
struct LeavingRule {
  /// m: deeper than surfaces that were placed by hand or measured. Half: such starts are refused; twice: a part that is
  /// placed in another by mistake may be planned for.
  static constexpr double kDeepest = 1e-3;
  /// m: a gap that is left without turning; rounded corners change it by some hundredths. Half: plans are rounded off
  /// less and rest at corners; twice: a part may be pressed in by 0.2 mm.
  static constexpr double kMayClose = 1e-4;
  /// m of path of any point. Half of 0.05: long flush fits cannot be left; twice: a motion may go along a surface for
  /// longer without its clearance.
  static constexpr double nearness(double clearance) { return 0.05 + 2.0 * clearance; }
};

/// What is to be planned: a value; the scene is shared and immutable.
struct Problem {
  std::shared_ptr<const manipulation::PreparedScene> scene;
  workcell::EntityId entity = 0;
  /// Of a mannequin: the hand that moves, by its grip; the feet stay. Empty for all others.
  std::optional<mannequin::Side> hand = {};
  /// External axes that carry the robot and are not locked move along (FreeSpace::create()); joints of `start`, `hints`
  /// and goals are then all of theirs.
  bool with_axes = false;
  /// Where entities are that do not stand as in the scene; the planned one too.
  manipulation::Placements placements = {};
  /// Where the motion begins; empty: where the entity stands.
  std::optional<EntityConfiguration> start = {};
  Goal goal = goal::ToPose{};
  /// m that the whole motion keeps from everything but the entity's own links.
  double clearance = 0.005;
  /// What touches the entity at its start or goal, or is nearer than the clearance, is left and reached by LeavingRule;
  /// false: such a start or goal is a failure.
  bool leaves_contact = false;
  /// Poses of the tool (of a solid: of its own frame) that the motion passes, in this order.
  std::vector<Pose> through = {};
  /// Configurations that a way may pass, in their order: a way shown by hand, an older plan. Their free stretches are
  /// kept as bridges and joined by the search; where that fails or takes `most_checks` checks, and with `through`, the
  /// plan does without them.
  std::vector<EntityConfiguration> hints = {};
  std::uint64_t seed = 1;
  /// Checks (configurations and motions) that each of the searches may use between two places; what bounds the work.
  std::size_t most_checks = 100'000;
  /// s of wall time for the search; afterwards it is given up. It never changes which plan is found.
  double time_limit_s = 10.0;
  /// Threads at most; 0: one a core. The plan does not depend on it.
  int threads = 0;
  /// Checked before every check, by all threads: true ends the plan as cancelled within milliseconds. May be null.
  const std::atomic<bool>* stop = nullptr;
  /// Gets the progress, 0 .. 1, in the calling thread; may be empty.
  std::function<void(double)> progress = {};
};

}  // namespace hapticell::planning
