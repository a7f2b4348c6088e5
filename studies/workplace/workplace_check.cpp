// SPDX-License-Identifier: Apache-2.0
#include "studies/workplace/workplace_check.h"

#include <algorithm>

#include "collision/queries/proximity_query.h"
#include "manipulation/scene/scene_service.h"
#include "mannequin/ergonomics/advice/body_sizes.h"
#include "mannequin/posture/forward_kinematics.h"
#include "mannequin/shape/body_shape.h"
#include "mannequin/shape/figure_model.h"

namespace hapticell::studies {
namespace {

using manipulation::PreparedScene;
using manipulation::ScenePart;
using mannequin::Side;
using workcell::Entity;

/// m: the solver's 1 mm and 0.5 deg at the wrist (0.9 mm at 0.1 m), seen at the grip. Half: right answers miss the
/// promise; twice: wrong by 4 mm would keep it.
constexpr double kGripTolerance = 0.002;
constexpr workcell::EntityId kFirstBody = workcell::EntityId{1} << 60;  // Above all of a cell.

const Entity* entityOf(const std::vector<Entity>& entities, workcell::EntityId id) {
  const auto found = std::find_if(entities.begin(), entities.end(), [id](const Entity& e) { return e.id == id; });
  return found == entities.end() ? nullptr : &*found;
}

dvec3 shiftOf(const Entity& shown, const WorkplaceCell& place) {
  const mannequin::Posture posture = mannequin::toPosture(*shown.figure(), {shown.X_WE, shown.joints()});
  const dvec3 ahead = posture.X_WR.rotate({1.0, 0.0, 0.0});
  return place.away * glm::normalize(dvec3(ahead.x, ahead.y, 0.0)) + dvec3(0.0, 0.0, place.rise);
}

/// How far the worse active hand's grip is from its target, m.
double gripError(const Entity& shown, const mannequin::Figure& figure, const mannequin::Posture& posture,
                 const dvec3& shift) {
  const mannequin::Posture task = mannequin::toPosture(*shown.figure(), {shown.X_WE, shown.joints()});
  const mannequin::FigurePose was = mannequin::forwardKinematics(*shown.figure(), task);
  const mannequin::FigurePose is = mannequin::forwardKinematics(figure, posture);
  const std::array<bool, 2> active = ergonomics::activeHands(was, task);
  double worst = 0.0;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const auto i = static_cast<std::size_t>(side);
    if (!active[i]) continue;
    const dvec3 wanted = mannequin::handPose(was, side) * shown.figure()->p_HandGrip[i] + shift;
    worst = std::max(worst, glm::length(mannequin::handPose(is, side) * figure.p_HandGrip[i] - wanted));
  }
  return worst;
}

/// Hands touch the work on purpose.
bool mayTouch(const kinematics::RobotModel& model, int link) {
  const int body = mannequin::bodyOfLink(model, link);
  if (body < 0 || body >= static_cast<int>(mannequin::kSegmentCount)) return true;
  const auto segment = static_cast<mannequin::Segment>(body);
  return segment == mannequin::Segment::kLeftHand || segment == mannequin::Segment::kRightHand;
}

/// The models of the boundary bodies, made once: a scene that has their meshes prepared hands them to the next.
const std::vector<std::shared_ptr<const kinematics::RobotModel>>& boundaryModels() {
  static const auto models = [] {
    std::vector<std::shared_ptr<const kinematics::RobotModel>> made;
    for (const auto& body : mannequin::boundaryFigures()) made.push_back(mannequin::figureModel(body.figure));
    return made;
  }();
  return models;
}

Entity bodyOf(std::size_t index, const mannequin::Figure& figure, const mannequin::Posture& posture) {
  const auto stands = mannequin::toModel(figure, posture);
  Entity body;
  body.id = kFirstBody + index;
  body.X_WE = stands.X_WE;
  body.body = workcell::Mannequin{{.model = boundaryModels()[index], .joints = stands.joints},
                                  std::make_shared<const mannequin::Figure>(figure)};
  return body;
}

/// What a body of the scene enters, other bodies aside; empty: nothing.
std::string enteredBy(workcell::EntityId body, const PreparedScene& scene) {
  const auto placed = [&](const ScenePart& part) {
    const Entity& owner = *scene.find(part.entity);
    return PreparedScene::partPose(owner, owner.X_WE, owner.joints(), part.link);
  };
  for (const ScenePart& part : scene.parts()) {
    if (part.entity != body || mayTouch(*scene.find(body)->robot(), part.link)) continue;
    for (const ScenePart& other : scene.parts()) {
      if (other.entity >= kFirstBody) continue;
      if (collision::distance(part.mesh.collider, placed(part), other.mesh.collider, placed(other), 1e-3).colliding)
        return scene.find(other.entity)->name;
    }
  }
  return {};
}

/// The cell without the one who showed the task, and with the bodies in their postures.
std::shared_ptr<const PreparedScene> sceneWith(const std::vector<Entity>& after, const Entity& shown,
                                               const std::vector<mannequin::NamedFigure>& bodies,
                                               const WorkplaceCell& place, manipulation::SceneService& scenes) {
  std::vector<Entity> entities;
  for (const Entity& entity : after) {
    if (entity.id != shown.id && entity.attachment.to != shown.name && entity.visible && entity.checked)
      entities.push_back(entity);
  }
  for (std::size_t i = 0; i < bodies.size(); ++i)
    entities.push_back(bodyOf(i, bodies[i].figure, place.postures[i]));
  return scenes.prepare({std::move(entities), {}, {}, 0});
}

}  // namespace

