// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "collision/trees/cache_file.h"
#include "collision/surfaces/recognised_surface.h"

namespace hapticell::collision {

/// Recognised surfaces on disk, in the folder of the trees: one file per mesh, named by its content. It keeps only the
/// slow part (which triangle lies on which surface); the rest is measured again. Files of another version and damaged
/// or incomplete files are ignored and overwritten. Any number of programs may share a folder.
class SurfaceCache {
 public:
  /// `folder` is made at the first store; with an empty path nothing is stored or found.
  explicit SurfaceCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Fills region_of and the regions' shapes and triangles of `surface` (connectedSurface() of the mesh); if there is
  /// no such file, returns false and changes nothing.
  bool load(const ContentHash& mesh, RecognisedSurface& surface) const;
  void store(const ContentHash& mesh, const RecognisedSurface& surface) const;

 private:
  std::filesystem::path fileOf(const ContentHash& mesh) const { return folder_ / (nameOf(mesh) + ".surfaces"); }

  std::filesystem::path folder_;
};

}  // namespace hapticell::collision
