// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "collision/queries/mesh_search.h"
#include "collision/pieces/separating_directions.h"
#include "collision/contacts/zone_contacts.h"

namespace hapticell::collision {

class PlacedPart;
struct NearPair;
struct PieceGroup;

/// Finds what the moving parts could meet from their convex pieces, for one zone radius at a time; used by
/// zoneContacts(). Lives for one query; refers to the parts' data. One thread.
class FacetQuery {
 public:
  /// How closely a zone is described.
  enum class Detail : std::uint8_t {
    kTurning,  ///< Includes contacts that turning could cause; coarser tolerances are tried before giving up.
    kCrowded,  ///< Ignores turning when groups that others imply are removed.
    kAny,      ///< kTurning; if it finds no set, kCrowded.
  };

  /// `options.pair_mask` may be replaced later by setMask(); `options.max_entries` is ignored.
  FacetQuery(std::span<const ZonePart> moving, std::span<const ZonePart> environment, const ZoneOptions& options);
  ~FacetQuery();
  FacetQuery(const FacetQuery&) = delete;
  FacetQuery& operator=(const FacetQuery&) = delete;

  /// Outlives the query; empty: all pairs count.
  void setMask(std::span<const std::uint8_t> mask) { options_.pair_mask = mask; }
  /// Number of directions after which an attempt is given up.
  void setMostDirections(std::size_t count) { most_directions_ = count; }

  /// Everything within the radius (m); empty if that is more than `max_entries`.
  std::optional<ZoneContacts> attempt(double radius, Detail detail, std::size_t max_entries);
  /// The nearest contacts only, each in a group of one.
  ZoneContacts nearestOnly(double radius, std::size_t max_entries);

  /// Number of directions examined, about a microsecond each; the same in every run.
  std::size_t work() const { return work_; }

 private:
  struct Effort;
  static const Effort kEfforts[4];
  DirectionLimits limits(std::size_t moving_part, double radius) const;
  bool counts(std::size_t moving_part, std::size_t environment_part) const;
  /// False: too many pairs; the zone must shrink.
  bool collect(std::size_t moving_part, const DirectionLimits& limits, std::vector<PieceGroup>& groups);
  /// Pairs of pieces that come within the reach, by a quick search; incomplete if there are many.
  std::vector<NearPair> nearPairs(std::size_t moving_part, const DirectionLimits& limits);
  /// False: too many candidates.
  bool candidates(PlacedPart& a, PlacedPart& b, double reach, std::vector<LabelPair>& found);
  bool candidatesOnDemand(PlacedPart& a, PlacedPart& b, double reach, std::vector<LabelPair>& found);
  bool labelsWithin(const PlacedPart& a, const PlacedPart& b, double reach, std::size_t most,
                    std::vector<LabelPair>& found);
  std::optional<ZoneContacts> written(const std::vector<std::vector<PieceGroup>>& groups, double radius,
                                      const Effort& effort, std::size_t max_entries) const;
  void write(std::size_t moving_part, const PieceGroup& group, ZoneContacts& result) const;
  ZoneContact entry(std::size_t moving_part, const PieceGroup& group, const SeparatingDirection& direction,
                    const SupportPoint& support) const;

  ZoneOptions options_;
  std::vector<PlacedPart> moving_;
  std::vector<PlacedPart> environment_;
  std::size_t most_directions_;
  std::size_t work_ = 0;
  bool complete_ = true;  // Of the last nearPairs().
};

}  // namespace hapticell::collision
