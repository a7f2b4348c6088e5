// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "studies/document/study_document.h"
#include "studies/variants/variation.h"

namespace hapticell::studies {

/// The variants of a study by number: which values each has. Immutable; any thread.
///
/// Work is shared out by units: a unit is one variant, or a whole search from one start, whose variants follow from each
/// other. Unit u has the variants from u * variantsPerUnit() on.
class VariantSpace {
 public:
  /// `variations` outlive it. Errors: more than 1e7 variants, lists of different lengths for kList, ranges that a
  /// sampling cannot use.
  static Expected<VariantSpace> create(const StudyDocument& document,
                                       const std::vector<std::unique_ptr<Variation>>& variations);

  std::size_t units() const { return units_; }
  std::size_t variantsPerUnit() const { return per_unit_; }
  /// Of all units; a search may end before it has used all of its numbers.
  std::size_t count() const { return units_ * per_unit_; }
  bool isSearch() const { return sampling_ == Sampling::kSearch; }

  /// One value a variation. @pre !isSearch(), number < count()
  std::vector<Value> values(std::size_t number) const;

  /// Indices of the variations that a search changes; the others are lists.
  const std::vector<std::size_t>& searched() const { return searched_; }
  /// The place where the search of a unit begins, as shares of the ranges of searched(): the middles for the first
  /// start, then low-discrepancy samples. @pre isSearch()
  std::vector<double> searchStart(std::size_t unit) const;
  /// The values for shares of the searched ranges in one unit. @pre isSearch()
  std::vector<Value> searchValues(std::size_t unit, const std::vector<double>& shares) const;

 private:
  /// The values of the listed variations for a number among all their combinations; the first varies slowest.
  void setListed(std::size_t combination, const std::vector<std::size_t>& which, std::vector<Value>& values) const;
  std::size_t combinations(const std::vector<std::size_t>& which) const;

  std::vector<const Variation*> variations_;
  Sampling sampling_ = Sampling::kGrid;
  std::uint64_t seed_ = 0;
  std::size_t units_ = 0, per_unit_ = 1, starts_ = 1;
  std::vector<std::size_t> searched_, listed_;
};

/// The units of chunk `chunk` of `chunks`, counted from 1: [begin, end). Together the chunks have each unit once.
struct ChunkUnits {
  std::size_t begin = 0, end = 0;
};
/// @pre 1 <= chunk <= chunks
ChunkUnits unitsOfChunk(std::size_t units, std::size_t chunk, std::size_t chunks);

}  // namespace hapticell::studies
