// SPDX-License-Identifier: Apache-2.0
// The constraint sets of the held entity, made here and now or with the search in another thread.
#include <algorithm>
#include <array>
#include <cstdio>

#include "manipulation/holding/contact_search.h"
#include "manipulation/holding/held_entity.h"

namespace hapticell::manipulation {

namespace {

constexpr double kPlainZone = 0.020;     ///< m of hand: what a plain set is used for instead.
constexpr double kCrowdedStays = 0.010;  ///< m of hand until a complete set is tried again.
constexpr double kHairsBreadth = 1e-4;   ///< m: parts that rest in each other by less are not inside of each other.
constexpr std::size_t kMostWaysOut = 8;
constexpr std::size_t kMostOwn = 8;  ///< Pairs of the entity's own parts that are felt at a time.

}  // namespace

void HeldEntity::startBoundaries() {
  double widest = kSkin;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    feel_[i].boundary = std::max(kSkin, pairs_[i].safety_distance);
    widest = std::max(widest, feel_[i].boundary);
  }
  // Nearer than its boundary already: it must not be thrown out, only get no nearer.
  motion_->distances(widest * (1.0 + 1e-9), near_);
  for (const auto& [pair, found] : near_) {
    feel_[pair].boundary = std::min(feel_[pair].boundary, found.distance);
  }
  if (!motion_->anySoft()) return;
  findWaysOut();
  MotionMapping here;
  here.anchor(movedFrame(), movedFrame());
  const BuiltConstraints built = buildConstraints(
      {*manipulator_, accepted_, here, movedFrame(), 0.01, 0.01, parts_, obstacles_, motion_pairs_, feel_});
  pairGaps(built, built.set.X_DR, gaps_);
  for (std::uint32_t i = 0; i < pairs_.size(); ++i) {
    if (motion_->isSoft(i) && gaps_[i] < 0.0) feel_[i].boundary += gaps_[i];
  }
  for (std::size_t k = 0; k < built.set.count; ++k) {
    const int pair = built.origins[k].pair;
    if (pair < 0 || std::abs(built.set.constraints[k].gap) > FreeMotion::kGuard) continue;
    const haptic::Vector6& a = built.set.constraints[k].gradient;
    motion_->guard(static_cast<std::uint32_t>(pair), glm::normalize(dvec3(a[0], a[1], a[2])));
  }
}

/// What intersects other than by a hair is led out by one plane: facets deep inside say nothing of use.
void HeldEntity::findWaysOut() {
  for (const auto& [pair, found] : near_) {
    const MotionPair& who = motion_pairs_[pair];
    if (ways_out_.size() >= kMostWaysOut || !found.colliding || who.other_part >= 0 || !feel_[pair].felt) continue;
    const auto& part = moved_parts_[who.part].part->mesh.collider;
    const Pose& X_WP = motion_->partPoses()[who.part];
    collision::ProximityQuery query(part, motion_->obstacle(who.obstacle).collider);
    const collision::FreeingShift shift = collision::freeingShift(query, X_WP, motion_->obstacle(who.obstacle).X_WO);
    if (shift.found && shift.depth < kHairsBreadth) continue;
    noteWayOut(pair, shift);
    if (!shift.found) continue;
    WayOut way;
    way.plane.pair = pair;
    way.plane.nhat_W = shift.direction_W;
    way.p_PC = part->center();
    way.reached = glm::dot(shift.direction_W, X_WP * way.p_PC);
    ways_out_.push_back(way);
    feel_[pair].felt = false;
  }
}

void HeldEntity::noteWayOut(std::uint32_t pair, const collision::FreeingShift& shift) {
  const MotionPair& who = motion_pairs_[pair];
  const std::string inside =
      nameOf(*moved_parts_[who.part].part) + " starts inside " + nameOf(*obstacle_parts_[who.obstacle]);
  if (!shift.found) {
    notes_.push_back(inside + " and no straight way out was found; it is not held back by it until they are apart");
    return;
  }
  std::array<char, 96> way{};
  const dvec3& n = shift.direction_W;
  std::snprintf(way.data(), way.size(), ", %.1f mm deep: it comes free along (%.2f, %.2f, %.2f)", 1e3 * shift.depth,
                n.x + 0.0, n.y + 0.0, n.z + 0.0);
  notes_.push_back(inside + way.data() +
                   (shift.by_winding ? " (an open mesh: told by its winding number)" : std::string()));
}

