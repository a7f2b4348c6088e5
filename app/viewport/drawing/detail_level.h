// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace hapticell::app {

/// How much of the picture is drawn. Each step drops the least noticeable detail. At every level, parts deviate from
/// their shape by at most kMostPixels.
enum class DetailLevel {
  kFull,         ///< Occlusion, shadows, all edges, outlines.
  kNoOcclusion,  ///< Without ambient occlusion; shadows only of what does not move.
  kPlain,        ///< Without shadows.
  kNoEdges,      ///< Faces only; states stay marked.
  kHalfSize,     ///< The same at half the resolution.
  kCoarse        ///< Parts with the coarsest allowed triangles.
};

/// Pixels of the window: largest deviation of a part that is drawn coarser (docs/dev/window.md). Half: more triangles
/// than slow machines draw in time; twice: steps between levels become visible.
inline constexpr double kMostPixels = 3.0;
/// Parts smaller than this may be drawn as their bounding box (docs/dev/window.md). Half: more small parts to draw;
/// twice: boxes become visible.
inline constexpr double kBoxPixels = 6.0;

/// Allowed deviation of parts at a level of detail, in pixels of the window.
double allowedPixels(DetailLevel level);
/// Drawn pixels per pixel of the window, along a side.
inline double drawnShare(DetailLevel level) {
  return level >= DetailLevel::kHalfSize ? 0.5 : 1.0;
}

/// Chooses the level of detail during motion, from the time that frames take, so that the window keeps its rate.
///
/// Drops quickly, restores slowly: a frame slower than the budget drops a level; a long run of frames that would also
/// fit with more detail restores one. A level that was far too slow when last drawn is retried only much later.
class DetailGovernor {
 public:
  /// `budget_s`: time for one frame during motion; a guaranteed 10 Hz leaves 0.1 s for everything in the GUI thread.
  /// `first`: the initial level on an unknown machine; below full, levels are restored quickly until a frame was too
  /// slow.
  explicit DetailGovernor(double budget_s = 0.055, DetailLevel first = DetailLevel::kFull)
      : budget_s_(budget_s), level_(first), patience_(first == DetailLevel::kFull ? kPatience : kQuickPatience) {}

  DetailLevel level() const { return level_; }
  /// How many triangles a frame should draw: learnt from frames with little other cost, so that a higher level causes
  /// no long frame. Parts that keep their shape are drawn in any case (Frame::most_triangles).
  std::size_t mostTriangles() const { return most_triangles_; }
  /// Reports how long a frame at level() took, in seconds, and how many triangles of faces it had (0: unknown).
  void frameTook(double seconds, std::size_t triangles = 0);
  double budget() const { return budget_s_; }
  /// Sets another budget from the next frame on.
  void setBudget(double seconds) { budget_s_ = seconds; }

 private:
  /// Number of fast frames before a better level is tried, later and at the start. By trial. Half: levels oscillate;
  /// twice: a scene that became faster stays coarse for longer.
  static constexpr int kPatience = 20, kQuickPatience = 2;
  double budget_s_;
  DetailLevel level_;
  void learnTriangles(double seconds, std::size_t triangles);
  std::size_t most_triangles_ = 100000;  ///< Initial value.
  int good_frames_ = 0;
  int patience_;
  double last_took_[6]{};  ///< By level; 0: not drawn yet.
  bool just_raised_ = false;
};

/// The rate and duration of recent frames. Times in seconds of any steady clock.
class FrameMeter {
 public:
  void frame(double now_s, double took_s);
  /// Frames a second over the last second of drawing.
  double rate(double now_s) const;
  double lastSeconds() const { return last_took_; }
  double worstSeconds() const;

 private:
  /// Frames whose times are kept: more than a second at 60 Hz. Half: rates of fast screens are too low; twice: memory.
  static constexpr std::size_t kCapacity = 128;
  double start_[kCapacity]{};
  double took_[kCapacity]{};
  std::size_t count_ = 0;
  double last_took_ = 0.0;
};

}  // namespace hapticell::app
