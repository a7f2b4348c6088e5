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

/// What was worked out for each place of each mesh, kept from query to query.
using SignatureCaches = std::unordered_map<const SurfaceModel*, std::unique_ptr<SignatureCache>>;

/// What the moving parts could meet, told by recognised surfaces, one zone radius at a time.
///
/// Corners, rims and balls of the moving bodies against the environment's surfaces (offset by the ball's radius), those
/// of the environment against the moving bodies' surfaces, and edges and cylinders that cross. Groups of one point are
/// those of SignatureCache; entries carry the surface's curvature and its end as a trim; an entry that lies deeper than
/// the zone and a group that cannot be met in it are left out. New places may cost so much a query (about 15 ms);
/// beyond that the attempt fails and says isCold(): the next query goes on from there. Lives for one query. One thread.
class SurfaceQuery {
 public:
  SurfaceQuery(SignatureCaches& caches, std::span<const ZonePart> moving, std::span<const ZonePart> environment,
               const ZoneOptions& options)
      : caches_(caches), moving_(moving), environment_(environment), options_(options) {}

  /// Outlives the query; empty: all pairs count. Parts of pairs that count have their surfaces.
  void setMask(std::span<const std::uint8_t> mask) { options_.pair_mask = mask; }
  /// Free-form regions then make an attempt fail: facets tell them better.
  void setMayFallBack(bool may) { may_fall_back_ = may; }

  /// Everything within the radius (m), or nothing where that is more than `max_entries`.
  std::optional<ZoneContacts> attempt(double radius, std::size_t max_entries);

  /// Some attempt has failed for want of time only.
  bool isCold() const { return new_work_ > kMostNewWork; }
  /// The last attempt failed because a ring's quadric is not good for that radius: a smaller one is, facets do not
  /// help.
  bool isRough() const { return rough_; }
  /// Of the last attempt, per pair (moving * environment.size() + environment): entries before the limit, or so far as
  /// it got; the pair at which it was given up counts most.
  const std::vector<std::size_t>& weights() const { return weights_; }
  /// In ZoneContacts::work, about a microsecond each: repeats exactly.
  std::size_t work() const;

 private:
  static constexpr std::size_t kMostNewWork = 1500000;  // of SignatureCache::takeWork(), about 15 ms

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
  bool rough_ = false;          ///< A ring was told too roughly.
  bool rough_allowed_ = false;  ///< At this radius they may be.
  bool may_fall_back_ = false;
  std::size_t new_work_ = 0;
  std::size_t work_ = 0;
  std::vector<std::size_t> weights_;
};

}  // namespace hapticell::collision
