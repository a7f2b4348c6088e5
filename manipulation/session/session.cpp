// SPDX-License-Identifier: Apache-2.0
#include "manipulation/session/session.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <thread>
#include <utility>

#include "geometry/system/listed.h"
#include "geometry/system/percentile.h"
#include "haptic/client/tcp_link.h"
#include "haptic/devices/simulated_device.h"
#include "haptic/server/configured_loop.h"
#include "haptic/server/force_loop.h"
#include "haptic/server/in_memory_link.h"
#include "manipulation/session/force_extremes.h"
#include "manipulation/session/penetration_meter.h"

namespace hapticell::manipulation {

namespace {

using SteadyClock = std::chrono::steady_clock;

/// s between two measurements: 1 mm of way at 0.1 m/s. Half: sessions take longer; twice: a short penetration may be
/// missed.
constexpr double kLeastPenetrationPeriod = 0.010;
/// s for a server to answer: it starts in well under one. Half: a busy machine fails; twice: slower to report that none
/// is there.
constexpr double kPatience = 5.0;
/// s of a live hand: a day. Half: a shift and a half; twice: memory for a trace of nobody's use.
constexpr double kLongestHand = 86400.0;

/// s of a session with a StraightHand after it has reached its goal. Half: shorter reports; twice: nothing new.
constexpr double kAfterGoal = 0.5;
/// s between two reported values of the authority: a fall takes 0.25 s. Half: longer reports; twice: falls are missed.
constexpr double kAuthorityPeriod = 0.1;

double secondsSince(SteadyClock::time_point begin) {
  return std::chrono::duration<double>(SteadyClock::now() - begin).count();
}

Expected<workcell::EntityId> findEntity(const SessionOptions& options) {
  for (const workcell::Entity& entity : options.entities)
    if (entity.name == options.entity) return entity.id;
  const std::string names = listed(options.entities, &workcell::Entity::name);
  return makeError({.place = "--entity",
                    .found = Text("no entity is named '%1'", options.entity),
                    .expected = names.empty() ? Text("an entity (the workcell is empty)") : Text("one of %1", names)});
}

/// The engine with everything that a session watches about it; both kinds of session drive one.
class WatchedEngine {
 public:
  WatchedEngine(haptic::HapticLink& link, const SessionOptions& options)
      : options_(options), engine_(link, options.configuration), forces_(options.device.electronics.delay_ticks) {}

  void searchInThread() { engine_.searchInThread(); }

