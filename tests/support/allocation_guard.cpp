// SPDX-License-Identifier: Apache-2.0
#include "tests/support/allocation_guard.h"

#include <cstdlib>
#include <limits>
#include <new>

// clang links its thread sanitizer's own operators into each program, and no others beside them.
#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define HAPTICELL_OPERATORS_ARE_TAKEN
#endif
#endif

namespace {

thread_local std::size_t allocations = 0;
constexpr std::size_t kNoShortage = std::numeric_limits<std::size_t>::max();
thread_local std::size_t still_granted = kNoShortage;
thread_local std::size_t smallest_refused = 0;

}  // namespace

#ifndef HAPTICELL_OPERATORS_ARE_TAKEN
namespace {

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  if (still_granted != kNoShortage && size >= smallest_refused) {
    if (still_granted == 0) throw std::bad_alloc();
    --still_granted;
  }
  size = size == 0 ? 1 : size;
  void* memory = alignment == 0 ? std::malloc(size)
                                : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void* countedOrNull(std::size_t size) noexcept {
  try {
    return counted(size, 0);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

}  // namespace

void* operator new(std::size_t size) {
  return counted(size, 0);
}
void* operator new[](std::size_t size) {
  return counted(size, 0);
}
void* operator new(std::size_t size, std::align_val_t a) {
  return counted(size, static_cast<std::size_t>(a));
}
void* operator new[](std::size_t size, std::align_val_t a) {
  return counted(size, static_cast<std::size_t>(a));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return countedOrNull(size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  return countedOrNull(size);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}
#endif

namespace hapticell::test {

bool allocationsAreCounted() {
#ifdef HAPTICELL_OPERATORS_ARE_TAKEN
  return false;
#else
  return true;
#endif
}

AllocationGuard::AllocationGuard() : at_start_(allocations) {}

std::size_t AllocationGuard::count() const {
  return allocations - at_start_;
}

MemoryShortage::MemoryShortage(std::size_t granted, std::size_t smallest) {
  smallest_refused = smallest;
  still_granted = granted;
}

MemoryShortage::~MemoryShortage() {
  still_granted = kNoShortage;
}

}  // namespace hapticell::test
