// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace hapticell::collision {

/// Four numbers that are added and compared together; the last is unused.
using Float4 = float __attribute__((vector_size(16)));

/// A triangle while a tree is built: its corners, relative to the middle of its mesh.
struct BuildItem {
  float corner[9];
  std::uint32_t triangle;
};

/// Three axes by component: their x coordinates in `x`, and so on.
struct BuildAxes {
  Float4 x{1.0f, 0.0f, 0.0f, 0.0f};
  Float4 y{0.0f, 1.0f, 0.0f, 0.0f};
  Float4 z{0.0f, 0.0f, 1.0f, 0.0f};

  /// Coordinates of a point along the axes.
  Float4 along(const float* p) const { return p[0] * x + p[1] * y + p[2] * z; }
};

/// An extent along axes.
struct Extent {
  Float4 low = Float4{} + 3e38f;
  Float4 high = Float4{} - 3e38f;

  void add(Float4 p) {
    low = p < low ? p : low;
    high = p > high ? p : high;
  }
  void add(const Extent& other) {
    low = other.low < low ? other.low : low;
    high = other.high > high ? other.high : high;
  }
  /// Half of the box's surface.
  float surface() const {
    const Float4 size = high - low;
    return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
  }
};

/// A box around triangles.
struct FittedBox {
  BuildAxes axes;
  Extent extent;
};

/// The extent of a triangle along the axes.
Extent extentOf(const BuildItem& item, const BuildAxes& axes);

/// The box of least surface among three choices: along the given axes, along those of the surface's covariance
/// (Gottschalk et al. 1996) and, if there are few triangles, along those of the largest one. `along_given` is the
/// extent along the given axes.
FittedBox fitBox(const BuildItem* items, std::size_t count, const BuildAxes& given, const Extent& along_given);

}  // namespace hapticell::collision
