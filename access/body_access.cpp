// SPDX-License-Identifier: Apache-2.0
#include "access/body_access.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <tuple>

#include "geometry/shapes/shapes.h"
#include "manipulation/checks/body_contacts.h"
#include "mannequin/ergonomics/advice/body_sizes.h"
#include "mannequin/posture/posture_solver.h"
#include "mannequin/shape/body_shape.h"
#include "mannequin/shape/figure_model.h"

namespace hapticell::access {

namespace {

using manipulation::PreparedScene;
using mannequin::Figure;
using mannequin::Posture;
using mannequin::Side;
using workcell::Entity;
using workcell::EntityId;

constexpr EntityId kBodyId = EntityId{1} << 60;  ///< Beyond any document's ids.
/// m: a hand nearer to its place than this is there; kThere of hands_to.cpp. Half: fewer count; twice: 4 mm off.
constexpr double kThere = 2e-3;
/// Places around the part where a person could stand, by azimuth and m from it to the feet. Half: nobody finds the gap
/// between two machines; twice: twice the time.
constexpr int kAzimuths = 12;
constexpr double kDistances[] = {0.40, 0.55, 0.75};
/// Of these, the free ones that are tried. Half: a better one may be missed; twice: twice the time.
constexpr std::size_t kMostStands = 4;
/// Places on the way where the hand must follow. Half: a wall that the elbow meets may be missed; twice: twice the time.
constexpr int kAlong = 4;

bool isOfHand(const kinematics::RobotModel& model, int link, Side side) {
  const int body = mannequin::bodyOfLink(model, link);
  if (body < 0) return false;
  const auto index = static_cast<std::size_t>(body);
  const auto hand = side == Side::kLeft ? mannequin::Segment::kLeftHand : mannequin::Segment::kRightHand;
  if (index == mannequin::indexOf(hand)) return true;
  const std::size_t first = mannequin::phalanxBody(side, 0, 0);
  return index >= first && index < first + mannequin::kDigits * mannequin::kPhalanges;
}

/// One person in the cell, without those that are gone.
class Person {
 public:
  Person(const RemovalScene& scene, std::size_t unit, UnitSet gone, const RemovalWay& way, const BodyQuestion& question,
         const mannequin::NamedFigure& body)
      : scene_(scene), unit_(unit), gone_(gone), way_(way), question_(question), figure_(body.figure) {
    best_.name = body.name;
    best_.figure = body.figure;
    prepare();
    places_ = graspPlaces(scene.units()[unit], question.tool);
    best_.grasp = graspFor(scene.units()[unit], question.tool);
    if (question.tool.length > 0.0) {
      // The room for the glove is around the hand only: the sweep adds it to the tool as well.
      const double radius = std::max(question.tool.radius - question.glove, 0.2 * question.tool.radius);
      const double length = std::max(question.tool.length - 2.0 * question.glove, 0.2 * question.tool.length);
      tool_ = collision::MeshCollider::build(geometry::makeCylinder(radius, length));
    }
  }

  BodyAccess answer(const std::atomic<bool>& cancel) {
    for (const Posture& stand : stands()) {
      for (const GraspPlace& place : places_) {
        for (const Side side : {Side::kRight, Side::kLeft}) {
          if (cancel) return best_;
          attempt(stand, place, side);
        }
      }
      if (best_.reached) break;
    }
    return best_;
  }

 private:
  const Entity& body() const { return *here_->find(kBodyId); }

  void prepare() {
    const PreparedScene& cell = scene_.scene();
    std::vector<EntityId> absent;
    for (std::size_t u = 0; u < scene_.movableCount(); ++u) {
      if ((gone_ >> u & 1) == 0) continue;
      for (const auto& part : scene_.units()[u].parts) absent.push_back(part.part->entity);
    }
    std::vector<Entity> entities;
    for (const Entity& entity : cell.entities()) {
      const Entity* carrier = cell.find(entity.attachment.to);
      const bool carried = carrier != nullptr && carrier->figure() != nullptr;
      if (entity.figure()) {
        if (own_ == nullptr) own_ = &entity;
      } else if (!carried && std::find(absent.begin(), absent.end(), entity.id) == absent.end()) {
        entities.push_back(entity);
      }
    }
    Entity person;
    person.id = kBodyId;
    person.name = best_.name;
    person.body = workcell::Mannequin{{.model = mannequin::figureModel(figure_)},
                                      std::make_shared<const Figure>(figure_)};
    person.setJoints(std::vector<double>(person.robot()->dof(), 0.0));
    entities.push_back(std::move(person));
    here_ = PreparedScene::prepare(std::move(entities), cell.pairs(), cell.defaults(), &cell);
  }

