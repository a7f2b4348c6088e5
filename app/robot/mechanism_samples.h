// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "workcell/document/document.h"

namespace hapticell::app {

/// Small mechanisms to start with and to learn from.
enum class MechanismSample { kDoor, kGripper, kTurntable };

/// "Door", "Gripper", "Turntable".
const char* nameOf(MechanismSample sample);

/// The content of a sample: solids of the cell, and the joints between them, in W.
struct SampleParts {
  std::string name;
  std::vector<workcell::Entity> parts;  ///< The first one is fixed.
  std::vector<workcell::MechanismJoint> joints;
};
/// A sample with its base at X_WB, with names that the document does not use yet. Error: a shape cannot be made.
Expected<SampleParts> sampleParts(MechanismSample sample, const Pose& X_WB, const workcell::Document& document);

}  // namespace hapticell::app
