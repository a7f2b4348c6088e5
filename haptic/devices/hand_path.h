// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/shapes/pose.h"
#include "geometry/system/error.h"

namespace hapticell::haptic {

/// The intended pose of the hand at one time.
struct HandSample {
  double t = 0.0;  ///< Seconds from the path's beginning.
  Pose X_DH;
  std::uint32_t buttons = 0;
};

/// A hand's path in the device frame: samples in the order of time.
class HandPath {
 public:
  /// Contract: at least one sample, times not decreasing.
  explicit HandPath(std::vector<HandSample> samples, std::vector<Text> assumptions = {});

  /// The sample at `t`: the pose interpolated, the buttons of the sample before. Outside the path, the first or last
  /// sample.
  HandSample at(double t) const;
  double duration() const { return samples_.back().t; }
  const std::vector<HandSample>& samples() const { return samples_; }
  /// What was assumed about the file (times of a clock, millimetres), one sentence each without a full stop.
  const std::vector<Text>& assumptions() const { return assumptions_; }

 private:
  std::vector<HandSample> samples_;
  std::vector<Text> assumptions_;
};

/// Reads `t,x,y,z,qw,qx,qy,qz,button` (a header line, columns in any order; `qw..qz` and `button` may be missing, other
/// columns are ignored; `.` is the decimal point in every locale). Errors name line and column. Quaternions are
/// normalised when their length is within 1 % of one, else refused. Times of a clock and positions in millimetres are
/// recognised (recogniseHandUnits()) and listed in assumptions().
Expected<HandPath> readHandPath(const std::filesystem::path& file);

/// The same from a text; errors use `name` as the file.
Expected<HandPath> parseHandPath(std::string_view text, const std::string& name);

}  // namespace hapticell::haptic
