// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

namespace hapticell::app {

/// The most that one call could draw: `uses` of a mesh of `units` triangles (or edges).
struct DrawLoad {
  std::size_t units = 0, uses = 0;
};

/// A part of a load: some of its uses with a range of their units.
struct DrawPart {
  std::size_t first_use = 0, uses = 0, first_unit = 0, units = 0;
};

/// Progress of a picture that is drawn in several passes. All passes must offer the calls in the same order.
struct DrawProgress {
  std::size_t done = 0;     ///< Units times uses, counted from the first load.
  std::size_t call = 4096;  ///< Units per call; learnt from the duration of calls.
};

/// What is drawn in one go: everything with as few calls as possible, or, for a picture at rest, what fits into the
/// time, continuing where the last go ended. Passes offer their loads one after the other. Uses no OpenGL.
class DrawShare {
 public:
  struct Clock {
    std::function<double()> now;      ///< Seconds.
    std::function<void()> wait = {};  ///< Returns when all calls are completed.
  };
  using Draw = std::function<void(const DrawPart&)>;

  /// Draws everything.
  DrawShare() = default;
  /// Draws for about `seconds`, at least one call. `progress` must outlive it.
  DrawShare(DrawProgress& progress, double seconds, Clock clock);

  /// Calls `draw` for the part of the load that is due.
  void offer(const DrawLoad& load, const Draw& draw);
  /// Offers a load that cannot be divided, as expensive as so many units.
  void once(std::size_t units, const std::function<void()>& draw);
  /// True if nothing was left for another go.
  bool isWhole() const { return !left_over_; }
  /// Duration of the longest call that fewer units could not shorten; only a smaller area can. Seconds.
  double longestLeast() const { return longest_least_; }
  /// Smallest number of triangles in a call: with fewer, the call costs more than drawing. Half: slower; twice: longer
  /// pauses without a graphics card.
  static constexpr std::size_t kLeastUnits = 256;
  /// s; planned duration of a call: half of a 60 Hz frame, between two checks of the time. Half: more calls; twice: a
  /// piece of a picture is late by twice as much.
  static constexpr double kCallSeconds = 0.008;

 private:
  void drawPart(const DrawPart& part, bool cuttable, const Draw& draw);
  DrawProgress* progress_ = nullptr;
  double seconds_ = 0.0, start_ = 0.0, longest_least_ = 0.0;
  Clock clock_;
  std::size_t offered_ = 0;  ///< Units times uses before the present load.
  bool over_ = false, left_over_ = false;
};

}  // namespace hapticell::app
