// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

namespace hapticell::app {

/// What one call could draw: `uses` of a mesh of `units` triangles (or of edges).
struct DrawLoad {
  std::size_t units = 0, uses = 0;
};

/// A part of a load: some of its uses with a run of their units.
struct DrawPart {
  std::size_t first_use = 0, uses = 0, first_unit = 0, units = 0;
};

/// How far a picture that is drawn in several goes has come. The calls of all goes must be offered in the same order.
struct DrawProgress {
  std::size_t done = 0;     ///< Units times uses, from the first load on.
  std::size_t call = 4096;  ///< Units that one call may draw; learnt from the time that calls take.
};

/// What is drawn in one go: everything by as few calls as can be, or of a picture at rest what fits into the time, from
/// where the last go ended. Passes offer it their loads one after the other. Knows no OpenGL.
class DrawShare {
 public:
  struct Clock {
    std::function<double()> now;      ///< Seconds.
    std::function<void()> wait = {};  ///< Returns when all that was called is drawn.
  };
  using Draw = std::function<void(const DrawPart&)>;

  /// Everything.
  DrawShare() = default;
  /// About `seconds` of it, at least one call. `progress` must outlive it.
  DrawShare(DrawProgress& progress, double seconds, Clock clock);

  /// Calls `draw` for what is due of the load.
  void offer(const DrawLoad& load, const Draw& draw);
  /// What cannot be cut, as heavy as so many units.
  void once(std::size_t units, const std::function<void()>& draw);
  /// Nothing was left for another go.
  bool isWhole() const { return !left_over_; }
  /// Seconds of the longest call that could not have been cut further by fewer units: a smaller area must be drawn.
  double longestLeast() const { return longest_least_; }
  /// Triangles of a call, however long it takes: fewer cost more for the call than for drawing. Half: slower; twice:
  /// longer pauses without a graphics card.
  static constexpr std::size_t kLeastUnits = 256;
  /// s that a call shall take: half of a 60 Hz picture, between two looks at the time. Half: more calls; twice: a piece
  /// of a picture is late by twice as much.
  static constexpr double kCallSeconds = 0.008;

 private:
  void drawPart(const DrawPart& part, bool cuttable, const Draw& draw);
  DrawProgress* progress_ = nullptr;
  double seconds_ = 0.0, start_ = 0.0, longest_least_ = 0.0;
  Clock clock_;
  std::size_t offered_ = 0;  ///< Units times uses before the load that is offered.
  bool over_ = false, left_over_ = false;
};

}  // namespace hapticell::app
