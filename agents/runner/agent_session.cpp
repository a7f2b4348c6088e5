// SPDX-License-Identifier: Apache-2.0
#include "agents/runner/agent_session.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

#include "agents/runner/deadlock_watch.h"
#include "agents/runner/planned_way.h"
#include "agents/runner/run_recorder.h"
#include "agents/task/agent_section.h"
#include "agents/wishes/operator_agent.h"
#include "manipulation/checks/mannequin_sight.h"

namespace hapticell::agents {

namespace {

using Clock = std::chrono::steady_clock;

/// s that a person has to begin before the next deadlock counts. Half: asked while reaching for the mouse; twice: waits
/// where nobody leads.
constexpr double kHandTime = 10.0;
/// s in which agents get going along a way before the next deadlock counts.
constexpr double kSessionWayTime = 0.5;

/// The task's agents; the operator waits for a person's hand.
std::vector<WeightedAgent> watchedAgentsOf(const AgentCell& cell, std::uint64_t seed) {
  std::vector<WeightedAgent> agents;
  for (const AgentSection& section : cell.task().agents) {
    auto agent =
        makeAgent({section, cell.task(), cell.start(), cell.lookAt(), cell.clearances().obstacles(), seed});
    if (!agent) continue;  // AgentCell has made each of them once.
    if (agent->name == "operator") agent->agent = std::make_unique<OperatorAgent>();
    agents.push_back(std::move(*agent));
  }
  return agents;
}

}  // namespace

struct AgentSession::Work {
  struct Weighting {
    bool enabled = true;
    double weight = 1.0;
  };

  Work(std::shared_ptr<const AgentCell> of, std::uint64_t seed_of)
      : cell(std::move(of)),
        seed(seed_of),
        recorder(*cell),
        loop(cell->start().placed(cell->start().configuration()), cell->clearances().fresh(), watchedAgentsOf(*cell, seed),
             cell->task().goal, cell->task().clearance, cell->lookAt()) {
    recorder.add(loop);
    show();
  }

  void work();
  void step(std::unique_lock<std::mutex>& lock);
  bool drewBack(std::unique_lock<std::mutex>& lock);
  void plan(std::unique_lock<std::mutex>& lock);
  void show();
  void meetDeadlock();
  bool isSeen() const;
  double remaining() const { return loop.way() != nullptr ? loop.way()->remaining(loop.body()) : loop.remaining(); }

