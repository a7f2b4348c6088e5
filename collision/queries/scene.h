// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "collision/queries/inner_balls.h"
#include "collision/queries/motion_check.h"
#include "collision/queries/placed_bounds.h"
#include "collision/queries/proximity_query.h"
#include "collision/queries/scene_pairs.h"
#include "collision/trees/part_tree.h"

namespace hapticell::collision {

/// What a part belongs to: an entity of the document (its id) and, for a robot, the link (0 for a solid).
struct PartKey {
  std::uint64_t entity = 0;
  std::uint32_t part = 0;
  bool operator==(const PartKey&) const = default;
};

/// The distance of one pair: A is its moved part, B the part that A is checked against.
struct PairDistance {
  PairIndex pair = 0;
  DistanceResult result;
};

/// A part that moves in advance().
struct MovedPart {
  PartIndex part = 0;
  PartMotion motion;
};

/// The stop of a scene's motion.
struct SceneStop {
  double s = 1.0;
  bool stopped = false;
  bool began_colliding = false;  ///< Some pair collided at s = 0.
  PairIndex pair = 0;            ///< The pair that stops it; `nearest` belongs to this pair.
  DistanceResult nearest;
};

/// Parts placed in the world and the pairs of them that are checked: moved against environment, link against link.
///
/// A tree of the parts' boxes finds what is near, so the cost of a query depends on the parts that are near, not on the
/// number of parts. Pairs of sets that never come near cost nothing. Every pair that came near keeps its warm query and
/// its last distance. That distance minus the path lengths of its parts since then is a lower bound, which answers most
/// queries after small steps. Queries that look for one pair share one upper bound. Belongs to one thread, which may
/// edit it between two queries; another thread builds colliders and hands them over. Warm queries do not allocate,
/// except to append to the caller's vectors; a pair that comes near for the first time does. Pairs that are disabled,
/// or whose part is removed, are skipped.
class Scene {
 public:
  /// Adds a part at X_WP; an empty mesh is allowed. Indices of removed parts are used again.
  PartIndex addPart(const PartKey& key, std::shared_ptr<const MeshCollider> collider, const Pose& X_WP = {});
  /// Removes the part and every pair with it. Other pairs keep their state but may change their index.
  void removePart(PartIndex part);
  void setPose(PartIndex part, const Pose& X_WP);
  const Pose& pose(PartIndex part) const { return parts_[part].X_WP; }
  const PartKey& key(PartIndex part) const { return parts_[part].key; }
  const MeshCollider& collider(PartIndex part) const { return *parts_[part].collider; }
  const std::shared_ptr<const MeshCollider>& sharedCollider(PartIndex part) const { return parts_[part].collider; }

  /// Adds a pair that is checked; the caller chooses `tag` (for example the number of its pair set). A part is never
  /// paired with itself, and two parts are one pair at most, either way round: added again it gets the new tag.
  PairIndex addPair(PartIndex moved, PartIndex environment, std::uint32_t tag = 0);
  /// Checks each part of the first list against each part of the second, never against itself. Memory and time depend
  /// only on the pairs that are near. Such a pair gets its index when it first comes near. 64 sets at most; of several
  /// the later tag counts.
  void addPairs(std::span<const PartIndex> moved, std::span<const PartIndex> environment, std::uint32_t tag = 0);
  void clearPairs();
  /// Pairs that have an index: 0 to pairCount() - 1.
  std::size_t pairCount() const { return pairs_.size(); }
  /// The pair of these two, either way round, that addPair() or addPairs() added; it has an index from now on.
  std::optional<PairIndex> pairOf(PartIndex a, PartIndex b);
  PartIndex moved(PairIndex pair) const { return pairs_[pair].moved; }
  PartIndex environment(PairIndex pair) const { return pairs_[pair].environment; }
  std::uint32_t tag(PairIndex pair) const { return pairs_[pair].tag; }
  void setEnabled(PairIndex pair, bool enabled);
  bool isEnabled(PairIndex pair) const { return pairs_[pair].enabled; }

  /// The nearest of all pairs, if any is nearer than `limit` (m). Pairs that collide come before all others.
  std::optional<PairDistance> nearest(double limit = std::numeric_limits<double>::infinity());
  /// The same, exact only up to demand.exact_within.
  std::optional<PairDistance> nearest(const DistanceDemand& demand);

  /// Appends every pair whose distance is below `margin` (m), each with its exact distance, nearest first.
  void pairsWithin(double margin, std::vector<PairDistance>& found);

  /// Whether any pair collides; ends at the first.
  bool collides();

