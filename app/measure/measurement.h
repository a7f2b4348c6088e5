// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "app/viewport/tools/picked_feature.h"

namespace hapticell::app {

/// Measurements of one picked feature, or of two; a value, in W, m and rad.
///
/// Planes count as unbounded; edges end at their ends. If both are points, edges or parallel to each other, or one is a
/// point, the distance is the shortest one between the two; between faces that are not parallel it is that of the
/// picked points (`between_picks`).
struct Measurement {
  std::optional<double> length;    ///< Of an edge.
  std::optional<double> radius;    ///< Of a circle, cylinder, sphere.
  std::optional<double> distance;  ///< Between the two.
  bool between_picks = false;
  dvec3 p_WA{0.0}, p_WB{0.0};          ///< Ends of the distance; components are p_WB - p_WA.
  std::optional<double> angle;         ///< Between lines, axes or planes, 0 .. pi/2.
  std::optional<double> between_axes;  ///< Between centres, or parallel axes of circles and cylinders.
};

Measurement measure(const PickedFeature& feature);
Measurement measure(const PickedFeature& a, const PickedFeature& b);

}  // namespace hapticell::app
