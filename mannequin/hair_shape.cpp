// SPDX-License-Identifier: Apache-2.0
#include "mannequin/hair_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "mannequin/head_flesh.h"
#include "mannequin/surface_nets.h"

namespace hapticell::mannequin {

namespace {

/// How far down hair goes, by how far ahead; HeadMeasures' coordinates, m. Forehead, temple, before and behind the ear,
/// nape.
using Line = std::array<std::pair<double, double>, 7>;
constexpr Line kShort{{{-0.120, -0.062},
                       {-0.070, -0.062},
                       {-0.030, -0.024},
                       {0.0085, 0.000},
                       {0.0160, 0.000},
                       {0.0420, 0.046},
                       {0.0900, 0.068}}};
constexpr Line kLong{{{-0.130, -0.110},
                      {-0.060, -0.112},
                      {-0.020, -0.106},
                      {0.0180, -0.086},
                      {0.0300, -0.020},
                      {0.0520, 0.044},
                      {0.0920, 0.066}}};

double lineAt(const Line& line, double x) {
  if (x <= line.front().first) return line.front().second;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const auto [x1, z1] = line[i];
    const auto [x0, z0] = line[i - 1];
    if (x <= x1) return z0 + (z1 - z0) * (x - x0) / (x1 - x0);
  }
  return line.back().second;
}

/// What hair lies on: the skull, and with long hair what hangs behind it.
Flesh hairBed(const HeadMeasures& m) {
  const double s = m.size(), length = m.scale.x / m.scale.y, height = m.scale.z / m.scale.y;
  const dvec3 middle = m.at(-0.004, 0.0, 0.0167);
  Flesh bed{{{middle, middle, 0.0772 * s, 0.0772 * s, {1.275 * length, 1.0, 1.256 * height}}}, 0.030 * s, -1e9, {}, {}};
  if (m.female)
    bed.blobs.push_back(
        {m.at(-0.030, 0.0, -0.010), m.at(-0.034, 0.0, -0.094), 0.0690 * s, 0.0600 * s, {0.92, 1.18, 1.0}});
  return bed;
}

}  // namespace

geometry::TriangleMesh hairMesh(const Figure& figure, double cell) {
  const HeadMeasures m(figure);
  const Flesh bed = hairBed(m);
  const Line& line = m.female ? kLong : kShort;
  const double sides = m.female ? 0.010 : 0.005, top = 0.013;  // m thick.
  constexpr double kRoots = 0.035;                             // m over which it gets as thick as that.
  GridField field{bed.bounds(), cell, {}};
  field.bounds.min -= dvec3(0.02);
  field.bounds.max += dvec3(0.02);
  field.evaluate = [&](const dvec3&, double, const std::vector<dvec3>& points, std::vector<double>& values) {
    values.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const dvec3 p = (points[i] - m.origin) / m.scale;
      const double up = std::clamp(p.z / 0.07, 0.0, 1.0);
      // Lower at the middle of the forehead than at the temples.
      const double ahead = p.x + (p.x > 0.02 ? 5.0 * p.y * p.y : 0.0), above = p.z - lineAt(line, ahead);
      // Thin where it begins, or it would be a helmet's rim.
      const double begins = std::clamp(above / kRoots, 0.0, 1.0), root = m.female ? 0.55 : 0.30;
      const double thick =
          (sides + (top - sides) * up * up * (3.0 - 2.0 * up)) * (root + (1.0 - root) * begins * (2.0 - begins));
      values[i] = -blended(-(bed.distance(points[i]) - thick), 0.7 * above, 0.008);
    }
  };
  return surfaceOf(field);
}

}  // namespace hapticell::mannequin
