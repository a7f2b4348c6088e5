// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace hapticell::collision {

/// Children of a node, and the lanes of one box test: eight floats are a vector of AVX2, so any other number needs
/// other kernels.
inline constexpr int kTreeWidth = 8;
/// Maximum number of triangles in a leaf: 4 x 4 pairs are one pack of kPackSize. Half: twice the nodes and their
/// memory; twice: four times the pairs of two leaves.
inline constexpr int kLeafSize = 4;
/// Triangle pairs that are measured together: 16 floats are a vector of AVX-512, or two of AVX2. Half: half of AVX-512
/// lies idle; twice: more pairs that a nearer one would have spared.
inline constexpr int kPackSize = 16;

/// Boxes around a node's children, one per lane, in the mesh's frame M but relative to the node's `origin`. Numbers
/// rounded to float are therefore no larger than the node, and a hall of 20 m keeps micrometres. The third axis is u x
/// v.
struct alignas(32) BoxNode {
  float u[3][kTreeWidth];
  float v[3][kTreeWidth];
  float center[3][kTreeWidth];
  float half[3][kTreeWidth];
  std::uint32_t child[kTreeWidth];  ///< With BoxTree::kLeafBit the index of a leaf, else of a node.
  float origin[3];                  ///< p_MO, exactly this number.
  std::uint32_t count;              ///< Lanes in use; the others are infinitely far away.
};

/// Up to four triangles, corner by corner (x, y, z of the first, the second, the third), relative to `origin`. The
/// largest angle is at the first corner. Unused lanes repeat the last triangle.
struct alignas(16) LeafBlock {
  float corner[9][kLeafSize];
  std::uint32_t triangle[kLeafSize];
  float origin[3];  ///< p_MO, exactly this number.
  std::uint32_t count;
};

/// One box in the frame of a node, relative to its origin; a point has no size.
struct QueryBox {
  float axis[3][3];
  float center[3];
  float half[3];
  float line[3] = {};  ///< A unit vector along which gaps are looked for too; 0: none.
};

/// How a box moves against a node's children, in the node's frame: a child at p (relative to the node's origin) sees it
/// go by any share from -1 to 1 of `at` + `turn` x p. What else comes nearer is `margin` and, for each child, its half
/// diagonal times `turn_size`.
struct BoxSweep {
  float at[3];      ///< m
  float turn[3];    ///< rad
  float margin;     ///< m
  float turn_size;  ///< rad: no less than the length of `turn`.
};

/// Takes the second leaf's corners into the first leaf's frame: R c + t, with R row by row.
struct LeafTransform {
  float R[9];
  float t[3];
  float line[3] = {};  ///< In the first leaf's frame and towards the second: gaps along it are looked for too; 0: none.
};

/// Triangle pairs in parallel lanes, each in its own frame: coordinates first[3 * corner + axis][lane].
struct alignas(64) PackedPairs {
  float first[9][kPackSize];
  float second[9][kPackSize];
};

/// Distances of the pairs: `squared` differs from the true square by at most `doubt`.
struct alignas(64) PackedDistances {
  float squared[kPackSize];
  float doubt[kPackSize];
};

/// The same in double, where rounding does not matter (coordinates of both meshes in one frame).
struct alignas(64) ExactPairs {
  double first[9][kTreeWidth];
  double second[9][kTreeWidth];
};

/// Boxes of a node of the parts' tree (PartTree): 16 floats are a vector of AVX-512, or two of AVX2. Half: twice the
/// levels; twice: two vectors for what one mostly answers.
inline constexpr int kPartLanes = 16;

/// Axis-aligned boxes in the world, one per lane; a lane without a box has min above max.
struct alignas(64) PartBoxes {
  float min[3][kPartLanes];
  float max[3][kPartLanes];
};

/// The box that is asked about.
struct QueryBounds {
  float min[3];
  float max[3];
};

/// The inner loops of the proximity engine for one instruction set. Without state; any thread.
struct ProximityKernels {
  const char* name;

  /// Squares of lower bounds of the distances of a box to a node's eight children; never above the true square.
  /// Returns those (bit by lane) that are below the limit.
  std::uint32_t (*boxBounds)(const BoxNode& node, const QueryBox& query, float limit_squared, float* squared);

  /// Which of the 16 pairs of two leaves' triangles (bit 4 * lane of b + lane of a) may be nearer than
  /// sqrt(limit_squared): the plane of neither face keeps them that far apart. Sets `corners_b` to b's corners in a's
  /// frame.
  std::uint32_t (*leafPairs)(const LeafBlock& a, const LeafBlock& b, const LeafTransform& transform,
                             float limit_squared, float (*corners_b)[kLeafSize]);

  /// Distances of the first `count` pairs, 16 at most; the result's other lanes are undefined.
  void (*packedDistances)(const PackedPairs& pairs, int count, PackedDistances& result);

  /// Squares of the distances of 8 pairs, to double's rounding.
  void (*exactDistances)(const ExactPairs& pairs, double* squared);

  /// Gaps of 8 pairs along a unit vector, from the first towards the second, to double's rounding; negative where they
  /// overlap. No pair is nearer than its gap.
  void (*exactGaps)(const ExactPairs& pairs, const double* line, double* gaps);

  /// Of 8 pairs whose second triangles are in a frame of their own, the same pairs in the first's: R c + t, with R row
  /// by row.
  void (*placePairs)(const ExactPairs& pairs, const double* R, const double* t, ExactPairs& placed);

  /// Which of the 16 boxes (bit by lane) overlap or touch the box.
  std::uint32_t (*nearBoxes)(const PartBoxes& boxes, const QueryBounds& query);

  /// boxBounds() where the box moves against the children: lower bounds over all places. Returns those that are below
  /// the child's margin.
  std::uint32_t (*sweptBoxBounds)(const BoxNode& node, const QueryBox& query, const BoxSweep& sweep, float* squared);

  /// leafPairs() where the one moves against the other by any share from -1 to 1 of `sweep`, in the first leaf's frame.
  std::uint32_t (*sweptLeafPairs)(const LeafBlock& a, const LeafBlock& b, const LeafTransform& transform,
                                  float limit_squared, const float* sweep, float (*corners_b)[kLeafSize]);

  /// Whether all triangles of the leaf are proven to be farther from the box (in the leaf's frame, relative to its
  /// origin) than sqrt(limit_squared): each along the line from its nearest point to the box's middle, which is tight
  /// where the box is smaller than the triangle.
  bool (*isLeafBeyond)(const LeafBlock& leaf, const QueryBox& query, float limit_squared);
};

/// The kernels of this machine: the widest instruction set of its processor. To use less, set HAPTICELL_SIMD to
/// portable, avx2 or avx512.
const ProximityKernels& proximityKernels();

/// The kernels of the given name, for tests; null if this processor or build lacks them.
const ProximityKernels* proximityKernels(const char* name);

}  // namespace hapticell::collision
