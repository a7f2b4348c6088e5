// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tinyxml.h>

#include <string>
#include <vector>

#include "geometry/shapes/vector.h"

namespace hapticell::workcell {

/// Where the models of an SDF <population> stand, in the world.
struct Population {
  std::vector<dvec3> positions;
  std::string remark;  ///< What was assumed, or why there is no population; empty if the file states everything.
};

/// As Gazebo places them (its class physics::Population): a grid about the pose, rows along x and y turned with it; rows
/// along one axis of the box evenly from its lower end. "random" and "uniform" leave the places to chance: spread evenly
/// over the box or cylinder, and told. At most 5000.
Population populationOf(const TiXmlElement& population);

}  // namespace hapticell::workcell
