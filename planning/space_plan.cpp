// SPDX-License-Identifier: Apache-2.0
#include "planning/space_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "collision/queries/proximity_query.h"
#include "kinematics/model/jacobian.h"
#include "manipulation/manipulators/manipulator_kinds.h"
#include "planning/own_pair_motion.h"

namespace hapticell::planning {

using manipulation::HeldModel;
using manipulation::HeldPairs;
using manipulation::MotionPair;
using manipulation::MovedPart;

namespace {

/// m: nearer than this at rest counts as touching, as for JointCheck. Half: rounding decides; twice: a pair 2 um apart
/// is not checked.
constexpr double kRestTouching = 1e-6;

/// Joint positions at which a pair that touches at rest has to touch too to be left out. Half: a link that is in
/// contact by chance may pass through what it touches; twice: twice the time, which is small.
constexpr int kLastingSamples = 32;

/// Share of the proven way of a joint that counts: rounding. Half, twice: far from rounding and from what matters.
constexpr double kProvenShare = 1.0 - 1e-6;
/// rad: joints without limits are proven up to here. Half: full turns are proven anew each time; twice: so is none.
constexpr double kProvenTurn = 2.0 * std::numbers::pi;

/// The variables that move one of the two links, but not both.
std::vector<std::size_t> jointsBetween(const kinematics::RobotModel& model, int first, int second) {
  std::vector<std::size_t> joints;
  const auto of_first = kinematics::variablesOfChain(model, std::max(0, first));
  const auto of_second = kinematics::variablesOfChain(model, std::max(0, second));
  for (int v = 0; v < static_cast<int>(model.dof()); ++v) {
    const bool moves_first = std::find(of_first.begin(), of_first.end(), v) != of_first.end();
    const bool moves_second = std::find(of_second.begin(), of_second.end(), v) != of_second.end();
    if (model.closure != nullptr || moves_first != moves_second) joints.push_back(static_cast<std::size_t>(v));
  }
  return joints;
}

bool movesWithJoints(const kinematics::RobotModel& model, int link) {
  return model.closure != nullptr || !kinematics::variablesOfChain(model, std::max(0, link)).empty();
}

Expected<void> canBePlannedFor(const workcell::Entity* entity, bool has_hand) {
  if (entity == nullptr)
    return makeError({.found = "the entity does not exist", .expected = "one that exists in the document"});
  const Text place("entity '%1'", entity->name);
  if (entity->figure() != nullptr) {
    if (has_hand) return {};
    return makeError({.place = place,
                      .found = "a mannequin, but not which of its hands is to move",
                      .expected = "its left or right hand"});
  }
  const bool is_solid = entity->kind() == workcell::EntityKind::kSolid && entity->mesh() != nullptr;
  if (!is_solid && !workcell::isMachine(*entity))
    return makeError({.place = place,
                      .found = Text("a path cannot be planned for a %1", workcell::wordOf(entity->kind())),
                      .expected = "a robot, a mechanism, a mannequin or a solid with a shape"});
  if (has_hand)
    return makeError({.place = place, .found = "a hand, which it does not have", .expected = "a mannequin"});
  return {};
}

}  // namespace

Expected<std::shared_ptr<const SpacePlan>> SpacePlan::create(std::shared_ptr<const manipulation::PreparedScene> scene,
                                                             workcell::EntityId id,
                                                             const config::Configuration& configuration,
                                                             const manipulation::Placements& placements,
                                                             const MovedChoice& choice) {
  const std::optional<mannequin::Side>& hand = choice.hand;
  const workcell::Entity* entity = scene->find(id);
  HAPTICELL_TRY(canBePlannedFor(entity, hand.has_value()));
  std::vector<Text> notes;
  workcell::Entity free = *entity;
  free.locked = false;
  const EntityConfiguration present = manipulation::standingOf(*entity, placements);
  free.X_WE = present.X_WE;
  if (free.robot()) free.setJoints(present.joints);
  const std::shared_ptr<SpacePlan> plan(new SpacePlan(HeldModel(std::move(scene), free, placements, choice.with_axes, notes)));
  plan->present_ = plan->model_.taken();
  std::vector<manipulation::Taking::Part> parts;
  for (const MovedPart& part : plan->model_.parts()) parts.push_back({part.link, part.X_LP});
  manipulation::MovedBy moved_by;
  if (hand) moved_by = manipulation::by::Hand{.side = *hand};
  for (const Text& note : notes) plan->addNote(note);
  const manipulation::Taking taking{
      plan->model_.form(),   plan->model_.taken(), manipulation::resolved(moved_by, plan->model_.form()),
      *plan->model_.scene(), configuration,        parts};
  auto manipulator = manipulation::makeManipulator(taking, manipulation::manipulatorKinds());
  HAPTICELL_TRY(manipulator);
  plan->manipulator_ = std::move(*manipulator);
  if (hand) plan->figure_ = std::make_unique<const StandingFigure>(taking, *hand);
  const HeldPairs held(plan->model_, *plan->manipulator_, placements,
                       {moved_by, entity->contact.on_contact, entity->contact.force_class}, configuration);
  plan->addNote(held.leftOutNote());
  if (hand) plan->addNote(plan->figure_->note());
  plan->addPairs(held);
  plan->addObstacles(held);
  if (free.robot() && !hand) plan->leaveOutLasting();
  return std::shared_ptr<const SpacePlan>(plan);
}

void SpacePlan::addPairs(const HeldPairs& held) {
  const kinematics::RobotModel* robot = model_.form().robot().get();
  for (std::size_t i = 0; i < held.size(); ++i) {
    const MotionPair& motion = held.motionPairs()[i];
    if (!motion.blocks) continue;
    CheckedPair pair;
    pair.own = motion.other_part >= 0;
    pair.part = motion.part;
    const MovedPart& moved = model_.parts()[motion.part];
    if (!pair.own && standsStill(moved.link)) continue;
    pair.other = pair.own ? static_cast<std::uint32_t>(motion.other_part)
                          : static_cast<std::uint32_t>(model_.parts().size()) + motion.obstacle;
    const manipulation::ScenePart& met =
        pair.own ? *model_.parts()[pair.other].part : *held.obstacleParts()[motion.obstacle];
    pair.words = {model_.nameOf(*moved.part), model_.nameOf(met), pair.own ? model_.id() : met.entity};
    if (pair.own && robot != nullptr && figure_ == nullptr)
      pair.joints = jointsBetween(*robot, moved.link, model_.parts()[pair.other].link);
    (pair.own ? own_pairs_ : pairs_).push_back(std::move(pair));
  }
}

/// What no joint moves (a base), and a standing mannequin's feet.
bool SpacePlan::standsStill(int link) const {
  if (figure_ != nullptr) return figure_->standsStill(link);
  const kinematics::RobotModel* robot = model_.form().robot().get();
  return robot != nullptr && !movesWithJoints(*robot, link);
}

const std::vector<FreeRange>& SpacePlan::freeRanges() const {
  std::call_once(ranges_known_, [this] {
    ranges_.reserve(own_pairs_.size());
    for (const CheckedPair& pair : own_pairs_) ranges_.push_back(freeRangeOf(pair));
  });
  return ranges_;
}

FreeRange SpacePlan::freeRangeOf(const CheckedPair& pair) const {
  const kinematics::RobotModel* robot = model_.form().robot().get();
  if (robot == nullptr || robot->closure != nullptr || pair.joints.size() != 1) return {};
  const std::size_t variable = pair.joints.front();
  const kinematics::Joint& joint = robot->joints[static_cast<std::size_t>(robot->moving[variable])];
  collision::ProximityQuery query(model_.parts()[pair.part].part->mesh.collider,
                                  model_.parts()[pair.other].part->mesh.collider);
  const double begin = present_.joints[variable];
  const auto provenTo = [&](double end) {
    EntityConfiguration to = present_;
    to.joints[variable] = end;
    std::vector<double> bounds(spheres_.size());
    manipulator_->pathBounds(present_, to, spheres_, bounds);
    PlannedMotion motion(*manipulator_, present_, to, model_.parts().size());
    const auto stop = leadOwnPair(query, pair, motion, bounds[pair.part] + bounds[pair.other]);
    if (stop.began_colliding) return std::numeric_limits<double>::quiet_NaN();
    return begin + (stop.stopped ? kProvenShare * stop.s : 1.0) * (end - begin);
  };
  const FreeRange range{provenTo(std::max(joint.lower, -kProvenTurn)), provenTo(std::min(joint.upper, kProvenTurn))};
  return std::isnan(range.lower) || std::isnan(range.upper) ? FreeRange() : range;
}

void SpacePlan::addObstacles(const HeldPairs& held) {
  for (std::size_t i = 0; i < held.obstacles().size(); ++i) {
    const auto& collider = held.obstacleParts()[i]->mesh.collider;
    obstacles_.push_back(collider);
    X_WO_.push_back(held.obstacles()[i].X_W);
    if (!collider->isEmpty()) obstacle_bounds_.add(collision::placedBounds(*collider, X_WO_.back()).box_W());
  }
  for (const MovedPart& part : model_.parts()) {
    const collision::MeshCollider& collider = *part.part->mesh.collider;
    spheres_.push_back({collider.center(), collider.radius()});
    radius_ = std::max(radius_, glm::length(part.X_LP * collider.center()) + collider.radius());
  }
}

/// A robot's first links touch what it stands on wherever it is.
void SpacePlan::leaveOutLasting() {
  std::vector<CheckedPair*> lasting;
  for (CheckedPair& pair : pairs_) lasting.push_back(&pair);
  std::mt19937_64 random(1);
  for (int i = 0; i <= kLastingSamples && !lasting.empty(); ++i) {
    std::vector<Pose> X_WP(model_.parts().size());
    manipulator_->partPoses(i == 0 ? present_ : anywhere(random), X_WP);
    std::erase_if(lasting, [&](const CheckedPair* pair) { return !touches(*pair, X_WP); });
    // Where loops close, joint positions are not free to choose.
    if (model_.form().robot()->closure != nullptr) break;
  }
  if (lasting.empty()) return;
  std::string names;
  for (CheckedPair* pair : lasting) {
    names += (names.empty() ? "" : ", ") + pair->words.moved + " / " + pair->words.met;
    pair->is_lasting = true;
  }
  std::erase_if(pairs_, [](const CheckedPair& pair) { return pair.is_lasting; });
  addNote(Text("not checked, because they always touch: %1", names));
}

void SpacePlan::addNote(const Text& more) {
  if (!more.empty()) note_ = note_.empty() ? more : Text("%1; %2", note_, more);
}

bool SpacePlan::touches(const CheckedPair& pair, const std::vector<Pose>& X_WP) const {
  const std::size_t obstacle = pair.other - model_.parts().size();
  const auto distance = collision::distance(model_.parts()[pair.part].part->mesh.collider, X_WP[pair.part],
                                            obstacles_[obstacle], X_WO_[obstacle], kRestTouching);
  return !distance.beyond_limit;
}

/// Joints anywhere in their ranges.
EntityConfiguration SpacePlan::anywhere(std::mt19937_64& random) const {
  EntityConfiguration at = present_;
  const kinematics::RobotModel& robot = *model_.form().robot();
  for (std::size_t i = 0; i < at.joints.size(); ++i) {
    const kinematics::Joint& joint = robot.joints[static_cast<std::size_t>(robot.moving[i])];
    const double lower = std::max(joint.lower, -kProvenTurn), upper = std::min(joint.upper, kProvenTurn);
    at.joints[i] = lower + static_cast<double>(random() >> 11) * 0x1.0p-53 * (upper - lower);
  }
  return at;
}

}  // namespace hapticell::planning
