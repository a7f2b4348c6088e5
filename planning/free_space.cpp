// SPDX-License-Identifier: Apache-2.0
#include "planning/free_space.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>
#include <random>

#include "collision/queries/freeing_shift.h"
#include "collision/queries/proximity_query.h"
#include "geometry/system/assertion.h"
#include "kinematics/model/jacobian.h"
#include "manipulation/holding/held_pairs.h"
#include "manipulation/manipulators/manipulator_kinds.h"
#include "planning/own_pair_motion.h"

namespace hapticell::planning {

namespace {

using manipulation::HeldModel;
using manipulation::HeldPairs;
using manipulation::Manipulator;
using manipulation::MotionPair;
using manipulation::MovedPart;

/// m: nearer than this at rest counts as touching, as for JointCheck. Half: rounding decides; twice: a pair 2 um apart
/// is not checked.
constexpr double kRestTouching = 1e-6;

/// Joint positions at which a pair that touches at rest has to touch too to be left out. Half: a link that is in
/// contact by chance may pass through what it touches; twice: twice the time, which is small.
constexpr int kLastingSamples = 32;

/// m of path between the places of a motion that are looked at before it is proven, which take a few us each. Half:
/// free motions take longer; twice: more motions that end in something are found by their proof only, which takes ms.
constexpr double kLooksApart = 0.1;
/// Pieces between such places at most; the proof looks at the places between them. By `planning_bench`; half: motions
/// that end in something take longer; twice: free ones do.
constexpr int kMostLooks = 4;

/// Share of the proven way of a joint that counts: rounding. Half, twice: far from rounding and from what matters.
constexpr double kProvenShare = 1.0 - 1e-6;
/// rad: joints without limits are proven up to here. Half: full turns are proven anew each time; twice: so is none.
constexpr double kProvenTurn = 2.0 * std::numbers::pi;

/// Values of a joint; at first none.
struct FreeRange {
  double lower = std::numeric_limits<double>::infinity(), upper = -lower;
  bool holds(double q) const { return lower <= q && q <= upper; }
};

/// A pair that is checked: parts of the space's scene, by index, and who they are.
struct CheckedPair : OwnPair {
  bool own = false;
  bool is_lasting = false;               ///< They touch whatever the joints are.
  std::vector<std::size_t> joints = {};  ///< Of an own pair: those that move the two against each other.
  Blocker words = {};
};

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

Expected<std::unique_ptr<Manipulator>> manipulatorOf(const HeldModel& model,
                                                     const config::Configuration& configuration) {
  std::vector<manipulation::Taking::Part> parts;
  for (const MovedPart& part : model.parts()) parts.push_back({part.link, part.X_LP});
  const manipulation::Taking taking{
      model.form(),   model.taken(), manipulation::resolved(manipulation::MovedBy(), model.form()),
      *model.scene(), configuration, parts};
  return makeManipulator(taking, manipulation::manipulatorKinds());
}

Expected<void> canBePlannedFor(const workcell::Entity* entity) {
  if (entity == nullptr)
    return makeError({.found = "the entity does not exist", .expected = "one that exists in the document"});
  const bool is_solid = entity->kind() == workcell::EntityKind::kSolid && entity->mesh() != nullptr;
  if (is_solid || workcell::isMachine(*entity)) return {};
  return makeError({.place = Text("entity '%1'", entity->name),
                    .found = Text("a path cannot be planned for a %1", workcell::wordOf(entity->kind())),
                    .expected = "a robot, a mechanism or a solid with a shape"});
}

}  // namespace

Text Blocker::text() const {
  return Text("%1 would touch %2", moved, met);
}

struct FreeSpace::Plan {
  explicit Plan(HeldModel held) : model(std::move(held)) {}

  HeldModel model;
  std::unique_ptr<Manipulator> manipulator;
  std::vector<CheckedPair> pairs, own_pairs;
  std::vector<std::shared_ptr<const collision::MeshCollider>> obstacles;
  std::vector<Pose> X_WO;
  std::vector<manipulation::PartSphere> spheres;
  geometry::Bounds obstacle_bounds;
  EntityConfiguration present;
  double radius = 0.0;
  Text note;
  mutable std::once_flag ranges_known;
  mutable std::vector<FreeRange> ranges;  ///< Of own_pairs; see freeRanges().

