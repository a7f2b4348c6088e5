// SPDX-License-Identifier: Apache-2.0
// Part of proximity_kernels_body.h, see there: distances of several pairs of triangles at once.
#pragma once

#include "collision/trees/kernel_vectors.h"
#include "collision/trees/proximity_kernels.h"

namespace hapticell::collision {
namespace {

/// A triangle and the values that its pairs share.
template <typename V>
struct Face {
  Vector<V> corner[3];
  Vector<V> edge[3];
  V inverse_length[3];  ///< Squared lengths, and one over them (0 for a point).
  V length[3];
  Vector<V> normal;
  V normal_squared;
  V g11, g12, g22;  ///< Products of the first corner's edges.
  V barycentric[3][2];
  V height[3];  ///< Heights of the other triangle's corners, times the normal's length.
};

template <typename V, typename T>
HAPTICELL_INLINE void loadFace(const T* coordinates, int stride, Face<V>& face) {
  for (int c = 0; c < 3; ++c) face.corner[c] = loadVector<V>(coordinates + 3 * c * stride, stride);
  for (int c = 0; c < 3; ++c) {
    face.edge[c] = face.corner[(c + 1) % 3] - face.corner[c];
    face.length[c] = dot(face.edge[c], face.edge[c]);
    face.inverse_length[c] = face.length[c] > V{} ? all<V>(1) / face.length[c] : V{};
  }
  const Vector<V> e = face.edge[0], g = face.corner[2] - face.corner[0];
  face.normal = cross(e, g);
  face.normal_squared = dot(face.normal, face.normal);
  face.g11 = face.length[0];
  face.g12 = dot(e, g);
  face.g22 = face.length[2];
}

/// Projects the other triangle's corners onto a face; returns the least squared height of those inside its prism.
template <typename V>
HAPTICELL_INLINE V cornersAbove(Face<V>& face, const Vector<V>* other, V best) {
  using T = typename Scalar<V>::Type;
  const Vector<V> g = face.corner[2] - face.corner[0];
  /// Square of height over length: the normal of a needle is only rounding error, so a needle counts by its edges. The
  /// type's rounding, times 16 in float. Half: normals of rounding; twice: wider needles.
  constexpr T kNeedle = sizeof(T) == 4 ? T(1e-6) : T(1e-16);
  const V scale = face.g11 * face.g22;
  const V trusted = face.normal_squared > kNeedle * scale ? face.normal_squared : V{};
  face.normal_squared = trusted;
  const V inverse = trusted > V{} ? all<V>(1) / trusted : V{};
  /// Of a triangle's sides by which a corner may lie outside of a prism in float: its answers are only candidates,
  /// measured again in double. Half: a nearest pair may be missed; twice: more candidates.
  constexpr T kTolerance = sizeof(T) == 4 ? T(1e-4) : T(0);
  for (int c = 0; c < 3; ++c) {
    const Vector<V> o = other[c] - face.corner[0];
    face.height[c] = dot(face.normal, o);
    const V d1 = dot(face.edge[0], o), d2 = dot(g, o);
    const V s = (face.g22 * d1 - face.g12 * d2) * inverse, t = (face.g11 * d2 - face.g12 * d1) * inverse;
    face.barycentric[c][0] = s;
    face.barycentric[c][1] = t;
    const V squared = face.height[c] * face.height[c] * inverse;
    const auto inside = (s >= -kTolerance) & (t >= -kTolerance) & (s + t <= 1 + kTolerance) & (trusted > V{});
    best = (inside & (squared < best)) ? squared : best;
  }
  return best;
}

/// 0 where an edge of the other passes through the face.
template <typename V>
HAPTICELL_INLINE V pierced(const Face<V>& face, V best) {
  for (int c = 0; c < 3; ++c) {
    const int n = (c + 1) % 3;
    const V from = face.height[c], to = face.height[n];
    const V share = from / (from - to);
    const V s = face.barycentric[c][0] + share * (face.barycentric[n][0] - face.barycentric[c][0]);
    const V t = face.barycentric[c][1] + share * (face.barycentric[n][1] - face.barycentric[c][1]);
    const auto through =
        ((from > V{}) ^ (to > V{})) & (s >= V{}) & (t >= V{}) & (s + t <= all<V>(1)) & (face.normal_squared > V{});
    best = through ? V{} : best;
  }
  return best;
}

/// Edge pairs after Ericson 2005, 5.1.9.
template <typename V>
HAPTICELL_INLINE V edgePairs(const Face<V>& first, const Face<V>& second, V best) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Vector<V>&d1 = first.edge[i], &d2 = second.edge[j];
      const Vector<V> r = first.corner[i] - second.corner[j];
      const V a = first.length[i], e = second.length[j];
      const V b = dot(d1, d2), c = dot(d1, r), f = dot(d2, r);
      const V denominator = a * e - b * b;
      const V ratio = denominator > V{} ? (b * f - c * e) / denominator : V{};
      const V t = clampedToUnit((b * clampedToUnit(ratio) + f) * second.inverse_length[j]);
      const V s = clampedToUnit((b * t - c) * first.inverse_length[i]);
      const Vector<V> apart = r + s * d1 - t * d2;
      best = smaller(best, dot(apart, apart));
    }
  }
  return best;
}

template <typename V>
HAPTICELL_INLINE V distancesSquared(Face<V>& first, Face<V>& second) {
  using T = typename Scalar<V>::Type;
  V best = all<V>(T(3e38));
  best = cornersAbove(first, second.corner, best);
  best = cornersAbove(second, first.corner, best);
  best = edgePairs(first, second, best);
  return pierced(second, pierced(first, best));
}

template <typename V>
HAPTICELL_INLINE V largestSquare(const Face<V>& face) {
  return larger(dot(face.corner[0], face.corner[0]),
                larger(dot(face.corner[1], face.corner[1]), dot(face.corner[2], face.corner[2])));
}

/// How slender a triangle is at its first corner: the product of the edges there over twice the area, at most 100.
template <typename V>
HAPTICELL_INLINE V slenderness(const Face<V>& face) {
  const V square =
      smaller(face.g11 * face.g22 / (face.normal_squared + face.g11 * face.g22 * 1e-4f + 1e-36f), all<V>(1e4f));
  // The arithmetic mean with 1 exceeds the square root by at most half, so no root is needed near 1.
  return smaller(0.5f * (square + 1.0f), 0.01f * square + 25.0f);
}

template <typename V>
HAPTICELL_INLINE void packedPart(const PackedPairs& pairs, int lane, PackedDistances& result) {
  Face<V> first, second;
  loadFace(&pairs.first[0][lane], kPackSize, first);
  loadFace(&pairs.second[0][lane], kPackSize, second);
  const V slender = larger(slenderness(first), slenderness(second));
  const V size = larger(largestSquare(first), largestSquare(second));
  store(&result.squared[lane], distancesSquared(first, second));
  store(&result.doubt[lane], size * (4.0f + slender) * 2.4e-7f);
}

}  // namespace
}  // namespace hapticell::collision
