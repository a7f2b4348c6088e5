// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "app/viewport/camera.h"

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

/// A label that wants a place near its point.
struct LabelWish {
  std::uint64_t key = 0;   ///< The same label has the same key in the next frame.
  glm::dvec2 anchor{0.0};  ///< Pixel of the point that it speaks of.
  glm::dvec2 size{0.0};    ///< Pixels.
};

struct PlacedLabel {
  std::uint64_t key = 0;
  PixelBox box;
  glm::dvec2 anchor{0.0};
  bool right_of_point = true;
};

/// Places labels beside their points: they stay on the side they had, and move only when they would cover their point,
/// another label, a kept-free box or the border; a new place is reached within 120 ms.
class LabelLayout {
 public:
  /// Places `wishes` (first one has the best choice) for a frame that comes `seconds` after the one before.
  /// With `motion` off, labels jump.
  std::vector<PlacedLabel> place(const std::vector<LabelWish>& wishes, const std::vector<PixelBox>& keep_free,
                                 const ViewSize& size, double seconds, bool motion = true);
  /// True while a label is still on its way.
  bool moving() const { return moving_; }

 private:
  struct Memory {
    std::uint64_t key = 0;
    glm::dvec2 offset{0.0};  // Of the box's corner from the anchor: where it shall be.
    glm::dvec2 shown{0.0};   // Where it is drawn.
    bool right = true;
  };
  std::vector<Memory> memories_;
  bool moving_ = false;
};

/// The leader from a label to its point: from the middle of the side that faces it, level first, then straight.
std::vector<glm::dvec2> leaderOf(const PlacedLabel& label);

}  // namespace hapticell::app
