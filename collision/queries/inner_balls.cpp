// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/inner_balls.h"

#include <algorithm>
#include <memory>
#include <vector>

#include "collision/queries/mesh_search.h"

namespace hapticell::collision {

namespace {

/// Places along each side of the mesh's box that are tried. Half: smaller balls; twice: eight times the searches.
constexpr int kPlacesPerSide = 8;
/// Of the distance to the surface: keeps the balls clear of what a pose's rounding moves (1e-12), and of what counts as
/// touching. Half (0.002): still; twice: as well.
constexpr double kShareOfDistance = 0.999;
/// Of the largest ball: smaller ones seldom meet another. Half or twice: a few balls more or fewer.
constexpr double kLeastShare = 0.2;
/// Of the balls' reach from the origin: ten times the rounding of a place there to float (6e-8), and of the other
/// mesh's, which is as far away at most as both reach. Half: still; twice: balls of thin sheets are lost.
constexpr double kRoundedOfReach = 1e-6;
constexpr float kFarAway = 1e12F;  // m: as far as a pose may be. Half or twice as well.
/// Questions before balls are made: their millisecond is as much as some hundred searches. Half or twice as well.
constexpr int kQuestionsBefore = 200;

}  // namespace

InnerBalls::InnerBalls(const MeshCollider& mesh) {
  if (!mesh.isEmpty() && mesh.shells().anyClosed()) fill(mesh);
  round();
}

void InnerBalls::fill(const MeshCollider& mesh) {
  const geometry::Bounds& box = mesh.shells().closedBounds();
  const dvec3 step = (box.max - box.min) / double{kPlacesPerSide};
  std::vector<Ball> found;
  for (int i = 0; i < kPlacesPerSide; ++i) {
    for (int j = 0; j < kPlacesPerSide; ++j) {
      for (int k = 0; k < kPlacesPerSide; ++k) {
        const dvec3 p = box.min + step * (dvec3(i, j, k) + 0.5);
        if (mesh.contains(p)) found.push_back({p, kShareOfDistance * nearestPoint(mesh, p).distance});
      }
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const Ball& a, const Ball& b) { return a.radius > b.radius; });
  for (const Ball& ball : found) {
    if (count_ == kMost || ball.radius < kLeastShare * found.front().radius) return;
    const auto reachesIn = [&](const Ball& other) { return glm::distance(ball.p, other.p) < other.radius; };
    if (std::any_of(balls_.begin(), balls_.begin() + static_cast<std::ptrdiff_t>(count_), reachesIn)) continue;
    balls_[count_++] = ball;
  }
}

void InnerBalls::round() {
  double reach = 0.0;
  for (const Ball& ball : balls()) reach = std::max(reach, glm::length(ball.p) + ball.radius);
  for (std::size_t i = 0; i < kMost; ++i) {
    const bool is_used = i < count_;
    for (int k = 0; k < 3; ++k) at_[k][i] = is_used ? static_cast<float>(balls_[i].p[k]) : kFarAway;
    radius_[i] = is_used ? static_cast<float>(std::max(0.0, balls_[i].radius - kRoundedOfReach * reach)) : 0.0F;
  }
}

bool InnerBalls::overlap(const Pose& X_WA, const InnerBalls& b, const Pose& X_WB) const {
  const Pose X_AB = X_WA.inverse() * X_WB;
  const dmat3 R = X_AB.R();
  for (std::size_t i = 0; i < b.count_; ++i) {
    const fvec3 p(X_AB.p + R * b.balls_[i].p);
    const float radius = b.radius_[i];
    float most = -1.0F;
    for (std::size_t j = 0; j < kMost; ++j) {  // Without a branch, so that the compiler takes four at a time.
      const float x = at_[0][j] - p.x, y = at_[1][j] - p.y, z = at_[2][j] - p.z, reach = radius_[j] + radius;
      const float depth = reach * reach - (x * x + y * y + z * z);
      most = depth > most ? depth : most;
    }
    if (most > 0.0F) return true;
  }
  return false;
}

const InnerBalls* InnerBallsOnDemand::get(const MeshCollider& mesh) {
  if (const InnerBalls* made = made_.load(std::memory_order_acquire)) return made;
  if (asked_.fetch_add(1, std::memory_order_relaxed) < kQuestionsBefore) return nullptr;
  auto balls = std::make_unique<const InnerBalls>(mesh);
  const InnerBalls* there = nullptr;
  // Another thread may have been faster, with the same balls.
  if (!made_.compare_exchange_strong(there, balls.get(), std::memory_order_acq_rel)) return there;
  return balls.release();
}

}  // namespace hapticell::collision
