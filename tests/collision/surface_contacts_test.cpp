// SPDX-License-Identifier: Apache-2.0
#include "collision/surface_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <random>

#include "collision/contact_rows.h"
#include "collision/mesh_search.h"
#include "collision/surface_clusters.h"
#include "tests/collision/generated_parts.h"
#include "tests/support/test_data.h"
#include "workcell/mesh_reader.h"

namespace hapticell::test {
namespace {

using collision::BallQuery;
using collision::ContactGroup;
using collision::ContactRow;
using collision::SignatureCache;
using collision::SurfaceModel;

/// A row's value at another place, as the force loop reckons it: the surface's quadric through its foot.
double valueAt(const ContactRow& row, const dvec3& q) {
  const dvec3 e = q - (row.p_W - row.gap * row.nhat_W);
  double value = glm::dot(row.nhat_W, e) + 0.5 * glm::dot(e, row.M_W * e);
  if (row.has_trim) value = std::min(value, row.trim_gap + glm::dot(row.trim_nhat_W, q - row.p_W));
  return value;
}

/// The same from the groups' surfaces themselves.
double exactly(const SurfaceModel& model, const std::vector<std::vector<std::uint32_t>>& groups, const dvec3& q) {
  double least = 1e9;
  for (const auto& group : groups) {
    double best = -1e9;
    for (const auto e : group) best = std::max(best, collision::elementValue(model.elements()[e], q, 0.0));
    least = std::min(least, best);
  }
  return least;
}

double claimed(const std::vector<ContactGroup>& groups, const dvec3& q) {
  double least = 1e9;
  for (const ContactGroup& group : groups) {
    double best = -1e9;
    for (const ContactRow& row : group.rows) best = std::max(best, valueAt(row, q));
    least = std::min(least, best);
  }
  return least;
}

struct PointReport {
  int points = 0, free = 0, walls = 0, holes = 0, exact_walls = 0, exact_holes = 0;
  double depth = 0.0;  ///< Largest error of a wall or hole, m.
  std::size_t most_entries = 0, overfull = 0;
  double ms = 0.0;
};

/// A point body at random free places; the set it gets there against random points 0.1 mm off the surface within the
/// zone.
PointReport tryPoints(const SurfaceModel& model, int count, double zone, unsigned seed, bool verbose = false) {
  constexpr double kOff = 1e-4;
  PointReport report;
  const auto& surface = model.surface();
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<double> areas;
  for (std::uint32_t t = 0; t < surface.mesh.triangles.size(); ++t) areas.push_back(collision::areaOf(surface.mesh, t));
  std::discrete_distribution<std::uint32_t> pick(areas.begin(), areas.end());
  const auto onSurface = [&](std::uint32_t t) {
    const double a = std::sqrt(uniform(random)), b = uniform(random);
    return (1 - a) * surface.mesh.corner(t, 0) + a * (1 - b) * surface.mesh.corner(t, 1) +
           a * b * surface.mesh.corner(t, 2);
  };
  SignatureCache cache(model);
  const std::clock_t start = std::clock();
  while (report.points < count) {
    const auto first = pick(random);
    const dvec3 p =
        onSurface(first) + zone * 0.6 * uniform(random) * surface.normals[first] + 2e-4 * surface.normals[first];
    if (model.collider().contains(p)) continue;
    const auto& cell = cache.cell(p, 0.0, zone);
    if (cell.overfull) {
      ++report.overfull;
      if (report.overfull > 1000) break;
      continue;
    }
    std::vector<ContactGroup> groups;
    for (const auto& elements : cell.groups) appendGroups(BallQuery{model, Pose{}, p, 0.0, zone}, elements, {}, groups);
    std::size_t entries = 0;
    for (const auto& group : groups) entries += group.rows.size();
    report.most_entries = std::max(report.most_entries, entries);
    std::vector<std::uint32_t> near;
    collision::trianglesWithin(model.collider(), p, zone, near);
    if (near.empty()) continue;
    std::vector<double> weights;
    for (const auto t : near) weights.push_back(areas[t]);
    std::discrete_distribution<std::size_t> pick_near(weights.begin(), weights.end());
    for (int tries = 0, i = 0; tries < 400 && i < 25; ++tries) {
      const auto t = near[pick_near(random)];
      const dvec3 q = onSurface(t) + (uniform(random) < 0.5 ? -kOff : kOff) * surface.normals[t];
      if (glm::length(q - p) > zone ||
          std::abs(collision::nearestPoint(model.collider(), q, kOff).distance) < 0.5 * kOff)
        continue;
      ++i;
      ++report.points;
      const bool inside = model.collider().contains(q);
      const double value = claimed(groups, q), exact = exactly(model, cell.groups, q);
      report.exact_walls += !inside && exact < 0.0;
      report.exact_holes += inside && exact > 0.0;
      report.free += inside ? 0 : 1;
      const bool wall = !inside && (value < 0.0 || exact < 0.0), hole = inside && (value > 0.0 || exact > 0.0);
      report.walls += wall;
      report.holes += hole;
      if (wall || hole) report.depth = std::max(report.depth, std::abs(value));
      if (verbose && (wall || hole) && report.walls + report.holes < 8) {
        const auto hit = collision::nearestPoint(model.collider(), q);
        std::printf("  %s p %.5f %.5f %.5f q %.5f %.5f %.5f value %.6f type %d of q, groups %zu\n",
                    wall ? "wall" : "hole", p.x, p.y, p.z, q.x, q.y, q.z, value,
                    static_cast<int>(surface.regions[surface.region_of[hit.triangle]].shape.type), groups.size());
        for (const auto& g : groups) {
          double best = -1e9;
          for (const auto& r : g.rows) best = std::max(best, valueAt(r, q));
          if ((wall && best < 0.0)) {
            std::printf("    group:");
            for (const auto& r : g.rows) {
              const auto& el = model.elements()[r.element];
              std::printf(" [el %u type %d kind %u side %g val %.6f true %.6f trim %d %.6f]", r.element,
                          static_cast<int>(el.shape.type), r.kind, el.shape.side, valueAt(r, q),
                          collision::elementValue(el, q, 0.0), r.has_trim, r.trim_gap);
            }
            std::printf("\n");
          }
        }
      }
    }
  }
  report.ms = 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return report;
}

void print(const std::string& name, double zone, const PointReport& r) {
  std::printf(
      "%-20s zone %4.1f mm: %d points, %d free, exact walls %d, holes %d; walls %d, holes %d (%.3f mm), entries <= "
      "%zu, overfull %zu, %.0f ms\n",
      name.c_str(), 1e3 * zone, r.points, r.free, r.exact_walls, r.exact_holes, r.walls, r.holes, 1e3 * r.depth,
      r.most_entries, r.overfull, r.ms);
}

TEST(SurfaceContacts, NeitherWallsNorHolesOnGeneratedParts) {
  for (const GeneratedPart& part : generatedParts()) {
    const auto model = SurfaceModel::build(part.mesh);
    for (const double zone : {0.005, 0.015}) {
      const PointReport report = tryPoints(*model, 10000, zone, 7, true);
      print(part.name, zone, report);
      EXPECT_EQ(report.walls, 0) << part.name;
      EXPECT_EQ(report.holes, 0) << part.name;
    }
  }
}

}  // namespace
}  // namespace hapticell::test
