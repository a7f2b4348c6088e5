// SPDX-License-Identifier: Apache-2.0
#include "studies/variants/low_discrepancy.h"

#include <array>
#include <boost/random/sobol.hpp>
#include <cmath>

#include "geometry/system/assertion.h"

namespace hapticell::studies {

namespace {

constexpr std::array<unsigned, kMostDimensions> kPrimes{
    2,   3,   5,   7,   11,  13,  17,  19,  23,  29,  31,  37,  41,  43,  47,  53,  59,
    61,  67,  71,  73,  79,  83,  89,  97,  101, 103, 107, 109, 113, 127, 131, 137, 139,
    149, 151, 157, 163, 167, 173, 179, 181, 191, 193, 197, 199, 211, 223, 227, 229};

/// The digits of `index` in a base, mirrored behind the point.
double radicalInverse(std::size_t index, unsigned base) {
  double value = 0.0, unit = 1.0;
  for (; index > 0; index /= base) {
    unit /= base;
    value += unit * static_cast<double>(index % base);
  }
  return value;
}

void shift(std::vector<double>& sample, std::uint64_t seed) {
  for (std::size_t i = 0; seed != 0 && i < sample.size(); ++i) {
    sample[i] += unitNumber(seed, i);
    sample[i] -= std::floor(sample[i]);
    if (sample[i] >= 1.0) sample[i] = 0.0;
  }
}

}  // namespace

double unitNumber(std::uint64_t seed, std::uint64_t index) {
  std::uint64_t z = seed * 0xD1342543DE82EF95ULL + (index + 1) * 0x9E3779B97F4A7C15ULL;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
  z ^= z >> 31;
  return static_cast<double>(z >> 11) * 0x1.0p-53;
}

std::vector<double> haltonSample(std::size_t index, std::size_t dimensions, std::uint64_t seed) {
  HAPTICELL_DEMAND(dimensions <= kMostDimensions);
  std::vector<double> sample(dimensions);
  // Sample 0 would be the corner of all ranges.
  for (std::size_t i = 0; i < dimensions; ++i) sample[i] = radicalInverse(index + 1, kPrimes[i]);
  shift(sample, seed);
  return sample;
}

std::vector<double> sobolSample(std::size_t index, std::size_t dimensions, std::uint64_t seed) {
  HAPTICELL_DEMAND(dimensions <= kMostDimensions);
  std::vector<double> sample(dimensions);
  if (dimensions == 0) return sample;
  boost::random::sobol engine(dimensions);
  engine.discard(index * dimensions);
  for (double& number : sample) number = static_cast<double>(engine() >> 11) * 0x1.0p-53;
  shift(sample, seed);
  return sample;
}

}  // namespace hapticell::studies
