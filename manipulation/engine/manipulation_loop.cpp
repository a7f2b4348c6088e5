// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/manipulation_loop.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <new>
#include <thread>

#include "haptic/rendering/triple_buffer.h"
#include "manipulation/engine/manipulation_engine.h"
#include "manipulation/engine/second_stylus.h"
#include "manipulation/scene/scene_service.h"
#include "workcell/import/background_thread.h"

namespace hapticell::manipulation {

namespace {

using Clock = std::chrono::steady_clock;

/// Hz: the slowest and the fastest rate that sets are felt well at (docs/dev/feel.md: 10, 60, 1000). Half of the first:
/// zones must be twice as wide; twice the second: faster than the force loop.
constexpr double kLeastRate = 10.0;
constexpr double kMostRate = 1000.0;
/// Steps that the shown figures are about: half a second at 1000 Hz, with a p99 of five. Half: p99 is nearly the
/// maximum; twice: figures lag.
constexpr std::size_t kTimesKept = 500;
/// Between two states for the window: no display shows more than 125 a second; a new contact at once, but not oftener
/// than each 2 ms; ten at rest. Half: twice the copies; twice: pictures 16 ms late.
constexpr std::chrono::milliseconds kPictureEvery{8}, kContactEvery{2}, kPictureAtRest{100};
/// Until the loop rests with the stylus, and its period then: 25 Hz, what idles at 0.2 % of a core (Performance). Half:
/// rests in short pauses of work; twice: idles later, or answers 80 ms late.
constexpr std::chrono::milliseconds kRestsAfter{500}, kPeriodAtRest{40};
/// m, rad: a stylus that lies still trembles by its encoders' steps (0.02 mm, 0.5 mrad). Half: coarse devices (0.06 mm)
/// never rest; twice: slow motion begins with a step of 0.2 mm.
constexpr double kStill = 1e-4, kStillTurn = 1e-3;

std::int64_t nanoseconds(Clock::time_point t) {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(t.time_since_epoch()).count();
}

/// The rate and the slow steps of the last half thousand.
class StepTimes {
 public:
  void add(Clock::time_point begin, Clock::time_point end) {
    if (last_ != Clock::time_point{}) periods_.push_back(std::chrono::duration<double>(begin - last_).count());
    last_ = begin;
    durations_.push_back(std::chrono::duration<double>(end - begin).count());
    if (periods_.size() > kTimesKept) periods_.pop_front();
    if (durations_.size() > kTimesKept) durations_.pop_front();
  }
  /// The time until the next one is not a period.
  void pause() { last_ = {}; }
  double rate() const {
    double sum = 0.0;
    for (const double period : periods_) sum += period;
    return sum > 0.0 ? static_cast<double>(periods_.size()) / sum : 0.0;
  }
  double p99() const {
    if (durations_.empty()) return 0.0;
    std::vector<double> sorted(durations_.begin(), durations_.end());
    const auto at = static_cast<std::ptrdiff_t>(sorted.size() * 99 / 100);
    std::nth_element(sorted.begin(), sorted.begin() + at, sorted.end());
    return sorted[static_cast<std::size_t>(at)];
  }

 private:
  Clock::time_point last_;
  std::deque<double> periods_, durations_;
};

/// Whether there has been nothing to do for a while but to watch a stylus that lies still.
class StylusRest {
 public:
  void look(const ManipulationEngine& engine, bool busy, Clock::time_point now) {
    const auto& state = engine.hapticState();
    const bool moved = state && (glm::length(state->X_DS.p - X_DStill_.p) > kStill ||
                                 glm::length(rotationVector(glm::conjugate(X_DStill_.q) * state->X_DS.q)) > kStillTurn);
    if (moved) X_DStill_ = state->X_DS;
    if (moved || busy || !engine.isIdle()) busy_ = now;
    rests_ = now - busy_ > kRestsAfter;
  }
  bool rests() const { return rests_; }

 private:
  Pose X_DStill_;
  Clock::time_point busy_{};
  bool rests_ = false;
};

}  // namespace

struct ManipulationLoop::Worker {
  Worker(std::unique_ptr<haptic::HapticLink> the_link, const config::Configuration& the_configuration,
         std::function<void()> told_of_contact, std::shared_ptr<SceneService> the_scenes)
      : link(std::move(the_link)),
        scenes(the_scenes ? std::move(the_scenes) : std::make_shared<SceneService>()),
        configuration(the_configuration),
        on_felt(std::move(told_of_contact)) {
    preparer = std::thread([this] {
      workcell::lowerThreadPriority();
      prepareScenes();
    });
    stepper = std::thread([this] { run(); });
  }
  ~Worker() { stop(); }

