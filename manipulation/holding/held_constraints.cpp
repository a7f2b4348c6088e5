// SPDX-License-Identifier: Apache-2.0
#include "manipulation/holding/held_constraints.h"

#include <algorithm>

#include "manipulation/holding/contact_search.h"

namespace hapticell::manipulation {

namespace {

/// m of hand that a plain set (one plane a pair) is used for instead: its planes are rough beyond. Half: sets are made
/// more often; twice: walls where the part bends away.
constexpr double kPlainZone = 0.020;
/// m of hand until a complete set is tried again in a crowd. Half: twice the useless searches; twice: plain sets longer
/// than needed.
constexpr double kCrowdedStays = 0.010;
/// Pairs of the entity's own parts that are felt at a time: of 64 entries, with 12 for limits. Half: of a folded robot
/// fewer pairs are felt (the exact check sees all); twice: less room for contacts.
constexpr std::size_t kMostOwn = 8;

bool isNearer(const FreeMotion::PairDistance& a, const FreeMotion::PairDistance& b) {
  return a.result.distance < b.result.distance;
}

}  // namespace

HeldConstraints::HeldConstraints(HeldState& state)
    : state_(state), boundaries_(state), friction_(state.model), finder_(std::make_shared<collision::ContactFinder>()) {
  friction_.update(*state_.manipulator, state_.accepted);
}

HeldConstraints::~HeldConstraints() {
  if (asked_) search_->drop();
}

/// Brings what changes with the place up to date.
void HeldConstraints::refresh() {
  boundaries_.raise();
  friction_.update(*state_.manipulator, state_.accepted);
}

bool HeldConstraints::hasAnswer() const {
  return asked_ && search_->isAnswered();
}

ConstraintDraft HeldConstraints::draft(ConstraintInputs& inputs) {
  inputs.only_complete = true;
  inputs.finder = finder_.get();
  inputs.surfaces = state_.model.surfaces();
  state_.motion.distances(inputs.zone_radius * inputs.mapping.scale(), state_.pairs.firstOwn(), own_);
  std::sort(own_.begin(), own_.end(), isNearer);
  if (own_.size() > kMostOwn) own_.resize(kMostOwn);
  inputs.own = own_;
  inputs.freeing = boundaries_.freeingPlanes();
  ConstraintDraft draft = draftConstraints(inputs);
  draft.options.needed_radius = needed_radius_ * inputs.mapping.scale();
  return draft;
}

/// The answer's set for where the entity is by now; empty while there is no answer.
std::optional<BuiltConstraints> HeldConstraints::takeAnswer(const MotionMapping& mapping, const Pose& X_DProxy) {
  const std::unique_ptr<ContactSearch::Question> answered = search_->take();
  if (!answered) return std::nullopt;
  std::vector<dvec3> gone_W;
  for (std::size_t i = 0; i < state_.pairs.obstacles().size(); ++i) {
    gone_W.push_back(state_.pairs.obstacles()[i].X_W.p - answered->environment[i].X_W.p);
  }
  asked_->draft.moving = std::move(answered->moving);
  BuiltConstraints built = completed(asked_->draft, answered->found, gone_W);
  moveReference(built, mapping.toDevice(asked_->draft.X_WM, X_DProxy), mapping.toDevice(state_.movedFrame(), X_DProxy));
  return built;
}

/// Nothing while another search is under way.
void HeldConstraints::ask(ConstraintInputs& inputs, double least_radius) {
  if (!search_->isFree()) return;
  refresh();
  asked_ = Asked{draft(inputs), least_radius};
  auto question = std::make_unique<ContactSearch::Question>();
  question->finder = finder_;
  question->scene = state_.model.scene();
  question->moving = std::move(asked_->draft.moving);
  question->environment = state_.pairs.obstacles();
  question->mask = asked_->draft.mask;
  question->options = asked_->draft.options;
  search_->ask(std::move(question));
}

/// What the complete set is worth decides whether it or a plain one is told.
BuiltConstraints HeldConstraints::judged(BuiltConstraints built, ConstraintInputs& inputs, double least_radius) {
  crowded_ = built.set.zone_radius < least_radius || !built.complete;
  crowded_radius_ = built.complete ? built.set.zone_radius : 0.0;
  X_DCrowded_ = inputs.mapping.toDevice(state_.movedFrame(), inputs.X_DNear);
  return crowded_ ? plain(inputs) : std::move(built);
}

BuiltConstraints HeldConstraints::waiting(ConstraintInputs& inputs, const Wish& wish) {
  BuiltConstraints built;
  if (!wish.may_wait) built = plain(inputs);
  built.pending = true;
  return built;
}

BuiltConstraints HeldConstraints::make(const MotionMapping& mapping, const Pose& X_DProxy, const Wish& wish) {
  ConstraintInputs inputs{*state_.manipulator,
                          state_.accepted,
                          mapping,
                          X_DProxy,
                          wish.zone_radius,
                          wish.turn_ahead,
                          state_.model.pieces(),
                          state_.pairs.obstacles(),
                          state_.pairs.motionPairs(),
                          state_.pairs.feel()};
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
  const Pose X_DHere = mapping.toDevice(state_.movedFrame(), X_DProxy);
  const bool near = glm::length(X_DHere.p - X_DCrowded_.p) < kCrowdedStays;
  const bool stays_crowded = crowded_ && near && wish.least_radius > 0.7 * crowded_radius_;
  if (search_ != nullptr && !stays_crowded) {
    ask(inputs, wish.least_radius);
    return waiting(inputs, wish);
  }
  refresh();
  if (stays_crowded) return plain(inputs);
  ConstraintDraft asked = draft(inputs);
  asked.options.pair_mask = asked.mask;
  BuiltConstraints built = completed(asked, finder_->find(asked.moving, state_.pairs.obstacles(), asked.options));
  if (built.pending) return waiting(inputs, wish);
  return judged(std::move(built), inputs, wish.least_radius);
}

BuiltConstraints HeldConstraints::plain(ConstraintInputs inputs) {
  inputs.zone_radius = std::max(kPlainZone, needed_radius_);
  state_.motion.distances(2.0 * inputs.zone_radius * inputs.mapping.scale(), near_);
  std::sort(near_.begin(), near_.end(), isNearer);
  own_.clear();
  std::copy_if(near_.begin(), near_.end(), std::back_inserter(own_),
               [&](const auto& n) { return n.pair >= state_.pairs.firstOwn(); });
  inputs.own = own_;
  inputs.freeing = boundaries_.freeingPlanes();
  return buildPlainConstraints(inputs, near_);
}

std::optional<haptic::Constraint> HeldConstraints::surface(workcell::EntityId other, double offset) {
  /// m within which the nearest surface is looked for. Our choice. Half: a far wall is no surface; twice: dearer
  /// queries.
  constexpr double kFarthest = 0.5;
  state_.motion.distances(kFarthest, near_);
  const FreeMotion::PairDistance* nearest = nullptr;
  for (const FreeMotion::PairDistance& near : near_) {
    if (state_.pairs[near.pair].other != other || near.result.colliding) continue;
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
  applyCondition(state_.manipulator->differentiate(state_.accepted)[state_.pairs.motionPairs()[nearest->pair].part],
                 condition, constraint);
  return constraint;
}

}  // namespace hapticell::manipulation
