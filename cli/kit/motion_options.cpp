// SPDX-License-Identifier: Apache-2.0
#include "cli/kit/motion_options.h"

#include "cli/kit/result_writer.h"

namespace hapticell::cli {

void addMotionReading(Subcommand command, std::string& up, std::string& markers) {
  command.option("--up", up, "Up axis of the motion file (x, y, z; --up=-z). Default: detected");
  command.option("--markers", markers, "Table of your own markers, for a .c3d (docs/user/formats.md)")
      .takes(ValueKind::kFile);
}

Expected<mannequin::MotionReading> motionReading(const std::string& up, const std::string& markers) {
  mannequin::MotionReading reading;
  reading.markers = markers;
  if (up.empty()) return reading;
  const auto axis = mannequin::parseUpAxis(up);
  HAPTICELL_TRY(axis);
  reading.up = *axis;
  return reading;
}

void addReading(const mannequin::RecordedMotion& motion, nlohmann::ordered_json& document) {
  document["up"] = mannequin::nameOf(motion.up);
  if (!motion.marker_set.empty()) document["marker_set"] = motion.marker_set;
  nlohmann::ordered_json& assumptions = document["assumptions"] = nlohmann::ordered_json::array();
  for (const Text& sentence : motion.assumptions) assumptions.push_back(sentence);
}

}  // namespace hapticell::cli
