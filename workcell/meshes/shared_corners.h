// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::workcell {

/// Makes vertices of the corners of a soup: corners of the same bits are one vertex, numbered in the order of their
/// first corners. A tenth of a soup's memory, and welding finds the same.
class SharedCorners {
 public:
  /// Makes room for that many vertices, so that fewer cost nothing beside their own.
  void reserve(std::size_t vertices);
  /// The number of the vertex at p.
  std::uint32_t add(const dvec3& p);
  /// The same for many, in a fraction of the time: what they need of the memory is fetched beforehand.
  void add(std::span<const dvec3> points, std::uint32_t* numbers);

  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  /// The numbers of those that are vertices, kNone for the others. Several threads at once.
  void find(std::span<const dvec3> points, std::uint32_t* numbers) const;
  /// Makes vertices of the different places for which find() said kNone, and gives them their numbers. `last`: nothing
  /// is added or sought any more, which saves half.
  void addMissing(std::span<const dvec3> points, std::uint32_t* numbers, bool last);

  const std::vector<dvec3>& vertices() const { return vertices_; }
  std::vector<dvec3> take() { return std::move(vertices_); }

 private:
  struct Slot {
    std::uint32_t hash = 0, vertex = kFree;
  };
  static constexpr std::uint32_t kFree = kNone;
  /// Points in one go: what memory answers at a time. Half: it is waited for; twice: no effect.
  static constexpr std::size_t kBatch = 24;

  void hashAll(std::span<const dvec3> points, std::uint32_t* hashes) const;
  std::uint32_t findHashed(const dvec3& p, std::uint32_t hash) const;
  std::uint32_t addHashed(const dvec3& p, std::uint32_t hash);
  void resize(std::size_t slots);

  std::vector<dvec3> vertices_;
  std::vector<Slot> slots_;
  std::size_t mask_ = 0;
};

}  // namespace hapticell::workcell
