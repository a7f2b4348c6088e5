// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "cli/kit/subcommand.h"
#include "mannequin/motion/recorded_motion.h"

namespace hapticell::cli {

/// --up and --markers, which say how a recorded motion is read.
void addMotionReading(Subcommand command, std::string& up, std::string& markers);
Expected<mannequin::MotionReading> motionReading(const std::string& up, const std::string& markers);

/// `up`, `marker_set` (of markers) and `assumptions[]`: what was understood of the file.
void addReading(const mannequin::RecordedMotion& motion, nlohmann::ordered_json& document);

}  // namespace hapticell::cli
