// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace hapticell::app {

/// Uses of one mesh that one call could draw: `uses` times `triangles`.
struct DrawLoad {
  std::size_t triangles = 0, uses = 0;
};

/// Cuts what a pass has to draw into calls, each about as long as wanted: whole batches where they are quick, single
/// uses or runs of triangles where they are not. How many triangles that is it learns from the time that calls took. No
/// OpenGL; any thread.
class DrawPieces {
 public:
  /// One call: `uses` of the load's, from `first_use` on (counted over all loads), with a run of its triangles.
  struct Piece {
    std::size_t load = 0, first_use = 0, uses = 0, first_triangle = 0, triangles = 0;
  };
  /// `seconds`: what a call shall take; `triangles`: what is tried first (carried from one pass to the next).
  DrawPieces(std::vector<DrawLoad> loads, double seconds, std::size_t triangles = kFirst);
  /// The next call; nothing when all is drawn.
  std::optional<Piece> next();
  /// Tells what the last call took.
  void took(double seconds);
  std::size_t triangles() const { return triangles_; }
  static constexpr std::size_t kFirst = 4096, kLeast = 256;

 private:
  std::vector<DrawLoad> loads_;
  double seconds_;
  std::size_t triangles_;
  std::size_t drawn_ = 0;  ///< Triangles of the last call.
  std::size_t load_ = 0, use_ = 0, before_ = 0, triangle_ = 0;
};

}  // namespace hapticell::app
