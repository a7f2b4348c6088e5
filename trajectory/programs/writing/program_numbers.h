// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trajectory/programs/writing/program_export.h"

namespace hapticell::trajectory {

/// How a language writes one kind of number: its range, its unit, and the number of digits.
struct NumberRule {
  const char* unit;
  double scale;  ///< From SI to `unit`.
  double least, greatest;
  int decimals;
};

/// The rules of one language. If it has no such number, `greatest` is 0.
struct ProgramNumbers {
  const char* language;     ///< "KUKA KRL"
  NumberRule speed;         ///< Of lines, from m/s.
  NumberRule acceleration;  ///< Of lines, from m/s2.
  NumberRule joint_speed;   ///< Of the first move, from a share of 1.
  NumberRule blend;         ///< From m.
  NumberRule dwell;         ///< From s.
};

/// Ranges as in the makers' manuals; if these leave the upper end to the robot, a value that no robot reaches.
const ProgramNumbers& programNumbers(ProgramFormat format);

/// Converts numbers to the text of the language, and records errors and rounding.
///
/// A number that the language cannot represent (it would become 0, or the end of the range) is an error; the first one
/// is kept. Rounding by more than 0.1 % is a note, once for each kind of number.
class NumberWriter {
 public:
  explicit NumberWriter(const ProgramNumbers& numbers) : numbers_(numbers) {}

  /// `value` in SI by `rule`; `name` is the user's word for it ("speed", "dwell of frame 3").
  std::string text(const NumberRule& rule, double value, const Text& kind, const Text& place = {});

  const std::optional<Error>& error() const { return error_; }
  const std::vector<Text>& notes() const { return notes_; }

 private:
  const ProgramNumbers& numbers_;
  std::optional<Error> error_;
  std::vector<Text> notes_;
  std::vector<Text> noted_kinds_;
};

}  // namespace hapticell::trajectory
