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

/// The content of a program other than its targets. Poses are of the TCP in the robot's base (or in the user frame, if
/// the caller transformed them).
struct ProgramOptions {
  /// Any text; empty: the name of the trajectory. Converted to a name of the language (program_names.h).
  std::string name;
  /// The controller's own tool; empty: its default. A number for FANUC and INFORM, otherwise an expression of the
  /// language (KRL "TOOL_DATA[1]", URScript "p[0,0,0.1,0,0,0]").
  std::string tool = "";
  std::string base = "";      ///< Work object, base or user frame, likewise.
  double speed = 0.25;        ///< m/s along lines.
  double acceleration = 1.2;  ///< m/s2, if the format has one.
  double joint_speed = 0.2;   ///< Share of the greatest speed, for the first move.
  double blend = 0.002;       ///< m; limited to half of the distance to either neighbour.
  /// The robot's configuration for given joints: KUKA "S 2, T 35", ABB "[0,-1,0,1]", FANUC "N U T, 0, 0, 0"; empty if
  /// unknown.
  std::function<std::string(std::span<const double>)> configuration{};
  /// False: a program is returned even if its targets read back farther than kProgramPromise from their frames.
  bool must_read_back = true;
};

/// One file of a program: its name and bytes. `name` may contain a folder (VAL3).
struct ProgramFile {
  std::string name;
  std::string content;
};

/// The trajectory as a program for this controller: a joint move to the first frame (if joints are known), then a
/// linear move to each frame. Numbers have '.' in any locale; units are those of the format. The header states what the
/// user must check: tool, base, safety. `notes` receives what users should know: a changed name, a rounded number.
/// Errors: no frames; not six joints; a pose that is not finite; a number that the language cannot represent (it would
/// become 0 or be cut to its range); a tool or base that is not an expression of the language; a program that does not
/// read back within kProgramPromise.
Expected<std::vector<ProgramFile>> exportProgram(const Trajectory& trajectory, ProgramFormat format,
                                                 const ProgramOptions& options, std::vector<Text>* notes = nullptr);

/// The accuracy promised for a written program: every target is within this (m, rad) of its frame. Languages write 1e-3
/// mm or better, angles 1e-4 deg. Half: rounding of some languages fails; twice: an error of 2 um passes.
inline constexpr PathTolerance kProgramPromise{1e-6, 2e-6};

/// The largest distance of targets from their frames, and where it occurs.
struct ProgramMeasure {
  PoseDistance largest;
  std::size_t frame_of_position = 0, frame_of_angle = 0;
};

/// Reads the program back with the reader of the language, which shares nothing with its writer, and measures it
/// against the trajectory, in the program's own base. Errors: something cannot be read back, or the targets differ.
Expected<ProgramMeasure> measureProgram(const std::vector<ProgramFile>& files, ProgramFormat format,
                                        const ProgramOptions& options, const Trajectory& trajectory);

/// The files with complete paths: one file with the requested name (with the format's extension if it has none);
/// several files beside it with the same stem; VAL3 in a folder of that name.
std::vector<ProgramFile> placedProgram(const std::vector<ProgramFile>& files, ProgramFormat format,
                                       const std::filesystem::path& wanted);

}  // namespace hapticell::trajectory
