// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/mass_properties.h"

#include <cmath>
#include <cstddef>
#include <span>

#include "geometry/shapes/edge_uses.h"

namespace hapticell::geometry {

namespace {

/// First and second moments of the volume about a common origin, summed over signed tetrahedra.
struct Moments {
  double volume = 0.0;
  dvec3 first{0.0};
  dmat3 second{0.0};  ///< Integral of x x^T.
};

void addTetrahedron(Moments& sum, const dvec3& a, const dvec3& b, const dvec3& c) {
  const double six_volumes = glm::dot(a, glm::cross(b, c));
  sum.volume += six_volumes / 6.0;
  const dvec3 total = a + b + c;
  sum.first += total * (six_volumes / 24.0);
  // Over a tetrahedron with one corner at 0: integral of x x^T = 6V/120 * (sum of v v^T + total total^T).
  const dmat3 squares = glm::outerProduct(a, a) + glm::outerProduct(b, b) + glm::outerProduct(c, c);
  sum.second += (squares + glm::outerProduct(total, total)) * (six_volumes / 120.0);
}

dmat3 inertiaOf(const dmat3& second) {
  const double trace = second[0][0] + second[1][1] + second[2][2];
  return dmat3(trace) - second;
}

}  // namespace

bool isClosed(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return false;
  const EdgeUses edges(mesh.triangles, mesh.vertices.size());
  bool closed = true;
  edges.each(0, edges.vertices(), [&closed](std::span<const EdgeUses::Use> uses) {
    std::ptrdiff_t balance = 0;
    for (const EdgeUses::Use& use : uses) balance += use.up() ? 1 : -1;
    closed = closed && balance == 0;
  });
  return closed;
}

double enclosedVolume(const TriangleMesh& mesh) {
  const dvec3 origin = mesh.bounds().center();
  double volume = 0.0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const dvec3 a = mesh.corner(t, 0) - origin, b = mesh.corner(t, 1) - origin, c = mesh.corner(t, 2) - origin;
    volume += glm::dot(a, glm::cross(b, c)) / 6.0;
  }
  return volume;
}

MassProperties massProperties(const TriangleMesh& mesh) {
  MassProperties result;
  if (mesh.triangles.empty()) return result;
  // The bounds' centre as origin keeps parts that stand far from their own origin exact.
  const dvec3 origin = mesh.bounds().center();
  Moments sum;
  dvec3 surface_first(0.0);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const dvec3 a = mesh.corner(t, 0) - origin, b = mesh.corner(t, 1) - origin, c = mesh.corner(t, 2) - origin;
    addTetrahedron(sum, a, b, c);
    const double area = 0.5 * glm::length(glm::cross(b - a, c - a));
    result.area += area;
    surface_first += (a + b + c) * (area / 3.0);
  }
  result.closed = isClosed(mesh);
  result.volume = sum.volume;
  const double size = 2.0 * mesh.bounds().radius();
  const bool solid = std::abs(sum.volume) > 1e-12 * size * size * size;
  dvec3 p_OC(0.0);
  if (solid)
    p_OC = sum.first / sum.volume;
  else if (result.area > 0.0)
    p_OC = surface_first / result.area;
  result.p_MC = origin + p_OC;
  if (solid) {
    const double sign = sum.volume < 0.0 ? -1.0 : 1.0;
    result.inertia_C_M = inertiaOf(sign * (sum.second - sum.volume * glm::outerProduct(p_OC, p_OC)));
  }
  return result;
}

}  // namespace hapticell::geometry
