// SPDX-License-Identifier: Apache-2.0
#include "collision/contacts/contact_finder.h"

#include <algorithm>
#include <cmath>

#include "collision/contacts/placed_part.h"
#include "geometry/system/assertion.h"

namespace hapticell::collision {

namespace {

/// From one tried zone to the next: 0.65 is five tries from 60 to 7 mm. Nearer to 1 (0.8): twice the tries for a zone
/// 10 % wider on average; smaller (0.4): half the tries, zones up to 2.5 times too small.
constexpr double kShrink = 0.65;
/// Of the wanted zone, where the first search begins: 3 of 60 mm, so that a crowded place is found at once. Half: open
/// places need two tries more; twice: the first try in a crowd may take long.
constexpr double kFirstShare = 0.05;
/// Of the wanted zone: below it turning may be left out among facets if the last set was crowded. Half: tight zones
/// keep all corners and shrink further; twice: bodies can tilt into each other sooner.
constexpr double kCrowdedShare = 0.25;
/// Of the wanted zone: below it (3 of 60 mm) turning is left out at once. Half: a crowd ends with zones of 1.5 mm;
/// twice: turning is lost where it would have fitted.
constexpr double kLeastShare = 0.05;
/// Of the wanted zone (15 of 60 mm, which a hand at 0.25 m/s crosses between two sets at 16 Hz): surfaces need no
/// comparison. Half: narrow zones stay; twice: facets are tried more often, each a search.
constexpr double kWideEnough = 0.25;
/// Levels: 1 / 0.65^3 = 3.6 times, what facets must win where something is round, as they lose its curvature. Half (1.9
/// times): steps of facets are felt for little; twice (13 times): facets are hardly taken.
constexpr std::size_t kMuchWider = 3;
/// Share of recognised area that lets a pair begin with surfaces (Contacts: "more than a fifth free form"). It only
/// chooses the first try; half: free form begins uselessly; 0.9: a few fillets begin with facets.
constexpr double kMostlyKnown = 0.8;
/// Queries between two tries of a wider zone. Half: each second query costs two searches; twice: after a crowd the zone
/// stays small for eight sets.
constexpr int kTryLarger = 4;
/// Times wider than what fits: less is not tried between two levels. Half of the tenth: more tries for 5 %; twice: half
/// levels (1.24) hardly count.
constexpr double kWorthwhile = 1.1;
/// Queries until what did not fit as surfaces is tried again, first and at most (Contacts: 12, 24, up to 192). At 60 Hz
/// 0.2 s and 3 s. Half: twice the useless searches; twice: surfaces come back twice as late.
constexpr int kRest = 12, kLongestRest = 192;
/// Queries until a pair that has just changed is looked at again: the next places differ little. Half: it may go back
/// and forth each second set; twice: a bad choice lasts eight sets.
constexpr int kSoon = 4;
/// Queries that a pair may end without an answer for want of time (15 ms of new work each) before it rests longer.
/// Half: new places are given up sooner; twice: others wait, as one pair is tried at a time.
constexpr int kMostCold = 6;
/// Levels that the zone shrinks by for want of time; then it is pending. Half: less found at once; twice: zones of a
/// sixth, where waiting one query would give the whole.
constexpr std::size_t kColdLevels = 2;
/// Of what a part and the zone reach: what is farther away by its sphere is not looked at. Nothing asks for more than
/// once. Half: pairs would be missed; twice: twice as many boxes are compared.
constexpr double kFarther = 2.0;

struct Sphere {
  dvec3 center_W;
  double radius;
};

Sphere sphereOf(const ZonePart& part) {
  geometry::Bounds bounds = part.pieces != nullptr ? part.pieces->bounds() : geometry::Bounds();
  if (part.surfaces != nullptr) bounds.add(part.surfaces->bounds());
  return {part.X_W * bounds.center(), bounds.radius()};
}

/// Indices of the environment's parts that count and may come into the zone of a moving one.
std::vector<std::uint32_t> nearParts(std::span<const ZonePart> moving, std::span<const ZonePart> environment,
                                     const ZoneOptions& options) {
  std::vector<Sphere> spheres;
  for (const ZonePart& part : moving) {
    spheres.push_back(sphereOf(part));
    spheres.back().radius += kFarther * (std::max(part.reach, options.radius) + options.safety_distance);
  }
  std::vector<std::uint32_t> near;
  for (std::uint32_t e = 0; e < environment.size(); ++e) {
    const Sphere at = sphereOf(environment[e]);
    for (std::size_t m = 0; m < moving.size(); ++m) {
      if (!options.pair_mask.empty() && options.pair_mask[m * environment.size() + e] == 0) continue;
      if (glm::distance(at.center_W, spheres[m].center_W) > at.radius + spheres[m].radius) continue;
      near.push_back(e);
      break;
    }
  }
  return near;
}

}  // namespace

/// One query under way.
struct ContactFinder::Search {
  Search(SignatureCaches& caches, std::span<const ZonePart> the_moving, std::span<const ZonePart> the_environment,
         const ZoneOptions& the_options, double kept_radius)
      : moving(the_moving),
        environment(the_environment),
        options(the_options),
        surfaces(caches, the_moving, the_environment, the_options) {
    radii.push_back(options.radius);
    while (radii.back() * kShrink >= options.min_radius) radii.push_back(radii.back() * kShrink);
    insert(kept_radius);
  }

