// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "geometry/shapes/triangle_mesh.h"
#include "mannequin/shape/hand_shape.h"

namespace hapticell::mannequin {

/// A tapered capsule from a to b with end radii, stretched along the axes of its frame: the element from which bodies
/// are built. Metres.
struct Blob {
  dvec3 a{0.0}, b{0.0};
  double ra = 0.0, rb = 0.0;
  dvec3 stretch{1.0};
  double blend = -1.0;  ///< m over which it blends into the blobs before it; negative: the value of its flesh.
};

/// The flesh of one rigid body of the figure, in its own frame.
struct Flesh {
  std::vector<Blob> blobs;
  double blend = 0.02;           ///< m over which blobs blend into each other.
  double floor = -1e9;           ///< Cut off below this z (soles).
  std::array<float, 3> color{};  ///< Clothing or skin.
  std::vector<Blob> hollows{};   ///< Taken away: sockets.

  /// Approximate distance (m) of a point to the surface, negative inside; never larger than the true one.
  double distance(const dvec3& p) const;
  /// The same with the outward direction at that point: unit, of the nearest blob.
  double distance(const dvec3& p, dvec3& outward) const;
  geometry::Bounds bounds() const;
};

/// Flesh of all segments, then of the phalanges of left and right hand (digit by digit). Generated from the figure's
/// dimensions, without third-party models.
inline constexpr std::size_t kBodies = kSegmentCount + 2 * kDigits * kPhalanges;
constexpr std::size_t phalanxBody(Side side, std::size_t digit, std::size_t phalanx) {
  return kSegmentCount + (static_cast<std::size_t>(side) * kDigits + digit) * kPhalanges + phalanx;
}
/// Index of the body that carries a body; itself for the pelvis.
std::size_t parentBody(std::size_t body);
std::vector<Flesh> fleshOf(const Figure& figure);

/// Closed surface of one body in its own frame, cells of `cell` metres. Round at its ends, so that neighbours overlap
/// without a gap in any posture.
geometry::TriangleMesh bodyMesh(const Flesh& flesh, double cell);

/// Smooth minimum of two distances: a polynomial over `k` metres.
double blended(double a, double b, double k);

}  // namespace hapticell::mannequin
