// SPDX-License-Identifier: Apache-2.0
#include "planning/goal_states.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "geometry/system/overloaded.h"
#include "kinematics/model/solution_list.h"
#include "manipulation/checks/inverse_batch.h"
#include "planning/axis_places.h"
#include "planning/standing_figure.h"

namespace hapticell::planning {

namespace {

/// Full turns of a pose's solutions that become goals, nearest first. Half: a joint turned far may have to turn back;
/// twice: more goals that searches try in vain.
constexpr std::size_t kMostTurned = 64;
/// Places of a region that are tried. Half: small free parts of a region are missed; twice: twice the time before the
/// search begins.
constexpr int kRegionSamples = 64;
/// m: how far from a goal that is not free the nearest free place is looked for. Half the steps: coarser answers;
/// twice: twice the time.
constexpr double kNearestSteps[] = {0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5};
/// Where on the straight way to the goal the nearest place that is reached is looked for: at this share of the one
/// before, so often, and then by halves. Half the numbers: nothing is found near the start; coarser answers. Twice: twice
/// the time.
constexpr double kNearestShare = 0.8;
constexpr int kNearestShares = 40, kNearestHalves = 6;
/// rad or m: joints beyond a limit by rounding are on it. Half: numbers typed with six digits are refused; twice: 2e-6
/// beyond passes.
constexpr double kOnLimit = 1e-6;

/// Configurations of a goal that are not free and are kept all the same. Half: one that could be reached by leaving it
/// backwards may be missing; twice: some ms more where none can.
constexpr std::size_t kMostTight = 16;

/// Of a robot with external axes: configurations of a pose that are checked, and free ones that become goals, those
/// reached soonest first. Half: goals that need a far way are missed; twice: more goals that searches try in vain.
constexpr std::size_t kMostPlaced = 400, kMostGoals = 48;
/// The same near a goal that is not free: places of the axes, and configurations of a pose. Half: a nearest place may be
/// missed; twice: twice the time.
constexpr std::size_t kPlacesNear = 6, kMostPlacedNear = 16;

using Blocks = std::map<std::string, std::size_t>;

/// A number from 0 to 1 that is the same with every standard library.
double unitOf(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1.0p-53;
}

Error goalError(const FreeSpace& space, Text found, Text expected) {
  return {.place = Text("the goal of '%1'", space.entity().name),
          .found = std::move(found),
          .expected = std::move(expected)};
}

Text beyondLimits(const kinematics::Joint& joint, double position) {
  const auto shown = [&](double value) {
    return joint.type == kinematics::JointType::kPrismatic ? Text("%1", Text::Length{value})
                                                           : Text("%1", Text::Angle{value});
  };
  return Text("joint '%1' of the goal is at %2, outside its limits of %3 to %4", joint.name, shown(position),
              shown(joint.lower), shown(joint.upper));
}

/// What a goal of one entity is made from.
class GoalFinder {
 public:
  GoalFinder(FreeSpace& space, const EntityConfiguration& start, std::uint64_t seed)
      : space_(space), start_(start), seed_(seed) {}

  Expected<GoalStates> find(const Goal& goal) {
    auto states = statesOf(goal);
    if (states) states->tight = std::move(tight_);
    return states;
  }

 private:
  Expected<GoalStates> statesOf(const Goal& goal) {
    return std::visit(Overloaded{[&](const goal::ToPose& to) { return toPose(to.X_WT); },
                                 [&](const goal::ToJoints& to) { return toJoints(to.joints); },
                                 [&](const goal::ToRegion& to) { return toRegion(to); },
                                 [&](const goal::OutOfCell& to) { return outOfCell(to.margin); }},
                      goal);
  }

  Expected<void> prepareInverse() {
    if (!space_.hasJoints() || space_.figure() != nullptr || inverse_) return {};
    auto inverse = manipulation::inverseToTool(space_.ownEntity());
    HAPTICELL_TRY(inverse);
    inverse_ = std::move(*inverse);
    if (const std::size_t axes = space_.axisVariables(); axes > 0)
      places_ = axisPlaces(*space_.entity().robot(), axes, start_.joints, seed_);
    return {};
  }

  /// Adds the free configurations of a pose.
  void addFreeAt(const Pose& X_WT, std::vector<EntityConfiguration>& free) {
    for (EntityConfiguration& one : configurationsAt(X_WT)) {
      if (space_.axisVariables() > 0 && free.size() >= kMostGoals) break;
      ++tried_;
      if (space_.isFree(one)) {
        free.push_back(std::move(one));
      } else if (const auto blocker = space_.blocker()) {
        ++blocks_[blocker->met];
        if (first_blocker_.empty()) first_blocker_ = blocker->text();
        if (tight_.size() < kMostTight) tight_.push_back(std::move(one));
      }
    }
  }

