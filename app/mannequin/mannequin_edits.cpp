// SPDX-License-Identifier: Apache-2.0
#include "app/mannequin/mannequin_edits.h"

#include <algorithm>
#include <cmath>

#include "mannequin/body/body_request_text.h"
#include "mannequin/posture/forward_kinematics.h"
#include "mannequin/shape/figure_model.h"
#include "workcell/import/entity_source.h"

namespace hapticell::app {

using mannequin::Posture;

Posture postureOf(const workcell::Entity& entity) {
  return mannequin::toPosture(*entity.figure(), {entity.X_WE, entity.joints()});
}

workcell::Command postureCommand(const workcell::Entity& entity, const Posture& posture) {
  mannequin::ModelConfiguration stands = mannequin::toModel(*entity.figure(), posture);
  return workcell::SetConfiguration{entity.id, stands.X_WE, std::move(stands.joints)};
}

Posture placedHere(const workcell::Entity& entity, Posture posture) {
  const Posture now = postureOf(entity);
  const dvec3 ahead = now.X_WR.rotate({1.0, 0.0, 0.0});
  const double heading = std::atan2(ahead.y, ahead.x);
  const dvec3 had = posture.X_WR.rotate({1.0, 0.0, 0.0});
  const double turn = heading - std::atan2(had.y, had.x);
  const dquat q(std::cos(0.5 * turn), 0.0, 0.0, std::sin(0.5 * turn));
  posture.X_WR.q = glm::normalize(q * posture.X_WR.q);
  posture.X_WR.p.x = now.X_WR.p.x;
  posture.X_WR.p.y = now.X_WR.p.y;
  // A figure on a platform stays on it.
  const double floor = now.X_WR.p.z - mannequin::onFloor(*entity.figure(), now).X_WR.p.z;
  posture = mannequin::onFloor(*entity.figure(), posture);
  posture.X_WR.p.z += floor;
  return posture;
}

std::optional<Posture> libraryPostureAt(const workcell::Entity& entity, std::string_view name) {
  auto posture = mannequin::libraryPosture(*entity.figure(), name);
  if (!posture) return std::nullopt;
  return placedHere(entity, *posture);
}

mannequin::BodyRequest requestOf(const workcell::Entity& entity) {
  if (auto request = mannequin::parseBodyRequest(entity.source.path)) return *request;
  mannequin::BodyRequest request;
  request.sex = entity.figure()->sex;
  request.stature = entity.figure()->body[mannequin::Dimension::kStature];
  request.mass = entity.figure()->totalMass();
  return request;
}

Expected<std::vector<workcell::Command>> resizeCommands(const workcell::Entity& entity,
                                                        const mannequin::BodyRequest& request) {
  Diagnostics diagnostics;
  auto fresh = workcell::EntityLoader({}).load(mannequin::bodyRequestText(request), 0.0, diagnostics);
  HAPTICELL_TRY(fresh);
  const Posture before = postureOf(entity);
  const double floor = before.X_WR.p.z - mannequin::onFloor(*entity.figure(), before).X_WR.p.z;
  Posture after = before;
  // The feet stay where they are, seen from above.
  const auto feet = [](const mannequin::Figure& figure, const Posture& posture) {
    const auto pose = mannequin::forwardKinematics(figure, posture);
    return 0.5 *
           (mannequin::footPose(pose, mannequin::Side::kLeft).p + mannequin::footPose(pose, mannequin::Side::kRight).p);
  };
  const dvec3 shift = feet(*entity.figure(), before) - feet(*fresh->figure(), after);
  after.X_WR.p += dvec3(shift.x, shift.y, 0.0);
  after = mannequin::onFloor(*fresh->figure(), after);
  after.X_WR.p.z += floor;
  mannequin::ModelConfiguration stands = mannequin::toModel(*fresh->figure(), after);
  std::vector<workcell::Command> commands;
  commands.emplace_back(workcell::ReplaceShape{entity.id, std::move(*fresh)});
  commands.emplace_back(workcell::SetConfiguration{entity.id, stands.X_WE, std::move(stands.joints)});
  return commands;
}

Expected<workcell::Entity> newMannequin(const mannequin::BodyRequest& request, const Pose& X_WE,
                                        const std::vector<std::string>& taken) {
  Diagnostics diagnostics;
  auto entity = workcell::EntityLoader({}).load(mannequin::bodyRequestText(request), 0.0, diagnostics);
  if (!entity) return entity;
  entity->X_WE = X_WE;
  entity->name = "Operator";
  for (int number = 2; std::find(taken.begin(), taken.end(), entity->name) != taken.end(); ++number) {
    entity->name = "Operator " + std::to_string(number);
  }
  return entity;
}

const char* handLink(mannequin::Side side) {
  return side == mannequin::Side::kLeft ? "l_hand" : "r_hand";
}

}  // namespace hapticell::app