  /// The exact distance of one pair (`limit` as in ProximityQuery).
  DistanceResult distance(PairIndex pair, double limit = std::numeric_limits<double>::infinity());

  /// How far the parts may move together, every pair keeping `clearance` (m) as advance() of one pair does. Parts that
  /// are not listed do not move. The poses of the scene are not changed. A part is listed once.
  SceneStop advance(std::span<const MovedPart> moved, double clearance);

  /// A pair that does not surely keep its clearance everywhere on this motion; empty: all of them do, both ends
  /// included. `clearance` (m) is by the tag of the pair, one for each tag that is used. Proven by halving: pairs that
  /// keep it by less than a tenth of it (at least 0.1 mm) may be found too; with a clearance of 0 only those that
  /// advance() would stop. Parts that do not move (path_bound 0) are checked only if `standing`. The poses of the scene
  /// are not changed. A part is listed once.
  std::optional<PairIndex> findNearer(std::span<const MovedPart> moved, std::span<const double> clearance,
                                      bool standing);

 private:
  struct Part {
    PlacedBounds at;         ///< See boundsOf().
    bool has_moved = false;  ///< `at` is of an earlier pose.
    double travelled = 0.0;  ///< m: upper bound of the path length of its points since it was added.
    double asked_at = 0.0;   ///< Its path length when collides() last searched around it,
    double look = 0.0;       ///< and the search radius (m).
    /// No checked partner is nearer than this value (m) minus the path lengths of this part and of the sought parts.
    double quiet_until = -std::numeric_limits<double>::infinity();
    double clear = 0.0;          ///< Search radius of the last round that searched around it: nothing was nearer (m).
    std::uint32_t asked_in = 0;  ///< That round.
    double way_of_round = 0.0;   ///< Its path length between two queries.
    std::uint32_t round = 0;
    bool empty = true;  ///< No triangle, or removed.
    Pose X_WP;
    PartKey key;
    std::shared_ptr<const MeshCollider> collider;  ///< Null once removed.
    std::shared_ptr<InnerBallsOnDemand> balls;     ///< Shared by all parts of this collider.
  };
  struct Candidate {
    double lower_bound;
    PairIndex pair;
  };
  /// A place on a motion.
  struct Station {
    Pose X_WP;
    PlacedBounds at;
  };
  /// Of so many stretches middle and spread are kept. Instead of a middle 0 has the end, asked for as kEndNode.
  static constexpr std::size_t kStations = 16;
  static constexpr std::size_t kEndNode = ~std::size_t{0};
  /// A stretch of a motion; number 1 is the whole, 2 and 3 its halves, 4 to 7 its quarters.
  struct Stretch {
    double from, to;
    std::size_t node;
    double middle() const { return 0.5 * (from + to); }
    bool isKept() const { return node > 0 && node < kStations; }
  };
  /// Where any point of a part is on a stretch: where it is in its middle, moved by some share from -1 to 1 of
  /// sweep.d_W, and by as much again in any direction as `rest` (m). With the sweep's turn what is left is `bent` (m).
  struct Spread {
    PartSweep sweep;
    double rest = 0.0, bent = 0.0;
  };
  /// A part of advance(). Its 4 KB are used again by the next motion.
  struct Swept {
    PartIndex part = 0;
    const PartMotion* motion = nullptr;
    Pose X_WBegin, X_WEnd;
    PlacedBounds begin;  ///< See beginOf().
    bool knows_begin = false;
    std::uint32_t known_stations = 0, known_spreads = 0;  ///< Bits: those that were asked for.
    std::array<Station, kStations> stations{};
    std::array<Spread, kStations> spread{};
  };

  /// One of a pair in advance().
  struct Mover {
    PartIndex part = 0;
    Swept* swept = nullptr;             ///< Null: it does not move,
    const Pose* X_WStanding = nullptr;  ///< but is here.
    double pathBound() const { return swept == nullptr ? 0.0 : swept->motion->path_bound; }
    Pose at(double s) const { return swept == nullptr ? *X_WStanding : swept->motion->at(s); }
    /// `scratch` is filled for one that does not move.
    const PartMotion& motion(PartMotion& scratch) const {
      if (swept == nullptr) scratch = standingStill(*X_WStanding);
      return swept == nullptr ? scratch : *swept->motion;
    }
  };
  /// Where a part is on its motion.
  struct Place {
    const Pose& X_WP;
    const PlacedBounds& at;
  };

