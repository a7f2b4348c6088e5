// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/viewport/scene/camera.h"

namespace hapticell::app {

/// An axis-aligned rectangle in pixels of the viewport.
struct PixelBox {
  glm::dvec2 min{0.0};
  glm::dvec2 max{0.0};
  glm::dvec2 size() const { return max - min; }
  bool overlaps(const PixelBox& other) const {
    return min.x < other.max.x && other.min.x < max.x && min.y < other.max.y && other.min.y < max.y;
  }
  bool contains(const glm::dvec2& p) const { return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y; }
};

/// A straight line of the picture, in pixels of the viewport.
struct PixelLine {
  glm::dvec2 from{0.0}, to{0.0};
  double room = 6.0;  ///< On either side of it.
  /// True if the line comes closer to the box than `room` (as a square about each of its points).
  bool reaches(const PixelBox& box) const;
};

/// A label to be placed near its point.
struct LabelWish {
  std::uint64_t key = 0;   ///< The same label has the same key in the next frame.
  glm::dvec2 anchor{0.0};  ///< Pixel of the point that it belongs to.
  glm::dvec2 size{0.0};    ///< Pixels.
  /// A short text next to its point, at this distance in pixels, without a leader; 0: a label with a leader.
  double gap = 0.0;
};

struct PlacedLabel {
  std::uint64_t key = 0;
  PixelBox box;
  glm::dvec2 anchor{0.0};
  bool right_of_point = true;
};

/// Areas that labels must not cover.
struct KeptFree {
  std::vector<PixelBox> boxes;   ///< Always kept free.
  std::vector<PixelLine> lines;  ///< Kept free if there is another position: handles, arrows, pens.
};

/// Places labels next to their points: they stay on their side and move only if they would cover their point, another
/// label, an area that is kept free or the border; they reach a new position within 120 ms. Two labels never overlap,
/// not even while moving: a label without a free position is not shown.
class LabelLayout {
 public:
  /// Places `wishes` (the first one has the first choice) for a frame that is `seconds` after the previous one.
  /// With `motion` off, labels jump.
  std::vector<PlacedLabel> place(const std::vector<LabelWish>& wishes, const KeptFree& keep_free, const ViewSize& size,
                                 double seconds, bool motion = true);
  /// True while a label is still moving.
  bool moving() const { return moving_; }

 private:
  struct Memory {
    std::uint64_t key = 0;
    glm::dvec2 offset{0.0};  // Target of the box's corner relative to the anchor.
    glm::dvec2 shown{0.0};   // Where it is drawn now.
    bool right = true;
  };
  const Memory* remembered(std::uint64_t key) const;
  bool mayGlide(const LabelWish& wish, const Memory& memory, const std::vector<LabelWish>& wishes) const;
  std::vector<Memory> memories_;
  bool moving_ = false;
};

/// The leader from a label to its point: from the middle of the nearest side, first horizontal, then straight to the
/// point; from the top or bottom side, straight.
std::vector<glm::dvec2> leaderOf(const PlacedLabel& label);

}  // namespace hapticell::app
