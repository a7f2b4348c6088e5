// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "geometry/error.h"

namespace hapticell::importer {

/// What must be known of a 3MF file (a ZIP archive, ECMA-376 part 2) before it is unpacked.
struct ModelPackage {
  double metres_per_unit =
      1e-3;  ///< As its model says (3MF core specification 1.3, section 3.4.1): a millimetre by default.
};

/// Looks into the archive without unpacking it. Errors: no archive, an entry that leads out of it or is a link, more
/// than a gigabyte once unpacked, or more than 200 times the file (a bomb).
Expected<ModelPackage> lookIntoPackage(const std::filesystem::path& file);

}  // namespace hapticell::importer
