// SPDX-License-Identifier: Apache-2.0
#include "planning/live/live_planner.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include "geometry/system/overloaded.h"
#include "planning/live/way_search.h"
#include "trajectory/motion/trajectory.h"
#include "workcell/import/background_thread.h"

namespace hapticell::planning {

namespace {

/// s of one check in virtual time, about the mean of the cells of docs/dev/performance.md. Half and twice: half and
/// twice the delay of a plan, in virtual time only.
constexpr double kCheckTime = 20e-6;
/// Of what is left of the way in use, a new way must be shorter than this to replace it. Half: bad ways stay; twice
/// (more than all): each new way replaces the last one.
constexpr double kWorthChange = 0.8;
/// s without progress on a way (of 2 mm) until any new one replaces it. Half: slow hands are sent about; twice: stuck
/// for 3 s.
constexpr double kStuck = 1.5;
constexpr double kProgress = 0.002;
/// m, rad: at the goal. Half: a hand that trembles has to aim; twice: visibly beside it.
constexpr double kAtGoal = 0.002, kAtGoalTurn = 0.035, kAtGoalJoint = 0.02;

double costOf(const PlanResult& result) {
  return kCheckTime * static_cast<double>(result.checks);
}

}  // namespace

bool isAtGoal(const Goal& goal, const Pose& X_WT, const std::vector<double>& joints, const geometry::Bounds& obstacles,
              double radius) {
  return std::visit(
      Overloaded{[&](const goal::ToPose& to) {
                   const trajectory::PoseDistance off = trajectory::distanceBetween(to.X_WT, X_WT);
                   return off.position <= kAtGoal && off.angle <= kAtGoalTurn;
                 },
                 [&](const goal::ToJoints& to) {
                   if (to.joints.size() != joints.size()) return false;
                   for (std::size_t i = 0; i < joints.size(); ++i)
                     if (std::abs(to.joints[i] - joints[i]) > kAtGoalJoint) return false;
                   return true;
                 },
                 [&](const goal::ToRegion& to) {
                   const Pose X_GT = to.X_WT.inverse() * X_WT;
                   const dvec3 over = glm::abs(X_GT.p) - to.half;
                   return std::max({over.x, over.y, over.z}) <= kAtGoal &&
                          glm::length(rotationVector(X_GT.q)) <= to.turn + kAtGoalTurn;
                 },
                 [&](const goal::OutOfCell& out) {
                   if (obstacles.isEmpty()) return true;
                   const dvec3 away = glm::max(obstacles.min - X_WT.p, X_WT.p - obstacles.max);
                   return std::max({away.x, away.y, away.z}) >= radius + out.margin;
                 }},
      goal);
}

struct LivePlanner::Worker {
  Worker(LiveOptions wanted, const config::Configuration& configuration)
      : options(std::move(wanted)), search(options, configuration) {
    if (options.in_virtual_time) return;
    thread = std::thread([this] {
      workcell::lowerThreadPriority();
      run();
    });
  }
  ~Worker() {
    {
      const std::lock_guard lock(mutex);
      stopping = true;
      stop = true;
    }
    wait.notify_all();
    if (thread.joinable()) thread.join();
  }

  /// The planning thread: the newest view, then a pause.
  void run() {
    const auto period = std::chrono::duration<double>(options.period_s);
    for (;;) {
      manipulation::PlanView view;
      {
        std::unique_lock lock(mutex);
        wait.wait(lock, [this] { return stopping || has_view; });
        if (stopping) return;
        view = newest_view;
        has_view = false;
        stop = false;
      }
      WaySearch::Found found = search.find(view, &stop);
      if (const manipulation::PlanView now = present(); now.hold == found.hold) search.join(found, now);
      std::unique_lock lock(mutex);
      book(found);
      noteSpace();
      finish(std::move(found), newest_view);
      wait.wait_for(lock, period, [this] { return stopping; });
      if (stopping) return;
    }
  }

  /// Where the entity is by now.
  manipulation::PlanView present() {
    const std::lock_guard lock(mutex);
    return newest_view;
  }

  /// Under the lock, as what follows.
  void book(const WaySearch::Found& found) {
    ++figures.searches;
    figures.seconds += found.result.seconds;
    figures.failure = found.result.failure;
    if (!found.X_WM.empty()) ++figures.found;
  }

  void noteSpace() {
    const FreeSpace* space = search.space();
    if (space == nullptr) return;
    obstacles = space->obstacleBounds();
    radius = space->hasJoints() ? 0.0 : space->radius();
    knows_space = true;
  }

