// SPDX-License-Identifier: Apache-2.0
#include "app/planning/path_planner.h"

#include <atomic>
#include <iterator>
#include <string>
#include <utility>

#include "app/kit/thread_pool_task.h"
#include "geometry/system/atomic_file.h"
#include "geometry/system/scratch_folder.h"
#include "planning/axis_motions.h"
#include "planning/timed_plan.h"
#include "planning/written_plan.h"
#include "trajectory/files/trajectory_io.h"

namespace hapticell::app {

namespace {

/// How much of the slack the corners are rounded off by, one after the other until the written motion keeps the
/// clearance; as `hapticell-cli plan`. The last is exact but rests at corners.
constexpr double kRoundings[] = {1.0, 0.4, 0.1};

/// `motions`: of the entity first, then of its axes.
Expected<planning::WrittenPlan> measuredAsWritten(const std::vector<trajectory::Trajectory>& motions,
                                                  const planning::Plan& plan, const PathRequest& request) {
  const auto folder = ScratchFolder::make();
  HAPTICELL_TRY(folder);
  std::vector<std::filesystem::path> files;
  for (const trajectory::Trajectory& motion : motions) {
    files.push_back(folder->path() / ("path" + std::to_string(files.size()) + ".htraj"));
    HAPTICELL_TRY(writeFileAtomically(files.back(), toJsonText(motion)));
  }
  return planning::checkWrittenPlan({files.front(), {files.begin() + 1, files.end()}}, plan, request.problem.clearance,
                                    request.problem.scene, request.problem.entity, request.configuration);
}

Expected<void> addMotion(const planning::FreeSpace& space, const PathRequest& request, PathAnswer& answer) {
  Error missed;
  for (const double rounding : kRoundings) {
    const auto motion = planning::timedMotion(*answer.result.plan, space, {.sample_s = 0.01, .rounding = rounding});
    HAPTICELL_TRY(motion);
    auto motions = planning::motionsOfEntities(*motion, space);
    const auto check = measuredAsWritten(motions, *answer.result.plan, request);
    HAPTICELL_TRY(check);
    const Promises& promises = check->promises;
    if (!promises.areKept()) {
      missed = promises.missed("path.htraj");
      continue;
    }
    answer.clearance = promises.list.front().measured;
    answer.clearance_place = promises.list.front().place;
    for (const planning::TightPair& one : check->tight) answer.tight.push_back(one.text());
    answer.motion = std::move(motions.front());
    answer.axes.assign(std::make_move_iterator(motions.begin() + 1), std::make_move_iterator(motions.end()));
    return {};
  }
  return tl::unexpected(std::move(missed));
}

Expected<PathAnswer> planPath(PathRequest& request) {
  request.problem.scene = request.scenes->prepare(std::move(request.source));
  const auto space = planning::FreeSpace::create(request.problem.scene, request.problem.entity, request.configuration,
                                                 request.problem.placements, request.problem.hand,
                                                 request.problem.with_axes);
  HAPTICELL_TRY(space);
  auto result = planning::plan(request.problem, *space);
  HAPTICELL_TRY(result);
  PathAnswer answer{std::move(*result), std::nullopt, {}, 0.0, {}, {}};
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
