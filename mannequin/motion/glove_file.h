// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "geometry/system/error.h"
#include "mannequin/motion/glove_mapping.h"

namespace hapticell::mannequin {

/// A user's calibration of a glove as JSON: {"format":"hapticell-glove","version":1,"gain":[22 numbers],"offset":[22]},
/// rad a reading of 0 .. 255, and rad.
Expected<GloveCalibration> readGloveCalibration(const std::filesystem::path& file);

/// Written to a temporary file and renamed; folders are created. Errors: it cannot be written.
Expected<void> writeGloveCalibration(const GloveCalibration& calibration, const std::filesystem::path& file);

/// Typical values of a hand of middle size without calibration: 60 readings flat, 200 in a fist. Sufficient to see the
/// hand move.
GloveCalibration roughGloveCalibration();

}  // namespace hapticell::mannequin
