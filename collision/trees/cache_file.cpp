// SPDX-License-Identifier: Apache-2.0
#include "collision/trees/cache_file.h"

#include <cstdio>
#include <cstring>
#include <system_error>

#include "geometry/system/atomic_file.h"

namespace hapticell::collision {

namespace {

std::uint64_t mixed(std::uint64_t x) {
  x ^= x >> 32;
  x *= 0xE9846AF9B1A615DDull;
  x ^= x >> 32;
  x *= 0xE9846AF9B1A615DDull;
  return x ^ (x >> 28);
}

}  // namespace

void addToHash(ContentHash& hash, std::span<const std::byte> bytes) {
  std::size_t at = 0;
  const auto next = [&](std::size_t size) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, size);
    at += size;
    hash[0] = (hash[0] ^ word) * 0x9E3779B97F4A7C15ull;
    hash[0] ^= hash[0] >> 29;
    hash[1] = (hash[1] + word) * 0xC2B2AE3D27D4EB4Full;
    hash[1] ^= hash[1] >> 31;
  };
  while (at + 8 <= bytes.size()) next(8);
  if (at < bytes.size()) next(bytes.size() - at);
  hash[0] = mixed(hash[0] + bytes.size());
  hash[1] = mixed(hash[1] ^ bytes.size());
}

std::string nameOf(const ContentHash& hash) {
  char name[48];
  std::snprintf(name, sizeof(name), "%016llx%016llx", static_cast<unsigned long long>(hash[0]),
                static_cast<unsigned long long>(hash[1]));
  return name;
}

void writeWhole(const std::filesystem::path& path, std::initializer_list<std::span<const std::byte>> parts) {
  std::error_code none;
  std::filesystem::create_directories(path.parent_path(), none);
  if (none) return;
  auto file = AtomicFile::begin(path, {.durable = false});
  if (!file) return;
  for (const auto& bytes : parts) {
    if (!file->write({reinterpret_cast<const char*>(bytes.data()), bytes.size()})) return;
  }
  (void)file->commit();
}

}  // namespace hapticell::collision
