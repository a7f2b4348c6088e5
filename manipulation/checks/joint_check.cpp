// SPDX-License-Identifier: Apache-2.0
#include "manipulation/checks/joint_check.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "kinematics/model/jacobian.h"
#include "manipulation/holding/held_pairs.h"
#include "manipulation/manipulators/manipulator_kinds.h"
#include "manipulation/scene/rest_pairs.h"

namespace hapticell::manipulation {

namespace {

/// A pair of the plan: parts of the scene, by index, and who they are.
struct CheckedPair {
  std::uint32_t part = 0;   ///< Index of the moved part.
  std::uint32_t other = 0;  ///< Of the obstacle, or of the other moved part.
  bool own = false;         ///< Both are moved parts.
  bool fixed = false;       ///< No joint moves the two against each other.
  bool left_out = false;    ///< They touch at rest.
  std::string moved, met;
  std::string first, second;  ///< As checkPath() names them.
};

/// m: nearer than this at rest counts as touching, as in collisionAt(). Half: rounding decides; twice: a pair 2 um apart
/// is not checked.
constexpr double kRestTouching = 1e-6;

bool isMoved(const kinematics::RobotModel& model, int link) {
  return model.closure != nullptr || !kinematics::variablesOfChain(model, link).empty();
}

Expected<std::unique_ptr<Manipulator>> manipulatorOf(const HeldModel& model,
                                                     const config::Configuration& configuration) {
  std::vector<Taking::Part> parts;
  for (const MovedPart& part : model.parts()) parts.push_back({part.link, part.X_LP});
  const Taking taking{model.form(),       model.taken(), resolved(MovedBy(), model.form()), *model.scene(),
                      configuration,      parts};
  return makeManipulator(taking, manipulatorKinds());
}

}  // namespace

struct JointCheck::Plan {
  explicit Plan(HeldModel held) : model(std::move(held)) {}

