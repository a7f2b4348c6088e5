// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/motions/trace_curves.h"

#include <algorithm>

#include "app/trajectory/motions/track_rows.h"

namespace hapticell::app {
namespace {

using Role = SceneCurve::Role;

// Dots of frames on a trace: more run together. Half, twice: fewer or more to pick.
constexpr std::size_t kMostDots = 60;

Role roleOf(CheckMark mark) {
  switch (mark) {
    case CheckMark::kCollision:
      return Role::kContact;
    case CheckMark::kLimit:
      return Role::kLimit;
    case CheckMark::kCareful:
      return Role::kNearMiss;
    case CheckMark::kFree:
    case CheckMark::kNone:
      break;
  }
  return Role::kSelection;
}

void addAxes(const Pose& X_WT, double length, std::vector<SceneCurve>& curves) {
  const Role roles[3] = {Role::kAxisX, Role::kAxisY, Role::kAxisZ};
  for (int i = 0; i < 3; ++i) {
    SceneCurve axis;
    axis.points_W = {X_WT.p, X_WT.p + X_WT.rotate(length * dvec3(i == 0, i == 1, i == 2))};
    axis.role = roles[i];
    axis.style = SceneCurve::Style::kSolid;
    axis.width = 3.0;
    curves.push_back(std::move(axis));
  }
}

/// Frames about as far from each other along the way, kMostDots of them: where it stood still there is one.
void addEvenFrames(const trajectory::Trajectory& trajectory, std::size_t stride, std::vector<std::size_t>& dots) {
  std::vector<std::pair<std::size_t, double>> places;  // Frame and way to it.
  double way = 0.0;
  for (std::size_t i = 0; i < trajectory.size(); i += stride) {
    if (!places.empty()) way += glm::distance(trajectory[i].X_WT.p, trajectory[places.back().first].X_WT.p);
    places.emplace_back(i, way);
  }
  double next = 0.0;
  for (const auto& [frame, at] : places) {
    if (at < next) continue;
    dots.push_back(frame);
    next = at + way / static_cast<double>(kMostDots);
  }
}

}  // namespace

std::vector<SceneCurve> traceCurves(const Motion& motion, std::size_t most, std::optional<std::size_t> frame,
                                    double axis_length) {
  std::vector<SceneCurve> curves;
  if (!motion.trajectory || motion.trajectory->empty()) return curves;
  const auto& trajectory = *motion.trajectory;
  const std::size_t stride = 1 + trajectory.size() / std::max<std::size_t>(1, most);
  SceneCurve line;
  line.style = SceneCurve::Style::kSolid;
  line.role = Role::kSelection;
  line.width = 1.8;
  CheckMark before = markAt(motion, trajectory[0].t);
  line.role = roleOf(before);
  for (std::size_t i = 0; i < trajectory.size();
       i = i + 1 == trajectory.size() ? i + 1 : std::min(i + stride, trajectory.size() - 1)) {
    const CheckMark mark = markAt(motion, trajectory[i].t);
    line.points_W.push_back(trajectory[i].X_WT.p);
    if (roleOf(mark) == roleOf(before)) continue;
    // A new colour begins where the old one ends.
    curves.push_back(line);
    line.points_W = {trajectory[i].X_WT.p};
    line.role = roleOf(mark);
    line.width = mark == CheckMark::kCollision || mark == CheckMark::kLimit ? 3.0 : 1.8;
    before = mark;
  }
  if (line.points_W.size() > 1) curves.push_back(line);
  std::vector<std::size_t> dots{0, trajectory.size() - 1};
  for (std::size_t i = 0; i < trajectory.size() && dots.size() < kMostDots; ++i)
    if (trajectory[i].by_hand || trajectory[i].dwell > 0.0) dots.push_back(i);
  if (motion.check) addEvenFrames(trajectory, stride, dots);
  for (const std::size_t i : dots) {
    SceneCurve dot;
    dot.points_W = {trajectory[i].X_WT.p};
    dot.role = roleOf(markAt(motion, trajectory[i].t));
    curves.push_back(std::move(dot));
  }
  if (motion.check)
    for (const auto& finding : motion.check->findings) {
      SceneCurve dot;
      dot.points_W = {trajectory.poseAt(finding.t_in).p};
      dot.role = roleOf(markOf(finding));
      curves.push_back(std::move(dot));
    }
  if (frame && *frame < trajectory.size()) addAxes(trajectory[*frame].X_WT, axis_length, curves);
  return curves;
}

}  // namespace hapticell::app
