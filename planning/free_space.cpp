// SPDX-License-Identifier: Apache-2.0
#include "planning/free_space.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "collision/queries/freeing_shift.h"
#include "collision/queries/proximity_query.h"
#include "geometry/system/assertion.h"
#include "manipulation/manipulators/posture_finder.h"
#include "planning/own_pair_motion.h"
#include "planning/space_plan.h"

namespace hapticell::planning {

namespace {

using manipulation::Manipulator;
using manipulation::MovedPart;

/// m of path between the places of a motion that are looked at before it is proven, which take a few us each. Half:
/// free motions take longer; twice: more motions that end in something are found by their proof only, which takes ms.
constexpr double kLooksApart = 0.1;
/// Pieces between such places at most; the proof looks at the places between them. By `planning_bench`; half: motions
/// that end in something take longer; twice: free ones do.
constexpr int kMostLooks = 4;

/// Known ends that are kept. Half: long searches ask some again; twice: some MB more.
constexpr std::size_t kMostKnown = 20'000;

/// FNV-1a over the numbers.
std::uint64_t hashOf(const EntityConfiguration& at) {
  std::uint64_t hash = 14695981039346656037ULL;
  const auto add = [&hash](double number) { hash = (hash ^ std::bit_cast<std::uint64_t>(number)) * 1099511628211ULL; };
  for (int i = 0; i < 3; ++i) add(at.X_WE.p[i]);
  for (int i = 0; i < 4; ++i) add(at.X_WE.q[i]);
  for (const double joint : at.joints) add(joint);
  return hash;
}

bool isEqual(const EntityConfiguration& a, const EntityConfiguration& b) {
  return a.joints == b.joints && a.X_WE.p == b.X_WE.p && a.X_WE.q == b.X_WE.q;
}

}  // namespace

Text Blocker::text() const {
  return Text("%1 would touch %2", moved, met);
}

Expected<FreeSpace> FreeSpace::create(std::shared_ptr<const manipulation::PreparedScene> scene, workcell::EntityId id,
                                      const config::Configuration& configuration,
                                      const manipulation::Placements& placements,
                                      const std::optional<mannequin::Side>& hand, bool with_axes) {
  auto plan = SpacePlan::create(std::move(scene), id, configuration, placements, {hand, with_axes});
  HAPTICELL_TRY(plan);
  return FreeSpace(std::move(*plan));
}

FreeSpace::FreeSpace(std::shared_ptr<const SpacePlan> plan) : plan_(std::move(plan)) {
  const std::vector<MovedPart>& moved = plan_->model().parts();
  for (const MovedPart& part : moved) scene_.addPart({part.part->entity, 0}, part.part->mesh.collider);
  for (std::size_t i = 0; i < plan_->obstacles().size(); ++i) {
    scene_.addPart({0, 0}, plan_->obstacles()[i], plan_->obstaclePoses()[i]);
  }
  for (std::size_t i = 0; i < plan_->pairs().size(); ++i) {
    scene_.addPair(plan_->pairs()[i].part, plan_->pairs()[i].other, static_cast<std::uint32_t>(i));
  }
  for (const CheckedPair& pair : plan_->ownPairs()) {
    own_.emplace_back(moved[pair.part].part->mesh.collider, moved[pair.other].part->mesh.collider);
  }
  clearances_.assign(plan_->pairs().size(), 0.0);
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
  known_free_.clear();
  clearances_.assign(clearances_.size(), clearance);
}

/// Of moved_.
bool FreeSpace::meetsNothing(bool moves) {
  const auto found = scene_.findNearer(moved_, clearances_, !moves);
  if (found) blocked_by_ = plan_->pairs()[scene_.tag(*found)].words;
  return !found;
}

bool FreeSpace::standsFree(const EntityConfiguration& at) {
  if (plan_->figure() != nullptr && !plan_->figure()->stands(at)) return false;
  plan_->manipulator().partPoses(at, X_WP_);
  for (std::size_t i = 0; i < moved_.size(); ++i) moved_[i].motion = collision::standingStill(X_WP_[i]);
  return meetsNothing(false) && !ownPartsTouch(at);
}

/// Whether something is in the way at the end, in the middle, at the quarters and so on: of most motions that are not
/// free. Needs bounds_.
bool FreeSpace::isMetOnTheWay(const EntityConfiguration& from, const EntityConfiguration& to) {
  const double way = bounds_.empty() ? 0.0 : *std::max_element(bounds_.begin(), bounds_.end());
  for (int pieces = 1; pieces <= kMostLooks; pieces *= 2) {
    for (int i = 1; i <= pieces; i += 2) {
      if (i == pieces && isKnownFree(to)) continue;
      if (!standsFree(between(from, to, static_cast<double>(i) / pieces))) return true;
    }
    if (way <= kLooksApart * pieces) break;
  }
  return false;
}

bool FreeSpace::isFree(const EntityConfiguration& at) {
  blocked_by_.reset();
  if (stop_ != nullptr && stop_->load(std::memory_order_relaxed)) return false;
  ++checks_;
  if (isKnownFree(at)) return true;
  if (!standsFree(at)) return false;
  setKnownFree(at);
  return true;
}

/// Searches grow from what they reached, and shortcuts end at waypoints: about every second end is known.
bool FreeSpace::isKnownFree(const EntityConfiguration& at) const {
  const auto known = known_free_.find(hashOf(at));
  return known != known_free_.end() && isEqual(known->second, at);
}

void FreeSpace::setKnownFree(const EntityConfiguration& at) {
  if (known_free_.size() >= kMostKnown) known_free_.clear();
  known_free_.insert_or_assign(hashOf(at), at);
}

/// Whether the own pair is proven to be apart there by the one joint between its parts.
bool FreeSpace::keptApart(std::size_t own, const EntityConfiguration& at) const {
  const CheckedPair& pair = plan_->ownPairs()[own];
  return pair.joints.size() == 1 && plan_->freeRanges()[own].holds(at.joints[pair.joints.front()]);
}

/// At X_WP_, the parts' poses at `at`.
bool FreeSpace::ownPartsTouch(const EntityConfiguration& at) {
  for (std::size_t i = 0; i < own_.size(); ++i) {
    const CheckedPair& pair = plan_->ownPairs()[i];
    if (keptApart(i, at)) continue;
    if (!own_[i].within(X_WP_[pair.part], X_WP_[pair.other], collision::kLeastClearance)) continue;
    blocked_by_ = pair.words;
    return true;
  }
  return false;
}

/// What moves both brings them no nearer: only the joints between them count. Needs bounds_.
double FreeSpace::ownWay(const CheckedPair& pair, const EntityConfiguration& from, const EntityConfiguration& to) {
  if (plan_->figure() != nullptr) {
    double way = bounds_[pair.part] + bounds_[pair.other];
    const Manipulator::OwnPair own = pair;
    plan_->manipulator().tightenOwnBounds(from, to, plan_->spheres(), std::span(&own, 1), std::span(&way, 1));
    return way;
  }
  EntityConfiguration apart = from;
  for (const std::size_t joint : pair.joints) apart.joints[joint] = to.joints[joint];
  plan_->manipulator().pathBounds(from, apart, plan_->spheres(), own_bounds_);
  return own_bounds_[pair.part] + own_bounds_[pair.other];
}

bool FreeSpace::ownPartsTouch(const EntityConfiguration& from, const EntityConfiguration& to) {
  const Manipulator& manipulator = plan_->manipulator();
  manipulator.partPoses(manipulator.between(from, to, 0.5), X_WP_);
  own_bounds_.resize(bounds_.size());
  PlannedMotion motion(manipulator, from, to, moved_.size());
  for (std::size_t i = 0; i < own_.size(); ++i) {
    const CheckedPair& pair = plan_->ownPairs()[i];
    if (keptApart(i, from) && keptApart(i, to)) continue;
    const Pose &X_WA = X_WP_[pair.part], &X_WB = X_WP_[pair.other];
    const auto comesNear = [&](double way) {
      return spheresApart(own_[i], X_WA, X_WB) <= collision::kLeastClearance + 0.5 * way + collision::kRounding;
    };
    if (!comesNear(bounds_[pair.part] + bounds_[pair.other])) continue;
    const double way = ownWay(pair, from, to);
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
  ++checks_;
  plan_->manipulator().pathBounds(from, to, plan_->spheres(), bounds_);
  if (isMetOnTheWay(from, to)) return false;
  if (plan_->figure() == nullptr) {
    const bool is_free = isProven(from, to);
    if (is_free) setKnownFree(to);
    return is_free;
  }
  const std::vector<EntityConfiguration> knots = plan_->figure()->knots(from, to);
  for (std::size_t i = 1; i < knots.size(); ++i) {
    plan_->manipulator().pathBounds(knots[i - 1], knots[i], plan_->spheres(), bounds_);
    if (!isProven(knots[i - 1], knots[i])) return false;
  }
  return !knots.empty();
}

/// As the manipulator moves from one to the other. Needs bounds_.
bool FreeSpace::isProven(const EntityConfiguration& from, const EntityConfiguration& to) {
  const Manipulator& manipulator = plan_->manipulator();
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
  plan_->manipulator().partPoses(at, X_WP_);
  for (std::size_t i = 0; i < X_WP_.size(); ++i) scene_.setPose(static_cast<collision::PartIndex>(i), X_WP_[i]);
}

std::optional<collision::PairDistance> FreeSpace::measure(const EntityConfiguration& at, double limit) {
  place(at);
  return scene_.nearest(limit);
}

PairGap FreeSpace::gapFrom(const collision::PairDistance& found) const {
  PairGap gap{found.pair, found.result.distance, found.result.nhat_BA_W, plan_->pairs()[scene_.tag(found.pair)].words};
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
  known_free_.clear();
  for (const PairGap& one : pairs) scene_.setEnabled(one.pair, checked);
}

EntityConfiguration FreeSpace::proposed(const EntityConfiguration& from, const Pose& X_WT) const {
  EntityConfiguration at = plan_->manipulator().propose(from, X_WT, std::numeric_limits<double>::infinity());
  return plan_->figure() == nullptr ? at : plan_->figure()->onItsFeet(at);
}

double FreeSpace::clearanceAt(const EntityConfiguration& at, double limit) {
  const auto nearest = measure(at, limit);
  return nearest ? nearest->result.distance : limit;
}

std::optional<Blocker> FreeSpace::nearestAt(const EntityConfiguration& at, double limit) {
  const auto nearest = measure(at, limit);
  return nearest ? std::optional(plan_->pairs()[scene_.tag(nearest->pair)].words) : std::nullopt;
}

EntityConfiguration FreeSpace::between(const EntityConfiguration& from, const EntityConfiguration& to, double s) const {
  return plan_->figure() == nullptr ? plan_->manipulator().between(from, to, s) : plan_->figure()->between(from, to, s);
}

double FreeSpace::pathBound(const EntityConfiguration& from, const EntityConfiguration& to) const {
  std::vector<double> bounds(plan_->spheres().size());
  plan_->manipulator().pathBounds(from, to, plan_->spheres(), bounds);
  return bounds.empty() ? 0.0 : *std::max_element(bounds.begin(), bounds.end());
}

Pose FreeSpace::toolAt(const EntityConfiguration& at) const {
  return hasJoints() ? plan_->manipulator().movedFrame(at) : at.X_WE;
}

const geometry::Bounds& FreeSpace::obstacleBounds() const {
  return plan_->obstacleBounds();
}

double FreeSpace::radius() const {
  return plan_->radius();
}

const StandingFigure* FreeSpace::figure() const {
  return plan_->figure();
}

std::vector<EntityConfiguration> FreeSpace::posturesAt(const Pose& X_WT, const EntityConfiguration& from,
                                                       Shortfall* shortfall) const {
  HAPTICELL_DEMAND(plan_->figure() != nullptr);
  std::vector<EntityConfiguration> starts{from};
  if (const auto* finder = plan_->manipulator().postureFinder()) {
    for (EntityConfiguration& upright : finder->upright(from)) starts.push_back(std::move(upright));
  }
  return plan_->figure()->posturesAt(X_WT, starts, shortfall);
}

const workcell::Entity& FreeSpace::entity() const {
  return plan_->model().form();
}

const manipulation::PreparedScene& FreeSpace::scene() const {
  return *plan_->model().scene();
}

const workcell::Entity& FreeSpace::ownEntity() const {
  return *plan_->model().members().back();
}

EntityConfiguration FreeSpace::ownAt(const EntityConfiguration& all) const {
  return plan_->model().standing(all);
}

manipulation::HeldModel::Standing FreeSpace::axesAt(const EntityConfiguration& all) const {
  return plan_->model().axes(all);
}

std::size_t FreeSpace::axisVariables() const {
  const auto& own = ownEntity().robot();
  return own ? entity().robot()->dof() - own->dof() : 0;
}

const EntityConfiguration& FreeSpace::present() const {
  return plan_->present();
}

const Text& FreeSpace::note() const {
  return plan_->note();
}

}  // namespace hapticell::planning