  const std::vector<FreeRange>& freeRanges() const;
  FreeRange freeRangeOf(const CheckedPair& pair) const;
  void addPairs(const HeldPairs& held);
  void addObstacles(const HeldPairs& held);
  void leaveOutLasting();
  bool touches(const CheckedPair& pair, const std::vector<Pose>& X_WP) const;
  EntityConfiguration anywhere(std::mt19937_64& random) const;
};

void FreeSpace::Plan::addPairs(const HeldPairs& held) {
  const kinematics::RobotModel* robot = model.form().robot().get();
  for (std::size_t i = 0; i < held.size(); ++i) {
    const MotionPair& motion = held.motionPairs()[i];
    if (!motion.blocks) continue;
    CheckedPair pair;
    pair.own = motion.other_part >= 0;
    pair.part = motion.part;
    const MovedPart& moved = model.parts()[motion.part];
    if (!pair.own && robot != nullptr && !movesWithJoints(*robot, moved.link)) continue;
    pair.other = pair.own ? static_cast<std::uint32_t>(motion.other_part)
                          : static_cast<std::uint32_t>(model.parts().size()) + motion.obstacle;
    const manipulation::ScenePart& met =
        pair.own ? *model.parts()[pair.other].part : *held.obstacleParts()[motion.obstacle];
    pair.words = {model.nameOf(*moved.part), model.nameOf(met), pair.own ? model.id() : met.entity};
    if (pair.own && robot != nullptr) pair.joints = jointsBetween(*robot, moved.link, model.parts()[pair.other].link);
    (pair.own ? own_pairs : pairs).push_back(std::move(pair));
  }
}

/// Where the one joint between an own pair keeps it apart, whatever the other joints are: proven once, from the present
/// value to both limits, at the first question. Links beside each other are so near that each motion's own proof takes
/// hundreds of distances. Any thread.
const std::vector<FreeRange>& FreeSpace::Plan::freeRanges() const {
  std::call_once(ranges_known, [this] {
    ranges.reserve(own_pairs.size());
    for (const CheckedPair& pair : own_pairs) ranges.push_back(freeRangeOf(pair));
  });
  return ranges;
}

FreeRange FreeSpace::Plan::freeRangeOf(const CheckedPair& pair) const {
  const kinematics::RobotModel* robot = model.form().robot().get();
  if (robot == nullptr || robot->closure != nullptr || pair.joints.size() != 1) return {};
  const std::size_t variable = pair.joints.front();
  const kinematics::Joint& joint = robot->joints[static_cast<std::size_t>(robot->moving[variable])];
  collision::ProximityQuery query(model.parts()[pair.part].part->mesh.collider,
                                  model.parts()[pair.other].part->mesh.collider);
  const double begin = present.joints[variable];
  const auto provenTo = [&](double end) {
    EntityConfiguration to = present;
    to.joints[variable] = end;
    std::vector<double> bounds(spheres.size());
    manipulator->pathBounds(present, to, spheres, bounds);
    PlannedMotion motion(*manipulator, present, to, model.parts().size());
    const auto stop = leadOwnPair(query, pair, motion, bounds[pair.part] + bounds[pair.other]);
    if (stop.began_colliding) return std::numeric_limits<double>::quiet_NaN();
    return begin + (stop.stopped ? kProvenShare * stop.s : 1.0) * (end - begin);
  };
  const FreeRange range{provenTo(std::max(joint.lower, -kProvenTurn)), provenTo(std::min(joint.upper, kProvenTurn))};
  return std::isnan(range.lower) || std::isnan(range.upper) ? FreeRange() : range;
}

void FreeSpace::Plan::addObstacles(const HeldPairs& held) {
  for (std::size_t i = 0; i < held.obstacles().size(); ++i) {
    const auto& collider = held.obstacleParts()[i]->mesh.collider;
    obstacles.push_back(collider);
    X_WO.push_back(held.obstacles()[i].X_W);
    if (!collider->isEmpty()) obstacle_bounds.add(collision::placedBounds(*collider, X_WO.back()).box_W());
  }
  for (const MovedPart& part : model.parts()) {
    const collision::MeshCollider& collider = *part.part->mesh.collider;
    spheres.push_back({collider.center(), collider.radius()});
    radius = std::max(radius, glm::length(part.X_LP * collider.center()) + collider.radius());
  }
}

/// A robot's first links touch what it stands on wherever it is.
void FreeSpace::Plan::leaveOutLasting() {
  std::vector<CheckedPair*> lasting;
  for (CheckedPair& pair : pairs) lasting.push_back(&pair);
  std::mt19937_64 random(1);
  for (int i = 0; i <= kLastingSamples && !lasting.empty(); ++i) {
    std::vector<Pose> X_WP(model.parts().size());
    manipulator->partPoses(i == 0 ? present : anywhere(random), X_WP);
    std::erase_if(lasting, [&](const CheckedPair* pair) { return !touches(*pair, X_WP); });
    // Where loops close, joint positions are not free to choose.
    if (model.form().robot()->closure != nullptr) break;
  }
  if (lasting.empty()) return;
  std::string names;
  for (CheckedPair* pair : lasting) {
    names += (names.empty() ? "" : ", ") + pair->words.moved + " / " + pair->words.met;
    pair->is_lasting = true;
  }
  std::erase_if(pairs, [](const CheckedPair& pair) { return pair.is_lasting; });
  const Text touching("not checked, because they always touch: %1", names);
  note = note.empty() ? touching : Text("%1; %2", note, touching);
}

bool FreeSpace::Plan::touches(const CheckedPair& pair, const std::vector<Pose>& X_WP) const {
  const std::size_t obstacle = pair.other - model.parts().size();
  const auto distance = collision::distance(model.parts()[pair.part].part->mesh.collider, X_WP[pair.part],
                                            obstacles[obstacle], X_WO[obstacle], kRestTouching);
  return !distance.beyond_limit;
}

/// Joints anywhere in their ranges.
EntityConfiguration FreeSpace::Plan::anywhere(std::mt19937_64& random) const {
  EntityConfiguration at = present;
  const kinematics::RobotModel& robot = *model.form().robot();
  for (std::size_t i = 0; i < at.joints.size(); ++i) {
    const kinematics::Joint& joint = robot.joints[static_cast<std::size_t>(robot.moving[i])];
    const double lower = std::max(joint.lower, -kProvenTurn), upper = std::min(joint.upper, kProvenTurn);
    at.joints[i] = lower + static_cast<double>(random() >> 11) * 0x1.0p-53 * (upper - lower);
  }
  return at;
}

Expected<FreeSpace> FreeSpace::create(std::shared_ptr<const manipulation::PreparedScene> scene, workcell::EntityId id,
                                      const config::Configuration& configuration,
                                      const manipulation::Placements& placements) {
  const workcell::Entity* entity = scene->find(id);
  HAPTICELL_TRY(canBePlannedFor(entity));
  std::vector<Text> notes;
  workcell::Entity free = *entity;
  free.locked = false;
  const EntityConfiguration present = manipulation::standingOf(*entity, placements);
  free.X_WE = present.X_WE;
  if (free.robot()) free.setJoints(present.joints);
  auto plan = std::make_shared<Plan>(HeldModel(std::move(scene), free, placements, false, notes));
  auto manipulator = manipulatorOf(plan->model, configuration);
  HAPTICELL_TRY(manipulator);
  plan->manipulator = std::move(*manipulator);
  const HeldPairs held(plan->model, *plan->manipulator, placements,
                       {manipulation::MovedBy(), entity->contact.on_contact, entity->contact.force_class},
                       configuration);
  plan->note = held.leftOutNote();
  plan->present = present;
  plan->addPairs(held);
  plan->addObstacles(held);
  if (free.robot()) plan->leaveOutLasting();
  return FreeSpace(plan);
}

FreeSpace::FreeSpace(std::shared_ptr<const Plan> plan) : plan_(std::move(plan)) {
  const std::vector<MovedPart>& moved = plan_->model.parts();
  for (const MovedPart& part : moved) scene_.addPart({part.part->entity, 0}, part.part->mesh.collider);
  for (std::size_t i = 0; i < plan_->obstacles.size(); ++i) scene_.addPart({0, 0}, plan_->obstacles[i], plan_->X_WO[i]);
  for (std::size_t i = 0; i < plan_->pairs.size(); ++i) {
    scene_.addPair(plan_->pairs[i].part, plan_->pairs[i].other, static_cast<std::uint32_t>(i));
  }
  for (const CheckedPair& pair : plan_->own_pairs) {
    own_.emplace_back(moved[pair.part].part->mesh.collider, moved[pair.other].part->mesh.collider);
  }
  clearances_.assign(plan_->pairs.size(), 0.0);
  moved_.resize(moved.size());
  X_WP_.resize(moved.size());
  bounds_.resize(moved.size());
  for (std::size_t i = 0; i < moved.size(); ++i) moved_[i].part = static_cast<collision::PartIndex>(i);
}

FreeSpace FreeSpace::fresh() const {
  FreeSpace space(plan_);
  space.setClearance(clearance_);
  space.stop_ = stop_;
  return space;
}

void FreeSpace::setClearance(double clearance) {
  HAPTICELL_DEMAND(clearance >= 0.0);
  clearance_ = clearance;
  clearances_.assign(clearances_.size(), clearance);
}

/// Of moved_.
bool FreeSpace::meetsNothing(bool moves) {
  const auto found = scene_.findNearer(moved_, clearances_, !moves);
  if (found) blocked_by_ = plan_->pairs[scene_.tag(*found)].words;
  return !found;
}

bool FreeSpace::standsFree(const EntityConfiguration& at) {
  plan_->manipulator->partPoses(at, X_WP_);
  for (std::size_t i = 0; i < moved_.size(); ++i) moved_[i].motion = collision::standingStill(X_WP_[i]);
  return meetsNothing(false) && !ownPartsTouch(at);
}

/// Whether something is in the way at the end, in the middle, at the quarters and so on: of most motions that are not
/// free. Needs bounds_.
bool FreeSpace::isMetOnTheWay(const EntityConfiguration& from, const EntityConfiguration& to) {
  const double way = bounds_.empty() ? 0.0 : *std::max_element(bounds_.begin(), bounds_.end());
  for (int pieces = 1; pieces <= kMostLooks; pieces *= 2) {
    for (int i = 1; i <= pieces; i += 2) {
      if (!standsFree(plan_->manipulator->between(from, to, static_cast<double>(i) / pieces))) return true;
    }
    if (way <= kLooksApart * pieces) break;
  }
  return false;
}

bool FreeSpace::isFree(const EntityConfiguration& at) {
  blocked_by_.reset();
  if (stop_ != nullptr && stop_->load(std::memory_order_relaxed)) return false;
  ++checks_;
  return standsFree(at);
}

/// Whether the own pair is proven to be apart there by the one joint between its parts.
bool FreeSpace::keptApart(std::size_t own, const EntityConfiguration& at) const {
  const CheckedPair& pair = plan_->own_pairs[own];
  return pair.joints.size() == 1 && plan_->freeRanges()[own].holds(at.joints[pair.joints.front()]);
}

/// At X_WP_, the parts' poses at `at`.
bool FreeSpace::ownPartsTouch(const EntityConfiguration& at) {
  for (std::size_t i = 0; i < own_.size(); ++i) {
    const CheckedPair& pair = plan_->own_pairs[i];
    if (keptApart(i, at)) continue;
    if (!own_[i].within(X_WP_[pair.part], X_WP_[pair.other], collision::kLeastClearance)) continue;
    blocked_by_ = pair.words;
    return true;
  }
  return false;
}

/// What moves both brings them no nearer: only the joints between them count.
bool FreeSpace::ownPartsTouch(const EntityConfiguration& from, const EntityConfiguration& to) {
  const Manipulator& manipulator = *plan_->manipulator;
  manipulator.partPoses(manipulator.between(from, to, 0.5), X_WP_);
  own_bounds_.resize(bounds_.size());
  PlannedMotion motion(manipulator, from, to, moved_.size());
  for (std::size_t i = 0; i < own_.size(); ++i) {
    const CheckedPair& pair = plan_->own_pairs[i];
    if (keptApart(i, from) && keptApart(i, to)) continue;
    const Pose &X_WA = X_WP_[pair.part], &X_WB = X_WP_[pair.other];
    const auto comesNear = [&](double way) {
      return spheresApart(own_[i], X_WA, X_WB) <= collision::kLeastClearance + 0.5 * way + collision::kRounding;
    };
    if (!comesNear(bounds_[pair.part] + bounds_[pair.other])) continue;
    EntityConfiguration apart = from;
    for (const std::size_t joint : pair.joints) apart.joints[joint] = to.joints[joint];
    manipulator.pathBounds(from, apart, plan_->spheres, own_bounds_);
    const double way = own_bounds_[pair.part] + own_bounds_[pair.other];
    if (!comesNear(way)) continue;
    if (!ownPairTouches(own_[i], pair, motion, way)) continue;
    blocked_by_ = pair.words;
    return true;
  }
  return false;
}

bool FreeSpace::isFree(const EntityConfiguration& from, const EntityConfiguration& to) {
  blocked_by_.reset();
  if (stop_ != nullptr && stop_->load(std::memory_order_relaxed)) return false;
  const Manipulator& manipulator = *plan_->manipulator;
  ++checks_;
  manipulator.pathBounds(from, to, plan_->spheres, bounds_);
  if (isMetOnTheWay(from, to)) return false;
  const double turned = manipulator.turnBound(from, to);
  PlannedMotion motion(manipulator, from, to, moved_.size());
  for (std::size_t i = 0; i < moved_.size(); ++i) {
    collision::PartMotion& part = moved_[i].motion;
    part.path_bound = bounds_[i];
    part.bend_bound = 2.0 * turned * bounds_[i];
    part.along = [&motion, i](double s) { return motion.poseOf(i, s); };
  }
  return meetsNothing(true) && !ownPartsTouch(from, to);
}

void FreeSpace::place(const EntityConfiguration& at) {
  plan_->manipulator->partPoses(at, X_WP_);
  for (std::size_t i = 0; i < X_WP_.size(); ++i) scene_.setPose(static_cast<collision::PartIndex>(i), X_WP_[i]);
}

std::optional<collision::PairDistance> FreeSpace::measure(const EntityConfiguration& at, double limit) {
  place(at);
  return scene_.nearest(limit);
}

PairGap FreeSpace::gapFrom(const collision::PairDistance& found) const {
  PairGap gap{found.pair, found.result.distance, found.result.nhat_BA_W, plan_->pairs[scene_.tag(found.pair)].words};
  if (!found.result.colliding) return gap;
  const collision::PartIndex a = scene_.moved(found.pair), b = scene_.environment(found.pair);
  collision::ProximityQuery query(scene_.sharedCollider(a), scene_.sharedCollider(b));
  const auto shift = collision::freeingShift(query, scene_.pose(a), scene_.pose(b));
  gap.gap = shift.found ? -shift.depth : -std::numeric_limits<double>::infinity();
  if (shift.found) gap.open_W = shift.direction_W;
  return gap;
}

std::vector<PairGap> FreeSpace::gapsAt(const EntityConfiguration& at, double limit) {
  place(at);
  std::vector<collision::PairDistance> found;
  scene_.pairsWithin(limit, found);
  std::vector<PairGap> gaps;
  for (const collision::PairDistance& one : found) gaps.push_back(gapFrom(one));
  std::stable_sort(gaps.begin(), gaps.end(), [](const PairGap& a, const PairGap& b) { return a.gap < b.gap; });
  return gaps;
}

double FreeSpace::gapOf(std::uint32_t pair, const EntityConfiguration& at) {
  place(at);
  return gapFrom({pair, scene_.distance(pair)}).gap;
}

void FreeSpace::setChecked(const std::vector<PairGap>& pairs, bool checked) {
  for (const PairGap& one : pairs) scene_.setEnabled(one.pair, checked);
}

EntityConfiguration FreeSpace::proposed(const EntityConfiguration& from, const Pose& X_WT) const {
  return plan_->manipulator->propose(from, X_WT, std::numeric_limits<double>::infinity());
}

double FreeSpace::clearanceAt(const EntityConfiguration& at, double limit) {
  const auto nearest = measure(at, limit);
  return nearest ? nearest->result.distance : limit;
}

std::optional<Blocker> FreeSpace::nearestAt(const EntityConfiguration& at, double limit) {
  const auto nearest = measure(at, limit);
  return nearest ? std::optional(plan_->pairs[scene_.tag(nearest->pair)].words) : std::nullopt;
}

EntityConfiguration FreeSpace::between(const EntityConfiguration& from, const EntityConfiguration& to, double s) const {
  return plan_->manipulator->between(from, to, s);
}

double FreeSpace::pathBound(const EntityConfiguration& from, const EntityConfiguration& to) const {
  std::vector<double> bounds(plan_->spheres.size());
  plan_->manipulator->pathBounds(from, to, plan_->spheres, bounds);
  return bounds.empty() ? 0.0 : *std::max_element(bounds.begin(), bounds.end());
}

Pose FreeSpace::toolAt(const EntityConfiguration& at) const {
  return hasJoints() ? plan_->manipulator->movedFrame(at) : at.X_WE;
}

const geometry::Bounds& FreeSpace::obstacleBounds() const {
  return plan_->obstacle_bounds;
}

double FreeSpace::radius() const {
  return plan_->radius;
}

const workcell::Entity& FreeSpace::entity() const {
  return plan_->model.form();
}

const EntityConfiguration& FreeSpace::present() const {
  return plan_->present;
}

const Text& FreeSpace::note() const {
  return plan_->note;
}

}  // namespace hapticell::planning
