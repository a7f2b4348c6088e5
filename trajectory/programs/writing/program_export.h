// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/system/error.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory {

enum class ProgramFormat { kKrl, kRapid, kFanuc, kUrScript, kVal3, kInform };

/// The content of a program apart from its targets. Poses are of the TCP in the robot's base (or the user's frame,
/// where the caller put them there).
struct ProgramOptions {
  std::string name;  ///< Any text; empty: of the trajectory. Made a name of the language (program_names.h).
  /// The controller's own tool; empty: its default. A number for FANUC and INFORM, else an expression of the language
  /// (KRL "TOOL_DATA[1]", URScript "p[0,0,0.1,0,0,0]").
  std::string tool = "";
  std::string base = "";      ///< Work object, base or user frame, likewise.
  double speed = 0.25;        ///< m/s along lines.
  double acceleration = 1.2;  ///< m/s2, where the format has one.
  double joint_speed = 0.2;   ///< Share of the greatest, for the first move.
  double blend = 0.002;       ///< m; kept below half of the way to either neighbour.
  /// The robot's configuration at joints: KUKA "S 2, T 35", ABB "[0,-1,0,1]", FANUC "N U T, 0, 0, 0"; empty where none.
  std::function<std::string(std::span<const double>)> configuration{};
  /// False: a program whose targets read back further than kProgramPromise from their frames is given all the same.
  bool must_read_back = true;
};

/// One file of a program: its name and bytes. `name` may hold a folder (VAL3).
struct ProgramFile {
  std::string name;
  std::string content;
};

/// The trajectory as a program of that controller, a joint move to the first frame (where joints are known), then a
/// line to each frame. Numbers have '.' whatever the locale; units are the format's. The header says what the user must
/// check: tool, base, safety. `notes` gets what users should know: a name that was changed, a number that was rounded.
/// Errors: no frames; other than six joints; a pose that is not finite; a number that the language cannot hold (it
/// would become 0 or be cut to its range); a tool or base that is no word of the language; a program that does not read
/// back within kProgramPromise.
Expected<std::vector<ProgramFile>> exportProgram(const Trajectory& trajectory, ProgramFormat format,
                                                 const ProgramOptions& options, std::vector<Text>* notes = nullptr);

/// What a written program is promised to hold: every target within this (m, rad) of its frame: languages have 1e-3 mm
/// or better, angles 1e-4 deg. Half: rounding of some languages fails; twice: 2 um off passes.
inline constexpr PathTolerance kProgramPromise{1e-6, 2e-6};

/// How far targets are from their frames at most, and where.
struct ProgramMeasure {
  PoseDistance largest;
  std::size_t frame_of_position = 0, frame_of_angle = 0;
};

/// Reads the program back by the language's reader, which shares nothing with its writer, and measures it against the
/// trajectory, in the program's own base. Errors: what cannot be read back, or has other targets.
Expected<ProgramMeasure> measureProgram(const std::vector<ProgramFile>& files, ProgramFormat format,
                                        const ProgramOptions& options, const Trajectory& trajectory);

/// The files with whole paths as names: one file under the requested name (with the format's extension if it has none);
/// several files next to it with the same stem; VAL3 in a folder of that name.
std::vector<ProgramFile> placedProgram(const std::vector<ProgramFile>& files, ProgramFormat format,
                                       const std::filesystem::path& wanted);

}  // namespace hapticell::trajectory
