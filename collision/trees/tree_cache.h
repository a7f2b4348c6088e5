// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "collision/trees/box_tree.h"
#include "collision/trees/cache_file.h"
#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::collision {

/// The hash of the mesh's vertices and triangles.
ContentHash contentHash(const geometry::TriangleMesh& mesh);

/// Trees on disk, one file per mesh, named by its content. Files of another version or machine and damaged or
/// incomplete files are ignored and overwritten. Any number of programs may share a folder: files are renamed into
/// place when complete.
class TreeCache {
 public:
  /// `folder` is made at the first store; with an empty path nothing is stored or found.
  explicit TreeCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::optional<BoxTree> load(const geometry::TriangleMesh& mesh, const ContentHash& hash) const;
  /// If the folder cannot be written, nothing is stored and no error is reported.
  void store(const BoxTree& tree, const ContentHash& hash) const;

 private:
  std::filesystem::path fileOf(const ContentHash& hash) const;

  std::filesystem::path folder_;
};

}  // namespace hapticell::collision