  /// A way that is worth a change becomes the newest.
  void finish(WaySearch::Found found, const manipulation::PlanView& now) {
    if (found.X_WM.empty() || found.hold != now.hold) return;
    if (given && !isWorth(found, now)) return;
    auto way = std::make_shared<manipulation::PlannedWay>();
    way->number = ++figures.given;
    way->answers = found.answers;
    way->hold = found.hold;
    way->X_WM = std::move(found.X_WM);
    way->postures = std::move(found.postures);
    way->clearance = options.clearance;
    given = std::move(way);
    best_left = found.length;
    best_ns = now.time_ns;
  }

  bool isWorth(const WaySearch::Found& found, const manipulation::PlanView& now) const {
    if (found.answers != now.insistences) return false;  // Asked before the hand insisted once more.
    if (found.answers != given->answers) return true;
    if (given->number != now.way_number) return false;  // The last one has not even been felt.
    const bool stuck = 1e-9 * static_cast<double>(now.time_ns - best_ns) > kStuck;
    return stuck || now.strayed || found.length < kWorthChange * now.way_left;
  }

  /// Progress on the way in use.
  void watch(const manipulation::PlanView& view) {
    if (!given || given->number != view.way_number || view.way_left > best_left - kProgress) return;
    best_left = view.way_left;
    best_ns = view.time_ns;
  }

  /// What was worked out for another hold is of no use.
  void watchHold(const manipulation::PlanView& view) {
    if (view.hold == hold) return;
    hold = view.hold;
    stop = true;
    given.reset();
    pending.reset();
  }

  void lookInVirtualTime(const manipulation::PlanView& view) {
    watchHold(view);
    watch(view);
    // As in a thread: what is being searched for the hand as it was before is of no use.
    if (pending && pending->answers != view.insistences) {
      book(*pending);
      pending.reset();
      next_ns = view.time_ns + static_cast<std::int64_t>(1e9 * options.period_s);
    }
    if (pending && view.time_ns >= due_ns) {
      book(*pending);
      search.join(*pending, view);
      finish(std::move(*pending), view);
      pending.reset();
      next_ns = view.time_ns + static_cast<std::int64_t>(1e9 * options.period_s);
    }
    if (pending || view.time_ns < next_ns) return;
    pending = search.find(view, nullptr);
    noteSpace();
    const double cost = options.cost_s ? options.cost_s(pending->result) : costOf(pending->result);
    due_ns = view.time_ns + static_cast<std::int64_t>(1e9 * std::max(0.0, cost));
  }

  const LiveOptions options;
  WaySearch search;  // The planning thread's; in virtual time the caller's.

  mutable std::mutex mutex;  // Guards what follows; held while a view or a way is copied, never during a search.
  std::condition_variable wait;
  manipulation::PlanView newest_view;
  bool has_view = false, stopping = false, knows_space = false;
  std::shared_ptr<const manipulation::PlannedWay> given;
  Figures figures;
  geometry::Bounds obstacles;
  double radius = 0.0;
  double best_left = 0.0;     ///< m of the way in use that were left at the last progress,
  std::int64_t best_ns = 0;   ///< and when that was.
  std::uint64_t hold = 0;     ///< PlanView::hold of `given`.
  std::atomic<bool> stop{false};
  // Virtual time only.
  std::optional<WaySearch::Found> pending;
  std::int64_t due_ns = 0, next_ns = 0;
  std::thread thread;
};

LivePlanner::LivePlanner(LiveOptions options, const config::Configuration& configuration)
    : worker_(std::make_unique<Worker>(std::move(options), configuration)) {}

LivePlanner::~LivePlanner() = default;

void LivePlanner::look(const manipulation::PlanView& view) {
  Worker& worker = *worker_;
  if (worker.options.in_virtual_time) return worker.lookInVirtualTime(view);
  {
    const std::lock_guard lock(worker.mutex);
    // What is being searched for the hand as it was before is of no use.
    if (view.insistences != worker.newest_view.insistences) worker.stop = true;
    worker.newest_view = view;
    worker.has_view = true;
    worker.watchHold(view);
    worker.watch(view);
  }
  worker.wait.notify_one();
}

std::shared_ptr<const manipulation::PlannedWay> LivePlanner::newest() {
  const std::lock_guard lock(worker_->mutex);
  return worker_->given;
}

bool LivePlanner::isReached(const manipulation::PlanView& view) const {
  const std::lock_guard lock(worker_->mutex);
  if (!worker_->knows_space && std::holds_alternative<goal::OutOfCell>(worker_->options.goal)) return false;
  const workcell::Entity* entity = view.scene ? view.scene->find(view.entity) : nullptr;
  if (entity == nullptr) return false;
  const Pose& X_WT = entity->robot() ? view.X_WM : view.standing.X_WE;
  return isAtGoal(worker_->options.goal, X_WT, view.standing.joints, worker_->obstacles, worker_->radius);
}

LivePlanner::Figures LivePlanner::figures() const {
  const std::lock_guard lock(worker_->mutex);
  return worker_->figures;
}

}  // namespace hapticell::planning
