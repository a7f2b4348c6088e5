// SPDX-License-Identifier: Apache-2.0
#include "manipulation/checks/kept_free.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "manipulation/checks/motion_replay.h"
#include "trajectory/checks/motion_measures.h"

namespace hapticell::manipulation {

namespace {

using trajectory::Trajectory;

/// Share of the recorded motion that is taken back near a collision, by round: most keep half of their smoothing. Our
/// choice, as the next two. Fewer rounds: back at the recording sooner; more: each costs a check.
constexpr std::array<double, 5> kShares{0.5, 0.75, 0.9, 1.0, 1.0};
/// s beyond the collision that are drawn fully, by round. Half: more rounds; twice: more of the motion loses its
/// smoothing.
constexpr std::array<double, 5> kReach{0.05, 0.05, 0.1, 0.1, 0.3};
/// s from there to nothing, by a cosine: a change of 1 mm adds 0.12 m/s2 (pi^2 / 2 / 0.2^2). Half: four times; twice: a
/// quarter, over twice the time.
constexpr double kEdge = 0.2;

/// 1 within `reach` of the interval, falling softly to 0 at `kEdge` beyond.
double weight(double t, const PathFinding& finding, double reach) {
  const double away = std::max({finding.t_in - reach - t, t - finding.t_out - reach, 0.0}) / kEdge;
  return away >= 1.0 ? 0.0 : 0.5 + 0.5 * std::cos(away * std::numbers::pi);
}

bool collides(const PathCheckResult& check) {
  return std::any_of(check.findings.begin(), check.findings.end(),
                     [](const auto& finding) { return finding.kind == PathFinding::Kind::kCollision; });
}

bool isNew(const PathFinding& finding, const std::vector<PathFinding>& before) {
  if (finding.kind != PathFinding::Kind::kCollision) return false;
  return std::none_of(before.begin(), before.end(), [&](const PathFinding& other) {
    return other.kind == finding.kind && other.first == finding.first && other.second == finding.second &&
           other.t_in <= finding.t_out && other.t_out >= finding.t_in;
  });
}

Trajectory blended(const Trajectory& recording, const Trajectory& processed, const std::vector<double>& share) {
  Trajectory result = processed.emptyCopy();
  result.reserve(processed.size());
  for (std::size_t i = 0; i < processed.size(); ++i) {
    Trajectory::Frame frame = processed[i];
    frame.X_WT = interpolate(processed[i].X_WT, recording[i].X_WT, share[i]);
    std::vector<double> joints(processed.joints(i).begin(), processed.joints(i).end());
    const auto recorded = recording.joints(i);
    for (std::size_t j = 0; j < std::min(joints.size(), recorded.size()); ++j)
      joints[j] += share[i] * (recorded[j] - joints[j]);
    result.addFrame(frame, joints);
  }
  return result;
}

std::vector<KeptFree::Nearer> intervalsOf(const Trajectory& motion, const std::vector<double>& share) {
  std::vector<KeptFree::Nearer> intervals;
  bool open = false;
  for (std::size_t i = 0; i < share.size(); ++i) {
    if (share[i] <= 0.0) {
      open = false;
      continue;
    }
    if (!open) intervals.push_back({motion[i].t, motion[i].t, 0.0});
    open = true;
    intervals.back().t_out = motion[i].t;
    intervals.back().share = std::max(intervals.back().share, share[i]);
  }
  return intervals;
}

}  // namespace

Expected<KeptFree> keptFree(std::shared_ptr<const PreparedScene> scene, const Trajectory& recording,
                            const Trajectory& processed, const PathCheckOptions& options,
                            const config::Configuration& configuration) {
  if (recording.size() != processed.size()) {
    return makeError({.place = "frames",
                      .found = std::to_string(processed.size()),
                      .expected = "the same number of frames as in the recording"});
  }
  const workcell::Entity* entity = scene->find(recording.entity);
  KeptFree kept;
  kept.trajectory = processed;
  std::vector<double> share(processed.size(), 0.0);
  std::optional<std::vector<PathFinding>> recorded;
  for (std::size_t round = 0;; ++round) {
    auto check = checkPath(scene, recording.entity, kept.trajectory, options, configuration);
    HAPTICELL_TRY(check);
    ++kept.checks;
    kept.check = std::move(*check);
    if (kept.check.cancelled || round == kShares.size()) break;
    if (!collides(kept.check)) break;
    if (!recorded) {
      const auto before = checkPath(scene, recording.entity, recording, options, configuration);
      HAPTICELL_TRY(before);
      ++kept.checks;
      recorded = before->findings;
    }
    bool any = false;
    for (const PathFinding& finding : kept.check.findings) {
      if (!isNew(finding, *recorded)) continue;
      any = true;
      for (std::size_t i = 0; i < share.size(); ++i) {
        share[i] = std::max(share[i], kShares[round] * weight(processed[i].t, finding, kReach[round]));
      }
    }
    if (!any) break;
    kept.trajectory = blended(recording, processed, share);
    if (entity != nullptr) {
      auto consistent = jointsFromPoses(*entity, kept.trajectory);
      HAPTICELL_TRY(consistent);
      kept.trajectory = std::move(*consistent);
    }
  }
  kept.nearer = intervalsOf(processed, share);
  return kept;
}

bool posesFollowJoints(const Trajectory& motion, const trajectory_checks::PosesByJoints& poses_by_joints) {
  if (!motion.has_poses || !motion.hasJoints() || !poses_by_joints) return false;
  const auto placed = poses_by_joints(motion);
  if (!placed) return false;
  /// m, rad: poses that follow from the joints, as kSamePose of motion_replay.cpp. Far below any tolerance, above
  /// rounding; half and twice as well.
  constexpr double kSame = 1e-6;
  for (std::size_t k = 0; k < motion.size(); ++k) {
    const auto off = trajectory::distanceBetween(motion[k].X_WT, (*placed)[k].X_WT);
    if (!motion[k].is_pose_apart && (off.position > kSame || off.angle > kSame)) return false;
  }
  return true;
}

Expected<trajectory::Retimed> retimedByJoints(const Trajectory& given, trajectory::RetimingOptions options,
                                              const trajectory_checks::PosesByJoints& poses_by_joints) {
  // To 1/40 of the tolerance: a tool at the end of 10 m. Half: long tools may miss their tolerance; twice: only tools
  // of over 100 m need it.
  constexpr int kTries = 4;
  const trajectory::PathTolerance asked = options.tolerance;
  const bool follow = posesFollowJoints(given, poses_by_joints);
  for (int round = 0;; ++round, options.tolerance.joint *= 0.4, options.sample_s *= 0.5) {
    auto made = trajectory::retimed(given, options);
    if (!made || !given.hasJoints() || !poses_by_joints) return made;
    auto placed = poses_by_joints(made->trajectory);
    HAPTICELL_TRY(placed);
    made->trajectory = std::move(*placed);
    if (!follow) return made;
    const auto off = trajectory_checks::passing(given, made->trajectory, {asked.position, asked.angle, asked.joint});
    made->report.max_deviation = {off.position, off.angle};
    if (round == kTries || asked.shareOf({off.position, off.angle}) <= 1.0) return made;
  }
}

Expected<RetimedFree> retimedFree(std::shared_ptr<const PreparedScene> scene, const Trajectory& motion,
                                  const trajectory::RetimingOptions& retiming, const PathCheckOptions& options,
                                  const config::Configuration& configuration) {
  const workcell::Entity* entity = scene->find(motion.entity);
  if (entity == nullptr)
    return makeError({.place = "entity", .found = "'" + motion.entity + "'", .expected = "an entity of the cell"});
  auto with_poses = motion.has_poses ? Expected<Trajectory>(motion) : posesFromJoints(*entity, motion);
  HAPTICELL_TRY(with_poses);
  const Trajectory given = std::move(*with_poses);
  auto timed =
      retimedByJoints(given, retiming, [entity](const Trajectory& made) { return posesFromJoints(*entity, made); });
  HAPTICELL_TRY(timed);
  auto kept = keptFree(scene, timed->given, timed->trajectory, options, configuration);
  HAPTICELL_TRY(kept);
  return RetimedFree{std::move(*kept), timed->report};
}

}  // namespace hapticell::manipulation
