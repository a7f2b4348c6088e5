// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "collision/trees/cache_file.h"
#include "collision/surfaces/recognised_surface.h"

namespace hapticell::collision {

/// Recognised surfaces on disk, beside the trees: one file a mesh, named by its content. Only what took long is kept
/// (which triangle lies on which surface); the rest is measured anew. Files of another version, damaged or cut ones are
/// passed over, and written anew. Any number of programs may share a folder.
class SurfaceCache {
 public:
  /// `folder` is made when something is stored; an empty path stores and finds nothing.
  explicit SurfaceCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Fills region_of and the regions' shapes and triangles of `surface` (connectedSurface() of the mesh); false, and
  /// nothing changed, where there is no such file.
  bool load(const ContentHash& mesh, RecognisedSurface& surface) const;
  void store(const ContentHash& mesh, const RecognisedSurface& surface) const;

 private:
  std::filesystem::path fileOf(const ContentHash& mesh) const { return folder_ / (nameOf(mesh) + ".surfaces"); }

  std::filesystem::path folder_;
};

}  // namespace hapticell::collision