  std::vector<EntityConfiguration> configurationsAt(const Pose& X_WT) {
    if (!space_.hasJoints()) return {{X_WT, {}}};
    if (space_.figure() != nullptr) return space_.posturesAt(X_WT, start_);
    if (space_.axisVariables() > 0) return placedAt(X_WT);
    std::vector<EntityConfiguration> all;
    kinematics::SolutionListOptions options;
    options.with_turns = true;
    options.most_turns = kMostTurned;
    const Pose X_BT = start_.X_WE.inverse() * X_WT;
    for (auto& one : kinematics::listSolutions(*space_.entity().robot(), *inverse_, X_BT, start_.joints, options)) {
      if (one.within_limits) all.push_back({start_.X_WE, std::move(one.q)});
    }
    return all;
  }

  /// All configurations of the arm, from places over the travel of its axes; those reached soonest first.
  std::vector<EntityConfiguration> placedAt(const Pose& X_WT) const {
    return soonestWithAxes(space_, *inverse_, X_WT, start_, places_, most_placed_);
  }

  /// Keeps the places from which the pose is reached soonest: near it, others will hardly do.
  void keepPlacesFor(const Pose& X_WT) {
    std::vector<std::vector<double>> kept;
    for (const EntityConfiguration& at : placedAt(X_WT)) {
      std::vector<double> place(at.joints.begin(), at.joints.begin() + static_cast<std::ptrdiff_t>(space_.axisVariables()));
      if (std::find(kept.begin(), kept.end(), place) == kept.end()) kept.push_back(std::move(place));
      if (kept.size() == kPlacesNear) break;
    }
    if (!kept.empty()) places_ = std::move(kept);
    most_placed_ = kMostPlacedNear;
  }

  Expected<GoalStates> toPose(const Pose& X_WT) {
    if (!X_WT.isValid())
      return makeError(goalError(space_, Text("a pose that is not valid"), Text("a position and a unit quaternion")));
    HAPTICELL_TRY(prepareInverse());
    GoalStates states;
    addFreeAt(X_WT, states.free);
    if (states.free.empty()) states.failure = tried_ == 0 ? unreachable(X_WT) : blocked(X_WT);
    return states;
  }

  Expected<GoalStates> toJoints(const std::vector<double>& joints) {
    const auto& robot = space_.entity().robot();
    if (space_.figure() != nullptr)
      return makeError(
          goalError(space_, Text("a posture by its joints, which is not planned: the feet stay, and balance decides on it"),
                    Text("a pose of the mannequin's hand")));
    if (!robot) return makeError(goalError(space_, Text("joints"), Text("a pose, because it has no joints")));
    if (joints.size() != robot->dof()) {
      const std::size_t own = robot->dof() - space_.axisVariables();
      const Text all("%1 joint positions", robot->dof());
      return makeError(
          goalError(space_, Text("%1 joint positions", joints.size()),
                    own == robot->dof() ? all : Text("%1, those of the external axes first, or %2 of its own", all, own)));
    }
    GoalStates states;
    EntityConfiguration at{start_.X_WE, joints};
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const kinematics::Joint& joint = robot->joints[static_cast<std::size_t>(robot->moving[i])];
      if (!std::isfinite(joints[i]))
        return makeError(goalError(space_, Text("a number that is not finite"), Text("numbers")));
      const double inside = std::clamp(joints[i], joint.lower, joint.upper);
      if (std::abs(inside - joints[i]) > kOnLimit) {
        states.failure = Failure{.kind = Failure::Kind::kLimit,
                                 .reason = beyondLimits(joint, joints[i]),
                                 .blocked_by = {},
                                 .nearest = {},
                                 .X_WT_nearest = {}};
        return states;
      }
      at.joints[i] = inside;
    }
    if (space_.isFree(at)) {
      states.free.push_back(std::move(at));
      return states;
    }
    tried_ = 1;
    if (const auto blocker = space_.blocker()) {
      ++blocks_[blocker->met];
      first_blocker_ = blocker->text();
    }
    tight_.push_back(at);
    HAPTICELL_TRY(prepareInverse());
    states.failure = blocked(space_.toolAt(at));
    return states;
  }

