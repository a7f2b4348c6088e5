// SPDX-License-Identifier: Apache-2.0
#include "collision/trees/tree_cache.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <span>
#include <system_error>

#include "collision/trees/cache_file.h"
#include "collision/trees/collider_build.h"

namespace hapticell::collision {

namespace {

/// Raised whenever the nodes, the leaves or how they are made change.
constexpr std::uint32_t kVersion = 1;
constexpr char kMagic[8] = {'H', 'C', 'T', 'R', 'E', 'E', '\r', '\n'};

struct TreeHeader {
  char magic[8];
  std::uint32_t version;
  std::uint32_t byte_order;
  ContentHash content;
  std::uint64_t nodes, leaves;
  std::uint64_t node_size, leaf_size;
  ContentHash payload;
};

template <typename Vector>
std::span<const std::byte> bytesOf(const Vector& items) {
  return std::as_bytes(std::span(items.data(), items.size()));
}

ContentHash payloadHash(const AlignedVector<BoxNode>& nodes, const AlignedVector<LeafBlock>& leaves) {
  ContentHash hash{1, 2};
  addToHash(hash, bytesOf(nodes));
  addToHash(hash, bytesOf(leaves));
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
  addToHash(hash, bytesOf(mesh.vertices));
  addToHash(hash, bytesOf(mesh.triangles));
  return hash;
}

std::filesystem::path TreeCache::fileOf(const ContentHash& hash) const {
  return folder_ / (nameOf(hash) + ".tree");
}

std::optional<BoxTree> TreeCache::load(const geometry::TriangleMesh& mesh, const ContentHash& hash) const {
  if (folder_.empty()) return std::nullopt;
  const std::filesystem::path path = fileOf(hash);
  std::error_code none;
  const std::uintmax_t size = std::filesystem::file_size(path, none);
  std::ifstream file(path, std::ios::binary);
  TreeHeader header{};
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
  TreeHeader header{};
  std::memcpy(header.magic, kMagic, sizeof(kMagic));
  header.version = kVersion;
  header.byte_order = 0x01020304u;
  header.content = hash;
  header.nodes = tree.nodes().size();
  header.leaves = tree.leaves().size();
  header.node_size = sizeof(BoxNode);
  header.leaf_size = sizeof(LeafBlock);
  header.payload = payloadHash(tree.nodes(), tree.leaves());
  writeWhole(fileOf(hash), {std::as_bytes(std::span(&header, 1)), bytesOf(tree.nodes()), bytesOf(tree.leaves())});
}

}  // namespace hapticell::collision
