// SPDX-License-Identifier: Apache-2.0 Included once by each of proximity_kernels_*.cpp, which are compiled for
// different instruction sets. Uses vector extensions of g++ and clang, no library: if an inline function of a library
// were compiled here for a new processor, the linker might use that copy everywhere.
#include "collision/trees/kernel_sweeps.h"
#include "collision/trees/kernel_triangles.h"
#include "collision/trees/kernel_vectors.h"
#include "collision/trees/proximity_kernels.h"

namespace hapticell::collision {
namespace {

/// Rounding in float, relative to the numbers added: 25 units of 6e-8, for a dozen sums. Half: a near pair may be
/// missed (DistanceOracle); twice: more pairs measured in double.
constexpr float kRoundingOfSums = 1.5e-6f;

using Mask8 = std::int32_t __attribute__((vector_size(32)));
HAPTICELL_INLINE std::uint32_t bitsOf(Mask8 mask) {
#ifdef __AVX__
  return static_cast<std::uint32_t>(__builtin_ia32_movmskps256(Float8(mask)));
#else
  std::uint32_t bits = 0;
  for (unsigned i = 0; i < 8; ++i) bits |= (mask[i] != 0 ? 1u : 0u) << i;
  return bits;
#endif
}

/// The gap along the query's line.
template <typename V>
HAPTICELL_INLINE V alongLine(const Vector<V>* axes, const V* halves, const Vector<V>& apart, const QueryBox& query,
                             V doubt) {
  const float* n = query.line;
  float taken_by_query = 0.0f;
  for (int i = 0; i < 3; ++i) {
    const float* q = query.axis[i];
    taken_by_query += query.half[i] * absolute(q[0] * n[0] + q[1] * n[1] + q[2] * n[2]);
  }
  V taken = doubt + taken_by_query;
  for (int k = 0; k < 3; ++k) taken += halves[k] * magnitude(axes[k].x * n[0] + axes[k].y * n[1] + axes[k].z * n[2]);
  const V open = larger(magnitude(apart.x * n[0] + apart.y * n[1] + apart.z * n[2]) - taken, V{});
  return open * open;
}

/// With kSwept the query box is somewhere between its place less the child's sweep and its place plus it. With kLine
/// gaps are looked for along the query's line and between the middles too, which pays where the nearest are not at 0.
/// Returns the square of the child's limit, if swept.
template <bool kSwept, bool kLine, typename V>
HAPTICELL_INLINE V boxBoundsPart(const BoxNode& node, int lane, const QueryBox& query, const BoxSweep* swept,
                                 float* squared) {
  Vector<V> axes[3] = {loadVector<V>(node.u[0] + lane, kTreeWidth), loadVector<V>(node.v[0] + lane, kTreeWidth), {}};
  axes[2] = cross(axes[0], axes[1]);
  const Vector<V> middle = loadVector<V>(node.center[0] + lane, kTreeWidth);
  const Vector<V> half = loadVector<V>(node.half[0] + lane, kTreeWidth);
  const Vector<V> apart{middle.x - query.center[0], middle.y - query.center[1], middle.z - query.center[2]};
  V size = magnitude(apart.x) + magnitude(apart.y) + magnitude(apart.z) + half.x + half.y + half.z +
           (query.half[0] + query.half[1] + query.half[2]);
  ChildSweep<V> child;
  if constexpr (kSwept) {
    child = childSweep(middle, half, *swept);
    size += child.rounding;
  }
  const V doubt = kRoundingOfSums * size;
  const V halves[3] = {half.x, half.y, half.z};
  V reach_of_query[3] = {doubt, doubt, doubt}, by_query{}, by_child{};
  [[maybe_unused]] V taken_along = doubt * sumOfMagnitudes(apart);
  for (int i = 0; i < 3; ++i) {
    const float* q = query.axis[i];
    V reach = doubt;
    for (int k = 0; k < 3; ++k) {
      const V cosine = magnitude(axes[k].x * q[0] + axes[k].y * q[1] + axes[k].z * q[2]);
      reach_of_query[k] += query.half[i] * cosine;
      reach += halves[k] * cosine;
    }
    if constexpr (kSwept) reach += magnitude(child.sweep.x * q[0] + child.sweep.y * q[1] + child.sweep.z * q[2]);
    const V along = magnitude(apart.x * q[0] + apart.y * q[1] + apart.z * q[2]);
    const V open = larger(along - query.half[i] - reach, V{});
    by_query += open * open;
    if constexpr (kLine) taken_along += query.half[i] * along;
  }
  for (int k = 0; k < 3; ++k) {
    if constexpr (kSwept) reach_of_query[k] += magnitude(dot(axes[k], child.sweep));
    const V along = magnitude(dot(apart, axes[k]));
    const V open = larger(along - halves[k] - reach_of_query[k], V{});
    by_child += open * open;
    if constexpr (kLine) taken_along += halves[k] * along;
  }
  V bound = larger(by_query, by_child);
  if constexpr (kLine) {
    const V square = dot(apart, apart), beyond = larger(square - taken_along, V{});
    bound = larger(bound, square > V{} ? beyond / square * beyond : V{});
    bound = larger(bound, alongLine(axes, halves, apart, query, doubt));
  }
  if constexpr (kSwept) bound = larger(bound, besideSweep(axes, halves, apart, query, child.sweep, doubt));
  store(squared + lane, bound);
  return child.limit_squared;
}

template <bool kLine>
HAPTICELL_INLINE std::uint32_t boundsOfBoxes(const BoxNode& node, const QueryBox& query, float limit_squared,
                                             float* squared) {
  constexpr int kLanes = sizeof(HAPTICELL_BOX_LANES) / sizeof(float);
  for (int lane = 0; lane < kTreeWidth; lane += kLanes) {
    boxBoundsPart<false, kLine, HAPTICELL_BOX_LANES>(node, lane, query, nullptr, squared);
  }
  return bitsOf(Mask8(load<Float8>(squared) < all<Float8>(limit_squared)));
}

std::uint32_t boxBounds(const BoxNode& node, const QueryBox& query, float limit_squared, float* squared) {
  if (query.line[0] == 0.0f && query.line[1] == 0.0f && query.line[2] == 0.0f)
    return boundsOfBoxes<false>(node, query, limit_squared, squared);
  return boundsOfBoxes<true>(node, query, limit_squared, squared);
}

std::uint32_t sweptBoxBounds(const BoxNode& node, const QueryBox& query, const BoxSweep& sweep, float* squared) {
  constexpr int kLanes = sizeof(HAPTICELL_BOX_LANES) / sizeof(float);
  float limits[kTreeWidth];
  for (int lane = 0; lane < kTreeWidth; lane += kLanes) {
    store(limits + lane, boxBoundsPart<true, false, HAPTICELL_BOX_LANES>(node, lane, query, &sweep, squared));
  }
  return bitsOf(Mask8(load<Float8>(squared) < load<Float8>(limits)));
}

/// Whether the other triangle is proven to be farther from a face's plane than the limit.
template <bool kSwept, typename V>
HAPTICELL_INLINE auto isApartByPlane(const Vector<V>* face, const Vector<V>* other, V limit_squared,
                                     const Vector<V>& sweep) {
  const Vector<V> e = face[1] - face[0], g = face[2] - face[0];
  const Vector<V> normal = cross(e, g);
  const Vector<V> o0 = other[0] - face[0], o1 = other[1] - face[0], o2 = other[2] - face[0];
  const V h0 = dot(normal, o0), h1 = dot(normal, o1), h2 = dot(normal, o2);
  const V low = smaller(smaller(h0, h1), h2), high = larger(larger(h0, h1), h2);
  const V gap = larger(low, -high);
  // The normal is a valid axis, but n . o has a rounding error of a few units in the last place of |e| |g| |o|. Sums of
  // magnitudes are used instead of the lengths.
  const V edge = sumOfMagnitudes(e), side = sumOfMagnitudes(g);
  V reach = larger(larger(sumOfMagnitudes(o0), sumOfMagnitudes(o1)), larger(sumOfMagnitudes(o2), edge + side));
  V taken{};
  if constexpr (kSwept) {
    taken = magnitude(dot(normal, sweep));
    reach += sumOfMagnitudes(sweep);
  }
  const V sure = gap - taken - kRoundingOfSums * edge * side * reach;
  return (sure > V{}) & (sure * sure > limit_squared * dot(normal, normal));
}

/// The same along a line.
template <bool kSwept, typename V>
HAPTICELL_INLINE auto isApartAlong(const Vector<V>& axis, const Vector<V>* first, const Vector<V>* second,
                                   V limit_squared, const Vector<V>& sweep) {
  const V a0 = dot(axis, first[0]), a1 = dot(axis, first[1]), a2 = dot(axis, first[2]);
  const V b0 = dot(axis, second[0]), b1 = dot(axis, second[1]), b2 = dot(axis, second[2]);
  V reach = larger(larger(sumOfMagnitudes(first[0]), sumOfMagnitudes(first[1])),
                   larger(larger(sumOfMagnitudes(first[2]), sumOfMagnitudes(second[0])),
                          larger(sumOfMagnitudes(second[1]), sumOfMagnitudes(second[2]))));
  V taken{};
  if constexpr (kSwept) {
    taken = magnitude(dot(axis, sweep));
    reach += sumOfMagnitudes(sweep);
  }
  const V gap = smaller(smaller(b0, b1), b2) - larger(larger(a0, a1), a2);
  const V sure = gap - taken - kRoundingOfSums * sumOfMagnitudes(axis) * reach;
  return (sure > V{}) & (sure * sure > limit_squared * dot(axis, axis));
}

HAPTICELL_INLINE Float8 twice(Float4 a) {
  return __builtin_shufflevector(a, a, 0, 1, 2, 3, 0, 1, 2, 3);
}
template <int kFirst>
HAPTICELL_INLINE Float8 spread(Float4 b) {
  return __builtin_shufflevector(b, b, kFirst, kFirst, kFirst, kFirst, kFirst + 1, kFirst + 1, kFirst + 1, kFirst + 1);
}

template <bool kSwept, int kFirst>
HAPTICELL_INLINE std::uint32_t leafPairsOfTwo(const Vector<Float8>* first, const Float4 (*b)[3], float limit_squared,
                                              const float* swept) {
  Vector<Float8> second[3];
  for (int c = 0; c < 3; ++c) second[c] = {spread<kFirst>(b[c][0]), spread<kFirst>(b[c][1]), spread<kFirst>(b[c][2])};
  const Float8 limit = all<Float8>(limit_squared);
  Vector<Float8> sweep{};
  if constexpr (kSwept) sweep = {all<Float8>(swept[0]), all<Float8>(swept[1]), all<Float8>(swept[2])};
  // Along the line between their middles are separated those that lie next to each other,
  const Vector<Float8> middles = (second[0] + second[1] + second[2]) - (first[0] + first[1] + first[2]);
  auto apart = isApartByPlane<kSwept>(first, second, limit, sweep) |
               isApartByPlane<kSwept>(second, first, limit, sweep) |
               isApartAlong<kSwept>(middles, first, second, limit, sweep);
  if constexpr (kSwept) {  // and square to the sweep those that pass beside each other.
    const Float8 square = dot(sweep, sweep);
    const Float8 share = square > Float8{} ? dot(middles, sweep) / square : Float8{};
    apart |= isApartAlong<kSwept>(middles - share * sweep, first, second, limit, sweep);
  }
  return ~bitsOf(apart) & 0xFFu;
}

/// Which of the 16 pairs are not apart along a unit vector that points from a to b.
HAPTICELL_INLINE std::uint32_t nearAlong(const LeafBlock& a, const Float4 (*b)[3], const float* line,
                                         float limit_squared) {
  Float4 high = all<Float4>(-3e38f), low = all<Float4>(3e38f), reach_a{}, reach_b{};
  for (int c = 0; c < 3; ++c) {
    const Vector<Float4> p = loadVector<Float4>(a.corner[3 * c], kLeafSize), q{b[c][0], b[c][1], b[c][2]};
    high = larger(high, p.x * line[0] + p.y * line[1] + p.z * line[2]);
    low = smaller(low, q.x * line[0] + q.y * line[1] + q.z * line[2]);
    reach_a = larger(reach_a, sumOfMagnitudes(p));
    reach_b = larger(reach_b, sumOfMagnitudes(q));
  }
  high += kRoundingOfSums * reach_a;
  low -= kRoundingOfSums * reach_b;
  std::uint32_t near = 0;
  for (int half = 0; half < 2; ++half) {
    const Float8 gap = (half == 0 ? spread<0>(low) : spread<2>(low)) - twice(high);
    const auto apart = (gap > Float8{}) & (gap * gap > all<Float8>(limit_squared));
    near |= (~bitsOf(Mask8(apart)) & 0xFFu) << (8 * half);
  }
  return near;
}

template <bool kSwept>
HAPTICELL_INLINE std::uint32_t pairsOfLeaves(const LeafBlock& a, const LeafBlock& b, const LeafTransform& transform,
                                             float limit_squared, const float* sweep, float (*corners_b)[kLeafSize]) {
  Vector<Float8> first[3];
  Float4 second[3][3];
  for (int c = 0; c < 3; ++c) {
    first[c] = {twice(load<Float4>(a.corner[3 * c])), twice(load<Float4>(a.corner[3 * c + 1])),
                twice(load<Float4>(a.corner[3 * c + 2]))};
    const Vector<Float4> p = loadVector<Float4>(b.corner[3 * c], kLeafSize);
    for (int i = 0; i < 3; ++i) {
      const float* row = transform.R + 3 * i;
      second[c][i] = p.x * row[0] + p.y * row[1] + p.z * row[2] + transform.t[i];
      store(corners_b[3 * c + i], second[c][i]);
    }
  }
  const std::uint32_t lanes_a = (1u << a.count) - 1u, lanes_b = (1u << (4 * b.count)) - 1u;
  std::uint32_t lanes = lanes_b & (lanes_a * 0x1111u);
  if constexpr (!kSwept) {
    lanes &= nearAlong(a, second, transform.line, limit_squared);
    if (lanes == 0) return 0;
  }
  std::uint32_t near = 0;
  if ((lanes & 0xFFu) != 0) near = leafPairsOfTwo<kSwept, 0>(first, second, limit_squared, sweep);
  if (lanes > 0xFFu) near |= leafPairsOfTwo<kSwept, 2>(first, second, limit_squared, sweep) << 8;
  return near & lanes;
}

std::uint32_t leafPairs(const LeafBlock& a, const LeafBlock& b, const LeafTransform& transform, float limit_squared,
                        float (*corners_b)[kLeafSize]) {
  return pairsOfLeaves<false>(a, b, transform, limit_squared, nullptr, corners_b);
}

std::uint32_t sweptLeafPairs(const LeafBlock& a, const LeafBlock& b, const LeafTransform& transform,
                             float limit_squared, const float* sweep, float (*corners_b)[kLeafSize]) {
  return pairsOfLeaves<true>(a, b, transform, limit_squared, sweep, corners_b);
}

/// From the triangles' nearest points to the middle of a box, which is the origin. Any axis proves what it proves: its
/// rounding does not matter.
template <typename V>
HAPTICELL_INLINE Vector<V> fromTriangle(const Vector<V>* corner) {
  V least = all<V>(3e38f);
  Vector<V> nearest{};
  for (int c = 0; c < 3; ++c) {
    const Vector<V> edge = corner[(c + 1) % 3] - corner[c];
    const V length = dot(edge, edge);
    const V share = length > V{} ? clampedToUnit(-dot(corner[c], edge) / length) : V{};
    const Vector<V> foot = corner[c] + share * edge;
    const V square = dot(foot, foot);
    const auto is_nearer = square < least;
    least = is_nearer ? square : least;
    nearest = {is_nearer ? foot.x : nearest.x, is_nearer ? foot.y : nearest.y, is_nearer ? foot.z : nearest.z};
  }
  const Vector<V> e = corner[1] - corner[0], g = corner[2] - corner[0], normal = cross(e, g);
  const V ee = dot(e, e), eg = dot(e, g), gg = dot(g, g), d1 = -dot(e, corner[0]), d2 = -dot(g, corner[0]);
  const V s = gg * d1 - eg * d2, t = ee * d2 - eg * d1, square = dot(normal, normal);
  const auto inside = (s >= V{}) & (t >= V{}) & (s + t <= square) & (square > V{});
  const V height = square > V{} ? dot(normal, corner[0]) / square : V{};
  const Vector<V> foot = height * normal;
  return {inside ? -foot.x : -nearest.x, inside ? -foot.y : -nearest.y, inside ? -foot.z : -nearest.z};
}

bool isLeafBeyond(const LeafBlock& leaf, const QueryBox& query, float limit_squared) {
  using V = Float4;
  using Mask4 = std::int32_t __attribute__((vector_size(16)));
  Vector<V> corner[3];
  V reach{};
  for (int c = 0; c < 3; ++c) {
    const Vector<V> at = loadVector<V>(leaf.corner[3 * c], kLeafSize);
    reach = larger(reach, sumOfMagnitudes(at));
    corner[c] = {at.x - query.center[0], at.y - query.center[1], at.z - query.center[2]};
  }
  const Vector<V> axis = fromTriangle(corner);
  V gap = -larger(larger(dot(axis, corner[0]), dot(axis, corner[1])), dot(axis, corner[2]));
  for (int i = 0; i < 3; ++i) {
    const float* q = query.axis[i];
    gap -= query.half[i] * magnitude(axis.x * q[0] + axis.y * q[1] + axis.z * q[2]);
    reach += absolute(query.center[i]) + query.half[i];
  }
  const V sure = gap - kRoundingOfSums * sumOfMagnitudes(axis) * reach;
  const auto beyond = Mask4((sure > V{}) & (sure * sure > limit_squared * dot(axis, axis)));
  return (beyond[0] & beyond[1] & beyond[2] & beyond[3]) != 0;  // Unused lanes repeat the last triangle.
}

void packedDistances(const PackedPairs& pairs, int count, PackedDistances& result) {
  constexpr int kLanes = sizeof(HAPTICELL_PACKED_LANES) / sizeof(float);
  for (int lane = 0; lane < count; lane += kLanes) packedPart<HAPTICELL_PACKED_LANES>(pairs, lane, result);
}

void exactDistances(const ExactPairs& pairs, double* squared) {
  constexpr int kLanes = sizeof(HAPTICELL_EXACT_LANES) / sizeof(double);
  for (int lane = 0; lane < kTreeWidth; lane += kLanes) {
    Face<HAPTICELL_EXACT_LANES> first, second;
    loadFace(&pairs.first[0][lane], kTreeWidth, first);
    loadFace(&pairs.second[0][lane], kTreeWidth, second);
    store(squared + lane, distancesSquared(first, second));
  }
}

template <typename V>
HAPTICELL_INLINE V heightsAlong(const double (*corner)[kTreeWidth], int lane, const double* line) {
  const Vector<V> p = loadVector<V>(&corner[0][lane], kTreeWidth);
  return p.x * line[0] + p.y * line[1] + p.z * line[2];
}

void exactGaps(const ExactPairs& pairs, const double* line, double* gaps) {
  using V = HAPTICELL_EXACT_LANES;
  constexpr int kLanes = sizeof(V) / sizeof(double);
  for (int lane = 0; lane < kTreeWidth; lane += kLanes) {
    V high = heightsAlong<V>(pairs.first, lane, line), low = heightsAlong<V>(pairs.second, lane, line);
    for (int c = 1; c < 3; ++c) {
      high = larger(high, heightsAlong<V>(pairs.first + 3 * c, lane, line));
      low = smaller(low, heightsAlong<V>(pairs.second + 3 * c, lane, line));
    }
    store(gaps + lane, low - high);
  }
}

void placePairs(const ExactPairs& pairs, const double* R, const double* t, ExactPairs& placed) {
  using V = HAPTICELL_EXACT_LANES;
  constexpr int kLanes = sizeof(V) / sizeof(double);
  for (int lane = 0; lane < kTreeWidth; lane += kLanes) {
    for (int c = 0; c < 3; ++c) {
      const Vector<V> p = loadVector<V>(&pairs.second[3 * c][lane], kTreeWidth);
      for (int i = 0; i < 3; ++i) {
        store(&placed.first[3 * c + i][lane], load<V>(&pairs.first[3 * c + i][lane]));
        store(&placed.second[3 * c + i][lane], p.x * R[3 * i] + p.y * R[3 * i + 1] + p.z * R[3 * i + 2] + t[i]);
      }
    }
  }
}

template <typename V>
HAPTICELL_INLINE auto overlapping(const PartBoxes& boxes, int lane, const QueryBounds& query) {
  auto near = load<V>(boxes.min[0] + lane) <= all<V>(query.max[0]);
  near &= load<V>(boxes.max[0] + lane) >= all<V>(query.min[0]);
  for (int k = 1; k < 3; ++k) {
    near &= load<V>(boxes.min[k] + lane) <= all<V>(query.max[k]);
    near &= load<V>(boxes.max[k] + lane) >= all<V>(query.min[k]);
  }
  return near;
}

std::uint32_t nearBoxes(const PartBoxes& boxes, const QueryBounds& query) {
  return bitsOf(Mask8(overlapping<Float8>(boxes, 0, query))) | bitsOf(Mask8(overlapping<Float8>(boxes, 8, query))) << 8;
}

}  // namespace

extern const ProximityKernels HAPTICELL_KERNELS;
const ProximityKernels HAPTICELL_KERNELS{HAPTICELL_KERNELS_NAME, boxBounds,      leafPairs,   packedDistances,
                                         exactDistances,         exactGaps,      placePairs,  nearBoxes,
                                         sweptBoxBounds,         sweptLeafPairs, isLeafBeyond};

}  // namespace hapticell::collision
