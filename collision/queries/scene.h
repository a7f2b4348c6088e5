// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "collision/queries/motion_check.h"
#include "collision/queries/proximity_query.h"

namespace hapticell::collision {

/// What a part belongs to: an entity of the document (its id) and, for a robot, the link (0 for a solid).
struct PartKey {
  std::uint64_t entity = 0;
  std::uint32_t part = 0;
  bool operator==(const PartKey&) const = default;
};

/// Indices of parts and pairs within one Scene; valid until the part or the pairs are removed.
using PartIndex = std::uint32_t;
using PairIndex = std::uint32_t;

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
/// Every pair keeps its warm query. Queries process the pairs in the order of a cheap lower bound (spheres and root
/// boxes) and share one upper bound, so distant pairs cost almost nothing. Belongs to one thread, which may edit it
/// between two queries; another thread builds colliders and hands them over. Warm queries do not allocate, except to
/// append to the caller's vectors. Pairs that are disabled, or whose part is removed, are skipped.
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
  /// paired with itself.
  PairIndex addPair(PartIndex moved, PartIndex environment, std::uint32_t tag = 0);
  void clearPairs();
  std::size_t pairCount() const { return pairs_.size(); }
  PartIndex moved(PairIndex pair) const { return pairs_[pair].moved; }
  PartIndex environment(PairIndex pair) const { return pairs_[pair].environment; }
  std::uint32_t tag(PairIndex pair) const { return pairs_[pair].tag; }
  void setEnabled(PairIndex pair, bool enabled) { pairs_[pair].enabled = enabled; }
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
  /// are not listed do not move. The poses of the scene are not changed.
  SceneStop advance(std::span<const MovedPart> moved, double clearance);

 private:
  struct Part {
    PartKey key;
    std::shared_ptr<const MeshCollider> collider;  ///< Null once removed.
    Pose X_WP;
    dvec3 center_W{0.0};
    OrientedBox root_W;
  };
  struct Pair {
    PartIndex moved;
    PartIndex environment;
    std::uint32_t tag;
    bool enabled;
    ProximityQuery query;
  };
  struct Candidate {
    double lower_bound;
    PairIndex pair;
  };

  void place(Part& part, const Pose& X_WP);
  double lowerBound(const Pair& pair) const;
  const std::vector<Candidate>& candidatesWithin(double margin);
  DistanceResult query(PairIndex pair, double limit);
  void prepareMotion(std::span<const MovedPart> moved, double clearance);
  SceneStop stopOnce(double clearance, double until);

  std::vector<Part> parts_;
  std::vector<Pair> pairs_;
  std::vector<Candidate> candidates_;
  std::vector<PartMotion> standing_;
  std::vector<const PartMotion*> motions_;
};

}  // namespace hapticell::collision
