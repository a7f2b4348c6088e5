// SPDX-License-Identifier: Apache-2.0
#include "workcell/meshes/shared_corners.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace hapticell::workcell {

namespace {

constexpr std::size_t kFewest = 1024;  // Slots. Half, twice: no effect.

std::uint32_t hashOf(const dvec3& p) {
  std::uint64_t hash = 0;
  for (const double part : {p.x, p.y, p.z}) hash = (hash ^ std::bit_cast<std::uint64_t>(part)) * 0x9E3779B97F4A7C15ull;
  return static_cast<std::uint32_t>((hash ^ (hash >> 32)) * 0xBF58476D1CE4E5B9ull >> 32);
}

bool hasSameBits(const dvec3& a, const dvec3& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

}  // namespace

void SharedCorners::reserve(std::size_t vertices) {
  vertices_.reserve(vertices);
  std::size_t slots = std::max(kFewest, slots_.size());
  while (slots < 2 * vertices) slots *= 2;
  if (slots > slots_.size()) resize(slots);
}

std::uint32_t SharedCorners::add(const dvec3& p) {
  return addHashed(p, hashOf(p));
}

void SharedCorners::add(std::span<const dvec3> points, std::uint32_t* numbers) {
  std::array<std::uint32_t, kBatch> hashes{};
  for (std::size_t begin = 0; begin < points.size(); begin += kBatch) {
    const std::size_t count = std::min(kBatch, points.size() - begin);
    if (slots_.empty()) resize(kFewest);
    hashAll(points.subspan(begin, count), hashes.data());
    for (std::size_t k = 0; k < count; ++k) numbers[begin + k] = addHashed(points[begin + k], hashes[k]);
  }
}

/// At most kBatch; fetches what addHashed() and findHashed() look at.
void SharedCorners::hashAll(std::span<const dvec3> points, std::uint32_t* hashes) const {
  for (std::size_t k = 0; k < points.size(); ++k) {
    hashes[k] = hashOf(points[k]);
    __builtin_prefetch(&slots_[hashes[k] & mask_]);
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Slot& slot = slots_[hashes[k] & mask_];
    if (slot.vertex != kFree) __builtin_prefetch(&vertices_[slot.vertex]);
  }
}

void SharedCorners::find(std::span<const dvec3> points, std::uint32_t* numbers) const {
  std::fill_n(numbers, points.size(), kNone);
  if (slots_.empty()) return;
  std::array<std::uint32_t, kBatch> hashes{};
  for (std::size_t begin = 0; begin < points.size(); begin += kBatch) {
    const std::size_t count = std::min(kBatch, points.size() - begin);
    hashAll(points.subspan(begin, count), hashes.data());
    for (std::size_t k = 0; k < count; ++k) numbers[begin + k] = findHashed(points[begin + k], hashes[k]);
  }
}

std::uint32_t SharedCorners::findHashed(const dvec3& p, std::uint32_t hash) const {
  for (std::size_t place = hash & mask_; slots_[place].vertex != kFree; place = (place + 1) & mask_) {
    const Slot& slot = slots_[place];
    if (slot.hash == hash && hasSameBits(vertices_[slot.vertex], p)) return slot.vertex;
  }
  return kNone;
}

void SharedCorners::addMissing(std::span<const dvec3> points, std::uint32_t* numbers, bool last) {
  const auto missing = static_cast<std::size_t>(std::count(numbers, numbers + points.size(), kNone));
  vertices_.reserve(vertices_.size() + missing);
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (numbers[k] != kNone) continue;
    if (last) {
      numbers[k] = static_cast<std::uint32_t>(vertices_.size());
      vertices_.push_back(points[k]);
    } else {
      numbers[k] = add(points[k]);
    }
  }
}

std::uint32_t SharedCorners::addHashed(const dvec3& p, std::uint32_t hash) {
  if (2 * vertices_.size() >= slots_.size()) resize(std::max(kFewest, 2 * slots_.size()));
  std::size_t place = hash & mask_;
  while (slots_[place].vertex != kFree) {
    const Slot& slot = slots_[place];
    if (slot.hash == hash && hasSameBits(vertices_[slot.vertex], p)) return slot.vertex;
    place = (place + 1) & mask_;
  }
  const auto number = static_cast<std::uint32_t>(vertices_.size());
  slots_[place] = {hash, number};
  vertices_.push_back(p);
  return number;
}

void SharedCorners::resize(std::size_t slots) {
  std::vector<Slot> old;
  old.resize(slots);
  old.swap(slots_);
  mask_ = slots_.size() - 1;
  for (const Slot& slot : old) {
    if (slot.vertex == kFree) continue;
    std::size_t place = slot.hash & mask_;
    while (slots_[place].vertex != kFree) place = (place + 1) & mask_;
    slots_[place] = slot;
  }
}

}  // namespace hapticell::workcell
