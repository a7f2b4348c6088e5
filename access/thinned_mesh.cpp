// SPDX-License-Identifier: Apache-2.0
#include "access/thinned_mesh.h"

#include <algorithm>
#include <array>
#include <map>

namespace hapticell::access {

namespace {

/// Cosine of normals that count as one face: 0.8 deg. Half: a few more rows for each corner; twice: finely cut round
/// faces move by a ten-thousandth less.
constexpr double kSameNormal = 0.9999;
/// Share of the thinnest side of the box that it is thinned by at most. Half: thin sheets still touch what they lie on;
/// twice: a fifth of a sheet is lost on both sides.
constexpr double kMostShare = 0.1;
/// How far a corner moves at most, in multiples of the faces' way. Half: edges under 60 deg stay too far out; twice:
/// needles turn inside out.
constexpr double kMostStretch = 4.0;
/// Damping of the least squares, where faces nearly agree. Half and twice: a millionth of the way.
constexpr double kDamping = 1e-6;

using Normals = std::vector<dvec3>;

void addNormal(Normals& normals, const dvec3& nhat) {
  const bool known = std::any_of(normals.begin(), normals.end(),
                                 [&](const dvec3& one) { return glm::dot(one, nhat) > kSameNormal; });
  if (!known) normals.push_back(nhat);
}

/// The least move of a corner that moves every face by 1 against its normal, as nearly as possible.
dvec3 moveOf(const Normals& normals) {
  dmat3 sum(kDamping);
  dvec3 side(0.0);
  for (const dvec3& n : normals) {
    sum += glm::outerProduct(n, n);
    side -= n;
  }
  const dvec3 move = glm::inverse(sum) * side;
  const double length = glm::length(move);
  return length > kMostStretch ? (kMostStretch / length) * move : move;
}

}  // namespace

geometry::TriangleMesh thinned(const geometry::TriangleMesh& mesh, double by) {
  const dvec3 size = mesh.bounds().size();
  const double way = std::min(by, kMostShare * std::min({size.x, size.y, size.z}));
  // Corners of a soup that lie on each other move together.
  std::map<std::array<double, 3>, Normals> corners;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = mesh.corners(i);
    const dvec3 normal = glm::cross(b - a, c - a);
    const double length = glm::length(normal);
    if (length == 0.0) continue;
    for (const dvec3& p : {a, b, c}) addNormal(corners[{p.x, p.y, p.z}], normal / length);
  }
  geometry::TriangleMesh result = mesh;
  for (dvec3& p : result.vertices) {
    const auto found = corners.find({p.x, p.y, p.z});
    if (found != corners.end()) p += way * moveOf(found->second);
  }
  return result;
}

}  // namespace hapticell::access
