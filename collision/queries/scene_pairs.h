// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "collision/queries/pair_table.h"
#include "collision/queries/proximity_query.h"

namespace hapticell::collision {

/// Indices of parts and pairs within one Scene; valid until the part or the pairs are removed.
using PartIndex = std::uint32_t;
using PairIndex = std::uint32_t;

/// The query of a pair, made when it is first needed. A copy makes its own: a query keeps what it found last.
class LazyQuery {
 public:
  LazyQuery() = default;
  LazyQuery(const LazyQuery&) {}
  LazyQuery(LazyQuery&&) noexcept = default;
  LazyQuery& operator=(const LazyQuery&) {
    made_.reset();
    return *this;
  }
  LazyQuery& operator=(LazyQuery&&) noexcept = default;
  ~LazyQuery() = default;

  ProximityQuery& of(const std::shared_ptr<const MeshCollider>& moved,
                     const std::shared_ptr<const MeshCollider>& environment) {
    if (!made_) made_ = std::make_unique<ProximityQuery>(moved, environment);
    return *made_;
  }

 private:
  std::unique_ptr<ProximityQuery> made_;
};

/// The pairs of a Scene: those named one by one, and those of sets of parts, which cost nothing until they come near.
/// One thread.
class ScenePairs {
 public:
  static constexpr PairIndex kNone = PairTable::kNone;
  /// Sets of one scene: a bit each.
  static constexpr std::size_t kMostSets = 64;

  struct Pair {
    PartIndex moved = 0;
    PartIndex environment = 0;
    std::uint32_t tag = 0;
    bool enabled = true;
    std::uint32_t seen = 0;  ///< The last query that visited this pair, so that each is visited once.
    /// Lower bound of the distance: this value minus the path lengths of both parts (m); see Scene.
    double apart_until = -std::numeric_limits<double>::infinity();
    /// They are near: up to this sum of path lengths (m) a wider search would not help.
    double near_until = -std::numeric_limits<double>::infinity();
    LazyQuery query{};
    std::uint32_t at_moved = 0, at_environment = 0;  ///< Places in the lists of its parts.
  };

  Pair& operator[](PairIndex pair) { return pairs_[pair]; }
  const Pair& operator[](PairIndex pair) const { return pairs_[pair]; }
  std::size_t size() const { return pairs_.size(); }

  /// See Scene::addPair() and addPairs().
  PairIndex add(PartIndex moved, PartIndex environment, std::uint32_t tag);
  void addSet(std::span<const PartIndex> moved, std::span<const PartIndex> environment, std::uint32_t tag);
  /// The pair of these two if it has an index already; else kNone.
  PairIndex known(PartIndex a, PartIndex b) const { return a == b ? kNone : table_.find(a, b); }
  /// The pair of these two, given an index if a set has them; kNone where they are no pair.
  PairIndex find(PartIndex a, PartIndex b);
  void removePart(PartIndex part);
  void clear();
  /// Makes all stored distances of its pairs invalid.
  void forgetDistances(PartIndex part);

  /// Parts that search for others, and what they search for: in a pair the moved part searches, in a set the smaller
  /// side.
  const std::vector<PartIndex>& seekers() const { return seekers_; }
  bool isSought(PartIndex part) const { return part < roles_.size() && roles_[part].sought; }
  /// False: they are surely no pair, as a part and itself.
  bool mayBePair(PartIndex a, PartIndex b) const {
    return a != b && ((isSeeker(a) && isSought(b)) || (isSeeker(b) && isSought(a)));
  }
  bool isSeeker(PartIndex part) const { return part < roles_.size() && roles_[part].seeks; }

 private:
  struct Roles {
    std::uint64_t moved_in = 0, environment_in = 0;  ///< Sets, a bit each.
    bool seeks = false, sought = false;
    std::vector<PairIndex> pairs;  ///< With an index.
  };

  Roles& rolesOf(PartIndex part);
  void setSeeks(PartIndex part);
  PairIndex make(PartIndex moved, PartIndex environment, std::uint32_t tag);
  void unlist(PartIndex part, std::uint32_t at);
  void remove(PairIndex pair);

  std::vector<Pair> pairs_;
  PairTable table_;
  std::vector<Roles> roles_;  ///< Of each part.
  std::vector<PartIndex> seekers_;
  std::vector<std::uint32_t> set_tags_;
};

}  // namespace hapticell::collision