/// Where they have come apart the usual contacts hold.
void HeldEntity::updateWaysOut() {
  freeing_.clear();
  for (std::size_t i = 0; i < ways_out_.size();) {
    WayOut& way = ways_out_[i];
    if (!motion_->isSoft(way.plane.pair)) {
      feel_[way.plane.pair].felt = pairs_[way.plane.pair].feel.felt;
      ways_out_.erase(ways_out_.begin() + static_cast<std::ptrdiff_t>(i));
      continue;
    }
    way.plane.p_W = motion_->partPoses()[motion_pairs_[way.plane.pair].part] * way.p_PC;
    const double at = glm::dot(way.plane.nhat_W, way.plane.p_W);
    way.reached = std::max(way.reached, at);
    way.plane.gap = at - way.reached;
    freeing_.push_back(way.plane);
    ++i;
  }
}

void HeldEntity::raiseBoundaries() {
  bool any = false;
  double widest = 0.0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const double wanted = std::max(kSkin, pairs_[i].safety_distance);
    widest = std::max(widest, wanted);
    any = any || feel_[i].boundary < wanted;
  }
  if (!any) return;
  motion_->distances(widest, near_);
  std::fill(gaps_.begin(), gaps_.end(), widest);
  for (const auto& [pair, found] : near_) gaps_[pair] = found.distance;
  for (std::uint32_t i = 0; i < pairs_.size(); ++i) {
    if (motion_->isSoft(i)) continue;
    const double wanted = std::max(kSkin, pairs_[i].safety_distance);
    feel_[i].boundary = std::min(wanted, std::max(feel_[i].boundary, gaps_[i]));
  }
}

void HeldEntity::searchWith(ContactSearch* search) {
  search_ = search;
}

bool HeldEntity::hasAnswer() const {
  return asked_ && search_->isAnswered();
}

ConstraintDraft HeldEntity::draft(ConstraintInputs& inputs) {
  inputs.only_complete = true;
  inputs.finder = finder_.get();
  inputs.surfaces = surfaces_;
  motion_->distances(inputs.zone_radius * inputs.mapping.scale(), first_own_, own_);
  std::sort(own_.begin(), own_.end(),
            [](const auto& a, const auto& b) { return a.result.distance < b.result.distance; });
  if (own_.size() > kMostOwn) own_.resize(kMostOwn);
  inputs.own = own_;
  updateWaysOut();
  inputs.freeing = freeing_;
  ConstraintDraft draft = draftConstraints(inputs);
  draft.options.needed_radius = needed_radius_ * inputs.mapping.scale();
  return draft;
}

/// The answer's set for where the entity is by now; nothing while there is none.
std::optional<BuiltConstraints> HeldEntity::takeAnswer(const MotionMapping& mapping, const Pose& X_DProxy) {
  const std::unique_ptr<ContactSearch::Question> answered = search_->take();
  if (!answered) return std::nullopt;
  std::vector<dvec3> gone_W;
  for (std::size_t i = 0; i < obstacles_.size(); ++i) {
    gone_W.push_back(obstacles_[i].X_W.p - answered->environment[i].X_W.p);
  }
  asked_->draft.moving = std::move(answered->moving);
  BuiltConstraints built = completed(asked_->draft, answered->found, gone_W);
  moveReference(built, mapping.toDevice(asked_->draft.X_WM, X_DProxy), mapping.toDevice(movedFrame(), X_DProxy));
  return built;
}

/// False while another search is under way.
bool HeldEntity::ask(ConstraintInputs& inputs, double least_radius) {
  if (!search_->isFree()) return false;
  raiseBoundaries();
  updateJointFriction();
  asked_ = Asked{draft(inputs), least_radius};
  auto question = std::make_unique<ContactSearch::Question>();
  question->finder = finder_;
  question->scene = scene_;
  question->moving = std::move(asked_->draft.moving);
  question->environment = obstacles_;
  question->mask = asked_->draft.mask;
  question->options = asked_->draft.options;
  search_->ask(std::move(question));
  return true;
}

