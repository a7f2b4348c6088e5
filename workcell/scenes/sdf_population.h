// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tinyxml.h>

#include <vector>

#include "geometry/shapes/vector.h"
#include "geometry/system/text.h"

namespace hapticell::workcell {

/// Poses of the models of an SDF <population>, in the world.
struct Population {
  std::vector<dvec3> positions;
  Text remark;  ///< What was assumed, or why there is no population; empty if the file states everything.
};

/// As in Gazebo (its class physics::Population): a grid around the pose, rows along x and y turned with it; rows along
/// one axis of the box evenly from its lower end. "random" and "uniform" are random in Gazebo; here they are spread
/// evenly over the box or cylinder, and this is reported. At most 5000.
Population populationOf(const TiXmlElement& population);

}  // namespace hapticell::workcell