  /// Sets all choices; errors are told before the session begins.
  Expected<void> prepare() {
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

  void step(double t, std::int64_t now_ns) {
    lead();
    const SteadyClock::time_point begin = SteadyClock::now();
    engine_.step(now_ns);
    times_.push_back(1e3 * secondsSince(begin));
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

  void showPicture(double t) {
    engine_.fillSnapshot(snapshot_);
    if (options_.picture) options_.picture(snapshot_);
    ++pictures_;
    if (t > measured_) measurePenetration(t);
  }

  void count(const MeteredTick& tick) { forces_.add(tick); }
  /// When the set of this number was sent, s; negative for one that was not.
  double sentAt(std::uint64_t sequence) const {
    return sequence == 0 || sequence > sent_.size() ? -1.0 : sent_[sequence - 1];
  }
  const std::optional<haptic::HapticState>& state() const { return engine_.hapticState(); }
  const haptic::ServerStatistics& serverStatistics() const { return engine_.serverStatistics(); }
  /// The goal of the planner beside the hand was reached half a second ago.
  bool isSolved(double t) const { return report_.plan && report_.plan->solved && t > report_.plan->solved_s + kAfterGoal; }
  bool inContact() const { return !engine_.contacts().empty(); }
  Pose movedFrame() const { return engine_.held() ? engine_.held()->movedFrame() : Pose::identity(); }

  SessionReport finish(double duration) {
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
    report_.contacts = contacts_.contacts();
    report_.limits = limits_.limits();
    report_.joints = joints_.joints();
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
    return report_;
  }

  SessionReport& report() { return report_; }

 private:
  /// Taking it once beforehand tells what could not be done when the button is pressed.
  Expected<std::shared_ptr<HeldEntity>> tryHold() {
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
  void lead() {
    if (!options_.training) return;
    if (!training_) training_.emplace(options_.training->exercise, options_.training->expert, options_.training->help);
    if (engine_.held()) training_->follow(engine_.held()->movedFrame());
    report_.training_share = std::max(report_.training_share, training_->share());
    std::vector<workcell::Guide> guides = options_.guides;
    guides.push_back(training_->guide());
    engine_.apply(command::SetGuides{std::move(guides)});
  }

  void notePlan(double t) {
    SessionPlan& plan = *report_.plan;
    const FeltPlan::State& state = engine_.plan();
    plan.ways = state.ways;
    plan.insistences = state.insistences;
    if (state.reached && !std::exchange(plan.solved, true)) plan.solved_s = t;
    if (t + 1e-9 >= kAuthorityPeriod * static_cast<double>(plan.authority.size())) {
      plan.authority.emplace_back(t, state.authority * state.share);
    }
  }

  void takeRecordings() {
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

  void measurePenetration(double t) {
    measured_ = t;
    penetration_.measure(engine_);
  }

  const SessionOptions& options_;
  ManipulationEngine engine_;
  workcell::EntityId entity_ = 0;
  std::shared_ptr<HeldEntity> start_;
  std::optional<TrainingRun> training_;
  SessionReport report_;
  ForceExtremes forces_;
  ContactTracker contacts_;
  LimitTracker limits_;
  JointMeter joints_;
  PenetrationMeter penetration_;
  SceneSnapshot snapshot_;
  std::vector<double> times_;
  std::vector<double> sent_;  ///< By the set's number less one, s.
  std::uint64_t pictures_ = 0;
  double measured_ = -1.0;
};

haptic::HandSample handAt(const SessionOptions& options, double t, const haptic::HapticState& felt) {
  return options.live_hand ? options.live_hand->at(t, felt) : options.hand.at(t);
}

}  // namespace

Expected<SessionReport> runSession(const SessionOptions& options, const TraceSink& trace) {
  if (options.live_hand && !(options.live_hand->duration_s > 0.0 && options.live_hand->duration_s < kLongestHand)) {
    return makeError(
        {.place = "duration", .found = "a duration out of range", .expected = "seconds above 0, 24 h at most"});
  }
  const SteadyClock::time_point begin = SteadyClock::now();
  haptic::VirtualClock clock;
  haptic::SimulatedDevice device(options.device);
  device.hand().setOptions(haptic::configuredHand(options.configuration));
  HAPTICELL_TRY(device.open());
  device.place(handAt(options, 0.0, {}).X_DH);
  haptic::ForceLoop loop(device, clock, haptic::configuredLoop(device, options.configuration));
  haptic::InMemoryLink link(loop, clock, haptic::describe(device), {.latency = options.latency_s});
  WatchedEngine engine(link, options);
  HAPTICELL_TRY(engine.prepare());

  const double period = loop.period();
  const double duration = options.live_hand ? options.live_hand->duration_s : options.hand.duration();
  const double step_period = 1.0 / std::clamp(options.configuration.manipulation.rate_hz, 10.0, 1000.0);
  const double picture_period = 1.0 / std::clamp(options.rate_gui_hz, 1.0, 1000.0);
  const auto ticks = static_cast<std::uint64_t>(std::ceil(duration / period - 1e-9));
  std::uint64_t steps = 0, pictures = 0, adopted = 0;
  std::vector<double> latencies;
  Pose X_DSBefore = device.truePose();
  std::optional<StraightHand> straight;
  if (options.straight_hand) straight.emplace(*options.straight_hand);
  double ended = 0.0;
  for (std::uint64_t tick = 0; tick <= ticks; ++tick) {
    const double t = static_cast<double>(tick) * period;
    if (straight && engine.isSolved(t)) break;
    ended = t;
    const haptic::HandSample sample =
        straight ? straight->next(t, X_DSBefore, engine.movedFrame()) : handAt(options, t, loop.current());
    device.hand().hold(sample.X_DH, sample.buttons);
    link.step();
    const haptic::HapticState& state = loop.current();
    const haptic::MetricVector carried{period * loop.lastRender().v_DO, dvec3(0.0)};
    engine.count({t, state.force_D, loop.renderer().applied(), loop.renderer().way(state.X_DS, X_DSBefore) - carried,
                  loop.lastRender().stiffness});
    X_DSBefore = state.X_DS;
    if (state.adopted_set != adopted) {
      adopted = state.adopted_set;
      if (const double sent = engine.sentAt(adopted); sent >= 0.0) latencies.push_back(1e3 * (t - sent));
    }
    if (t + 1e-9 >= static_cast<double>(steps) * step_period) {
      engine.step(t, clock.now());
      ++steps;
    }
    if (t + 1e-9 >= static_cast<double>(pictures) * picture_period) {
      engine.showPicture(t);
      ++pictures;
    }
    if (trace) {
      trace({t, state.X_DS, state.X_DP, state.force_D, state.torque_D, state.buttons, engine.inContact(),
             engine.movedFrame()});
    }
  }
  SessionReport report = engine.finish(ended);
  report.ticks = static_cast<std::uint64_t>(std::lround(ended / period)) + 1;
  report.rate_haptic_hz = 1.0 / period;
  report.delays.latency_p50_ms = percentile(latencies, 0.5);
  report.delays.latency_p99_ms = percentile(latencies, 0.99);
  report.machine_time_s = secondsSince(begin);
  return report;
}

namespace {

haptic::MetricVector commandOf(const haptic::HapticState& state) {
  return {state.force_D, state.torque_D / haptic::kRotationLever};
}

/// Turning that costs no torque is no work, so that it may be counted where none is driven, too.
haptic::MetricVector wayBetween(const haptic::HapticState& state, const haptic::HapticState& before) {
  return haptic::metricVector(haptic::metricDifference(state.X_DS, before.X_DS));
}

/// Waits until the server has answered and its device can be held.
Expected<haptic::DeviceDescription> awaitServer(haptic::TcpLink& link, const std::string& address) {
  const SteadyClock::time_point begin = SteadyClock::now();
  while (link.linkState() != haptic::LinkState::kConnected || !link.device()) {
    const bool refused = link.linkState() == haptic::LinkState::kRefused;
    if (refused || secondsSince(begin) > kPatience) {
      return makeError({.file = address,
                        .found = link.problem().empty() ? Text("no answer") : wholeText(link.problem()),
                        .expected = "a haptic server",
                        .fix = "Start hapticell-haptic-server."});
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  const haptic::DeviceDescription device = *link.device();
  if (device.simulated) return device;
  return makeError(
      {.file = address, .found = Text("'%1' is real hardware", device.name), .expected = "a simulated device"});
}

/// s for the state that shows that the server lived to the end, over TcpLink's 1 s. Half: as long as that; twice:
/// slower to fail.
constexpr double kLastPatience = 2.0;

/// A session is one connection from its beginning to its end: what a server does that was lost and found again, and who
/// held its stylus meanwhile, is not known.
class WatchedLink {
 public:
  WatchedLink(haptic::TcpLink& link, std::string address)
      : link_(link), address_(std::move(address)), connection_(link.connections()) {}

  Expected<void> check(double t) const {
    if (link_.linkState() != haptic::LinkState::kConnected) return lost(t, wholeText(link_.problem()));
    if (link_.connections() != connection_) return lost(t, Text("the connection was interrupted"));
    return {};
  }

  /// After the hand path: that the server is still there. A server that hangs is silent at first.
  Expected<void> checkEnd(double t) {
    static_cast<void>(link_.latestState());  // May have been waiting.
    const SteadyClock::time_point begin = SteadyClock::now();
    while (!link_.latestState()) {
      if (auto there = check(t); !there) return there;
      if (secondsSince(begin) > kLastPatience)
        return lost(t, Text("the server stopped sending the state of the stylus"));
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return check(t);
  }

 private:
  Expected<void> lost(double t, const Text& why) const {
    char when[32];
    std::snprintf(when, sizeof when, "%.2f", t);
    const std::string seconds = when;
    return makeError({.file = address_,
                      .found = why.empty() ? Text("the haptic server was lost after %1 s", seconds)
                                           : Text("the haptic server was lost after %1 s: %2", seconds, why),
                      .expected = "a server that answers until the hand path ends",
                      .fix = "Nothing was written. Check the messages of the server, then run the session again."});
  }

  haptic::TcpLink& link_;
  std::string address_;
  std::uint64_t connection_;
};

}  // namespace

Expected<SessionReport> runSessionOnServer(const SessionOptions& options, const std::string& host, int port,
                                           const TraceSink& trace) {
  auto link_options = haptic::linkOptionsFor(host, static_cast<std::uint16_t>(port));
  HAPTICELL_TRY(link_options);
  link_options->program = "hapticell-cli session";
  haptic::TcpLink link(*link_options);
  const auto device = awaitServer(link, host + ":" + std::to_string(port));
  HAPTICELL_TRY(device);
  WatchedLink watched(link, host + ":" + std::to_string(port));
  WatchedEngine engine(link, options);
  engine.searchInThread();
  HAPTICELL_TRY(engine.prepare());

  const double stiffness = device->stiffness > 0.0 ? device->stiffness : 1000.0;
  const double step_period = 1.0 / std::clamp(options.configuration.manipulation.rate_hz, 10.0, 1000.0);
  const double picture_period = 1.0 / std::clamp(options.rate_gui_hz, 1.0, 1000.0);
  const SteadyClock::time_point begin = SteadyClock::now();
  std::optional<haptic::HapticState> first, last;
  double next_picture = 0.0;
  for (double t = 0.0; t < options.hand.duration(); t = secondsSince(begin)) {
    const haptic::HandSample sample = options.hand.at(t);
    HAPTICELL_TRY(watched.check(t));
    link.sendHandTarget({true, sample.X_DH, sample.buttons});
    const auto now = std::chrono::duration_cast<std::chrono::nanoseconds>(SteadyClock::now().time_since_epoch());
    engine.step(t, now.count());
    if (const auto& state = engine.state(); state && (!last || state->tick != last->tick)) {
      if (!first) first = state;
      engine.count({1e-9 * static_cast<double>(state->server_stamp_ns), state->force_D, commandOf(*state),
                    wayBetween(*state, last.value_or(*state)), stiffness});
      last = state;
      if (trace) {
        trace({t, state->X_DS, state->X_DP, state->force_D, state->torque_D, state->buttons, engine.inContact(),
               engine.movedFrame()});
      }
    }
    if (t >= next_picture) {
      engine.showPicture(t);
      next_picture = t + picture_period;
    }
    std::this_thread::sleep_until(
        begin + std::chrono::duration_cast<SteadyClock::duration>(std::chrono::duration<double>(t + step_period)));
  }
  HAPTICELL_TRY(watched.checkEnd(options.hand.duration()));
  SessionReport report = engine.finish(options.hand.duration());
  const haptic::ServerStatistics& server = engine.serverStatistics();
  report.ticks = first && last ? last->tick - first->tick + 1 : 0;
  report.ticks_missed = server.missed_ticks;
  report.rate_haptic_hz = server.rate_hz;
  report.delays.latency_p50_ms = server.set_age_p50_ms;
  report.delays.latency_p99_ms = server.set_age_p99_ms;
  report.machine_time_s = secondsSince(begin);
  link.sendHandTarget({false, {}, 0});
  return report;
}

}  // namespace hapticell::manipulation
