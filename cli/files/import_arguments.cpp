// SPDX-License-Identifier: Apache-2.0
#include "cli/files/import_arguments.h"

namespace hapticell::cli {

void addTessellationOptions(Subcommand command, workcell::Tessellation& tessellation) {
  command
      .option("--chord", tessellation.chord,
              "STEP and IGES: farthest distance of a triangle from the true face, metres (0.0001)")
      .within(1e-9, 1e3);
  command.option("--angle", tessellation.angle, "STEP and IGES: largest turn along an edge, radians (0.3)")
      .within(1e-3, 3.0);
}

}  // namespace hapticell::cli
