// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "trajectory/programs/reading/program_path.h"

namespace hapticell::trajectory {

/// A position in /POS, of group 1.
struct FanucPosition {
  std::size_t line = 0;
  std::optional<Pose> X;
  std::optional<ProgramPath::Joints> joints;
  int frame = 0;
  bool has_more_groups = false;
  bool has_external_axes = false;
};

struct FanucLine {
  std::size_t line = 0;
  std::string text;  ///< Upper case, without blanks except inside texts.
};

/// Content of an LS file: its sections /PROG, /MN and /POS.
struct FanucFile {
  std::string name;
  std::vector<FanucLine> lines;  ///< Without remarks; a statement over several lines counts as one.
  std::map<int, FanucPosition> positions;
};

FanucFile parseFanuc(const std::string& text);

}  // namespace hapticell::trajectory