  /// A pair on a stretch of a motion on which it is not yet known to keep its clearance.
  struct Unproven {
    Stretch stretch;
    PairIndex pair;
    double way;  ///< m: bound of both paths on the whole motion.
    Spread of_moved{}, of_environment{};
    double margin = 0.0;  ///< m: without their turns they are too near within this.
    double length() const { return way * (stretch.to - stretch.from); }
    dvec3 sweep_W() const { return of_moved.sweep.d_W - of_environment.sweep.d_W; }
  };

  static geometry::Bounds sweptBox(const Swept& swept);

  /// Where the part is now. It is placed only when asked for, because most moving parts are never needed.
  const PlacedBounds& boundsOf(PartIndex index) {
    Part& part = parts_[index];
    if (part.has_moved) part.at = placedBounds(*part.collider, part.X_WP);
    part.has_moved = false;
    return part.at;
  }
  void keepInTree(PartIndex part);
  void travel(PartIndex part, const Pose& X_WP);
  void forgetQuiet(PartIndex part) { parts_[part].quiet_until = -std::numeric_limits<double>::infinity(); }
  void beginQuery();
  double way(const ScenePairs::Pair& pair) const;
  /// Distance of the two (m) here, or slightly less, because the search prunes in float.
  void certify(ScenePairs::Pair& pair, double distance) const {
    pair.apart_until = (1.0 - 1e-6) * distance - kTouchingDistance + way(pair);
  }
  ProximityQuery& queryOf(ScenePairs::Pair& pair);
  DistanceResult query(PairIndex pair, const DistanceDemand& demand);

  bool isQuiet(const Part& part) const { return part.quiet_until - part.travelled - sought_way_ > kTouchingDistance; }
  double lookAhead(const Part& part) const;
  void lookAround(PartIndex part);
  void suspect(PartIndex seeker, PartIndex other);
  bool collide(ScenePairs::Pair& pair, Part& seeker);
  bool ballsMeet(ScenePairs::Pair& pair);
  double boxesApart(ScenePairs::Pair& pair);
  void gather(double margin);
  void measure(PairIndex pair, DistanceDemand& left, std::optional<PairDistance>& best);
  void searchNearest(double margin, DistanceDemand& left, std::optional<PairDistance>& best);
  double extent();

  void prepareMotion(std::span<const MovedPart> moved, double clearance, bool standing = false);
  void addMotionPair(Swept& swept, PartIndex other, double clearance, bool standing);
  const PlacedBounds& beginOf(Swept& swept) const;
  static double leastOf(const ScenePairs::Pair& pair, std::span<const double> clearance);
  static bool isLong(const Unproven& one, double least);
  std::optional<PairIndex> nearerAtEnd(std::span<const double> clearance);
  std::optional<PairIndex> listUnproven(std::span<const double> clearance);
  std::optional<PairIndex> lookAtMiddles(std::span<const double> clearance);
  std::optional<PairIndex> proveOrHalve(std::span<const double> clearance);
  Mover moverOf(PartIndex part);
  Place placeOf(const Mover& mover, std::size_t node, double s, Station& scratch);
  Spread spreadOf(const Mover& mover, const Stretch& stretch, const Place& middle) const;
  std::span<Swept> swept() { return {swept_.data(), swept_count_}; }
  void endMotion();
  MotionStop follow(ProximityQuery& query, const Mover& moved, const Mover& met, double gap,
                    const MotionDemand& demand);
  SceneStop stopOnce(double clearance, double until);

  std::vector<Part> parts_;
  std::vector<PartIndex> unused_;
  std::unordered_map<const MeshCollider*, std::weak_ptr<InnerBallsOnDemand>> balls_;
  ScenePairs pairs_;
  PartTree tree_;            ///< Of the parts that are sought.
  double sought_way_ = 0.0;  ///< m: upper bound of their path lengths, summed over the rounds.
  double sought_way_of_round_ = 0.0, sought_step_ = 0.0;  ///< Of the present round, and of the last.
  std::uint32_t round_ = 0;                               ///< Queries until now.
  std::uint32_t pass_ = 0;                                ///< Searches until now, for Pair::seen.
  PartIndex nearest_of_[2] = {0, 0}, met_[2] = {0, 0};    ///< The pairs of the last answers, by their parts.

  std::vector<Candidate> candidates_;
  std::vector<Unproven> unproven_, halves_;  ///< Of findNearer().
  struct Suspect {
    double gap;
    PairIndex pair;
    PartIndex seeker;
  };
  std::vector<Suspect> suspects_;
  std::vector<Swept> swept_;  ///< Those of the present motion are the first swept_count_.
  std::size_t swept_count_ = 0;
  std::vector<std::uint32_t> swept_of_;  ///< For each part: its index in swept_ plus one; 0: it does not move.
};

}  // namespace hapticell::collision