  Expected<GoalStates> toRegion(const goal::ToRegion& region) {
    const bool is_valid = region.X_WT.isValid() && std::isfinite(region.turn) && region.turn >= 0.0 &&
                          glm::all(glm::greaterThanEqual(region.half, dvec3(0.0))) && glm::length(region.half) < 1e6;
    if (!is_valid)
      return makeError(goalError(space_, Text("a region that is not valid"), Text("a pose and sizes of 0 or more")));
    HAPTICELL_TRY(prepareInverse());
    std::mt19937_64 random(seed_);
    GoalStates states;
    addFreeAt(region.X_WT, states.free);
    for (int i = 0; i < kRegionSamples; ++i) {
      const dvec3 shift{unitOf(random), unitOf(random), unitOf(random)};
      const dvec3 axis{unitOf(random), unitOf(random), unitOf(random)};
      const dvec3 turn = region.turn / std::sqrt(3.0) * (2.0 * axis - 1.0);
      const Pose X_TS{(2.0 * shift - 1.0) * region.half, quaternionFromRotationVector(turn)};
      addFreeAt(region.X_WT * X_TS, states.free);
    }
    if (states.free.empty()) states.failure = tried_ == 0 ? unreachable(region.X_WT) : blocked(region.X_WT);
    return states;
  }

  Expected<GoalStates> outOfCell(double margin) {
    if (space_.figure() != nullptr)
      return makeError(goalError(space_, Text("out of the cell"), Text("a pose, because the mannequin's feet stay")));
    if (space_.hasJoints())
      return makeError(
          goalError(space_, Text("out of the cell"), Text("a pose or joints, because it is fixed by its base")));
    if (!(margin >= 0.0) || !std::isfinite(margin))
      return makeError(goalError(space_, Text("a margin that is not valid"), Text("0 or more metres")));
    const geometry::Bounds& box = space_.obstacleBounds();
    GoalStates states;
    if (box.isEmpty()) {
      states.free.push_back(start_);
      return states;
    }
    const double beyond = space_.radius() + space_.clearance() + margin + kOnLimit;
    for (int axis = 0; axis < 3; ++axis) {
      for (const bool above : {false, true}) {
        Pose X_WE = start_.X_WE;
        X_WE.p[axis] = above ? box.max[axis] + beyond : box.min[axis] - beyond;
        states.free.push_back({X_WE, start_.joints});
      }
    }
    std::stable_sort(states.free.begin(), states.free.end(), [&](const auto& a, const auto& b) {
      return glm::length(a.X_WE.p - start_.X_WE.p) < glm::length(b.X_WE.p - start_.X_WE.p);
    });
    return states;
  }

  void setNearest(Failure& failure, EntityConfiguration at, const Pose& X_WT) {
    failure.X_WT_nearest = space_.toolAt(at);
    failure.nearest_distance = glm::length(failure.X_WT_nearest->p - X_WT.p);
    failure.nearest = std::move(at);
  }

  /// No standing posture within the limits brings the hand there.
  Failure handCannotReach(const Pose& X_WT) {
    Failure failure;
    failure.kind = Failure::Kind::kReach;
    const bool is_left = space_.figure()->side() == mannequin::Side::kLeft;
    const Text hand = is_left ? Text("left hand") : Text("right hand");
    Shortfall shortfall;
    space_.posturesAt(X_WT, start_, &shortfall);
    const std::string& name = space_.entity().name;
    failure.reason = std::isfinite(shortfall.missing)
                         ? Text("the goal is out of reach of the %1 of %2 without a step; %3 are missing", hand, name,
                                Text::Length{shortfall.missing})
                         : Text("the goal is out of reach of the %1 of %2 without a step", hand, name);
    if (shortfall.nearest && space_.isFree(*shortfall.nearest)) {
      setNearest(failure, std::move(*shortfall.nearest), X_WT);
    } else {
      setNearestOnTheWay(failure, X_WT);
    }
    return failure;
  }

  std::optional<EntityConfiguration> freeAt(const Pose& X_WT) {
    for (EntityConfiguration& at : configurationsAt(X_WT)) {
      if (space_.isFree(at)) return std::move(at);
    }
    return std::nullopt;
  }

