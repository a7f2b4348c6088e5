// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace hapticell::app {

/// How much of the picture is drawn. Each step drops what is missed least. No part is off its shape by more than
/// kMostPixels in any of them.
enum class DetailLevel {
  kFull,         ///< Occlusion, shadows, all edges, outlines.
  kNoOcclusion,  ///< Without ambient occlusion; shadows of what stood still.
  kPlain,        ///< Without shadows.
  kNoEdges,      ///< Faces only; states stay marked.
  kHalfSize,     ///< The same at half the resolution.
  kCoarse        ///< Parts by the coarsest triangles that are allowed.
};

/// Of the window: how far a part that is drawn coarser is off at most (docs/dev/window.md). Half: more triangles than
/// slow machines draw in time; twice: steps between levels are seen.
inline constexpr double kMostPixels = 3.0;
/// What is smaller may be drawn as the box around it (docs/dev/window.md). Half: more small parts to draw; twice: boxes
/// are seen.
inline constexpr double kBoxPixels = 6.0;

/// How far parts may be off in pixels of the window, at a level of detail.
double allowedPixels(DetailLevel level);
/// Pixels that are drawn for one of the window, along a side.
inline double drawnShare(DetailLevel level) {
  return level >= DetailLevel::kHalfSize ? 0.5 : 1.0;
}

/// Chooses the detail while things move, from the time that frames take, so that the window keeps its rate.
///
/// Sheds at once, restores slowly: a frame slower than the budget drops a step, a long run of frames that would also
/// fit with more detail takes one back. A step that was far too slow when last drawn is tried again much later only.
class DetailGovernor {
 public:
  /// `budget_s`: what one frame may take while moving; 10 Hz guaranteed leaves 0.1 s for everything in the GUI thread.
  /// `first`: where it begins on a machine that it does not know yet; below full it climbs quickly until a frame was
  /// too slow.
  explicit DetailGovernor(double budget_s = 0.055, DetailLevel first = DetailLevel::kFull)
      : budget_s_(budget_s), level_(first), patience_(first == DetailLevel::kFull ? kPatience : kQuickPatience) {}

  DetailLevel level() const { return level_; }
  /// What a frame should draw: learnt where a frame costs little else, so that no step up makes one long frame. What
  /// keeps the parts' shapes is drawn all the same (Frame::most_triangles).
  std::size_t mostTriangles() const { return most_triangles_; }
  /// Tells how long a frame at level() took, in seconds, and how many triangles of faces it had (0: not known).
  void frameTook(double seconds, std::size_t triangles = 0);
  double budget() const { return budget_s_; }
  /// Another budget from the next frame on.
  void setBudget(double seconds) { budget_s_ = seconds; }

 private:
  /// Frames in time until a better level is tried, at the start soon. By trial. Half: levels swing; twice: a faster
  /// scene stays coarse for longer.
  static constexpr int kPatience = 20, kQuickPatience = 2;
  double budget_s_;
  DetailLevel level_;
  void learnTriangles(double seconds, std::size_t triangles);
  std::size_t most_triangles_ = 100000;  ///< A beginning.
  int good_frames_ = 0;
  int patience_;
  double last_took_[6]{};  ///< At each level; 0: not drawn yet.
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
  /// Frames of which times are kept: over a second's at 60 Hz. Half: rates of fast screens are cut; twice: memory.
  static constexpr std::size_t kCapacity = 128;
  double start_[kCapacity]{};
  double took_[kCapacity]{};
  std::size_t count_ = 0;
  double last_took_ = 0.0;
};

}  // namespace hapticell::app
