// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "collision/trees/box_tree.h"
#include "collision/trees/cache_file.h"
#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::collision {

/// Of its vertices and triangles.
ContentHash contentHash(const geometry::TriangleMesh& mesh);

/// Trees on disk, one file a mesh, named by its content. Files of another version or machine, damaged or cut ones are
/// passed over, and written anew. Any number of programs may share a folder: files appear whole, by renaming.
class TreeCache {
 public:
  /// `folder` is made when something is stored; an empty path stores and finds nothing.
  explicit TreeCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::optional<BoxTree> load(const geometry::TriangleMesh& mesh, const ContentHash& hash) const;
  /// Quietly does without where the folder cannot be written.
  void store(const BoxTree& tree, const ContentHash& hash) const;

 private:
  std::filesystem::path fileOf(const ContentHash& hash) const;

  std::filesystem::path folder_;
};

}  // namespace hapticell::collision