/// What the complete set is worth decides whether it or a plain one is told.
BuiltConstraints HeldEntity::judged(BuiltConstraints built, ConstraintInputs& inputs, double least_radius) {
  crowded_ = built.set.zone_radius < least_radius || !built.complete;
  crowded_radius_ = built.complete ? built.set.zone_radius : 0.0;
  X_DCrowded_ = inputs.mapping.toDevice(movedFrame(), inputs.X_DNear);
  return crowded_ ? plainConstraints(inputs) : std::move(built);
}

BuiltConstraints HeldEntity::waiting(ConstraintInputs& inputs, const SetWish& wish) {
  BuiltConstraints built;
  if (!wish.may_wait) built = plainConstraints(inputs);
  built.pending = true;
  return built;
}

BuiltConstraints HeldEntity::constraints(const MotionMapping& mapping, const Pose& X_DProxy, const SetWish& wish) {
  ConstraintInputs inputs{*manipulator_,   accepted_, mapping,    X_DProxy,      wish.zone_radius,
                          wish.turn_ahead, parts_,    obstacles_, motion_pairs_, feel_};
  needed_radius_ = wish.needed_radius;
  if (wish.anew && asked_) {
    search_->drop();
    asked_.reset();
  }
  if (asked_) {
    auto built = takeAnswer(mapping, X_DProxy);
    if (!built) return waiting(inputs, wish);
    const double least_radius = asked_->least_radius;
    asked_.reset();
    return built->pending ? waiting(inputs, wish) : judged(std::move(*built), inputs, least_radius);
  }
  const Pose X_DHere = mapping.toDevice(movedFrame(), X_DProxy);
  const bool near = glm::length(X_DHere.p - X_DCrowded_.p) < kCrowdedStays;
  const bool stays_crowded = crowded_ && near && wish.least_radius > 0.7 * crowded_radius_;
  if (search_ != nullptr && !stays_crowded) {
    ask(inputs, wish.least_radius);
    return waiting(inputs, wish);
  }
  raiseBoundaries();
  updateJointFriction();
  if (stays_crowded) return plainConstraints(inputs);
  ConstraintDraft asked = draft(inputs);
  asked.options.pair_mask = asked.mask;
  BuiltConstraints built = completed(asked, finder_->find(asked.moving, obstacles_, asked.options));
  if (built.pending) return waiting(inputs, wish);
  return judged(std::move(built), inputs, wish.least_radius);
}

BuiltConstraints HeldEntity::plainConstraints(ConstraintInputs inputs) {
  inputs.zone_radius = std::max(kPlainZone, needed_radius_);
  motion_->distances(2.0 * inputs.zone_radius * inputs.mapping.scale(), near_);
  std::sort(near_.begin(), near_.end(),
            [](const auto& a, const auto& b) { return a.result.distance < b.result.distance; });
  own_.clear();
  std::copy_if(near_.begin(), near_.end(), std::back_inserter(own_),
               [&](const auto& n) { return n.pair >= first_own_; });
  inputs.own = own_;
  updateWaysOut();
  inputs.freeing = freeing_;
  return buildPlainConstraints(inputs, near_);
}

std::optional<haptic::Constraint> HeldEntity::surfaceConstraint(workcell::EntityId other, double offset) {
  constexpr double kFarthest = 0.5;
  motion_->distances(kFarthest, near_);
  const FreeMotion::PairDistance* nearest = nullptr;
  for (const FreeMotion::PairDistance& near : near_) {
    if (pairs_[near.pair].other != other || near.result.colliding) continue;
    if (nearest == nullptr || near.result.distance < nearest->result.distance) nearest = &near;
  }
  if (nearest == nullptr) return std::nullopt;
  PointCondition condition;
  condition.p_WQ = nearest->result.p_WA;
  condition.nhat_W = nearest->result.nhat_BA_W;
  condition.gap = nearest->result.distance - offset;
  haptic::Constraint constraint;
  constraint.kind = haptic::ConstraintKind::kEquality;
  constraint.id = (std::uint64_t{1} << 61) + nearest->pair;
  applyCondition(manipulator_->differentiate(accepted_)[motion_pairs_[nearest->pair].part], condition, constraint);
  return constraint;
}

}  // namespace hapticell::manipulation
