// SPDX-License-Identifier: Apache-2.0
#include "mannequin/hair_shape.h"

#include <algorithm>
#include <cmath>

#include "mannequin/surface_nets.h"

namespace hapticell::mannequin {

geometry::TriangleMesh hairMesh(const Figure& figure, const Flesh& head, double cell) {
  constexpr double kThick = 0.009;  // m
  const double k = figure.body[Dimension::kStature] / 1.755, below = figure.sex == Sex::kFemale ? 0.125 : 0.085;
  // A plane from the forehead down over the ears to the nape: hair is above and behind it.
  const dvec3 forehead = figure.p_HeadEyes + k * dvec3(-0.012, 0.0, 0.062);
  const dvec3 nape(figure.p_HeadVertex.x - 0.090 * k, 0.0, figure.p_HeadEyes.z - below * k);
  const dvec3 along = glm::normalize(forehead - nape), faceward(along.z, 0.0, -along.x);
  GridField field{head.bounds(), cell, {}};
  field.bounds.min -= dvec3(kThick);
  field.bounds.max += dvec3(kThick);
  field.evaluate = [&](const dvec3&, double, const std::vector<dvec3>& points, std::vector<double>& values) {
    values.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      // Higher at the temples than in the middle of the forehead.
      const double line = glm::dot(points[i] - forehead, faceward) + 2.0 * points[i].y * points[i].y / k;
      values[i] = std::max(head.distance(points[i]) - kThick, line);
    }
  };
  return surfaceOf(field);
}

}  // namespace hapticell::mannequin