  /// The cell's mannequin's place first, then free ones around the part, the nearest first.
  std::vector<Posture> stands() const {
    std::vector<Posture> all;
    if (own_ != nullptr)
      all.push_back(ergonomics::standingAt(*own_->figure(),
                                           mannequin::toPosture(*own_->figure(), {own_->X_WE, own_->joints()}), figure_));
    const double floor = own_ != nullptr ? own_->X_WE.p.z : 0.0;
    const geometry::Bounds& part = scene_.units()[unit_].bounds_W;
    std::size_t free = 0;
    for (const double distance : kDistances) {
      for (int k = 0; k < kAzimuths && free < kMostStands; ++k) {
        const double azimuth = 2.0 * M_PI * k / kAzimuths;
        Posture stand = *mannequin::libraryPosture(figure_, "standing");
        stand.X_WR.q = glm::normalize(quaternionFromRotationVector({0.0, 0.0, azimuth + M_PI}) * stand.X_WR.q);
        stand.X_WR.p.x = part.center().x + distance * std::cos(azimuth);
        stand.X_WR.p.y = part.center().y + distance * std::sin(azimuth);
        stand.X_WR.p.z += floor;
        if (!manipulation::enteredByBody(*here_, body(), stand).empty()) continue;
        all.push_back(stand);
        ++free;
      }
    }
    return all;
  }

  mannequin::PostureTask taskOf(Side side) const {
    mannequin::PostureTask task;
    task.may_step = true;
    const auto i = static_cast<std::size_t>(side);
    task.loads[i] = {question_.load_kg, figure_.p_HandGrip[i]};
    return task;
  }

  void attempt(const Posture& stand, const GraspPlace& place, Side side) {
    const auto i = static_cast<std::size_t>(side);
    Posture start = stand;
    mannequin::setGrasp(start, side, best_.grasp);
    std::array<std::optional<mannequin::HandTarget>, 2> targets;
    targets[i] = place.target;
    const auto hands = mannequin::handsTo(figure_, start, taskOf(side), targets);
    BodyAccess trial;
    trial.name = best_.name;
    trial.figure = figure_;
    trial.grasp = best_.grasp;
    trial.hand = side;
    trial.place = place;
    trial.short_m = hands.short_m[i];
    trial.posture = trial.posture_end = hands.posture;
    if (tried_ && rank(trial) > rank(best_) && trial.short_m > kThere) return;
    if (trial.short_m <= kThere) {
      trial.touched = manipulation::enteredByBody(*here_, body(), trial.posture);
      trial.sweep = sweepHand(scene_, unit_, gone_, way_, shapesOf(trial), question_.glove);
      trial.reached = trial.touched.empty() && trial.sweep.fits;
    }
    score(trial);
    if (trial.reached) follow(trial);
    trial.why = whyNot(trial);
    if (tried_ && rank(best_) <= rank(trial)) return;
    trial.sight = manipulation::sightOfTarget(*here_, body(), trial.posture, scene_.units()[unit_].entity);
    best_ = std::move(trial);
    tried_ = true;
  }

  /// Less is better.
  static std::tuple<bool, int, double, int, double> rank(const BodyAccess& trial) {
    const bool there = trial.short_m <= kThere;
    const int faults = (there ? 0 : 4) + (trial.sweep.fits ? 0 : 2) + (trial.touched.empty() ? 0 : 1);
    return {!trial.reached, faults, there ? -trial.along : trial.short_m, trial.scores.rula(), -trial.scores.comfort};
  }

