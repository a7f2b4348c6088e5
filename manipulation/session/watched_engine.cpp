// SPDX-License-Identifier: Apache-2.0
#include "manipulation/session/watched_engine.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "geometry/system/listed.h"

namespace hapticell::manipulation {

namespace {

/// s between two measurements: 1 mm of way at 0.1 m/s. Half: sessions take longer; twice: a short penetration may be
/// missed.
constexpr double kLeastPenetrationPeriod = 0.010;
/// s of a session with a StraightHand after it has reached its goal. Half: shorter reports; twice: nothing new.
constexpr double kAfterGoal = 0.5;
/// s between two reported values of the authority: a fall takes 0.25 s. Half: longer reports; twice: falls are missed.
constexpr double kAuthorityPeriod = 0.1;

Expected<workcell::EntityId> findEntity(const SessionOptions& options) {
  for (const workcell::Entity& entity : options.entities)
    if (entity.name == options.entity) return entity.id;
  const std::string names = listed(options.entities, &workcell::Entity::name);
  return makeError({.place = "--entity",
                    .found = Text("no entity is named '%1'", options.entity),
                    .expected = names.empty() ? Text("an entity (the workcell is empty)") : Text("one of %1", names)});
}

}  // namespace

WatchedEngine::WatchedEngine(haptic::HapticLink& link, const SessionOptions& options)
    : options_(options), engine_(link, options.configuration), forces_(options.device.electronics.delay_ticks) {}

Expected<void> WatchedEngine::prepare() {
  const auto entity = findEntity(options_);
  HAPTICELL_TRY(entity);
  entity_ = *entity;
  engine_.apply(command::SetDocument{options_.entities, options_.pairs});
  engine_.apply(command::SetGuides{options_.guides});
  engine_.apply(command::ChooseEntity{entity_});
  engine_.apply(command::SetMovedBy{options_.moved_by});
  engine_.apply(command::SetAxes{options_.axes});
  engine_.apply(command::SetScale{options_.scale});
  if (options_.on_contact) engine_.apply(command::SetOnContact{*options_.on_contact});
  engine_.apply(options_.filter);
  if (options_.assistance) {
    engine_.apply(command::SetPlan{options_.assistance->planner, options_.assistance->authority});
    report_.plan.emplace();
  }
  if (options_.force_class) engine_.apply(command::SetForceClass{*options_.force_class});
  const auto tried = tryHold();
  HAPTICELL_TRY(tried);
  start_ = *tried;
  if (options_.recording) {
    engine_.apply(command::StartRecording{*options_.recording, {}, options_.mark_by_button});
  }
  engine_.apply(command::SetForces{options_.forces});
  return {};
}

void WatchedEngine::step(double t, std::int64_t now_ns) {
  lead();
  const auto begin = std::chrono::steady_clock::now();
  engine_.step(now_ns);
  times_.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
  sent_.resize(engine_.sentSet(), t);
  const double force = engine_.hapticState() ? glm::length(engine_.hapticState()->force_D) : 0.0;
  contacts_.add(t, engine_, force);
  limits_.add(t, engine_);
  joints_.add(t, engine_);
  for (const Result& result : engine_.takeResults()) {
    if (const auto* told = std::get_if<result::Notice>(&result)) report_.notices.push_back(english(told->sentence));
  }
  if (options_.assistance) notePlan(t);
  if (t - measured_ >= kLeastPenetrationPeriod) measurePenetration(t);
}

void WatchedEngine::showPicture(double t) {
  engine_.fillSnapshot(snapshot_);
  if (options_.picture) options_.picture(snapshot_);
  ++pictures_;
  if (t > measured_) measurePenetration(t);
}

double WatchedEngine::sentAt(std::uint64_t sequence) const {
  return sequence == 0 || sequence > sent_.size() ? -1.0 : sent_[sequence - 1];
}

bool WatchedEngine::isSolved(double t) const {
  return report_.plan && report_.plan->solved && t > report_.plan->solved_s + kAfterGoal;
}

SessionReport WatchedEngine::finish(double duration) {
  contacts_.finish(duration);
  report_.duration_s = duration;
  report_.steps = times_.size();
  // The first of each is at time zero: what lies between them counts.
  const auto rate = [&](std::uint64_t count) {
    return duration > 0.0 && count > 0 ? static_cast<double>(count - 1) / duration : 0.0;
  };
  report_.rate_manipulation_hz = rate(times_.size());
  report_.rate_gui_hz = rate(pictures_);
  std::sort(times_.begin(), times_.end());
  if (!times_.empty()) {
    report_.delays.step_median_ms = times_[times_.size() / 2];
    report_.delays.step_p99_ms = times_[times_.size() * 99 / 100];
    report_.delays.step_max_ms = times_.back();
  }
  report_.forces.force_max_n = forces_.maxForce();
  report_.forces.force_max_step_n_per_ms = forces_.maxStep();
  report_.forces.energy_min_j = forces_.leastEnergy();
  report_.forces.penetration_max_m = penetration_.worst();
  report_.forces.penetration_blocked_m = penetration_.worstBlocked();
  if (report_.plan) report_.plan->pull_max_step_n_per_ms = forces_.maxPullStep();
  report_.contacts = contacts_.contacts();
  report_.limits = limits_.limits();
  report_.joints = joints_.joints();
  noteEnd();
  return report_;
}

void WatchedEngine::noteEnd() {
  for (const LimitState& limit : engine_.nearLimits()) {
    if (limit.holds) report_.end.limits.push_back(english(limit.text));
  }
  takeRecordings();
  report_.end.held = engine_.held() != nullptr;
  report_.end.configuration = engine_.placement(entity_);
  report_.end.X_WM = start_->movedFrameWhen([&](workcell::EntityId id) { return engine_.placement(id); });
  for (const auto& [id, at] : start_->axes()) {
    report_.end.axes.push_back({engine_.scene()->find(id)->name, engine_.placement(id)});
  }
  for (const std::size_t i : engine_.contacts()) {
    const std::string& name = engine_.scene()->find(engine_.held()->pairs()[i].other)->name;
    auto& names = report_.end.contacts;
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
}

/// Taking it once beforehand tells what could not be done when the button is pressed.
Expected<std::shared_ptr<HeldEntity>> WatchedEngine::tryHold() {
  const workcell::Entity* entity = engine_.scene()->find(entity_);
  if (options_.axes.mode == AxesMode::kFrame && engine_.scene()->findFrame(options_.axes.frame).entity == nullptr) {
    return makeError({.place = "axes",
                      .found = Text("no frame is named '%1'", options_.axes.frame),
                      .expected = "the name of an entity or of a frame of one"});
  }
  auto taken = HeldEntity::take(engine_.sharedScene(), entity_, {},
                                {options_.moved_by, options_.on_contact.value_or(entity->contact.on_contact),
                                 options_.force_class.value_or(entity->contact.force_class)},
                                options_.configuration);
  HAPTICELL_TRY(taken);
  const by::Tool* tool = toolOf(options_.moved_by);
  if (tool != nullptr && tool->with_axes && (*taken)->axes().empty()) {
    const auto& notes = (*taken)->notes();
    return makeError({.place = Text("entity '%1'", entity->name),
                      .found = notes.empty() ? Text("it is not attached to anything that moves") : notes.front(),
                      .expected = "a robot attached to a moving link of a mechanism or robot that is not locked"});
  }
  return std::shared_ptr<HeldEntity>(std::move(*taken));
}

/// The expert's guide goes with the trainee.
void WatchedEngine::lead() {
  if (!options_.training) return;
  if (!training_) training_.emplace(options_.training->exercise, options_.training->expert, options_.training->help);
  if (engine_.held()) training_->follow(engine_.held()->movedFrame());
  report_.training_share = std::max(report_.training_share, training_->share());
  std::vector<workcell::Guide> guides = options_.guides;
  guides.push_back(training_->guide());
  engine_.apply(command::SetGuides{std::move(guides)});
}

void WatchedEngine::notePlan(double t) {
  SessionPlan& plan = *report_.plan;
  const FeltPlan::State& state = engine_.plan();
  plan.ways = state.ways;
  plan.insistences = state.insistences;
  if (state.reached && !std::exchange(plan.solved, true)) plan.solved_s = t;
  if (t + 1e-9 >= kAuthorityPeriod * static_cast<double>(plan.authority.size())) {
    plan.authority.emplace_back(t, state.authority * state.share);
  }
}

void WatchedEngine::takeRecordings() {
  if (!options_.recording) return;
  engine_.apply(command::StopRecording{});
  for (Result& result : engine_.takeResults()) {
    auto* recorded = std::get_if<result::Recorded>(&result);
    if (!recorded) continue;
    for (trajectory::Trajectory& one : recorded->trajectories) {
      (one.entity == options_.entity ? report_.recording : report_.other_recordings.emplace_back()) = std::move(one);
    }
  }
}

void WatchedEngine::measurePenetration(double t) {
  measured_ = t;
  penetration_.measure(engine_);
}

}  // namespace hapticell::manipulation
