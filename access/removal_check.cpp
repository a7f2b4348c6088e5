// SPDX-License-Identifier: Apache-2.0
#include "access/removal_check.h"

#include <algorithm>
#include <cmath>

#include "access/sweep_limits.h"
#include "collision/queries/mesh_search.h"
#include "geometry/system/atomic_file.h"
#include "geometry/system/scratch_folder.h"
#include "trajectory/files/trajectory_io.h"
#include "trajectory/motion/number_text.h"

namespace hapticell::access {

namespace {

/// m of motion between two looks. Half: twice the time; twice: a point may pass 1 mm of material unseen.
constexpr double kLookEvery = 1e-3;
/// Points on each part. Half: thin ribs across long edges may lie between two points; twice: twice the time.
constexpr std::size_t kMostPoints = 3000;
constexpr int kMostLooks = 3000;  ///< Of one way: 3 m. Half and twice: as kLookEvery.

/// Corners, and points along the edges, of a mesh.
std::vector<dvec3> pointsOf(const geometry::TriangleMesh& mesh) {
  std::vector<dvec3> points;
  const std::size_t stride = 1 + mesh.vertices.size() / kMostPoints;
  for (std::size_t i = 0; i < mesh.vertices.size(); i += stride) points.push_back(mesh.vertices[i]);
  double edges = 0.0;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto corners = mesh.corners(i);
    for (int k = 0; k < 3; ++k) edges += glm::length(corners[static_cast<std::size_t>((k + 1) % 3)] - corners[static_cast<std::size_t>(k)]);
  }
  const double spacing = edges / static_cast<double>(kMostPoints);
  for (std::uint32_t i = 0; i < mesh.triangles.size() && spacing > 0.0; ++i) {
    const auto corners = mesh.corners(i);
    for (std::size_t k = 0; k < 3; ++k) {
      const dvec3 edge = corners[(k + 1) % 3] - corners[k];
      const auto count = static_cast<int>(glm::length(edge) / spacing);
      for (int j = 1; j < count; ++j) points.push_back(corners[k] + (static_cast<double>(j) / count) * edge);
    }
  }
  return points;
}

/// The greatest depth of the points of A below B's surface, above `least`.
double deepest(const std::vector<dvec3>& points_A, const Pose& X_BA, const collision::MeshCollider& b, double least) {
  const geometry::Bounds& box = b.bounds();
  for (const dvec3& p_A : points_A) {
    const dvec3 p = X_BA * p_A;
    if (glm::any(glm::lessThan(p, box.min)) || glm::any(glm::greaterThan(p, box.max)) || !b.contains(p)) continue;
    least = std::max(least, collision::nearestPoint(b, p).distance);
  }
  return least;
}

/// What the part may meet, with its points.
struct Met {
  const RemovalUnit::Part* part;
  std::vector<dvec3> points;
};

}  // namespace

Promises removalPromises(const RemovalScene& scene, std::size_t unit, UnitSet gone,
                         const trajectory::Trajectory& written) {
  const RemovalUnit& own = scene.units()[unit];
  const Pose rest = scene.scene().find(own.entity)->X_WE, X_EW = rest.inverse();
  double deep = 0.0, deep_at = 0.0;
  for (const auto& a : own.parts) {
    std::vector<Met> others;
    for (std::size_t other = 0; other < scene.units().size(); ++other) {
      if (other == unit || (other < scene.movableCount() && (gone >> other & 1) != 0)) continue;
      for (const auto& b : scene.units()[other].parts)
        if (scene.areChecked(a, b)) others.push_back({&b, pointsOf(b.part->mesh.collider->mesh())});
    }
    const std::vector<dvec3> points = pointsOf(a.part->mesh.collider->mesh());
    const double size = glm::length((X_EW * a.X_WP).p) + a.part->mesh.collider->radius();
    for (std::size_t i = 1; i < written.size(); ++i) {
      const Twist step = difference(written[i].X_WT, written[i - 1].X_WT);
      const double way = glm::length(step.linear) + size * glm::length(step.angular);
      const int looks = std::clamp(static_cast<int>(std::ceil(way / kLookEvery)), 1, kMostLooks);
      for (int k = 0; k <= looks; ++k) {
        const double s = static_cast<double>(k) / looks;
        const Pose X_WA = interpolate(written[i - 1].X_WT, written[i].X_WT, s) * X_EW * a.X_WP;
        const geometry::Bounds bounds = geometry::transformed(X_WA, a.part->mesh.collider->bounds());
        for (const Met& met : others) {
          if (areApart(bounds, met.part->bounds_W)) continue;
          const auto& b = *met.part->part->mesh.collider;
          double now = deepest(points, met.part->X_WP.inverse() * X_WA, b, deep);
          now = deepest(met.points, X_WA.inverse() * met.part->X_WP, *a.part->mesh.collider, now);
          if (now <= deep) continue;
          deep = now;
          deep_at = written[i - 1].t + s * (written[i].t - written[i - 1].t);
        }
      }
    }
  }
  geometry::Bounds last;
  for (const auto& part : own.parts)
    last.add(geometry::transformed(written[written.size() - 1].X_WT * X_EW * part.X_WP, part.part->mesh.collider->bounds()));
  const dvec3 gap = glm::max(last.min - scene.box_W().max, scene.box_W().min - last.max);
  const Twist begin = difference(written[0].X_WT, rest);
  Promises promises;
  promises.help = Text("Ask with another --tolerance, or write the way only for what it is.");
  promises.list.push_back({.name = "start", .asked = 1e-3, .measured = glm::length(begin.linear), .unit = "m"});
  promises.list.push_back({.name = "out_of_box",
                           .asked = 0.0,
                           .measured = std::max({gap.x, gap.y, gap.z}),
                           .unit = "m",
                           .is_at_least = true,
                           .rounding = 1e-9});
  promises.list.push_back({.name = "depth",
                           .asked = 2.0 * scene.tolerance(),
                           .measured = deep,
                           .unit = "m",
                           .place = Text("at %1 s", trajectory::shortestText(std::round(1e4 * deep_at) / 1e4)),
                           .rounding = 1e-9});
  return promises;
}

Expected<trajectory::Trajectory> keptMotion(const RemovalScene& scene, std::size_t unit, UnitSet gone,
                                            const RemovalWay& way, double speed) {
  const auto motion = trajectoryOf(scene, unit, way, speed);
  const auto folder = ScratchFolder::make();
  HAPTICELL_TRY(folder);
  const std::filesystem::path file = folder->path() / "way.htraj";
  HAPTICELL_TRY(writeFileAtomically(file, trajectory::toJsonText(motion), {.durable = false}));
  auto written = trajectory::readTrajectory(file);
  HAPTICELL_TRY(written);
  Promises promises = removalPromises(scene, unit, gone, *written);
  promises.help = Text("Ask again with another depth that counts as touching, or show the way by hand.");
  promises.can_be_forced = false;
  if (!promises.areKept()) return makeError(promises.missed(motion.name));
  return written;
}

}  // namespace hapticell::access
