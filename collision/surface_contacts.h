// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>

#include "collision/signature_groups.h"
#include "collision/surface_model.h"
#include "collision/zone_contacts.h"

namespace hapticell::collision {

/// Everything that moving bodies could meet within a zone, told by the surfaces that their meshes were made from.
///
/// Corners, rims and balls of the moving bodies against the environment's surfaces (offset by the ball's radius), those
/// of the environment against the moving bodies' surfaces, and edges and cylinders that cross. Groups of one point are
/// those of SignatureCache; entries carry the surface's curvature and its end as a trim; an entry that lies deeper than
/// the zone and a group that cannot be met in it are left out. The zone shrinks as a whole (by 0.65) until the entries
/// fit. Where not even the smallest zone fits, `complete` is false and there are no contacts: zoneContacts() has them
/// then. `facets` says that free-form or open surfaces came in as facets.
///
/// Keeps what it worked out for each place of each mesh, so a warm query only evaluates. Every part has its `surfaces`,
/// which outlive this object. Without a hint the search begins at the zone that fitted last. One thread.
class SurfaceContacts {
 public:
  ZoneContacts find(std::span<const ZonePart> moving, std::span<const ZonePart> environment,
                    const ZoneOptions& options);

  /// Whether to ask at all: after an answer that was of no use some queries go without.
  bool isWorthAsking();
  void tellUse(bool used);

 private:
  friend class SurfaceQuery;
  SignatureCache& cacheOf(const SurfaceModel& model);

  std::unordered_map<const SurfaceModel*, std::unique_ptr<SignatureCache>> caches_;
  double wanted_ = 0.0;   ///< Of the last query,
  double kept_ = 0.0;     ///< and what it kept, m.
  int resting_ = 0;       ///< Queries still to go without.
  int since_larger_ = 0;  ///< Queries since a wider zone was tried.
};

}  // namespace hapticell::collision
