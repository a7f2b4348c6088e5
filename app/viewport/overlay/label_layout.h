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
  /// Whether it comes nearer to the box than its room (as a square about each of its points).
  bool reaches(const PixelBox& box) const;
};

/// A label that wants a place near its point.
struct LabelWish {
  std::uint64_t key = 0;   ///< The same label has the same key in the next frame.
  glm::dvec2 anchor{0.0};  ///< Pixel of the point that it speaks of.
  glm::dvec2 size{0.0};    ///< Pixels.
  /// A short text right beside its point, so many pixels away, with no leader; 0: a label with one.
  double gap = 0.0;
};

struct PlacedLabel {
  std::uint64_t key = 0;
  PixelBox box;
  glm::dvec2 anchor{0.0};
  bool right_of_point = true;
};

/// What labels keep free.
struct KeptFree {
  std::vector<PixelBox> boxes;   ///< Always.
  std::vector<PixelLine> lines;  ///< Where there is another place: handles, arrows, pens.
};

/// Places labels beside their points: they stay on the side they had, and move only when they would cover their point,
/// another label, what is kept free or the border; a new place is reached within 120 ms. Two labels never overlap, on
/// their way neither: one that has no place is not shown.
class LabelLayout {
 public:
  /// Places `wishes` (first one has the best choice) for a frame that comes `seconds` after the one before.
  /// With `motion` off, labels jump.
  std::vector<PlacedLabel> place(const std::vector<LabelWish>& wishes, const KeptFree& keep_free, const ViewSize& size,
                                 double seconds, bool motion = true);
  /// True while a label is still on its way.
  bool moving() const { return moving_; }

 private:
  struct Memory {
    std::uint64_t key = 0;
    glm::dvec2 offset{0.0};  // Of the box's corner from the anchor: where it shall be.
    glm::dvec2 shown{0.0};   // Where it is drawn.
    bool right = true;
  };
  const Memory* remembered(std::uint64_t key) const;
  bool mayGlide(const LabelWish& wish, const Memory& memory, const std::vector<LabelWish>& wishes) const;
  std::vector<Memory> memories_;
  bool moving_ = false;
};

/// The leader from a label to its point: from the middle of the side that faces it, level first, then straight; from
/// above or below straight.
std::vector<glm::dvec2> leaderOf(const PlacedLabel& label);

}  // namespace hapticell::app
