// SPDX-License-Identifier: Apache-2.0
#include "mannequin/posture/hands_to.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/shapes/bounds.h"

namespace hapticell::mannequin {
namespace {

using Targets = std::array<std::optional<HandTarget>, 2>;

// m; nearer than a picked point is meant. Half: more rounds; twice: hands stop 4 mm off.
constexpr double kThere = 2e-3;
// A wrist that turns on the way moves the grip; each round leaves a tenth of it: 1e-6 after six. Half: 1e-3, still near
// kThere; twice: time only.
constexpr int kWristRounds = 6;
// m below the picked face: the line across meets the sides of a plate. Half: rounded edges are missed less, thin plates
// too; twice: plates under 20 mm are missed.
constexpr double kUnder = 0.01;
// m between two sides: thinner is one sheet, nothing to hold between hands. Half, twice: thinner or thicker ones are
// refused.
constexpr double kThinnest = 2e-3;

/// The hand's turn with its palm along `into` and its fingers as near as can be to where the arm points.
dquat palmTurn(Side side, const dvec3& into, const dvec3& along) {
  dvec3 fingers = along - glm::dot(along, into) * into;
  if (glm::length(fingers) < 0.2 * glm::length(along)) {  // Pushed flat against a wall: fingers up.
    const dvec3 up = std::abs(into.z) < 0.9 ? dvec3(0.0, 0.0, 1.0) : dvec3(1.0, 0.0, 0.0);
    fingers = up - glm::dot(up, into) * into;
  }
  const dvec3 z = -glm::normalize(fingers);
  const dvec3 y = side == Side::kLeft ? -into : into;
  return glm::normalize(glm::quat_cast(glm::dmat3(glm::cross(y, z), y, z)));
}

HandsReach reachOf(const Figure& figure, const Posture& posture, const Targets& targets) {
  HandsReach reach{posture, {}};
  const FigurePose pose = forwardKinematics(figure, posture);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const auto i = static_cast<std::size_t>(side);
    if (targets[i]) reach.short_m[i] = glm::length(handPose(pose, side) * figure.p_HandGrip[i] - targets[i]->p_W);
  }
  return reach;
}

double worstOf(const HandsReach& reach) {
  return std::max(reach.short_m[0], reach.short_m[1]);
}

HandsReach withPalms(const Figure& figure, const Posture& start, PostureTask task, const Targets& targets) {
  const FigurePose pose = forwardKinematics(figure, start);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const auto i = static_cast<std::size_t>(side);
    task.hands[i].reset();
    if (!targets[i]) continue;
    const dvec3 shoulder = pose[armSegment(side, Segment::kLeftUpperArm)].p_WS;
    Pose hand{dvec3(0.0), palmTurn(side, targets[i]->into_W, targets[i]->p_W - shoulder)};
    hand.p = targets[i]->p_W - hand.rotate(figure.p_HandGrip[i]);
    task.hands[i] = hand;
    task.orientation[i] = true;
  }
  return reachOf(figure, PostureSolver(figure).solve(task, start).posture, targets);
}

/// Wrists as the arms bring them; since the grip turns with them the wrist's place is found in rounds.
HandsReach withFreeWrists(const Figure& figure, const Posture& start, PostureTask task, const Targets& targets) {
  HandsReach best = reachOf(figure, start, targets);
  Posture posture = start;
  for (int round = 0; round < kWristRounds && worstOf(best) > kThere; ++round) {
    const FigurePose pose = forwardKinematics(figure, posture);
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const auto i = static_cast<std::size_t>(side);
      task.hands[i].reset();
      if (!targets[i]) continue;
      const Pose hand = handPose(pose, side);
      task.hands[i] = Pose{targets[i]->p_W - hand.rotate(figure.p_HandGrip[i]), hand.q};
      task.orientation[i] = false;
    }
    posture = PostureSolver(figure).solve(task, posture).posture;
    const HandsReach reach = reachOf(figure, posture, targets);
    if (round == 0 || worstOf(reach) < worstOf(best)) best = reach;
  }
  return best;
}

/// Where a line leaves the mesh at both ends, as parameters along it; empty: it meets nothing.
std::optional<std::array<double, 2>> crossings(const geometry::TriangleMesh& mesh, const dvec3& p_M,
                                               const dvec3& direction_M) {
  double least = std::numeric_limits<double>::max(), most = std::numeric_limits<double>::lowest();
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = mesh.corners(i);
    const dvec3 ab = b - a, ac = c - a, h = glm::cross(direction_M, ac);
    const double det = glm::dot(ab, h);
    if (det == 0.0) continue;
    const dvec3 s = p_M - a, q = glm::cross(s, ab);
    const double u = glm::dot(s, h) / det, v = glm::dot(direction_M, q) / det;
    if (u < 0.0 || v < 0.0 || u + v > 1.0) continue;
    const double t = glm::dot(ac, q) / det;
    least = std::min(least, t);
    most = std::max(most, t);
  }
  if (most - least < kThinnest) return std::nullopt;
  return std::array{least, most};
}

}  // namespace

HandsReach handsTo(const Figure& figure, const Posture& start, const PostureTask& task, const Targets& targets) {
  const HandsReach turned = withPalms(figure, start, task, targets);
  if (worstOf(turned) <= kThere) return turned;
  const HandsReach free = withFreeWrists(figure, start, task, targets);
  return worstOf(free) < worstOf(turned) ? free : turned;
}

std::optional<std::array<HandTarget, 2>> oppositeSides(const geometry::TriangleMesh& mesh, const Pose& X_WM,
                                                       const dvec3& p_W, const dvec3& nhat_W, const dvec3& across_W) {
  if (mesh.triangles.empty()) return std::nullopt;
  const Pose X_MW = X_WM.inverse();
  const dvec3 across = X_MW.rotate(across_W);
  dvec3 axis(0.0);
  int nearest = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(across[i]) > std::abs(across[nearest])) nearest = i;
  axis[nearest] = across[nearest] < 0.0 ? -1.0 : 1.0;
  const geometry::Bounds bounds = mesh.bounds();
  const dvec3 middle = 0.5 * (bounds.min + bounds.max);
  const dvec3 under = X_MW * (p_W - kUnder * nhat_W);
  dvec3 at_height = middle;  // Of the picked point, along W's z.
  at_height += X_MW.rotate({0.0, 0.0, (X_WM * under).z - (X_WM * middle).z});
  dvec3 from = middle;
  std::optional<std::array<double, 2>> ends;
  for (const dvec3& through : {under, at_height, middle}) {
    from = through;
    if ((ends = crossings(mesh, from, axis))) break;
  }
  if (!ends) ends = std::array{glm::dot(axis, bounds.min - from), glm::dot(axis, bounds.max - from)};  // A hollow one.
  const double low = std::min((*ends)[0], (*ends)[1]), high = std::max((*ends)[0], (*ends)[1]);
  const dvec3 axis_W = X_WM.rotate(axis);
  return std::array{HandTarget{X_WM * (from + high * axis), -axis_W}, HandTarget{X_WM * (from + low * axis), axis_W}};
}

}  // namespace hapticell::mannequin
