// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace hapticell::collision {

/// What a build has done, for whoever shows or ends it. Any thread may read, and set `cancelled`, at any time.
struct BuildProgress {
  std::atomic<std::size_t> triangles_done{0};
  std::atomic<bool> cancelled{false};
};

/// With what a collider is built. The result does not depend on any of it.
struct ColliderBuild {
  unsigned threads = 1;                ///< 0 takes what the machine has.
  std::filesystem::path cache_folder;  ///< Trees are kept here by their mesh's content; empty keeps nothing.
  BuildProgress* progress = nullptr;   ///< Outlives the build.
};

/// $XDG_CACHE_HOME/hapticell/trees, else $HOME/.cache/hapticell/trees (XDG base directory specification); empty where
/// neither is set.
std::filesystem::path userCacheFolder();

/// What was unusual about a mesh's triangles.
struct TriangleCensus {
  std::uint32_t non_finite = 0;  ///< With a corner that is no number or infinite: left out, nothing is ever near them.
  std::uint32_t duplicate = 0;   ///< The same three corners as an earlier one, in either turn: left out of the search.
  std::uint32_t degenerate = 0;  ///< Without area: count as the segment or point that they are.
};

}  // namespace hapticell::collision
