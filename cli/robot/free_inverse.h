// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/kit/subcommand.h"
#include "geometry/system/error.h"

namespace hapticell::cli {

/// What `ik --collision-free` takes besides the poses.
struct FreeInverseOptions {
  bool asked = false;
  std::string workcell, entity;
  double clearance = 0.0;
  bool all = false;  ///< Every free solution, not only the nearest.
  bool until_missing = false;
  int jobs = 0;
};

/// Adds --collision-free, --workcell, --entity, --clearance, --until-missing and --jobs.
void addFreeInverse(Subcommand command, FreeInverseOptions& options);

/// The result of `ik --collision-free`: for each pose of the robot's tool in its root link the nearest solution that
/// touches nothing in the cell, found on all cores.
struct FreeInverseAnswer {
  nlohmann::ordered_json document;
  bool all_solved = true;
};
Expected<FreeInverseAnswer> solveFree(const FreeInverseOptions& options, const std::string& poses);

}  // namespace hapticell::cli
