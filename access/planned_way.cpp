// SPDX-License-Identifier: Apache-2.0
#include "access/planned_way.h"

#include <algorithm>
#include <cmath>

#include "access/ordered.h"
#include "access/removal_directions.h"
#include "planning/plan.h"

namespace hapticell::access {

namespace {

using manipulation::PreparedScene;
using workcell::Entity;
using workcell::EntityId;

/// Checks of each search: some seconds. Half: narrow openings are missed; twice: twice the wait for "none".
constexpr std::size_t kMostChecks = 20'000;
/// s, far beyond what the checks take, so that it does not decide. Half and twice: no effect but on a stuck machine.
constexpr double kTimeLimit = 60.0;
/// Ends of straight pieces that are tried besides the rest. Half: tight seats are not left; twice: twice the wait.
constexpr std::size_t kMostStarts = 1;
/// m: a first piece is at least this long. Half: still tight there; twice: shallow seats are not left.
constexpr double kFirstPiece = 5e-3;

/// The cell without what has gone and without persons; the unit thinned and detached.
std::shared_ptr<const PreparedScene> sceneFor(const RemovalScene& scene, std::size_t unit, UnitSet gone) {
  std::vector<EntityId> absent;
  for (std::size_t u = 0; u < scene.movableCount(); ++u) {
    if ((gone >> u & 1) == 0) continue;
    for (const auto& part : scene.units()[u].parts) absent.push_back(part.part->entity);
  }
  const PreparedScene& cell = scene.scene();
  const RemovalUnit& own = scene.units()[unit];
  std::vector<Entity> entities;
  for (Entity entity : cell.entities()) {
    const Entity* carrier = cell.find(entity.attachment.to);
    if (entity.figure() || (carrier != nullptr && carrier->figure())) continue;
    if (std::find(absent.begin(), absent.end(), entity.id) != absent.end()) continue;
    for (const auto& part : own.parts) {
      if (part.part->entity != entity.id) continue;
      entity.editSolid() = {std::make_shared<const geometry::TriangleMesh>(part.thin->mesh())};
    }
    if (entity.id == own.entity) entity.attachment = {};
    entities.push_back(std::move(entity));
  }
  return PreparedScene::prepare(std::move(entities), workcell::PairPolicy({}, cell.pairs().rules), cell.defaults(), &cell);
}

/// Where the search may begin: at rest, or after a straight piece; the longest first.
std::vector<Pose> startsOf(const RemovalScene& scene, std::size_t unit, UnitSet gone, const Pose& rest) {
  UnitMotion motion(scene, unit, gone);
  std::vector<std::pair<double, Pose>> pieces;
  for (const dvec3& direction : removalDirections(scene, unit)) {
    const double whole = scene.wayOut(unit, direction);
    const Pose end{rest.p + whole * direction, rest.q};
    const double free = motion.advance(rest, end) * whole;
    // Half way between the seat and what stops it, where it is widest as often as not.
    if (free >= kFirstPiece) pieces.push_back({free, Pose{rest.p + 0.5 * free * direction, rest.q}});
  }
  pieces = ordered(std::move(pieces), [](const auto& piece) { return -piece.first; });
  std::vector<Pose> starts{rest};
  for (std::size_t i = 0; i < pieces.size() && i < kMostStarts; ++i) starts.push_back(pieces[i].second);
  return starts;
}

bool isFree(const RemovalScene& scene, std::size_t unit, UnitSet gone, const RemovalWay& way) {
  UnitMotion motion(scene, unit, gone);
  for (std::size_t i = 1; i < way.X_WE.size(); ++i)
    if (motion.advance(way.X_WE[i - 1], way.X_WE[i]) < 1.0) return false;
  return true;
}

}  // namespace

std::optional<RemovalWay> plannedWay(const RemovalScene& scene, std::size_t unit, UnitSet gone,
                                     const std::atomic<bool>& cancel) {
  const Pose rest = scene.scene().find(scene.units()[unit].entity)->X_WE;
  planning::Problem problem;
  problem.scene = sceneFor(scene, unit, gone);
  problem.entity = scene.units()[unit].entity;
  problem.clearance = 0.0;
  problem.most_checks = kMostChecks;
  problem.time_limit_s = kTimeLimit;
  problem.stop = &cancel;
  const auto space = planning::FreeSpace::create(problem.scene, problem.entity, config::Configuration());
  if (!space) return std::nullopt;
  problem.goal = planning::goal::OutOfCell{};
  for (const Pose& start : startsOf(scene, unit, gone, rest)) {
    if (cancel) return std::nullopt;
    problem.start = manipulation::EntityConfiguration{start, {}};
    const auto found = planning::plan(problem, *space);
    if (!found || !found->isSolved()) continue;
    RemovalWay way{RemovalWay::Kind::kPlanned, {rest}};
    const bool has_piece = glm::length(start.p - rest.p) > 0.0;
    for (std::size_t i = has_piece ? 0 : 1; i < found->plan->waypoints.size(); ++i)
      way.X_WE.push_back(found->plan->waypoints[i].X_WE);
    if (isFree(scene, unit, gone, way)) return way;
  }
  return std::nullopt;
}

}  // namespace hapticell::access
