// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "collision/contacts/contact_rows.h"
#include "collision/queries/mesh_search.h"
#include "collision/surfaces/signature_groups.h"
#include "collision/contacts/zone_contacts.h"

namespace hapticell::collision {

/// Results for each place of each mesh, kept from query to query.
using SignatureCaches = std::unordered_map<const SurfaceModel*, std::unique_ptr<SignatureCache>>;

/// Finds what the moving parts could meet from recognised surfaces, for one zone radius at a time.
///
/// It checks corners, rims and balls of the moving bodies against the environment's surfaces (offset by the ball's
/// radius), those of the environment against the moving bodies' surfaces, and edges and cylinders that cross.
/// SignatureCache gives the groups of one point. Entries have the surface's curvature and, as a trim, its end. Entries
/// deeper than the zone and groups that cannot be met in it are left out. If new places take more than about 15 ms in a
/// query, the attempt fails with isCold(), and the next query continues from there. Lives for one query. One thread.
class SurfaceQuery {
 public:
  SurfaceQuery(SignatureCaches& caches, std::span<const ZonePart> moving, std::span<const ZonePart> environment,
               const ZoneOptions& options)
      : caches_(caches), moving_(moving), environment_(environment), options_(options) {}

  /// Outlives the query; empty: all pairs count. The parts of every pair that counts must have surfaces.
  void setMask(std::span<const std::uint8_t> mask) { options_.pair_mask = mask; }
  /// If true, free-form regions make an attempt fail, because facets describe them better.
  void setMayFallBack(bool may) { may_fall_back_ = may; }

  /// Everything within the radius (m); empty if that is more than `max_entries`.
  std::optional<ZoneContacts> attempt(double radius, std::size_t max_entries);

  /// An attempt failed only because it ran out of time.
  bool isCold() const { return new_work_ > kMostNewWork; }
  /// The last attempt failed because a ring's quadric is too inaccurate for that radius. A smaller radius helps, facets
  /// do not.
  bool isRough() const { return rough_; }
  /// Entries of the last attempt per pair (moving * environment.size() + environment), up to the limit or to where it
  /// ended. The pair at which it was given up has the largest value.
  const std::vector<std::size_t>& weights() const { return weights_; }
  /// In units of ZoneContacts::work, about a microsecond each; the same in every run.
  std::size_t work() const;

 private:
  // Of SignatureCache::takeWork(), about 15 ms: a query of new places takes a period at 60 Hz at most. Half: more sets
  // are pending; twice: sets 30 ms apart.
  static constexpr std::size_t kMostNewWork = 1500000;

  /// The points of one body against the surfaces of another.
  struct Meeting {
    const ZonePart& points;
    const ZonePart& obstacle;
    ContactGroup like;
    double reach;
  };

  bool counts(std::size_t m, std::size_t e) const {
    return options_.pair_mask.empty() || options_.pair_mask[m * environment_.size() + e] != 0;
  }
  bool gather(double radius);
  bool meet(const Meeting& meeting);
  bool addBall(const Meeting& meeting, const dvec3& p_W, double radius, const ContactGroup& like);
  bool addCircle(const Meeting& meeting, const BodyCircle& circle, std::uint64_t name);
  bool addRods(std::uint32_t m, std::uint32_t e, double reach);
  bool crossRods(std::uint32_t m, std::uint32_t e, SurfaceModel::RodKind of_moving, SurfaceModel::RodKind of_obstacle,
                 double reach);
  ZoneContact entryOf(const ContactGroup& group, const ContactRow& row) const;
  SignatureCache& cacheOf(const SurfaceModel& model);

  SignatureCaches& caches_;
  std::span<const ZonePart> moving_;
  std::span<const ZonePart> environment_;
  ZoneOptions options_;
  std::vector<ContactGroup> groups_;
  std::vector<TrianglePair> rod_pairs_;
  bool facets_ = false;
  bool rough_ = false;          ///< The quadric of a ring was too inaccurate.
  bool rough_allowed_ = false;  ///< At this radius inaccurate quadrics are allowed.
  bool may_fall_back_ = false;
  std::size_t new_work_ = 0;
  std::size_t work_ = 0;
  std::vector<std::size_t> weights_;
};

}  // namespace hapticell::collision
