// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace hapticell::collision {

/// Progress of a build, for showing or cancelling it. Any thread may read, and set `cancelled`, at any time.
struct BuildProgress {
  std::atomic<std::size_t> triangles_done{0};
  std::atomic<bool> cancelled{false};
};

/// Options for building a collider. The result does not depend on them.
struct ColliderBuild {
  unsigned threads = 1;                ///< 0: all that the machine has.
  std::filesystem::path cache_folder;  ///< Cache for trees, by their mesh's content; empty: no cache.
  BuildProgress* progress = nullptr;   ///< Outlives the build.
};

/// $XDG_CACHE_HOME/hapticell/trees, else $HOME/.cache/hapticell/trees (XDG base directory specification); empty if
/// neither is set.
std::filesystem::path userCacheFolder();

/// Unusual triangles of a mesh.
struct TriangleCensus {
  std::uint32_t non_finite = 0;  ///< With a NaN or infinite corner: left out, so nothing is ever near them.
  std::uint32_t duplicate = 0;   ///< The same three corners as an earlier one, in either orientation: left out of the
                                 ///< search.
  std::uint32_t degenerate = 0;  ///< Without area: treated as a segment or a point.
};

}  // namespace hapticell::collision
