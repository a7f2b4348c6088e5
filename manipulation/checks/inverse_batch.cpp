// SPDX-License-Identifier: Apache-2.0
#include "manipulation/checks/inverse_batch.h"

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <ctime>

#include "kinematics/closed_form/inverse_factory.h"

namespace hapticell::manipulation {

namespace {

/// Poses that a thread answers one after another. Half: more to share out; twice: fewer blocks for many cores.
constexpr std::size_t kInverseBlock = 64;

/// Lowers `least` to `value`.
void lowerTo(std::atomic<std::size_t>& least, std::size_t value) {
  for (std::size_t known = least; value < known && !least.compare_exchange_weak(known, value);) {
  }
}

}  // namespace

Expected<std::unique_ptr<kinematics::InverseModel>> inverseToTool(const workcell::Entity& robot) {
  if (!robot.robot())
    return makeError(
        {.place = Text("entity '%1'", robot.name), .found = "it has no joints", .expected = "a robot or a mechanism"});
  const int tip = robot.jointed().tip_link.empty() ? robot.robot()->defaultTip() : robot.robot()->findLink(robot.jointed().tip_link);
  if (tip < 0)
    return makeError({.place = Text("entity '%1'", robot.name),
                      .found = Text("no link is named '%1'", robot.jointed().tip_link),
                      .expected = "a link of the robot that carries the tool"});
  return kinematics::createInverse(*robot.robot(), tip, robot.jointed().X_LT);
}

FreeAnswer freeSolutions(const kinematics::InverseModel& inverse, JointCheck& check, const Pose& X_BT,
                         const std::vector<double>& q_start, double clearance) {
  FreeAnswer answer;
  bool held = false;
  for (kinematics::AlternativeSolution& one : inverse.solveAll(X_BT, q_start)) {
    held = held || !one.within_limits;
    if (!one.within_limits) continue;
    ++answer.checked;
    if (check.isFree(one.q, clearance)) answer.free.push_back({std::move(one.q), std::move(one.configuration)});
  }
  answer.status = kinematics::statusOf(answer.checked > 0, held);
  return answer;
}

Expected<InverseBatch> freeInverse(std::shared_ptr<const PreparedScene> scene, workcell::EntityId robot,
                                   std::span<const Pose> poses, const InverseBatchOptions& options,
                                   const config::Configuration& configuration) {
  const auto check = JointCheck::create(std::move(scene), robot, configuration, options.at_rest);
  HAPTICELL_TRY(check);
  const workcell::Entity& entity = check->entity();
  const auto inverse = inverseToTool(entity);
  HAPTICELL_TRY(inverse);
  const std::vector<double>& start = options.start.empty() ? entity.joints() : options.start;
  if (start.size() != entity.robot()->dof())
    return makeError({.place = Text("entity '%1'", entity.name),
                      .found = Text("%1 joint positions", start.size()),
                      .expected = Text("%1 joint positions", entity.robot()->dof())});
  InverseBatch batch;
  batch.inverse_model = (*inverse)->name();
  batch.note = check->note();
  batch.base_contact = check->baseContact();
  batch.answers.resize(poses.size());
  std::atomic<std::size_t> first_missing{poses.size()};
  tbb::enumerable_thread_specific<JointCheck> checks([&] { return check->fresh(); });
  const auto solve = [&](std::size_t block) {
    JointCheck& own = checks.local();
    const std::size_t end = std::min(poses.size(), (block + 1) * kInverseBlock);
    for (std::size_t i = block * kInverseBlock; i < end; ++i) {
      if (options.until_missing && i > first_missing) return;
      if (options.stop != nullptr && *options.stop) return;
      batch.answers[i] = freeSolutions(**inverse, own, poses[i], start, options.clearance);
      if (!batch.answers[i].isFree()) lowerTo(first_missing, i);
    }
  };
  const auto begin = std::chrono::steady_clock::now();
  const std::clock_t cpu_begin = std::clock();
  const std::size_t blocks = (poses.size() + kInverseBlock - 1) / kInverseBlock;
  tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
  batch.threads = arena.max_concurrency();
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, blocks, solve); });
  batch.cpu_seconds = static_cast<double>(std::clock() - cpu_begin) / CLOCKS_PER_SEC;
  batch.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (options.until_missing && first_missing < poses.size()) batch.answers.resize(first_missing + 1);
  for (const FreeAnswer& answer : batch.answers) {
    batch.checked += answer.checked;
    batch.free += answer.free.size();
  }
  return batch;
}

}  // namespace hapticell::manipulation
