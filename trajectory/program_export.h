// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/error.h"
#include "trajectory/trajectory.h"

namespace hapticell::trajectory {

enum class ProgramFormat { kKrl, kRapid, kFanuc, kUrScript, kVal3 };

/// What a program says beside its targets. Poses are of the TCP in the robot's base (or the user's frame, where the
/// caller put them there).
struct ProgramOptions {
  std::string name;       ///< Letters, digits and `_`; empty: of the trajectory. Shortened to what a controller takes.
  std::string tool = "";  ///< The controller's own tool; empty: its default.
  std::string base = "";  ///< Work object, base or user frame.
  double speed = 0.25;    ///< m/s along lines.
  double acceleration = 1.2;  ///< m/s2, where the format has one.
  double joint_speed = 0.2;   ///< Share of the greatest, for the first move.
  double blend = 0.002;       ///< m; kept below half of the way to either neighbour.
  /// The robot's configuration at joints: KUKA "S 2, T 35", ABB "[0,-1,0,1]", FANUC "N U T, 0, 0, 0"; empty where none.
  std::function<std::string(std::span<const double>)> configuration{};
};

/// One file of a program: its name and bytes. `name` may hold a folder (VAL3).
struct ProgramFile {
  std::string name;
  std::string content;
};

/// The trajectory as a program of that controller, a joint move to the first frame (where joints are known), then a
/// line to each frame. Numbers have '.' whatever the locale; units are the format's. The header says what the user must
/// check: tool, base, safety. Errors: no frames; a joint robot's format for a trajectory with other than six joints
/// (then only poses would do: FANUC and VAL3 need none).
Expected<std::vector<ProgramFile>> exportProgram(const Trajectory& trajectory, ProgramFormat format,
                                                 const ProgramOptions& options);

/// The files with whole paths as names: one under the name asked for (with the format's extension where it has none),
/// several beside it with the same stem, VAL3's in a folder of that name.
std::vector<ProgramFile> placedProgram(const std::vector<ProgramFile>& files, ProgramFormat format,
                                       const std::filesystem::path& wanted);

}  // namespace hapticell::trajectory
