// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hapticell::studies {

/// Most numbers that one sample may have.
inline constexpr std::size_t kMostDimensions = 50;

/// Sample `index` of the Halton sequence (Halton 1960) in `dimensions` numbers of [0, 1), shifted modulo 1 by amounts
/// that `seed` decides (Cranley and Patterson 1976); seed 0: not shifted. Any thread.
/// @pre dimensions <= kMostDimensions
std::vector<double> haltonSample(std::size_t index, std::size_t dimensions, std::uint64_t seed);

/// The same of the Sobol sequence (Sobol 1967, direction numbers of Boost).
std::vector<double> sobolSample(std::size_t index, std::size_t dimensions, std::uint64_t seed);

/// The number of [0, 1) that `seed` and `index` decide: SplitMix64 (Steele, Lea, Flood 2014). Equal on all machines.
double unitNumber(std::uint64_t seed, std::uint64_t index);

}  // namespace hapticell::studies
