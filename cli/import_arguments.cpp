// SPDX-License-Identifier: Apache-2.0
#include "cli/import_arguments.h"

#include "cli/number_range.h"

namespace hapticell::cli {

void addTessellationOptions(CLI::App& command, workcell::Tessellation& tessellation) {
  command
      .add_option("--chord", tessellation.chord,
                  "STEP and IGES: farthest distance of a triangle from the true face, metres (0.0001)")
      ->check(numberRange(1e-9, 1e3));
  command.add_option("--angle", tessellation.angle, "STEP and IGES: largest turn along an edge, radians (0.3)")
      ->check(numberRange(1e-3, 3.0));
}

}  // namespace hapticell::cli
