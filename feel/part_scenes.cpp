// SPDX-License-Identifier: Apache-2.0
#include "feel/part_scenes.h"

#include <cmath>
#include <functional>
#include <memory>

#include "collision/trees/mesh_collider.h"
#include "collision/queries/proximity_query.h"
#include "geometry/shapes/shapes.h"

namespace hapticell::feel {

namespace {

using collision::MeshCollider;
using geometry::TriangleMesh;

/// m, radius of the ball that measures, a hundredth of the held one, so that its 8 segments are off by under 4 um.
/// Half: two; twice: eight.
constexpr double kProbe = 0.05e-3;
/// m, half of the way over the part: three teeth of the rack, at 0.04 m/s. Half: one and a half; twice: nearly to the
/// rim of the blocks (30 mm).
constexpr double kPartWay = 0.012;
/// m: the lowered ball touches. A twentieth of an encoder step. Half and twice move the scene by a micrometre at most.
constexpr double kNear = 1e-6;
/// Steps of the lowering, each by the gap that is left. Our choice. Half: may end above a steep part; twice: only costs
/// time.
constexpr int kMostSteps = 200;
/// m between two of the balls that tell how deep the drawn one is, a tenth of kDrawn, and how many: 0.4 mm in all. Half
/// of the first: finer; half of the second: what is deeper than 0.2 mm is said by the round ball.
constexpr double kLayer = 1e-5;
constexpr int kLayers = 40;  // and how many there are.

using Query = collision::ProximityQuery;

/// The drawn ball, smaller and smaller: how much smaller it must be to be free is how deep it is.
std::vector<Query> layersAgainst(const std::shared_ptr<const MeshCollider>& part) {
  std::vector<Query> layers;
  for (int k = 0; k < kLayers; ++k) {
    TriangleMesh mesh = heldBall();
    for (dvec3& vertex : mesh.vertices) vertex *= 1.0 - k * kLayer / kBallRadius;
    layers.emplace_back(MeshCollider::build(mesh), part);
  }
  return layers;
}

class PartScene final : public FeelScene {
 public:
  PartScene(std::string name, std::shared_ptr<const MeshCollider> part)
      : name_(std::move(name)),
        query_(MeshCollider::build(geometry::makeSphere(kProbe, 8)), part),
        layers_(layersAgainst(part)) {
    drop(*part);
  }
  std::string name() const override { return name_; }
  const Pose& placement() const { return X_WP_; }
  ConstraintSet setAt(const Pose& X_DP, double) const override { return emptySet(X_DP); }
  /// What is seen: the ball's facets, which lie inside the ball, against those of the part.
  double penetration(const Pose& X_DP, double t) const override {
    const double of_ball = roundPenetration(X_DP, t);
    if (of_ball <= 0.0) return 0.0;
    const auto free =
        std::partition_point(layers_.begin(), layers_.end(), [&](Query& query) { return query.collides(X_DP, X_WP_); });
    return free == layers_.end() ? of_ball : static_cast<double>(free - layers_.begin()) * kLayer;
  }
  double roundPenetration(const Pose& X_DP, double) const override {
    return std::max(0.0, kBallRadius - distanceFrom(X_DP.p, X_WP_));
  }
  dvec3 handAt(double t, double press) const override {
    return {kPartWay * triangleWave(t, 1.667), 0.3 * kPartWay * std::sin(2.0 * t), -press};
  }
  dvec3 start() const override { return {-kPartWay, 0.0, 0.012}; }

 private:
  /// Of a point from the part; 0 inside.
  double distanceFrom(const dvec3& p_WQ, const Pose& X_WP) const {
    const collision::DistanceResult found = query_.distance(Pose::translation(p_WQ), X_WP);
    return found.colliding ? 0.0 : found.distance + kProbe;
  }
  /// Lowers the ball onto the part; the place where it touches becomes the origin.
  void drop(const MeshCollider& part) {
    const geometry::Bounds& bounds = part.bounds();
    const Pose X_PM = Pose::translation({-bounds.center().x, -bounds.center().y, -bounds.max.z});
    dvec3 at(0.0, 0.0, kBallRadius + 1e-3);
    for (int i = 0; i < kMostSteps && at.z > bounds.min.z - bounds.max.z; ++i) {
      const double gap = distanceFrom(at, X_PM) - kBallRadius;
      if (gap < kNear) break;
      at.z -= gap;
    }
    X_WP_ = Pose::translation(X_PM.p - at);
  }

  std::string name_;
  mutable Query query_;  // One session asks, in its own thread.
  mutable std::vector<Query> layers_;
  Pose X_WP_;
};

/// The block under z = height(x, y), 60 mm square.
TriangleMesh block(const std::function<double(double, double)>& height, int cells) {
  // m: a block of 60 mm, twice kPartWay and the ball, 30 mm thick. Half: the way leads over its rim; twice: coarser
  // triangles for the same count.
  constexpr double kHalf = 0.03, kFloor = -0.03;
  TriangleMesh mesh;
  const auto row = static_cast<std::uint32_t>(cells + 1);
  const auto add = [&](bool top) {
    for (std::uint32_t j = 0; j < row; ++j) {
      for (std::uint32_t i = 0; i < row; ++i) {
        const double x = kHalf * (2.0 * i / cells - 1.0), y = kHalf * (2.0 * j / cells - 1.0);
        mesh.vertices.push_back({x, y, top ? height(x, y) : kFloor});
      }
    }
  };
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  add(true);
  add(false);
  const std::uint32_t under = row * row, n = row - 1;
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * row + i;
      quad(a, a + 1, a + 1 + row, a + row);
      quad(under + a, under + a + row, under + a + 1 + row, under + a + 1);
    }
  }
  for (std::uint32_t k = 0; k < n; ++k) {
    quad(under + k, under + k + 1, k + 1, k);
    quad(n * row + k, n * row + k + 1, under + n * row + k + 1, under + n * row + k);
    quad(k * row, (k + 1) * row, under + (k + 1) * row, under + k * row);
    quad(under + k * row + n, under + (k + 1) * row + n, (k + 1) * row + n, k * row + n);
  }
  return mesh;
}

}  // namespace

std::vector<Part> freeFormParts() {
  std::vector<Part> parts;
  parts.push_back({"mesh sphere on free-form dish",
                   block([](double x, double y) { return 16.0 * x * x + 11.0 * y * y + 60.0 * x * x * y; }, 30)});
  parts.push_back({"mesh sphere in trough of 8 degree facets",
                   block(
                       [](double x, double) {
                         const double step = 0.005, left = step * std::floor(x / step), right = left + step;
                         const auto arc = [](double at) { return 0.035 - std::sqrt(0.035 * 0.035 - at * at); };
                         return arc(left) + (arc(right) - arc(left)) * (x - left) / step;
                       },
                       12)});
  parts.push_back({"mesh sphere on toothed rack",
                   block([](double x, double) { return 0.6 * std::abs(std::fmod(std::abs(x), 0.008) - 0.004); }, 60)});
  return parts;
}

MeshCase makePartCase(const Part& part) {
  auto truth = std::make_unique<PartScene>(part.name, MeshCollider::build(part.mesh));
  auto seen = ballAgainst(part.name, part.mesh, truth->placement());
  return {part.name, std::move(seen), std::move(truth)};
}

}  // namespace hapticell::feel
