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

/// Two 64-bit hashes of some content; different content practically never has equal hashes.
using ContentHash = std::array<std::uint64_t, 2>;

/// Protects against chance, not against attacks: two lanes of a multiplicative hash over eight bytes at a time.
void addToHash(ContentHash& hash, std::span<const std::byte> bytes);

/// 32 hexadecimal digits.
std::string nameOf(const ContentHash& hash);

/// Writes a file as AtomicFile does, but does not flush it to the disk: readers of caches check what they read, and a
/// file lost in a power cut is made again. Makes the folder. If writing fails, no file is written and no error is
/// reported.
void writeWhole(const std::filesystem::path& path, std::initializer_list<std::span<const std::byte>> parts);

}  // namespace hapticell::collision