  void stop() {
    if (!stepper.joinable()) return;
    {
      const std::lock_guard lock(mutex);
      stopping = true;
      progress.build.cancelled = true;
    }
    documents_wait.notify_all();
    steps_wait.notify_all();
    stepper.join();
    preparer.join();
  }

  /// The preparing thread: meshes of the newest document, older ones that wait are dropped.
  void prepareScenes() {
    const workcell::PairDefaults rule = pairDefaults(configuration);
    for (;;) {
      command::SetDocument document;
      {
        std::unique_lock lock(mutex);
        documents_wait.wait(lock, [this] { return stopping || document_waits; });
        if (stopping) return;
        document = std::move(newest_document);
        document_waits = false;
        progress.steps = progress.done = 0;
        progress.build.cancelled = stopping;
        preparing = true;
      }
      bool had_memory = true;
      std::shared_ptr<const PreparedScene> made;
      try {
        made = scenes->prepare({std::move(document.entities), std::move(document.pairs), rule, document.revision},
                               &progress);
      } catch (const std::bad_alloc&) {
        had_memory = false;
      }
      const std::lock_guard lock(mutex);
      preparing = false;
      if (!had_memory) {
        results.push_back(result::Notice{Text(
            "There was not enough memory to prepare the contacts: what was changed is not felt. Remove large parts")});
        continue;
      }
      if (!made) {
        results.emplace_back(
            result::Notice{Text("Preparing the contacts was given up: what was changed is not felt yet")});
        continue;
      }
      ready_scene = made;
      newest_scene = made;
      steps_wait.notify_one();
    }
  }

  /// True where there were some.
  bool takeCommands(ManipulationEngine& engine) {
    std::vector<Command> taken, for_second;
    std::optional<std::unique_ptr<haptic::HapticLink>> link_of_second;
    std::shared_ptr<const PreparedScene> scene;
    {
      const std::lock_guard lock(mutex);
      taken.swap(commands);
      for_second.swap(second_commands);
      link_of_second.swap(second_link);
      scene.swap(ready_scene);
    }
    const bool any = link_of_second || scene || !taken.empty() || !for_second.empty();
    if (link_of_second) changeSecond(engine, std::move(*link_of_second));
    if (scene) engine.setScene(std::move(scene));
    for (const Command& one : taken) engine.apply(one);
    if (!second) return any;
    for (const Command& one : for_second) second->holder().apply(one);
    return any;
  }

  /// Something that a loop at rest is woken for. Under the lock.
  bool hasOrders() const { return !commands.empty() || !second_commands.empty() || second_link || ready_scene; }

  void changeSecond(ManipulationEngine& engine, std::unique_ptr<haptic::HapticLink> the_link) {
    endSecond();
    if (!the_link) return;
    second = std::make_unique<SecondStylus>(std::move(the_link), engine);
    second->holder().searchInThread();
  }

  /// Lets go of what the second stylus holds, and of the stylus.
  void endSecond() {
    if (!second) return;
    second->holder().apply(command::Release{});
    second->holder().apply(command::SetForces{false});
    second->step(nanoseconds(Clock::now()));
    keepResults(second->holder().takeResults());
    second.reset();
  }

  void showStep(ManipulationEngine& engine, const StepTimes& times, bool idle) {
    SceneSnapshot& snapshot = snapshots.writeSlot();
    engine.fillSnapshot(snapshot);
    if (second) second->addTo(snapshot);
    snapshot.rate_manipulation_hz = times.rate();
    snapshot.step_p99_ms = 1e3 * times.p99();
    snapshot.idle = idle;
    snapshots.publish();
    keepResults(engine.takeResults());
    if (second) keepResults(second->holder().takeResults());
  }

  void keepResults(std::vector<Result> happened) {
    if (happened.empty()) return;
    const std::lock_guard lock(mutex);
    results.insert(results.end(), happened.begin(), happened.end());
  }