std::vector<Entity> movedCell(const WorkplaceQuestion& question, const WorkplaceCell& place) {
  std::vector<Entity> after = question.entities;
  const Entity* shown = entityOf(question.entities, question.mannequin);
  if (!shown || !shown->figure()) return after;
  const dvec3 shift = shiftOf(*shown, place);
  const std::vector<workcell::EntityId> moved = movedWith(question);
  for (Entity& entity : after) {
    if (std::find(moved.begin(), moved.end(), entity.id) != moved.end()) entity.X_WE.p += shift;
  }
  return after;
}

Promises workplacePromises(const WorkplaceQuestion& question, const WorkplaceCell& place,
                           const std::vector<Entity>& after, manipulation::SceneService& scenes) {
  Promises promises;
  promises.help = "The cell has changed: search again.";
  const Entity* shown = entityOf(question.entities, question.mannequin);
  const auto bodies = mannequin::boundaryFigures();
  if (!shown || !shown->figure() || place.postures.size() != bodies.size()) {
    promises.list.push_back({"bodies", 4.0, static_cast<double>(place.postures.size()), "bodies", "", true});
    return promises;
  }
  const dvec3 shift = shiftOf(*shown, place);
  const auto scene = sceneWith(after, *shown, bodies, place, scenes);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const mannequin::Figure& figure = bodies[i].figure;
    const mannequin::Posture& posture = place.postures[i];
    const std::string& name = bodies[i].name;
    const auto pose = mannequin::forwardKinematics(figure, posture);
    const int rula = ergonomics::scorePosture(figure, posture, pose, question.task).rula();
    const auto beyond = mannequin::limitViolations(posture);
    const std::string entered = enteredBy(kFirstBody + i, *scene);
    promises.list.push_back(
        {"rula_" + name, static_cast<double>(place.rula[i]), static_cast<double>(rula), "points", name});
    promises.list.push_back({"hands_" + name, kGripTolerance, gripError(*shown, figure, posture, shift), "m", name});
    promises.list.push_back({"joints_beyond_" + name, 0.0, static_cast<double>(beyond.size()), "joints",
                             beyond.empty() ? "" : name + ", " + english(textOf(beyond.front()))});
    promises.list.push_back(
        {"entered_" + name, 0.0, entered.empty() ? 0.0 : 1.0, "parts", entered.empty() ? "" : name + " in " + entered});
  }
  return promises;
}

}  // namespace hapticell::studies
