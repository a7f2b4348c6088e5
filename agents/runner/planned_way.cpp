// SPDX-License-Identifier: Apache-2.0
#include "agents/runner/planned_way.h"

#include <algorithm>
#include <numbers>

#include "geometry/shapes/shapes.h"
#include "manipulation/scene/scene_service.h"
#include "planning/plan.h"

namespace hapticell::agents {

namespace {

/// Checks that a search may make. Half: narrow ways are missed; twice: a goal without a way costs twice the time.
constexpr std::size_t kMostChecks = 30'000;
/// s; only the checks end a search, so that answers do not depend on the machine.
constexpr double kNoTimeLimit = 1e6;
/// m, radii of the ball that stands for a hand, tried in this order: from a hand whose fingers may point anywhere to one
/// that grasps. Half: the fingers are caught where the ball passes; twice: no way into a trunk.
constexpr double kHandRadii[] = {0.12, 0.09, 0.06, 0.04};
/// Shares of the straight way back to the run's start where a way may begin: a hand that is caught draws back first.
constexpr double kBack[] = {0.0, 0.15, 0.3, 0.5, 0.75, 1.0};
/// m of drawing back before the second way and each further one. Half: planned from where it was caught, in vain; twice:
/// the way in is made again.
constexpr double kBackBeforePlan = 0.15;
/// Of the goal's tolerances, within which a planned goal lies. Half: fewer goals; twice: ends outside.
constexpr double kWithin = 0.5;

planning::Problem problemFor(const AgentCell& cell, std::shared_ptr<const manipulation::PreparedScene> scene,
                             workcell::EntityId entity, std::uint64_t seed, const std::atomic<bool>* stop) {
  planning::Problem problem;
  problem.scene = std::move(scene);
  problem.entity = entity;
  problem.clearance = cell.task().clearance;
  problem.seed = seed;
  problem.most_checks = kMostChecks;
  problem.time_limit_s = kNoTimeLimit;
  problem.threads = 1;  // Runs are made side by side.
  problem.stop = stop;
  return problem;
}

/// With less and less clearance, until there is a way.
std::optional<std::vector<planning::EntityConfiguration>> solve(planning::Problem problem, Text& why) {
  const double asked = problem.clearance;
  for (const double share : {1.0, 0.5, 0.0}) {
    problem.clearance = share * asked;
    const auto answer = planning::plan(problem);
    if (!answer) {
      why = Text("%1", answer.error().message());
      return std::nullopt;
    }
    if (answer->plan) return answer->plan->waypoints;
    why = answer->failure->reason;
    if (answer->failure->kind == planning::Failure::Kind::kCancelled) return std::nullopt;
  }
  return std::nullopt;
}

planning::Goal robotGoal(const MovedBody& body, const AgentGoal& goal) {
  const Pose X_WG{goal.p_WG, goal.q_WG.value_or(body.handle().q)};
  if (goal.q_WG) return planning::goal::ToPose{X_WG};
  return planning::goal::ToRegion{X_WG, dvec3(kWithin * goal.tolerance), std::numbers::pi};
}

PlannedWay ofEntity(const AgentCell& cell, const MovedBody& body, const AgentGoal& goal, std::uint64_t seed,
                    const std::atomic<bool>* stop) {
  PlannedWay planned;
  planning::Problem problem = problemFor(cell, cell.scene(), cell.entity().id, seed, stop);
  const bool has_joints = cell.entity().robot() != nullptr;
  problem.start = body.configuration();
  if (has_joints) {
    problem.goal = robotGoal(body, goal);
  } else {
    const Pose X_EM = body.configuration().X_WE.inverse() * body.handle();
    problem.goal = planning::goal::ToPose{Pose{goal.p_WG, goal.q_WG.value_or(body.handle().q)} * X_EM.inverse()};
  }
  const auto found = solve(std::move(problem), planned.why);
  if (!found) return planned;
  std::vector<FollowedWay::Stop> stops;
  for (std::size_t i = 1; i < found->size(); ++i) {
    const planning::EntityConfiguration& at = (*found)[i];
    stops.push_back({body.placed(at)->handle(), has_joints ? at.joints : std::vector<double>{}});
  }
  planned.way = FollowedWay(std::move(stops), true);
  return planned;
}

/// The cell without the person, and a ball in place of the hand.
std::shared_ptr<const manipulation::PreparedScene> sceneOfBall(const AgentCell& cell, const MovedBody& body,
                                                               double radius, workcell::EntityId& ball) {
  manipulation::SceneSource source;
  source.pairs = cell.scene()->pairs();
  source.defaults = cell.scene()->defaults();
  for (const workcell::Entity& entity : cell.scene()->entities()) {
    ball = std::max(ball, entity.id + 1);
    if (entity.id != cell.entity().id && entity.attachment.to != cell.entity().name) source.entities.push_back(entity);
  }
  workcell::Entity hand;
  hand.id = ball;
  hand.name = cell.entity().name + " hand";
  hand.editSolid().mesh = std::make_shared<const geometry::TriangleMesh>(geometry::makeSphere(radius, 12));
  hand.X_WE = Pose::translation(body.handle().p);
  source.entities.push_back(std::move(hand));
  return manipulation::SceneService().prepare(std::move(source));
}

PlannedWay ofHand(const AgentCell& cell, const MovedBody& body, const AgentGoal& goal, std::uint64_t seed,
                  const std::atomic<bool>* stop) {
  PlannedWay planned;
  const dvec3 p_WHere = body.handle().p, p_WStart = cell.start().handle().p;
  for (const double radius : kHandRadii) {
    workcell::EntityId ball = 1;
    const auto scene = sceneOfBall(cell, body, radius, ball);
    for (const double back : kBack) {
      planning::Problem problem = problemFor(cell, scene, ball, seed, stop);
      const dvec3 p_WFrom = p_WHere + back * (p_WStart - p_WHere);
      problem.start = planning::EntityConfiguration{Pose::translation(p_WFrom), {}};
      problem.goal = planning::goal::ToRegion{Pose::translation(goal.p_WG), dvec3(radius), 0.0};
      const auto answer = planning::plan(problem);
      if (!answer) {
        planned.why = Text("%1", answer.error().message());
        return planned;
      }
      if (answer->failure) {
        planned.why = answer->failure->reason;
        const bool start = answer->failure->kind == planning::Failure::Kind::kStart;
        if (start) continue;
        break;
      }
      std::vector<FollowedWay::Stop> stops;
      for (const planning::EntityConfiguration& at : answer->plan->waypoints)
        stops.push_back({{at.X_WE.p, body.handle().q}, {}});
      planned.way = FollowedWay(std::move(stops), false);
      return planned;
    }
  }
  return planned;
}

}  // namespace

double backBeforePlan(const MovedBody& body, int plans_before) {
  return body.figure() == nullptr ? 0.0 : kBackBeforePlan * plans_before;
}

PlannedWay planWay(const AgentCell& cell, const MovedBody& body, const AgentGoal& goal, std::uint64_t seed,
                   const std::atomic<bool>* stop) {
  PlannedWay planned = body.figure() != nullptr ? ofHand(cell, body, goal, seed, stop)
                                                : ofEntity(cell, body, goal, seed, stop);
  if (planned.way) planned.why = {};
  return planned;
}

}  // namespace hapticell::agents
