// SPDX-License-Identifier: Apache-2.0
#include "mannequin/shape/hair_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "mannequin/shape/head_flesh.h"
#include "mannequin/shape/surface_nets.h"

namespace hapticell::mannequin {

namespace {

/// How far down hair goes (m, HeadMeasures' coordinates), by the angle from straight ahead, deg: forehead, temple,
/// before and over the ear, behind it, nape.
using Line = std::array<std::pair<double, double>, 13>;
constexpr Line kShort{{{0, 0.076},
                       {20, 0.079},
                       {34, 0.083},
                       {46, 0.070},
                       {58, 0.042},
                       {70, 0.022},
                       {79, -0.002},
                       {86, 0.000},
                       {96, 0.024},
                       {112, 0.014},
                       {126, -0.022},
                       {150, -0.050},
                       {180, -0.056}}};
constexpr Line kLong{{{0, 0.078},
                      {22, 0.081},
                      {36, 0.076},
                      {48, 0.056},
                      {58, 0.028},
                      {68, -0.008},
                      {78, -0.044},
                      {88, -0.068},
                      {100, -0.082},
                      {116, -0.090},
                      {134, -0.094},
                      {150, -0.096},
                      {180, -0.096}}};

/// Rounded at its knots.
double lineAt(const Line& line, double angle) {
  // Degrees by which knots of the hairline are rounded; drawn only. Half: corners; twice: no line at the ears.
  constexpr double kRound = 5.0;
  const auto straight = [&](double at) {
    if (at <= line.front().first) return line.front().second;
    for (std::size_t i = 1; i < line.size(); ++i) {
      const auto [a1, z1] = line[i];
      const auto [a0, z0] = line[i - 1];
      if (at <= a1) return z0 + (z1 - z0) * (at - a0) / (a1 - a0);
    }
    return line.back().second;
  };
  return (straight(std::abs(angle - kRound)) + straight(angle) + straight(angle + kRound)) / 3.0;
}

/// What hair lies on: skull and forehead, and with long hair what hangs behind them.
Flesh hairBed(const Figure& figure, const HeadMeasures& m) {
  Flesh bed = headFlesh(figure);
  bed.blobs.resize(2);
  bed.hollows.clear();
  if (m.female) {
    const double s = m.size();
    bed.blobs.push_back(
        {m.at(-0.026, 0.0, -0.010), m.at(-0.034, 0.0, -0.082), 0.0700 * s, 0.0560 * s, {0.92, 1.12, 1.0}});
  }
  return bed;
}

}  // namespace

geometry::TriangleMesh hairMesh(const Figure& figure, double cell) {
  const HeadMeasures m(figure);
  const Flesh bed = hairBed(figure, m);
  const Line& line = m.female ? kLong : kShort;
  const double sides = m.female ? 0.009 : 0.0045, top = m.female ? 0.012 : 0.011;  // m thick.
  // m over which hair grows to its full thickness, and how far it is in the head; drawn only. Half: a helmet's rim;
  // twice: bald temples.
  constexpr double kRoots = 0.030, kUnder = 0.0006;
  GridField field{bed.bounds(), cell, {}};
  field.bounds.min -= dvec3(0.02);
  field.bounds.max += dvec3(0.02);
  field.evaluate = [&](const dvec3&, double, const std::vector<dvec3>& points, std::vector<double>& values) {
    values.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const dvec3 p = (points[i] - m.origin) / m.scale;
      const double up = std::clamp(p.z / 0.07, 0.0, 1.0);
      const double above = p.z - lineAt(line, std::atan2(std::abs(p.y), p.x) * 180.0 / std::numbers::pi);
      // It grows out of the skin: a rim would make it a helmet. Locks fall from the parting to both sides.
      const double begins = std::clamp(above / kRoots, 0.0, 1.0);
      const double locks = 0.0011 * std::sin(95.0 * p.y + 60.0 * p.x) * std::sin(140.0 * p.x - 30.0 * p.z) * up;
      const double parting = 0.0022 * std::exp(-std::pow((p.y - 0.032) / 0.007, 2.0)) * up;
      const double full = sides + (top - sides) * up * up * (3.0 - 2.0 * up) + locks - parting;
      const double thick = full * begins * (2.0 - begins) - kUnder + std::min(0.0, above);
      values[i] = std::max(bed.distance(points[i]) - thick, 0.7 * -above - 0.006);
    }
  };
  return surfaceOf(field);
}

}  // namespace hapticell::mannequin
