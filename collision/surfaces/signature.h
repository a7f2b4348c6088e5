// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace hapticell::collision {

/// A set of elements, by their indices in the cell's list.
struct Signature {
  /// Surfaces within reach of one cell, six words of bits: more than fit into 64 entries of a set. Half: places with
  /// many small ones shrink the zone more; twice: all signatures twice as long.
  static constexpr std::size_t kMostElements = 384;
  void add(std::size_t i) { words[i / 64] |= std::uint64_t{1} << (i % 64); }
  bool has(std::size_t i) const { return (words[i / 64] >> (i % 64) & 1) != 0; }
  std::array<std::uint64_t, kMostElements / 64> words{};
  bool operator==(const Signature&) const = default;
  bool operator<(const Signature& other) const { return words < other.words; }
  int count() const {
    int sum = 0;
    for (const auto word : words) sum += std::popcount(word);
    return sum;
  }
  bool contains(const Signature& other) const {
    for (std::size_t i = 0; i < words.size(); ++i) {
      if ((other.words[i] & ~words[i]) != 0) return false;
    }
    return true;
  }
};

struct SignatureHash {
  std::size_t operator()(const Signature& signature) const {
    std::uint64_t h = 0;
    for (const auto word : signature.words) h = (h ^ word) * 0xff51afd7ed558ccdull, h ^= h >> 32;
    return h;
  }
};

}  // namespace hapticell::collision
