// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "collision/pieces/convex_pieces.h"
#include "geometry/shapes/pose.h"

namespace hapticell::collision {

class SurfaceModel;

/// One rigid body in a zone query: a moved solid, a robot's link, or an obstacle.
struct ZonePart {
  const ConvexPieces* pieces = nullptr;  ///< Prepared at load; null only for ContactFinder, with `surfaces`.
  Pose X_W;                              ///< Pose of the mesh's frame in the world.
  std::uint64_t key = 0;                 ///< Stable from query to query; part of the entries' ids.
  double reach = 0.0;  ///< How far any point of this part can move at most while the hand stays in the wanted radius,
                       ///< metres; 0 means the radius itself. Ignored for the environment.
  const SurfaceModel* surfaces = nullptr;  ///< For ContactFinder; null: facets only.
};

/// One entry of the set: gap + nhat_W . v >= 0 for a small motion v of the moving part at p_W.
///
/// Entries of one `group` are OR (free when one of them holds), groups are AND.
struct ZoneContact {
  std::uint32_t group = 0;
  std::uint32_t moving_part = 0;       ///< Index into `moving`.
  std::uint32_t environment_part = 0;  ///< Index into `environment`.
  dvec3 p_W{0.0};                      ///< Material point of the moving part whose motion along nhat_W changes the gap,
                                       ///< to first order in translation and rotation.
  dvec3 q_W{0.0};                      ///< The point of the environment it meets: gap = nhat_W . (p - q) or, where the
                                       ///< normal moves, nhat_W . (a - p) with a on the face of the moving part.
  dvec3 nhat_W{0.0, 0.0, 1.0};         ///< Unit: the direction in which the moving part becomes free.
  double gap = 0.0;                    ///< Metres, raw (no safety distance taken off); negative inside.
  /// If not 0, the gap after a motion d of the point is nhat . e + 1/2 e . M e with e = gap nhat + d, in 1/m: the
  /// surface's curvature and its normal-normal term, so that spheres, cylinders and cones are exact at any distance.
  dmat3 M_W{0.0};
  bool has_trim = false;  ///< A second value at the same point; the smaller of both counts.
  dvec3 trim_nhat_W{0.0, 0.0, 1.0};
  double trim_gap = 0.0;
  bool normal_moves = false;  ///< The normal turns with the moving part (its face on an obstacle's corner).
  std::uint64_t id = 0;       ///< The same physical contact keeps it from query to query.
};

struct ZoneOptions {
  double radius = 0.060;  ///< Wanted, metres.
  std::size_t max_entries = 64;
  double safety_distance = 0.0;  ///< Metres; the search goes this much farther out.
  double max_rotation = 0.3;     ///< Radians that the part may turn within the wanted radius; shrinks with it.
  double min_radius = 0.0005;    ///< Metres: below it zoneContacts() uses its fallback.
  double needed_radius =
      0.0;  ///< Metres: rather than a smaller zone, a ring's quadric may be inaccurate (by over 0.05 mm).
  /// Which pairs count, row by row: pair_mask[moving * environment.size() + environment]; empty = all.
  std::span<const std::uint8_t> pair_mask;
  bool only_complete = false;  ///< Incomplete answers are not wanted: they have no contacts and `complete` is false.
};

struct ZoneContacts {
  std::vector<ZoneContact> contacts;  ///< Ordered by group; group numbers count up from 0 without gaps.
  std::uint32_t groups = 0;
  double radius = 0.0;   ///< Metres: the set contains everything that can be met within it. For a part with its own
                         ///< reach, within reach * radius / wanted radius.
  bool complete = true;  ///< False: more than max_entries even at min_radius; then the set has only the nearest
                         ///< contacts, each in a group of one (AND).
  bool pending = false;  ///< ContactFinder: incomplete for now; the next query continues the work.
  bool facets = false;   ///< ContactFinder: some entries come from facets, not from a recognised surface.
  bool crowded = false;  ///< Turning was ignored when facets that others imply were removed.
  std::size_t work = 0;  ///< Cost in directions examined (about a microsecond each); the same in every run.
};

/// Finds everything that the moving parts could meet in the environment within the zone, from facets only.
///
/// For every pair of convex pieces near each other one group holds the directions in which they are separated or could
/// become so: faces of either and crossed edges, that is the faces of their Minkowski difference which the zone
/// reaches. Therefore overlapping pieces never count as free, under any translation. Further corners of the same faces
/// cover rotations. If the set would have more than max_entries, the zone shrinks as a whole. A start that touches or
/// penetrates gives gaps <= 0 with the direction of least penetration. Any thread.
ZoneContacts zoneContacts(std::span<const ZonePart> moving, std::span<const ZonePart> environment,
                          const ZoneOptions& options);

}  // namespace hapticell::collision