  /// How far the tool or hand gets on the straight way to the goal: to a place that is free, and from there by halves.
  void setNearestOnTheWay(Failure& failure, const Pose& X_WT) {
    const Pose X_WStart = space_.toolAt(start_);
    const auto atShare = [&](double share) { return freeAt(interpolate(X_WStart, X_WT, share)); };
    double reached = 1.0, beyond = 1.0;
    std::optional<EntityConfiguration> at;
    for (int k = 0; k < kNearestShares && !at; ++k) {
      beyond = reached;
      reached *= kNearestShare;
      at = atShare(reached);
    }
    for (int k = 0; k < kNearestHalves && at; ++k) {
      const double middle = 0.5 * (reached + beyond);
      auto farther = atShare(middle);
      (farther ? reached : beyond) = middle;
      if (farther) at = std::move(farther);
    }
    if (at) setNearest(failure, std::move(*at), X_WT);
  }

  /// No joints within the limits bring the tool there.
  Failure unreachable(const Pose& X_WT) {
    if (space_.figure() != nullptr) return handCannotReach(X_WT);
    if (space_.axisVariables() > 0) return unreachableWithAxes(X_WT);
    const auto solution = inverse_->solve(start_.X_WE.inverse() * X_WT, start_.joints);
    const bool limited = solution.status == kinematics::InverseStatus::kLimit;
    Failure failure;
    failure.kind = limited ? Failure::Kind::kLimit : Failure::Kind::kReach;
    EntityConfiguration at{start_.X_WE, solution.q};
    if (solution.q.size() == start_.joints.size() && space_.isFree(at)) {
      setNearest(failure, std::move(at), X_WT);
    } else {
      setNearestOnTheWay(failure, X_WT);
    }
    const std::string& name = space_.entity().name;
    failure.reason = limited ? Text("the limits of its joints keep the tool of %1 from the goal", name)
                             : Text("the goal is out of reach of %1", name);
    return failure;
  }

  Failure unreachableWithAxes(const Pose& X_WT) {
    Failure failure;
    bool limited = false;
    double least = std::numeric_limits<double>::infinity();
    std::optional<EntityConfiguration> nearest;
    for (const std::vector<double>& place : places_) {
      EntityConfiguration at = withAxesAt(start_, place);
      const EntityConfiguration own = space_.ownAt(at);
      const auto solution = inverse_->solve(own.X_WE.inverse() * X_WT, own.joints);
      limited = limited || solution.status == kinematics::InverseStatus::kLimit;
      if (solution.q.size() != own.joints.size()) continue;
      std::copy(solution.q.begin(), solution.q.end(), at.joints.begin() + static_cast<std::ptrdiff_t>(place.size()));
      const double distance = glm::length(space_.toolAt(at).p - X_WT.p);
      if (distance >= least || !space_.isFree(at)) continue;
      least = distance;
      nearest = std::move(at);
    }
    if (nearest) setNearest(failure, std::move(*nearest), X_WT);
    failure.kind = limited ? Failure::Kind::kLimit : Failure::Kind::kReach;
    const std::string& name = space_.entity().name;
    failure.reason =
        limited ? Text("the limits of its joints keep the tool of %1 from the goal, wherever its external axes are", name)
                : Text("the goal is out of reach of %1, wherever its external axes are", name);
    return failure;
  }

  /// All configurations there meet something.
  Failure blocked(const Pose& X_WT) {
    Failure failure;
    failure.kind = Failure::Kind::kBlocked;
    const auto most = std::max_element(blocks_.begin(), blocks_.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most != blocks_.end()) failure.blocked_by = most->first;
    failure.reason =
        Text("the goal is not free with a clearance of %1: %2", Text::Length{space_.clearance()}, first_blocker_);
    if (space_.axisVariables() > 0) keepPlacesFor(X_WT);
    for (const double step : kNearestSteps) {
      for (int i = 0; i < 27; ++i) {
        const dvec3 way(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        if (way == dvec3(0.0)) continue;
        if (auto at = freeAt({X_WT.p + step * glm::normalize(way), X_WT.q})) {
          setNearest(failure, std::move(*at), X_WT);
          return failure;
        }
      }
    }
    return failure;
  }

  FreeSpace& space_;
  const EntityConfiguration& start_;
  const std::uint64_t seed_;
  std::unique_ptr<kinematics::InverseModel> inverse_;  ///< Of the robot without its external axes.
  std::size_t most_placed_ = kMostPlaced;
  std::vector<std::vector<double>> places_;            ///< Of the external axes; empty: there are none.
  std::size_t tried_ = 0;
  Blocks blocks_;
  Text first_blocker_;
  std::vector<EntityConfiguration> tight_;
};

}  // namespace

Expected<GoalStates> goalStates(const Goal& goal, FreeSpace& space, const EntityConfiguration& start,
                                std::uint64_t seed) {
  return GoalFinder(space, start, seed).find(goal);
}

}  // namespace hapticell::planning
