// SPDX-License-Identifier: Apache-2.0
#include "access/straight_removal.h"

#include <algorithm>
#include <bit>

#include "access/ordered.h"
#include "access/removal_directions.h"
#include "access/sweep_limits.h"
#include "collision/queries/motion_check.h"
#include "geometry/system/in_parallel.h"

namespace hapticell::access {

namespace {

using collision::MotionStop;
using collision::ProximityQuery;

bool meets(const RemovalUnit::Part& moved, const RemovalUnit::Part& other, const dvec3& way_W) {
  geometry::Bounds swept = moved.bounds_W;
  swept.add({moved.bounds_W.min + way_W, moved.bounds_W.max + way_W});
  if (areApart(swept, other.bounds_W)) return false;
  ProximityQuery query(moved.thin, other.part->mesh.collider);
  const auto still = collision::standingStill(other.X_WP);
  Pose from = moved.X_WP, to = moved.X_WP;
  to.p += way_W;
  for (int i = 0; i < kMostContinued; ++i) {
    const MotionStop stop = advance(query, collision::straightMotion(from, to, *moved.thin), still, {});
    if (stop.began_colliding) return true;
    if (!stop.stopped) return false;
    if (stop.nearest.distance < kStopped) return true;
    from = interpolate(from, to, stop.s);
  }
  return true;
}

bool meets(const RemovalScene& scene, const RemovalUnit& moved, const RemovalUnit& other, const dvec3& way_W) {
  for (const auto& a : moved.parts)
    for (const auto& b : other.parts)
      if (scene.areChecked(a, b) && meets(a, b, way_W)) return true;
  return false;
}

/// Without those that need more than another one does.
std::vector<StraightWay> leastOf(std::vector<StraightWay> ways) {
  std::vector<StraightWay> least;
  for (StraightWay& way : ordered(std::move(ways), [](const StraightWay& one) { return std::popcount(one.blockers); })) {
    const bool more = std::any_of(least.begin(), least.end(), [&](const StraightWay& one) {
      return (one.blockers & ~way.blockers) == 0;
    });
    if (!more) least.push_back(std::move(way));
  }
  return least;
}

}  // namespace

StraightWay straightWay(const RemovalScene& scene, std::size_t unit, const dvec3& direction_W, double length) {
  StraightWay way{direction_W, length, 0, {}};
  for (std::size_t other = 0; other < scene.units().size(); ++other) {
    if (other == unit || !meets(scene, scene.units()[unit], scene.units()[other], length * direction_W)) continue;
    if (other < scene.movableCount()) {
      way.blockers |= UnitSet{1} << other;
    } else {
      way.fixed.push_back(other);
    }
  }
  return way;
}

std::vector<StraightWay> straightWays(const RemovalScene& scene, std::size_t unit) {
  const std::vector<dvec3> directions = removalDirections(scene, unit);
  std::vector<StraightWay> all(directions.size());
  geometry::inRanges(all.size(), geometry::rangesOf(all.size(), 2),
                     [&](std::size_t, std::size_t begin, std::size_t end) {
                       for (std::size_t i = begin; i < end; ++i)
                         all[i] = straightWay(scene, unit, directions[i], scene.wayOut(unit, directions[i]));
                     });
  std::vector<StraightWay> ways;
  for (const StraightWay& way : all)
    if (way.fixed.empty()) ways.push_back(way);
  if (!ways.empty()) return leastOf(std::move(ways));
  return {*std::min_element(all.begin(), all.end(), [](const StraightWay& a, const StraightWay& b) {
    return static_cast<std::size_t>(std::popcount(a.blockers)) + a.fixed.size() <
           static_cast<std::size_t>(std::popcount(b.blockers)) + b.fixed.size();
  })};
}

std::vector<std::size_t> overlappingAtRest(const RemovalScene& scene, std::size_t unit) {
  std::vector<std::size_t> found;
  for (std::size_t other = 0; other < scene.units().size(); ++other) {
    if (other != unit && meets(scene, scene.units()[unit], scene.units()[other], dvec3(0.0))) found.push_back(other);
  }
  return found;
}

}  // namespace hapticell::access
