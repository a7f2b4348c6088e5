// SPDX-License-Identifier: Apache-2.0
#include "cli/files/import_arguments.h"

namespace hapticell::cli {

void addTessellationOptions(Subcommand command, workcell::Tessellation& tessellation) {
  command.option("--chord", tessellation.chord, "STEP and IGES: chord error, m (0.0001)").within(1e-9, 1e3);
  command
      .option("--angle", tessellation.angle,
              "STEP and IGES: largest angle between neighbouring triangles along an edge, rad (0.3)")
      .within(1e-3, 3.0);
}

}  // namespace hapticell::cli