  /// Makes it a level of its own, unless there is one about so wide; false then. What was found keeps its level.
  bool insert(double radius) {
    const auto under = std::find_if(radii.begin(), radii.end(), [&](double other) { return other < radius; });
    if (under == radii.begin() || under == radii.end()) return false;
    if (radius > *(under - 1) / kWorthwhile || radius < *under * kWorthwhile) return false;
    if (static_cast<std::size_t>(under - radii.begin()) <= level) ++level;
    radii.insert(under, radius);
    return true;
  }

  /// The level that is so many whole steps wider than what was found, or the widest.
  std::size_t wider(std::size_t steps) const {
    const double wanted = 0.999 * radii[level] / std::pow(kShrink, static_cast<double>(steps));
    std::size_t up = level;
    while (up > 0 && radii[up] < wanted) --up;
    return up;
  }

  FacetQuery& facetQuery() {
    if (!facets) facets.emplace(moving, environment, options);
    return *facets;
  }
  void tell(std::size_t pair, bool by_facets) {
    surface_mask[pair] = by_facets ? 0 : 1;
    facet_mask[pair] = by_facets ? 1 : 0;
  }
  bool any(const std::vector<std::uint8_t>& mask) const {
    return std::any_of(mask.begin(), mask.end(), [](auto one) { return one != 0; });
  }

  /// Its bodies' boxes come within their reach at this zone.
  bool isNear(std::size_t pair, double radius) const {
    const ZonePart &a = moving[pair / environment.size()], &b = environment[pair % environment.size()];
    const double own = a.reach > 0.0 ? a.reach : options.radius;
    const geometry::Bounds near = geometry::transformed(a.X_W, a.surfaces->bounds());
    return overlap(grown(near, own * radius / options.radius + options.safety_distance),
                   geometry::transformed(b.X_W, b.surfaces->bounds()));
  }
  /// It has a round entry there.
  bool isCurved(std::size_t pair, const ZoneContacts& in) const {
    return std::any_of(in.contacts.begin(), in.contacts.end(), [&](const ZoneContact& contact) {
      return contact.M_W != dmat3(0.0) && contact.moving_part * environment.size() + contact.environment_part == pair;
    });
  }
  /// It has entries there.
  bool isMet(std::size_t pair, const ZoneContacts& in) const {
    return std::any_of(in.contacts.begin(), in.contacts.end(), [&](const ZoneContact& contact) {
      return contact.moving_part * environment.size() + contact.environment_part == pair;
    });
  }

