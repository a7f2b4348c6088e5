// SPDX-License-Identifier: Apache-2.0
#include "collision/tree_cache.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <span>
#include <system_error>

#include "collision/collider_build.h"

namespace hapticell::collision {

namespace {

/// Raised whenever the nodes, the leaves or how they are made change.
constexpr std::uint32_t kVersion = 1;
constexpr char kMagic[8] = {'H', 'C', 'T', 'R', 'E', 'E', '\r', '\n'};

struct Header {
  char magic[8];
  std::uint32_t version;
  std::uint32_t byte_order;
  ContentHash content;
  std::uint64_t nodes, leaves;
  std::uint64_t node_size, leaf_size;
  ContentHash payload;
};

std::uint64_t mixed(std::uint64_t x) {
  x ^= x >> 32;
  x *= 0xE9846AF9B1A615DDull;
  x ^= x >> 32;
  x *= 0xE9846AF9B1A615DDull;
  return x ^ (x >> 28);
}

/// Not against malice, only against chance: two lanes of a multiplicative hash over eight bytes at a time.
void add(ContentHash& hash, std::span<const std::byte> bytes) {
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

template <typename Vector>
std::span<const std::byte> bytesOf(const Vector& items) {
  return std::as_bytes(std::span(items.data(), items.size()));
}

ContentHash payloadHash(const AlignedVector<BoxNode>& nodes, const AlignedVector<LeafBlock>& leaves) {
  ContentHash hash{1, 2};
  add(hash, bytesOf(nodes));
  add(hash, bytesOf(leaves));
  return hash;
}

bool isSound(const AlignedVector<BoxNode>& nodes, const AlignedVector<LeafBlock>& leaves, std::size_t triangles) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].count == 0 || nodes[i].count > kTreeWidth) return false;
    for (std::uint32_t lane = 0; lane < nodes[i].count; ++lane) {
      const std::uint32_t child = nodes[i].child[lane];
      // Children come after their parents, so no path ever returns.
      const bool fits =
          BoxTree::isLeaf(child) ? (child & ~BoxTree::kLeafBit) < leaves.size() : child > i && child < nodes.size();
      if (!fits) return false;
    }
  }
  for (const LeafBlock& leaf : leaves) {
    if (leaf.count == 0 || leaf.count > kLeafSize) return false;
    for (const std::uint32_t triangle : leaf.triangle) {
      if (triangle >= triangles) return false;
    }
  }
  return !nodes.empty() && !leaves.empty();
}

template <typename Vector>
bool read(std::ifstream& file, Vector& into) {
  const auto size = static_cast<std::streamsize>(into.size() * sizeof(into[0]));
  return static_cast<bool>(file.read(reinterpret_cast<char*>(into.data()), size));
}

}  // namespace

std::filesystem::path userCacheFolder() {
  if (const char* xdg = std::getenv("XDG_CACHE_HOME"); xdg != nullptr && xdg[0] == '/') {
    return std::filesystem::path(xdg) / "hapticell/trees";
  }
  if (const char* home = std::getenv("HOME"); home != nullptr && home[0] == '/') {
    return std::filesystem::path(home) / ".cache/hapticell/trees";
  }
  return {};
}

ContentHash contentHash(const geometry::TriangleMesh& mesh) {
  ContentHash hash{3, 4};
  add(hash, bytesOf(mesh.vertices));
  add(hash, bytesOf(mesh.triangles));
  return hash;
}

std::filesystem::path TreeCache::fileOf(const ContentHash& hash) const {
  char name[48];
  std::snprintf(name, sizeof(name), "%016llx%016llx.tree", static_cast<unsigned long long>(hash[0]),
                static_cast<unsigned long long>(hash[1]));
  return folder_ / name;
}

std::optional<BoxTree> TreeCache::load(const geometry::TriangleMesh& mesh, const ContentHash& hash) const {
  if (folder_.empty()) return std::nullopt;
  const std::filesystem::path path = fileOf(hash);
  std::error_code none;
  const std::uintmax_t size = std::filesystem::file_size(path, none);
  std::ifstream file(path, std::ios::binary);
  Header header{};
  if (none || !file.read(reinterpret_cast<char*>(&header), sizeof(header))) return std::nullopt;
  if (std::memcmp(header.magic, kMagic, sizeof(kMagic)) != 0 || header.version != kVersion ||
      header.byte_order != 0x01020304u || header.content != hash || header.node_size != sizeof(BoxNode) ||
      header.leaf_size != sizeof(LeafBlock)) {
    return std::nullopt;
  }
  if (header.nodes > size / sizeof(BoxNode) || header.leaves > size / sizeof(LeafBlock) ||
      size != sizeof(header) + header.nodes * sizeof(BoxNode) + header.leaves * sizeof(LeafBlock)) {
    return std::nullopt;
  }
  AlignedVector<BoxNode> nodes(header.nodes);
  AlignedVector<LeafBlock> leaves(header.leaves);
  if (!read(file, nodes) || !read(file, leaves) || payloadHash(nodes, leaves) != header.payload ||
      !isSound(nodes, leaves, mesh.triangles.size())) {
    return std::nullopt;
  }
  return BoxTree(std::move(nodes), std::move(leaves));
}

void TreeCache::store(const BoxTree& tree, const ContentHash& hash) const {
  if (folder_.empty() || tree.isEmpty()) return;
  std::error_code none;
  std::filesystem::create_directories(folder_, none);
  if (none) return;
  Header header{};
  std::memcpy(header.magic, kMagic, sizeof(kMagic));
  header.version = kVersion;
  header.byte_order = 0x01020304u;
  header.content = hash;
  header.nodes = tree.nodes().size();
  header.leaves = tree.leaves().size();
  header.node_size = sizeof(BoxNode);
  header.leaf_size = sizeof(LeafBlock);
  header.payload = payloadHash(tree.nodes(), tree.leaves());
  const std::filesystem::path path = fileOf(hash);
  // Two builds of one mesh in one process write the same bytes: at worst the later renaming finds no file.
  const std::filesystem::path draft = path.string() + "." + std::to_string(::getpid()) + ".draft";
  {
    std::ofstream file(draft, std::ios::binary | std::ios::trunc);
    const auto write = [&file](std::span<const std::byte> bytes) {
      file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    };
    write(std::as_bytes(std::span(&header, 1)));
    write(bytesOf(tree.nodes()));
    write(bytesOf(tree.leaves()));
    file.flush();
    if (!file) {
      file.close();
      std::filesystem::remove(draft, none);
      return;
    }
  }
  std::filesystem::rename(draft, path, none);
  if (none) std::filesystem::remove(draft, none);
}

}  // namespace hapticell::collision
