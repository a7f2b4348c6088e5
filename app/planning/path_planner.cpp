// SPDX-License-Identifier: Apache-2.0
#include "app/planning/path_planner.h"

#include <atomic>
#include <utility>

#include "app/kit/thread_pool_task.h"
#include "geometry/system/atomic_file.h"
#include "geometry/system/scratch_folder.h"
#include "planning/timed_plan.h"
#include "planning/written_plan.h"
#include "trajectory/files/trajectory_io.h"

namespace hapticell::app {

namespace {

/// How much of the slack the corners are rounded off by, one after the other until the written motion keeps the
/// clearance; as `hapticell-cli plan`. The last is exact but rests at corners.
constexpr double kRoundings[] = {1.0, 0.4, 0.1};

Expected<planning::WrittenPlan> measuredAsWritten(const trajectory::Trajectory& motion, const planning::Plan& plan,
                                     const PathRequest& request) {
  const auto folder = ScratchFolder::make();
  HAPTICELL_TRY(folder);
  const std::filesystem::path file = folder->path() / "path.htraj";
  HAPTICELL_TRY(writeFileAtomically(file, toJsonText(motion)));
  return planning::checkWrittenPlan(file, plan, request.problem.clearance, request.problem.scene, request.problem.entity,
                                    request.configuration);
}

Expected<void> addMotion(const planning::FreeSpace& space, const PathRequest& request, PathAnswer& answer) {
  Error missed;
  for (const double rounding : kRoundings) {
    auto motion = planning::timedMotion(*answer.result.plan, space, {.sample_s = 0.01, .rounding = rounding});
    HAPTICELL_TRY(motion);
    const auto check = measuredAsWritten(*motion, *answer.result.plan, request);
    HAPTICELL_TRY(check);
    const Promises& promises = check->promises;
    if (!promises.areKept()) {
      missed = promises.missed("path.htraj");
      continue;
    }
    answer.clearance = promises.list.front().measured;
    answer.clearance_place = promises.list.front().place;
    for (const planning::TightPair& one : check->tight) answer.tight.push_back(one.text());
    answer.motion = std::move(*motion);
    return {};
  }
  return tl::unexpected(std::move(missed));
}

Expected<PathAnswer> planPath(PathRequest& request) {
  request.problem.scene = request.scenes->prepare(std::move(request.source));
  const auto space = planning::FreeSpace::create(request.problem.scene, request.problem.entity, request.configuration,
                                                 request.problem.placements, request.problem.hand);
  HAPTICELL_TRY(space);
  auto result = planning::plan(request.problem, *space);
  HAPTICELL_TRY(result);
  PathAnswer answer{std::move(*result), std::nullopt, 0.0, {}, {}};
  if (answer.result.isSolved()) HAPTICELL_TRY(addMotion(*space, request, answer));
  return answer;
}

}  // namespace

struct PathPlanner::Run {
  PathRequest request;
  std::atomic<bool> stop{false};
  std::atomic<double> progress{0.0};
};

PathPlanner::PathPlanner(QObject* parent) : QObject(parent) {
  poll_.setInterval(100);
  connect(&poll_, &QTimer::timeout, this, &PathPlanner::progressed);
}

PathPlanner::~PathPlanner() {
  cancel();
}

double PathPlanner::progress() const {
  return run_ ? run_->progress.load() : 0.0;
}

void PathPlanner::start(PathRequest request) {
  if (run_) return;
  run_ = std::make_shared<Run>();
  run_->request = std::move(request);
  run_->request.problem.stop = &run_->stop;
  run_->request.problem.progress = [run = run_.get()](double share) { run->progress = share; };
  poll_.start();
  runInThreadPool(
      this, [run = run_] { return planPath(run->request); },
      [this](const Expected<PathAnswer>& answer) {
        run_.reset();
        poll_.stop();
        if (answer) {
          emit ended(*answer);
        } else {
          emit failed(answer.error());
        }
      });
  emit progressed();
}

void PathPlanner::cancel() {
  if (run_) run_->stop = true;
}

}  // namespace hapticell::app
