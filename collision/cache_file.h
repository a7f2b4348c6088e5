// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <span>
#include <string>

namespace hapticell::collision {

/// Two 64-bit sums of some content; equal ones have equal sums, others practically never.
using ContentHash = std::array<std::uint64_t, 2>;

/// Not against malice, only against chance: two lanes of a multiplicative hash over eight bytes at a time.
void addToHash(ContentHash& hash, std::span<const std::byte> bytes);

/// 32 hexadecimal digits.
std::string nameOf(const ContentHash& hash);

/// Writes a file so that others see all of it or nothing (a draft is renamed); makes its folder. Quietly does without
/// where that fails.
void writeWhole(const std::filesystem::path& path, std::initializer_list<std::span<const std::byte>> parts);

}  // namespace hapticell::collision
