// SPDX-License-Identifier: Apache-2.0
#include "studies/variants/variant_space.h"

#include <algorithm>

#include "geometry/system/assertion.h"
#include "studies/document/study_section.h"
#include "studies/variants/low_discrepancy.h"

namespace hapticell::studies {

namespace {

/// Of one study; a results file has a row for each. Half: some full grids must be coarser; twice: results of tens of
/// gigabytes.
constexpr double kMostVariants = 1e7;

}  // namespace

Expected<VariantSpace> VariantSpace::create(const StudyDocument& document,
                                            const std::vector<std::unique_ptr<Variation>>& variations) {
  VariantSpace space;
  space.sampling_ = document.sampling;
  space.seed_ = document.seed;
  const auto refused = [&](std::size_t variation, Text found, Text expected) {
    return makeError(document.variations[variation].fault(std::move(found), std::move(expected)));
  };
  double units = 1.0;
  for (std::size_t i = 0; i < variations.size(); ++i) {
    space.variations_.push_back(variations[i].get());
    const ValueRange& range = variations[i]->range();
    const std::size_t count = range.count();
    switch (document.sampling) {
      case Sampling::kGrid:
        if (count == 0) return refused(i, Text("a range without steps"), Text("steps for a full grid, or [sampling]"));
        units *= static_cast<double>(count);
        break;
      case Sampling::kList:
        if (count == 0) return refused(i, Text("a range without steps"), Text("as many values as the others"));
        if (i > 0 && static_cast<double>(count) != units)
          return refused(i, Text("%1 values", count), Text("%1, as the others", static_cast<std::size_t>(units)));
        units = static_cast<double>(count);
        break;
      case Sampling::kHalton:
      case Sampling::kSobol: units = static_cast<double>(document.samples); break;
      case Sampling::kSearch:
        if (range.isNormal()) return refused(i, Text("a tolerance in a search"), Text("a list or a range"));
        if (range.isContinuous()) {
          space.searched_.push_back(i);
        } else {
          space.listed_.push_back(i);
          units *= static_cast<double>(count);
        }
        break;
    }
    if (units > kMostVariants)
      return makeError({.file = document.file.string(),
                        .found = "more than 10 000 000 variants",
                        .expected = "fewer values, or samples"});
  }
  if (variations.size() > kMostDimensions)
    return makeError({.file = document.file.string(),
                      .found = Text("%1 things that vary", variations.size()),
                      .expected = Text("at most %1", kMostDimensions)});
  if (space.isSearch()) {
    if (space.searched_.empty())
      return makeError({.file = document.file.string(),
                        .found = "a search without a range",
                        .expected = "at least one [[vary]] with from and to, without steps"});
    space.starts_ = document.search.starts;
    space.per_unit_ = document.search.evaluations;
    units *= static_cast<double>(space.starts_);
    if (units * static_cast<double>(space.per_unit_) > kMostVariants)
      return makeError({.file = document.file.string(),
                        .found = "more than 10 000 000 variants",
                        .expected = "fewer starts or evaluations"});
  }
  space.units_ = static_cast<std::size_t>(units);
  return space;
}

std::size_t VariantSpace::combinations(const std::vector<std::size_t>& which) const {
  std::size_t count = 1;
  for (const std::size_t i : which) count *= variations_[i]->range().count();
  return count;
}

void VariantSpace::setListed(std::size_t combination, const std::vector<std::size_t>& which,
                             std::vector<Value>& values) const {
  for (std::size_t k = which.size(); k-- > 0;) {
    const ValueRange& range = variations_[which[k]]->range();
    values[which[k]] = range.at(combination % range.count());
    combination /= range.count();
  }
}

std::vector<Value> VariantSpace::values(std::size_t number) const {
  HAPTICELL_DEMAND(!isSearch() && number < count());
  std::vector<Value> values(variations_.size());
  if (sampling_ == Sampling::kGrid) {
    std::vector<std::size_t> all(variations_.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    setListed(number, all, values);
    return values;
  }
  std::vector<double> sample;
  if (sampling_ == Sampling::kHalton) sample = haltonSample(number, values.size(), seed_);
  if (sampling_ == Sampling::kSobol) sample = sobolSample(number, values.size(), seed_);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const ValueRange& range = variations_[i]->range();
    values[i] = sampling_ == Sampling::kList ? range.at(number) : range.atShare(sample[i]);
  }
  return values;
}

std::vector<double> VariantSpace::searchStart(std::size_t unit) const {
  const std::size_t start = unit % starts_;
  if (start == 0) return std::vector<double>(searched_.size(), 0.5);
  return haltonSample(start - 1, searched_.size(), seed_);
}

std::vector<Value> VariantSpace::searchValues(std::size_t unit, const std::vector<double>& shares) const {
  std::vector<Value> values(variations_.size());
  setListed(unit / starts_, listed_, values);
  for (std::size_t k = 0; k < searched_.size(); ++k) {
    const ValueRange& range = variations_[searched_[k]]->range();
    values[searched_[k]] = range.from() + std::clamp(shares[k], 0.0, 1.0) * (range.to() - range.from());
  }
  return values;
}

ChunkUnits unitsOfChunk(std::size_t units, std::size_t chunk, std::size_t chunks) {
  HAPTICELL_DEMAND(chunk >= 1 && chunk <= chunks);
  return {units * (chunk - 1) / chunks, units * chunk / chunks};
}

}  // namespace hapticell::studies
