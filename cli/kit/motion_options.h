// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "cli/kit/subcommand.h"
#include "mannequin/motion/recorded_motion.h"

namespace hapticell::cli {

/// Adds --up and --markers, which say how to read a recorded motion.
void addMotionReading(Subcommand command, std::string& up, std::string& markers);
Expected<mannequin::MotionReading> motionReading(const std::string& up, const std::string& markers);

/// Adds `up`, `marker_set` (for markers) and `assumptions[]`: how the file was interpreted.
void addReading(const mannequin::RecordedMotion& motion, nlohmann::ordered_json& document);

}  // namespace hapticell::cli