  std::vector<SweptShape> shapesOf(const BodyAccess& trial) const {
    std::vector<SweptShape> shapes;
    const auto stands = mannequin::toModel(figure_, trial.posture);
    for (const auto& part : here_->partsOf(kBodyId)) {
      if (!isOfHand(*body().robot(), part.link, trial.hand)) continue;
      shapes.push_back({part.mesh.collider, PreparedScene::partPose(body(), stands.X_WE, stands.joints, part.link)});
    }
    if (tool_) {
      const dvec3 z = trial.place.target.into_W;
      const dvec3 across = std::abs(z.z) < 0.9 ? dvec3(0.0, 0.0, 1.0) : dvec3(1.0, 0.0, 0.0);
      const dvec3 x = glm::normalize(glm::cross(across, z));
      const Pose X_WT{0.5 * (trial.place.p_WPart + trial.place.target.p_W),
                      glm::normalize(glm::quat_cast(dmat3(x, glm::cross(z, x), z)))};
      shapes.push_back({tool_, X_WT});
    }
    return shapes;
  }

  ergonomics::PostureScores scoresOf(const Posture& posture, Side side) const {
    ergonomics::WorkTask task = question_.task;
    task.load_kg[static_cast<std::size_t>(side)] = question_.load_kg;
    return ergonomics::scorePosture(figure_, posture, mannequin::forwardKinematics(figure_, posture), task);
  }

  void score(BodyAccess& trial) const { trial.scores = trial.scores_end = scoresOf(trial.posture, trial.hand); }

  /// The hand goes with the part; its turn may change where the arm cannot keep it.
  void follow(BodyAccess& trial) const {
    const auto i = static_cast<std::size_t>(trial.hand);
    const Pose X_WH = mannequin::handPose(mannequin::forwardKinematics(figure_, trial.posture), trial.hand);
    const Pose X_EH = way_.X_WE.front().inverse() * X_WH;
    const mannequin::PostureSolver solver(figure_);
    for (int k = 1; k <= kAlong; ++k) {
      const double share = static_cast<double>(k) / kAlong;
      mannequin::PostureTask task = taskOf(trial.hand);
      task.hands[i] = way_.at(share) * X_EH;
      auto found = solver.solve(task, trial.posture_end);
      if (found.status != mannequin::PostureStatus::kSolved) {
        task.orientation[i] = false;
        found = solver.solve(task, trial.posture_end);
      }
      if (found.status != mannequin::PostureStatus::kSolved) return;
      if (!manipulation::enteredByBody(*here_, body(), found.posture).empty()) return;
      trial.along = share;
      trial.posture_end = found.posture;
    }
    trial.scores_end = scoresOf(trial.posture_end, trial.hand);
  }

  static std::string whyNot(const BodyAccess& trial) {
    if (trial.reached) return {};
    if (trial.short_m > kThere) {
      char text[60];
      std::snprintf(text, sizeof text, "%.0f mm short", 1000.0 * trial.short_m);
      return text;
    }
    if (!trial.sweep.fits) return "the hand meets " + trial.sweep.blocked_by;
    return "the body touches " + trial.touched;
  }

  const RemovalScene& scene_;
  std::size_t unit_;
  UnitSet gone_;
  const RemovalWay& way_;
  const BodyQuestion& question_;
  const Figure& figure_;
  std::shared_ptr<const PreparedScene> here_;  ///< The cell without its own persons, with this one.
  const Entity* own_ = nullptr;                ///< The cell's mannequin.
  std::vector<GraspPlace> places_;
  std::shared_ptr<const collision::MeshCollider> tool_;
  BodyAccess best_;
  bool tried_ = false;
};

}  // namespace

std::vector<BodyAccess> bodyAccess(const RemovalScene& scene, std::size_t unit, UnitSet gone, const RemovalWay& way,
                                   const BodyQuestion& question, const std::atomic<bool>& cancel) {
  std::vector<BodyAccess> answers;
  for (const mannequin::NamedFigure& body : question.bodies) {
    if (cancel) break;
    answers.push_back(Person(scene, unit, gone, way, question, body).answer(cancel));
  }
  return answers;
}

}  // namespace hapticell::access
