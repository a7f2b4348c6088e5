// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "collision/contacts/facet_query.h"
#include "collision/contacts/surface_query.h"
#include "collision/contacts/zone_contacts.h"

namespace hapticell::collision {

/// Finds everything that moving bodies could meet within a zone. For each pair of bodies it chooses the better method.
///
/// Recognised surfaces (SurfaceQuery) describe round and hollow shapes exactly and in few entries. Facets (FacetQuery)
/// describe free-form and toothed regions, open soups that no surface fits, and many flat convex pieces. A pair begins
/// with surfaces; a pair of mostly free-form meshes begins with facets. If surfaces give less than a quarter of the
/// wanted zone and facets give four times as much, the pair changes to facets. It changes back when surfaces fit again.
/// The finder tries both methods at every twelfth query and, if the other one fails, less and less often. The zone
/// shrinks as a whole (by 0.65) until all entries fit.
///
/// Keeps the results for each place of each mesh and where the last search ended, so a warm query only evaluates.
/// `pending`: new places took too long and the answer is incomplete; the next query continues. Keep using the contacts
/// that you have until then. The same queries in the same order give the same answers. The parts' data outlive this
/// object. One thread.
class ContactFinder {
 public:
  enum class Ways : std::uint8_t {
    kBest,      ///< As above.
    kSurfaces,  ///< All parts have surfaces; if not even the smallest zone fits, `complete` is false.
    kFacets,    ///< All parts have pieces; if not even the smallest zone fits, the answer has the nearest contacts
                ///< only.
  };
  explicit ContactFinder(Ways ways = Ways::kBest) : ways_(ways) {}

  /// The cost depends on the parts that are near; of all others only the bounding spheres are tested.
  ZoneContacts find(std::span<const ZonePart> moving, std::span<const ZonePart> environment,
                    const ZoneOptions& options);

 private:
  /// The method for one pair of bodies.
  struct PairWay {
    bool facets = false;
    bool fixed = false;         ///< Only one method is possible.
    bool mostly_known = false;  ///< Most of both surfaces is recognised.
    int resting = 0;            ///< Queries until the other method is tried,
    int rest = 0;               ///< and how many it was last time.
    int cold = 0;               ///< Consecutive trials that ran out of time.
  };
  struct Search;

  ZoneContacts findAmong(std::span<const ZonePart> moving, std::span<const ZonePart> environment,
                         const ZoneOptions& options);
  PairWay& wayOf(const ZonePart& moving, const ZonePart& environment);
  std::size_t startLevel(const Search& search) const;
  std::optional<ZoneContacts> attempt(Search& search, std::size_t level);
  void widen(Search& search);
  bool decideByFacets(Search& search, std::span<const std::size_t> pairs);
  void tryFacets(Search& search, bool narrow);
  void trySurfaces(Search& search, bool narrow);
  void restLonger(PairWay& way) const;
  ZoneContacts lastResort(Search& search);

  Ways ways_;
  std::map<std::pair<std::uint64_t, std::uint64_t>, PairWay> pair_ways_;  ///< By the bodies' keys.
  SignatureCaches caches_;
  double kept_share_ = 0.0;  ///< Share of the wanted zone in the last query; 0 before the first.
  bool crowded_ = false;
  int since_larger_ = 0;  ///< Queries since a larger zone was tried.
};

}  // namespace hapticell::collision
