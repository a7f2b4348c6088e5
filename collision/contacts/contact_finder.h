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

/// Everything that moving bodies could meet within a zone, each pair of bodies in the way that suits it where it is.
///
/// Recognised surfaces (SurfaceQuery) tell what is round or hollow exactly and in few entries; facets (FacetQuery) tell
/// free-form and toothed regions, open soups that no surface fits, and crowds of flat convex pieces. Pairs begin with
/// surfaces, those of mostly free-form meshes with facets. A pair whose surfaces leave less than a quarter of the
/// wanted zone goes over to facets if they give four times as much there, and comes back where surfaces fit again; both
/// are tried at every twelfth query and, without success, ever less often. The zone shrinks as a whole (by 0.65) until
/// all entries fit.
///
/// Keeps what it worked out for each place of each mesh and where the last search ended, so a warm query only
/// evaluates. `pending`: new places took too long, the answer is incomplete, what is held already goes on being held,
/// and the next query will know more. Same queries in the same order give the same answers. The parts' data outlive
/// this object. One thread.
class ContactFinder {
 public:
  enum class Ways : std::uint8_t {
    kBest,      ///< As above.
    kSurfaces,  ///< All parts have surfaces; where not even the smallest zone fits, `complete` is false.
    kFacets,    ///< All parts have pieces; where not even the smallest zone fits, the nearest contacts stand.
  };
  explicit ContactFinder(Ways ways = Ways::kBest) : ways_(ways) {}

  ZoneContacts find(std::span<const ZonePart> moving, std::span<const ZonePart> environment,
                    const ZoneOptions& options);

 private:
  /// How a pair of bodies is told.
  struct PairWay {
    bool facets = false;
    bool fixed = false;         ///< Has no other way.
    bool mostly_known = false;  ///< Most of both surfaces is recognised.
    int resting = 0;            ///< Queries until the other way is tried,
    int rest = 0;               ///< and how many it was last time.
    int cold = 0;               ///< Trials in a row that ended for want of time.
  };
  struct Search;

  PairWay& wayOf(const ZonePart& moving, const ZonePart& environment);
  std::size_t startLevel(const Search& search) const;
  std::optional<ZoneContacts> attempt(Search& search, std::size_t level);
  void widen(Search& search);
  bool tellByFacets(Search& search, std::span<const std::size_t> pairs);
  void tryFacets(Search& search, bool narrow);
  void trySurfaces(Search& search, bool narrow);
  void restLonger(PairWay& way) const;
  ZoneContacts lastResort(Search& search);

  Ways ways_;
  std::map<std::pair<std::uint64_t, std::uint64_t>, PairWay> pair_ways_;  ///< By the bodies' keys.
  SignatureCaches caches_;
  double kept_share_ = 0.0;  ///< Of the wanted zone, by the last query; 0 before the first.
  bool crowded_ = false;
  int since_larger_ = 0;  ///< Queries since a wider zone was tried.
};

}  // namespace hapticell::collision