  void run() {
    ManipulationEngine engine(*link, configuration);
    engine.searchInThread();
    StepTimes times;
    StylusRest rest;
    const double rate = std::clamp(configuration.manipulation.rate_hz, kLeastRate, kMostRate);
    const auto period = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1.0 / rate));
    Clock::time_point due = Clock::now(), shown{};
    std::int64_t felt = 0;
    for (;;) {
      const Clock::time_point begin = Clock::now();
      const bool commanded = takeCommands(engine);
      engine.step(nanoseconds(begin));
      if (second) second->step(nanoseconds(begin));
      const bool rested = rest.rests();
      rest.look(engine, commanded || second, begin);
      // A new contact is shown at once; one that chatters, no oftener than a display shows pictures.
      const std::int64_t newest = std::max(engine.feltAt(), second ? second->holder().contacts().feltAt() : 0);
      const bool new_contact = newest != felt && begin - shown >= kContactEvery;
      const bool other = new_contact || rested != rest.rests();
      if (other || begin - shown >= (rested ? kPictureAtRest : kPictureEvery)) {
        shown = begin;
        showStep(engine, times, rest.rests());
        if (std::exchange(felt, newest) != newest && on_felt) on_felt();
      }
      const Clock::time_point end = Clock::now();
      if (rest.rests()) {
        times.pause();
        due = end;
      } else {
        times.add(begin, end);
      }
      // A step that took longer than its period shifts the following ones: no burst to catch up.
      due = std::max(due + period, end);
      std::unique_lock lock(mutex);
      if (rest.rests())
        steps_wait.wait_until(lock, end + kPeriodAtRest, [this] { return stopping || hasOrders(); });
      else
        steps_wait.wait_until(lock, due, [this] { return stopping; });
      if (stopping) break;
    }
    takeCommands(engine);
    endSecond();
    engine.apply(command::Release{});
    engine.apply(command::StopRecording{});
    engine.apply(command::SetForces{false});
    engine.step(nanoseconds(Clock::now()));
    keepResults(engine.takeResults());
  }

  std::unique_ptr<haptic::HapticLink> link;
  const std::shared_ptr<SceneService> scenes;
  std::unique_ptr<SecondStylus> second;  // The loop's thread alone.
  const config::Configuration configuration;
  const std::function<void()> on_felt;
  haptic::TripleBuffer<SceneSnapshot> snapshots;

  std::mutex mutex;  // Guards what follows; held only while pointers are moved.
  std::condition_variable documents_wait, steps_wait;
  std::vector<Command> commands, second_commands;
  std::optional<std::unique_ptr<haptic::HapticLink>> second_link;  ///< Until the loop's thread takes it.
  std::vector<Result> results;
  command::SetDocument newest_document;
  bool document_waits = false;
  std::shared_ptr<const PreparedScene> ready_scene;  ///< Until the engine takes it.
  std::shared_ptr<const PreparedScene> newest_scene;
  bool preparing = false;
  bool stopping = false;
  PreparationProgress progress;

  std::thread preparer, stepper;
};

ManipulationLoop::ManipulationLoop(std::unique_ptr<haptic::HapticLink> link, const config::Configuration& configuration,
                                   std::function<void()> on_felt, std::shared_ptr<SceneService> scenes)
    : worker_(std::make_unique<Worker>(std::move(link), configuration, std::move(on_felt), std::move(scenes))) {}

ManipulationLoop::~ManipulationLoop() = default;

void ManipulationLoop::post(Command command) {
  const std::lock_guard lock(worker_->mutex);
  if (auto* document = std::get_if<command::SetDocument>(&command)) {
    worker_->newest_document = std::move(*document);
    worker_->document_waits = true;
    worker_->documents_wait.notify_one();
    return;
  }
  worker_->commands.push_back(std::move(command));
  worker_->steps_wait.notify_one();
}

void ManipulationLoop::setSecondStylus(std::unique_ptr<haptic::HapticLink> link) {
  const std::lock_guard lock(worker_->mutex);
  worker_->second_link = std::move(link);
  worker_->second_commands.clear();
  worker_->steps_wait.notify_one();
}

void ManipulationLoop::postSecond(Command command) {
  const std::lock_guard lock(worker_->mutex);
  worker_->second_commands.push_back(std::move(command));
  worker_->steps_wait.notify_one();
}

bool ManipulationLoop::latest(SceneSnapshot& snapshot) {
  if (!worker_->snapshots.update()) return false;
  snapshot = worker_->snapshots.value();
  return true;
}

std::vector<Result> ManipulationLoop::takeResults() {
  std::vector<Result> taken;
  const std::lock_guard lock(worker_->mutex);
  taken.swap(worker_->results);
  return taken;
}

std::vector<Result> ManipulationLoop::finish() {
  worker_->stop();
  return takeResults();
}

std::optional<double> ManipulationLoop::preparation() const {
  {
    const std::lock_guard lock(worker_->mutex);
    if (!worker_->preparing) return std::nullopt;
  }
  const std::size_t steps = worker_->progress.steps;
  return steps == 0 ? 0.0 : std::min(1.0, static_cast<double>(worker_->progress.done) / static_cast<double>(steps));
}

void ManipulationLoop::cancelPreparation() {
  const std::lock_guard lock(worker_->mutex);
  if (worker_->preparing) worker_->progress.build.cancelled = true;
}

std::shared_ptr<const PreparedScene> ManipulationLoop::scene() const {
  const std::lock_guard lock(worker_->mutex);
  return worker_->newest_scene;
}

}  // namespace hapticell::manipulation
