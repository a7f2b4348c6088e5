// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "trajectory/programs/writing/program_export.h"
#include "trajectory/programs/writing/program_numbers.h"

namespace hapticell::trajectory {

/// Input of all writers, checked by exportProgram: at least one frame; six joints or none.
struct ProgramInput {
  const Trajectory& trajectory;
  const ProgramOptions& options;
  std::string name;  ///< Accepted by the controller.
  /// One per frame, m; 0 at the ends, at dwells and where the language cannot represent it.
  std::vector<double> blends;
  const ProgramNumbers& rules;
  NumberWriter& numbers;

  bool hasJoints() const { return trajectory.hasJoints(); }
  std::string configurationAt(std::size_t i) const;
  /// Numbers of the options and of frame `i` in the unit of the language.
  std::string speed() const { return numbers.text(rules.speed, options.speed, Text("speed")); }
  std::string acceleration() const {
    return numbers.text(rules.acceleration, options.acceleration, Text("acceleration"));
  }
  std::string jointSpeed() const { return numbers.text(rules.joint_speed, options.joint_speed, Text("joint speed")); }
  std::string blend(std::size_t i) const { return numbers.text(rules.blend, blends[i], Text("blend"), placeOf(i)); }
  std::string dwell(std::size_t i) const {
    return numbers.text(rules.dwell, trajectory[i].dwell, Text("dwell"), placeOf(i));
  }

 private:
  static Text placeOf(std::size_t i) { return Text("frame %1", i); }
};

std::vector<ProgramFile> writeKrl(const ProgramInput& input);
std::vector<ProgramFile> writeRapid(const ProgramInput& input);
std::vector<ProgramFile> writeFanuc(const ProgramInput& input);
std::vector<ProgramFile> writeUrScript(const ProgramInput& input);
std::vector<ProgramFile> writeVal3(const ProgramInput& input);
std::vector<ProgramFile> writeInform(const ProgramInput& input);

/// "a, b, c" of numbers times `unit`, with `decimals` digits.
std::string numberList(std::initializer_list<double> values, int decimals, std::string_view separator = ",");
std::string jointList(std::span<const double> joints, int decimals, double unit, std::string_view separator = ",");

inline constexpr double kDegreesPerRadian = 57.295779513082323;
inline constexpr double kMillimetres = 1000.0;

}  // namespace hapticell::trajectory