  const std::shared_ptr<const AgentCell> cell;
  const std::uint64_t seed;
  std::atomic<bool> ends{false};
  mutable std::mutex mutex;
  std::condition_variable changed;  ///< What is wanted, or the state.
  // Guarded.
  State state;
  bool one_step = false;
  std::map<std::string, Weighting> weightings;
  std::optional<Twist> hand;
  std::optional<double> wait_for_hand;
  int plans_left = 0;  ///< Deadlocks that go to the planner without a question.
  bool asked = false;  ///< The planner was asked, and has not been reached yet.
  RunRecorder recorder;  ///< Written by the thread of the run alone.
  // Of the thread of the run.
  AgentLoop loop;
  DeadlockWatch watch;
  bool on_way = false;
  std::thread thread;
};

bool AgentSession::Work::isSeen() const {
  const FigureView* figure = loop.body().figure();
  if (figure == nullptr || cell->lookAt() == 0) return true;
  const auto sight = manipulation::sightOfTarget(*cell->scene(), cell->entity(), figure->posture, cell->lookAt());
  return sight.zone != mannequin::VisionZone::kOutside && sight.seen >= loop.goal().seen;
}

/// Under the lock.
void AgentSession::Work::show() {
  state.t = loop.t();
  state.remaining = loop.remaining();
  state.nearest = loop.nearestObstacle();
  state.at = loop.body().configuration();
  state.X_WM = loop.body().handle();
  state.wishes = loop.wishes();
  state.way_W.clear();
  if (loop.way() == nullptr) return;
  for (const FollowedWay::Stop& stop : loop.way()->stops()) state.way_W.push_back(stop.X_WM.p);
}

/// Under the lock.
void AgentSession::Work::meetDeadlock() {
  ++state.deadlocks;
  if (plans_left > 0) {
    state.phase = Phase::kPlanning;
    state.says = {};
    asked = true;
    return;
  }
  Text nearest("nothing is near");
  for (const NearPair& pair : loop.near()) {
    if (pair.other_link >= 0) continue;
    nearest = Text("nearest: %1, %2", loop.clearances().wordsOf(pair), Text::Length{pair.distance});
    break;
  }
  state.phase = Phase::kDeadlocked;
  state.says = Text("No progress, %1 from the goal (%2). Hand it over to the planner, or lead it by hand.",
                    Text::Length{loop.remaining()}, nearest);
}

void AgentSession::Work::step(std::unique_lock<std::mutex>& lock) {
  for (WeightedAgent& agent : loop.agents()) {
    if (const auto given = weightings.find(agent.name); given != weightings.end()) {
      agent.enabled = given->second.enabled;
      agent.weight = given->second.weight;
    }
    if (agent.name == "operator") static_cast<OperatorAgent&>(*agent.agent).setHand(hand);
  }
  const bool by_hand = hand.has_value();
  if (by_hand) plans_left = 0;
  lock.unlock();
  loop.step();
  const bool arrived = loop.hasArrived() && isSeen();
  lock.lock();
  recorder.add(loop);
  recorder.addWishes(loop);
  ++state.steps;
  show();
  if (arrived) {
    state.phase = Phase::kArrived;
    state.says = {};
    return;
  }
  if (wait_for_hand || by_hand || on_way != (loop.way() != nullptr)) {
    on_way = loop.way() != nullptr;
    watch.restart(loop.t(), remaining(), wait_for_hand.value_or(kSessionWayTime));
    wait_for_hand.reset();
  }
  if (watch.update(loop.t(), loop.body().handle().p, remaining()) && state.phase == Phase::kRunning) meetDeadlock();
}

/// One step back before the planner is asked; true once it is where the way is to begin.
bool AgentSession::Work::drewBack(std::unique_lock<std::mutex>& lock) {
  const double back = backBeforePlan(loop.body(), kMostPlans - plans_left);
  if (std::exchange(asked, false) && back > 0.0) loop.drawBack(back);
  if (!loop.isDrawingBack()) return true;
  lock.unlock();
  loop.step();
  lock.lock();
  recorder.add(loop);
  recorder.addWishes(loop);
  ++state.steps;
  show();
  return false;
}

void AgentSession::Work::plan(std::unique_lock<std::mutex>& lock) {
  const std::uint64_t now = seed + static_cast<std::uint64_t>(state.plans++);
  plans_left = std::max(0, plans_left - 1);
  lock.unlock();
  PlannedWay planned = planWay(*cell, loop.body(), loop.goal(), now, &ends);
  lock.lock();
  if (!planned.way) {
    plans_left = 0;
    state.phase = Phase::kDeadlocked;
    state.says = Text("The planner finds no way: %1. Lead it by hand, or change the weights.", planned.why);
    return;
  }
  loop.setWay(std::move(*planned.way));
  on_way = loop.way() != nullptr;
  watch.restart(loop.t(), remaining(), kSessionWayTime);
  show();
  state.says = Text("The agents follow the way that the planner found.");
  state.phase = Phase::kRunning;
}

void AgentSession::Work::work() {
  auto next = Clock::now();
  std::unique_lock lock(mutex);
  while (!ends) {
    if (state.phase == Phase::kPlanning && drewBack(lock)) {
      plan(lock);
      changed.notify_all();
      next = Clock::now();
    } else if (state.phase == Phase::kPlanning || state.phase == Phase::kRunning || one_step) {
      if (state.phase != Phase::kPlanning) {
        one_step = false;
        step(lock);
      }
      changed.notify_all();
      next = std::max(next + std::chrono::duration_cast<Clock::duration>(
                                 std::chrono::duration<double>(AgentLoop::kStep)),
                      Clock::now());
      changed.wait_until(lock, next, [this] { return ends.load(); });
    } else {
      changed.wait(lock, [this] {
        return ends || one_step || state.phase == Phase::kRunning || state.phase == Phase::kPlanning;
      });
      next = Clock::now();
    }
  }
}

AgentSession::AgentSession(std::shared_ptr<const AgentCell> cell, std::uint64_t seed)
    : work_(std::make_unique<Work>(std::move(cell), seed)) {
  work_->thread = std::thread([work = work_.get()] { work->work(); });
}

AgentSession::~AgentSession() {
  {
    const std::lock_guard lock(work_->mutex);
    work_->ends = true;
  }
  work_->changed.notify_all();
  work_->thread.join();
}

void AgentSession::run() {
  const std::lock_guard lock(work_->mutex);
  if (work_->state.phase == Phase::kPlanning || work_->state.phase == Phase::kArrived) return;
  work_->state.phase = Phase::kRunning;
  work_->state.says = {};
  work_->changed.notify_all();
}

void AgentSession::pause() {
  const std::lock_guard lock(work_->mutex);
  work_->plans_left = 0;
  if (work_->state.phase == Phase::kRunning) work_->state.phase = Phase::kPaused;
  work_->changed.notify_all();
}

void AgentSession::stepOnce() {
  const std::lock_guard lock(work_->mutex);
  State& state = work_->state;
  if (state.phase == Phase::kPlanning || state.phase == Phase::kArrived) return;
  state.phase = Phase::kPaused;
  work_->one_step = true;
  work_->changed.notify_all();
}

void AgentSession::setAgent(const std::string& name, bool enabled, double weight) {
  const std::lock_guard lock(work_->mutex);
  work_->weightings[name] = {enabled, weight};
}

void AgentSession::setHand(const std::optional<Twist>& velocity) {
  const std::lock_guard lock(work_->mutex);
  work_->hand = velocity;
}

void AgentSession::askPlanner() {
  const std::lock_guard lock(work_->mutex);
  if (work_->state.phase == Phase::kPlanning || work_->state.phase == Phase::kArrived) return;
  work_->state.phase = Phase::kPlanning;
  work_->state.says = {};
  work_->asked = true;
  work_->plans_left = kMostPlans;
  work_->changed.notify_all();
}

void AgentSession::takeByHand() {
  const std::lock_guard lock(work_->mutex);
  if (work_->state.phase == Phase::kPlanning || work_->state.phase == Phase::kArrived) return;
  work_->state.phase = Phase::kRunning;
  work_->state.says = {};
  work_->wait_for_hand = kHandTime;
  work_->plans_left = 0;
  work_->changed.notify_all();
}

AgentSession::State AgentSession::state() const {
  const std::lock_guard lock(work_->mutex);
  return work_->state;
}

bool AgentSession::waitUntil(const std::function<bool(const State&)>& is_so, double seconds) const {
  std::unique_lock lock(work_->mutex);
  return work_->changed.wait_for(lock, std::chrono::duration<double>(seconds), [&] { return is_so(work_->state); });
}

trajectory::Trajectory AgentSession::motion() const {
  const std::lock_guard lock(work_->mutex);
  return work_->recorder.motion();
}

std::string AgentSession::wishes() const {
  const std::lock_guard lock(work_->mutex);
  return work_->recorder.wishes();
}

const AgentCell& AgentSession::cell() const {
  return *work_->cell;
}

}  // namespace hapticell::agents