  HeldModel model;
  std::vector<CheckedPair> pairs;
  std::vector<std::shared_ptr<const collision::MeshCollider>> obstacles;
  std::vector<Pose> X_WO;
  Text note, base_contact;
};

namespace {

Text contactText(const CheckedPair& pair) {
  return pair.own ? Text("%1 would touch its own %2", pair.moved, pair.met)
                  : Text("%1 would touch %2", pair.moved, pair.met);
}

std::vector<CheckedPair> pairsOf(const HeldModel& model, const HeldPairs& held) {
  const kinematics::RobotModel& robot = *model.form().robot();
  const auto moved = [&](std::size_t part) { return isMoved(robot, std::max(0, model.parts()[part].link)); };
  std::vector<CheckedPair> pairs;
  for (std::size_t i = 0; i < held.size(); ++i) {
    const HeldPair& pair = held[i];
    const MotionPair& motion = held.motionPairs()[i];
    if (!motion.blocks) continue;
    CheckedPair checked;
    checked.part = motion.part;
    checked.own = motion.other_part >= 0;
    checked.other = checked.own ? static_cast<std::uint32_t>(motion.other_part) : motion.obstacle;
    checked.fixed = !checked.own && !moved(motion.part);
    checked.moved = pair.moved_part.empty() ? model.form().name : pair.moved_part;
    const workcell::Entity* other = model.scene()->find(pair.other);
    if (checked.own && model.isMember(pair.other)) {
      checked.met = pair.other_part;
    } else {
      checked.met = other != nullptr ? other->name : pair.other_part;
    }
    const ScenePart& second =
        checked.own ? *model.parts()[checked.other].part : *held.obstacleParts()[checked.other];
    checked.first = model.nameOf(*model.parts()[checked.part].part);
    checked.second = model.nameOf(second);
    pairs.push_back(std::move(checked));
  }
  return pairs;
}

}  // namespace

Expected<JointCheck> JointCheck::create(std::shared_ptr<const PreparedScene> scene, workcell::EntityId id,
                                        const config::Configuration& configuration, RestContacts at_rest,
                                        bool with_axes) {
  const workcell::Entity* entity = scene->find(id);
  if (entity == nullptr)
    return makeError({.found = "the entity does not exist", .expected = "one that exists in the document"});
  if (!entity->robot())
    return makeError({.place = Text("entity '%1'", entity->name),
                      .found = "it has no joints",
                      .expected = "a robot or a mechanism"});
  std::vector<Text> notes;
  workcell::Entity free = *entity;
  free.locked = false;
  auto plan = std::make_shared<Plan>(HeldModel(std::move(scene), free, {}, with_axes, notes));
  const auto manipulator = manipulatorOf(plan->model, configuration);
  HAPTICELL_TRY(manipulator);
  const HeldPairs held(plan->model, **manipulator, {}, {MovedBy(), entity->contact.on_contact, entity->contact.force_class},
                       configuration);
  plan->note = held.leftOutNote();
  plan->pairs = pairsOf(plan->model, held);
  for (std::size_t i = 0; i < held.obstacles().size(); ++i) {
    plan->obstacles.push_back(held.obstacleParts()[i]->mesh.collider);
    plan->X_WO.push_back(held.obstacles()[i].X_W);
  }
  JointCheck check(plan);
  check.place(plan->model.form().joints(), check.scene_);
  if (at_rest != RestContacts::kCount) check.leaveOutTouching(*plan, at_rest);
  // Whether the base is in contact does not depend on the joints: it is asked once.
  for (std::size_t i = 0; i < plan->pairs.size(); ++i) {
    if (!plan->pairs[i].fixed || plan->pairs[i].left_out) continue;
    const auto pair = static_cast<collision::PairIndex>(i);
    if (plan->base_contact.empty() && check.scene_.distance(pair, collision::kTouchingDistance).colliding)
      plan->base_contact = contactText(plan->pairs[i]);
    check.scene_.setEnabled(pair, false);
  }
  return check;
}

JointCheck::JointCheck(std::shared_ptr<const Plan> plan) : plan_(std::move(plan)) {
  const std::vector<MovedPart>& moved = plan_->model.parts();
  std::vector<collision::PartIndex> parts, obstacles;
  for (collision::Scene* scene : {&scene_, &obstacles_}) {
    for (const MovedPart& part : moved) scene->addPart({part.part->entity, 0}, part.part->mesh.collider);
    for (std::size_t i = 0; i < plan_->obstacles.size(); ++i) scene->addPart({0, 0}, plan_->obstacles[i], plan_->X_WO[i]);
    const auto first = static_cast<std::uint32_t>(moved.size());
    for (std::size_t i = 0; i < plan_->pairs.size(); ++i) {
      const CheckedPair& pair = plan_->pairs[i];
      const collision::PairIndex index =
          scene->addPair(pair.part, pair.own ? pair.other : first + pair.other, static_cast<std::uint32_t>(i));
      if (pair.fixed || pair.left_out || (pair.own && scene == &obstacles_)) scene->setEnabled(index, false);
    }
  }
}

bool JointCheck::touchesEverywhere(collision::PairIndex pair) {
  const workcell::Entity& form = plan_->model.form();
  if (form.robot()->closure != nullptr) return true;  // What touches at rest is left out.
  bool touches = true;
  for (int i = 0; i < kTouchPlaces && touches; ++i) {
    place(jointsAllOver(*form.robot(), i), scene_);
    touches = !scene_.distance(pair, kRestTouching).beyond_limit;
  }
  place(form.joints(), scene_);
  return touches;
}

void JointCheck::leaveOutTouching(Plan& plan, RestContacts which) {
  std::string names;
  for (std::size_t i = 0; i < plan.pairs.size(); ++i) {
    const auto pair = static_cast<collision::PairIndex>(i);
    const auto result = scene_.distance(pair, kRestTouching);
    if (result.beyond_limit) continue;
    if (which == RestContacts::kLeaveOutLasting && !plan.pairs[i].fixed && !touchesEverywhere(pair)) continue;
    plan.pairs[i].left_out = true;
    scene_.setEnabled(pair, false);
    obstacles_.setEnabled(pair, false);
    names += (names.empty() ? "" : ", ") + plan.pairs[i].moved + " / " + plan.pairs[i].met;
  }
  if (names.empty()) return;
  const Text touching("not checked, because they touch at rest: %1", names);
  plan.note = plan.note.empty() ? touching : Text("%1; %2", plan.note, touching);
}

/// A copy: its queries begin anew, what is made once of each mesh is shared (InnerBalls).
JointCheck JointCheck::fresh() const {
  return *this;
}

void JointCheck::place(const std::vector<double>& joints, collision::Scene& scene) {
  const workcell::Entity& form = plan_->model.form();
  kinematics::forwardKinematics(*form.robot(), joints, X_BL_);
  const std::vector<MovedPart>& moved = plan_->model.parts();
  for (std::uint32_t i = 0; i < moved.size(); ++i) {
    const Pose X_WP = form.X_WE * X_BL_[static_cast<std::size_t>(std::max(0, moved[i].link))] * moved[i].X_LP;
    scene.setPose(i, X_WP);
  }
}

bool JointCheck::isFree(const std::vector<double>& joints, double clearance) {
  if (!plan_->base_contact.empty()) return false;
  place(joints, scene_);
  if (scene_.collides()) return false;
  if (!(clearance > 0.0)) return true;
  place(joints, obstacles_);
  const auto nearest = obstacles_.nearest(clearance);
  return !nearest || nearest->result.distance >= clearance;
}

double JointCheck::clearance(const std::vector<double>& joints, double limit) {
  if (!plan_->base_contact.empty()) return 0.0;
  place(joints, obstacles_);
  const auto nearest = obstacles_.nearest(limit);
  return nearest ? nearest->result.distance : limit;
}

void JointCheck::nearer(const std::vector<double>& joints, double limit, std::vector<NearPair>& near) {
  place(joints, obstacles_);
  std::vector<collision::PairDistance> found;
  obstacles_.pairsWithin(limit, found);
  near.clear();
  for (const auto& one : found) near.push_back({one.pair, one.result.distance});
}

PlacedPair JointCheck::placed(const std::vector<double>& joints, std::uint32_t pair) {
  place(joints, obstacles_);
  const CheckedPair& words = plan_->pairs[obstacles_.tag(pair)];
  const collision::PartIndex a = obstacles_.moved(pair), b = obstacles_.environment(pair);
  return {obstacles_.sharedCollider(a), obstacles_.sharedCollider(b), obstacles_.pose(a), obstacles_.pose(b),
          words.first, words.second};
}

Text JointCheck::contactAt(const std::vector<double>& joints) {
  if (!plan_->base_contact.empty()) return plan_->base_contact;
  place(joints, scene_);
  const auto nearest = scene_.nearest(collision::kTouchingDistance);
  return nearest && nearest->result.colliding ? contactText(plan_->pairs[nearest->pair]) : Text();
}

const Text& JointCheck::baseContact() const {
  return plan_->base_contact;
}

const workcell::Entity& JointCheck::entity() const {
  return plan_->model.form();
}

const Text& JointCheck::note() const {
  return plan_->note;
}

}  // namespace hapticell::manipulation