  std::span<const ZonePart> moving, environment;
  const ZoneOptions& options;
  SurfaceQuery surfaces;
  std::optional<FacetQuery> facets;  ///< Made when first needed.
  std::vector<PairWay*> ways;        ///< Per pair; null for those that do not count or are far away.
  std::vector<std::uint8_t> surface_mask, facet_mask;
  std::vector<double> radii;  ///< m, from the wanted one down.
  std::size_t level = 0;      ///< Of `found`.
  std::optional<ZoneContacts> found;
  bool crowded = false;
  std::vector<std::size_t> weights;  ///< SurfaceQuery::weights() of what did not fit; empty: nothing did not.
};

ContactFinder::PairWay& ContactFinder::wayOf(const ZonePart& moving, const ZonePart& environment) {
  const auto [found, is_new] = pair_ways_.try_emplace({moving.key, environment.key});
  PairWay& way = found->second;
  if (!is_new) return way;
  const bool known = moving.surfaces != nullptr && environment.surfaces != nullptr && ways_ != Ways::kFacets;
  way.fixed = ways_ != Ways::kBest || !known;
  way.facets = !known;
  way.rest = kRest;
  if (way.fixed) return way;
  const double share =
      std::min(moving.surfaces->surface().recognisedShare(), environment.surfaces->surface().recognisedShare());
  way.mostly_known = share >= kMostlyKnown;
  if (way.mostly_known) return way;
  way.facets = true;
  way.resting = way.rest;
  return way;
}

void ContactFinder::restLonger(PairWay& way) const {
  way.resting = way.rest;
  way.rest = std::min(2 * way.rest, kLongestRest);
  way.cold = 0;
}

std::size_t ContactFinder::startLevel(const Search& search) const {
  const double share = kept_share_ > 0.0 ? kept_share_ : kFirstShare;
  std::size_t level = 0;
  while (level + 1 < search.radii.size() && search.radii[level] > share * search.options.radius * 1.001) ++level;
  return level;
}

std::optional<ZoneContacts> ContactFinder::attempt(Search& search, std::size_t level) {
  const double radius = search.radii[level];
  const std::size_t most = search.options.max_entries;
  ZoneContacts result;
  result.radius = radius;
  if (search.any(search.surface_mask)) {
    search.surfaces.setMask(search.surface_mask);
    auto told = search.surfaces.attempt(radius, most);
    if (!told) search.weights = search.surfaces.isRough() ? std::vector<std::size_t>() : search.surfaces.weights();
    if (!told) return std::nullopt;
    result = std::move(*told);
  }
  if (!search.any(search.facet_mask)) return result;
  FacetQuery& query = search.facetQuery();
  query.setMask(search.facet_mask);
  const double share = radius / search.options.radius;
  const bool crowded = share <= kCrowdedShare && (search.crowded || share < kLeastShare);
  const auto detail = crowded ? FacetQuery::Detail::kAny : FacetQuery::Detail::kTurning;
  auto told = query.attempt(radius, detail, most - result.contacts.size());
  if (!told) {
    search.weights.clear();
    if (2 * result.contacts.size() > most) search.weights = search.surfaces.weights();
    return std::nullopt;
  }
  for (ZoneContact& contact : told->contacts) {
    contact.group += result.groups;
    result.contacts.push_back(contact);
  }
  result.groups += told->groups;
  result.facets = result.facets || !told->contacts.empty();
  result.crowded = told->crowded;
  return result;
}

/// To the next levels above, as long as they fit, and once half a level where the hand may get farther than they say.
void ContactFinder::widen(Search& search) {
  bool halved = false;
  while (search.level > 0) {
    auto larger = attempt(search, search.level - 1);
    if (!larger) {
      const double fits = search.radii[search.level], above = search.radii[search.level - 1];
      if (halved || fits >= search.options.needed_radius || !search.insert(std::sqrt(fits * above))) return;
      halved = true;
      continue;
    }
    search.found = std::move(larger);
    --search.level;
  }
}

/// Facets for these pairs, if they fit a much wider zone than was found; a wider one where all that is met is flat, so
/// that facets tell it as well.
bool ContactFinder::decideByFacets(Search& search, std::span<const std::size_t> pairs) {
  bool curved = !search.found;
  for (const auto pair : pairs) {
    search.tell(pair, true);
    curved = curved || (search.ways[pair]->mostly_known && search.isCurved(pair, *search.found));
  }
  const std::size_t much = curved ? kMuchWider : 1;
  const std::size_t level = !search.found ? search.radii.size() - 1 : search.wider(much);
  auto wider = level < search.level || !search.found ? attempt(search, level) : std::nullopt;
  for (const auto pair : pairs) {
    PairWay& way = *search.ways[pair];
    way.facets = wider.has_value();
    way.resting = kSoon;
    if (!way.facets) search.tell(pair, false);
  }
  if (!wider) return false;
  search.found = std::move(wider);
  search.level = level;
  widen(search);
  return true;
}

/// The pair that takes most goes over to facets, or all that are met do, if that leaves a much wider zone.
void ContactFinder::tryFacets(Search& search, bool narrow) {
  if (search.weights.empty() || search.surfaces.isCold() || search.level == 0) return;
  const auto most = std::max_element(search.weights.begin(), search.weights.end());
  const auto heaviest = static_cast<std::size_t>(most - search.weights.begin());
  PairWay* way = search.ways[heaviest];
  if (way == nullptr || way->fixed || way->facets) return;
  if (!narrow && search.isCurved(heaviest, *search.found)) return;
  if (--way->resting > 0 && search.found) return;
  if (decideByFacets(search, {&heaviest, 1}) || !narrow) return;
  const double radius = search.radii[search.wider(kMuchWider)];
  std::vector<std::size_t> all;
  for (std::size_t pair = 0; pair < search.ways.size(); ++pair) {
    const PairWay* other = search.ways[pair];
    if (other == nullptr || other->fixed || other->facets) continue;
    if (pair == heaviest || search.isNear(pair, radius)) all.push_back(pair);
  }
  if (all.size() > 1) decideByFacets(search, all);
}

/// A pair told by facets goes back to its surfaces where these fit and have something round to tell: soon where the
/// zone is narrow, now and then elsewhere.
void ContactFinder::trySurfaces(Search& search, bool narrow) {
  for (std::size_t pair = 0; pair < search.ways.size(); ++pair) {
    PairWay* way = search.ways[pair];
    if (way == nullptr || way->fixed || !way->facets || !search.isMet(pair, *search.found)) continue;
    if (--way->resting > 0) continue;
    std::size_t level = search.level;
    while (level + 1 < search.radii.size() && search.radii[level + 1] >= kWideEnough * search.options.radius) ++level;
    search.tell(pair, false);
    auto told = attempt(search, level);
    if (told && search.isCurved(pair, *told)) {
      search.found = std::move(told);
      search.level = level;
      way->facets = false;
      way->resting = kSoon;
      way->rest = kRest;
      if (narrow) widen(search);
      return;
    }
    search.tell(pair, true);
    if (!told && search.surfaces.isCold() && ++way->cold <= kMostCold) return;
    restLonger(*way);
    return;  // One at a time.
  }
}

ZoneContacts ContactFinder::lastResort(Search& search) {
  ZoneContacts none;
  if (!search.options.only_complete && search.any(search.facet_mask) && !search.any(search.surface_mask))
    none = search.facetQuery().nearestOnly(search.options.min_radius, search.options.max_entries);
  none.radius = search.options.min_radius;
  none.complete = false;
  none.pending = search.surfaces.isCold();
  return none;
}

ZoneContacts ContactFinder::find(std::span<const ZonePart> moving, std::span<const ZonePart> environment,
                                 const ZoneOptions& options) {
  HAPTICELL_DEMAND(options.pair_mask.empty() || options.pair_mask.size() == moving.size() * environment.size());
  HAPTICELL_DEMAND(options.radius > 0.0 && options.max_entries > 0);
  const std::vector<std::uint32_t> near = nearParts(moving, environment, options);
  std::vector<ZonePart> parts;
  for (const std::uint32_t e : near) parts.push_back(environment[e]);
  std::vector<std::uint8_t> mask;
  if (!options.pair_mask.empty()) {
    for (std::size_t m = 0; m < moving.size(); ++m) {
      for (const std::uint32_t e : near) mask.push_back(options.pair_mask[m * environment.size() + e]);
    }
  }
  ZoneOptions of_near = options;
  of_near.pair_mask = mask;
  ZoneContacts found = findAmong(moving, parts, of_near);
  for (ZoneContact& contact : found.contacts) contact.environment_part = near[contact.environment_part];
  return found;
}

ZoneContacts ContactFinder::findAmong(std::span<const ZonePart> moving, std::span<const ZonePart> environment,
                                      const ZoneOptions& options) {
  Search search(caches_, moving, environment, options, kept_share_ * options.radius);
  search.crowded = crowded_;
  search.surfaces.setMayFallBack(ways_ == Ways::kBest);
  search.ways.assign(moving.size() * environment.size(), nullptr);
  search.surface_mask.assign(search.ways.size(), 0);
  search.facet_mask.assign(search.ways.size(), 0);
  for (std::size_t pair = 0; pair < search.ways.size(); ++pair) {
    if (!options.pair_mask.empty() && options.pair_mask[pair] == 0) continue;
    search.ways[pair] = &wayOf(moving[pair / environment.size()], environment[pair % environment.size()]);
    search.tell(pair, search.ways[pair]->facets);
  }
  search.level = startLevel(search);
  search.found = attempt(search, search.level);
  bool is_widest = !search.found;
  // A hand that may run into the zone's edge before the set after this one cannot wait long for a wider one.
  const bool hurried = search.found && search.radii[search.level] < options.needed_radius;
  if (search.found && (kept_share_ <= 0.0 || ++since_larger_ >= (hurried ? 1 : kTryLarger))) {
    since_larger_ = hurried ? 1 - kTryLarger : 0;  // In vain, unless it fits.
    const std::size_t before = search.level;
    widen(search);
    is_widest = true;
    if (search.level < before || search.surfaces.isCold()) since_larger_ = kTryLarger;  // There may be more.
  }
  const std::size_t started = search.level;
  while (!search.found && search.level + 1 < search.radii.size()) {
    if (search.surfaces.isCold() && search.level >= started + kColdLevels) break;
    search.found = attempt(search, ++search.level);
  }
  const bool narrow = !search.found || search.radii[search.level] < kWideEnough * options.radius;
  if (is_widest) tryFacets(search, narrow);
  if (search.found) trySurfaces(search, narrow);
  ZoneContacts result = search.found ? std::move(*search.found) : lastResort(search);
  if (!result.pending) kept_share_ = result.radius / options.radius;
  crowded_ = result.crowded;
  result.work = 1 + search.surfaces.work() + (search.facets ? search.facets->work() : 0);
  return result;
}

}  // namespace hapticell::collision
