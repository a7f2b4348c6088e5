// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/system/error.h"
#include "geometry/shapes/pose.h"

namespace hapticell::haptic {

/// Where a hand wants to be at one time.
struct HandSample {
  double t = 0.0;  ///< Seconds from the path's beginning.
  Pose X_DH;
  std::uint32_t buttons = 0;
};

/// A hand's path in the device frame: samples in the order of time.
class HandPath {
 public:
  /// Takes at least one sample, times not falling (a contract).
  explicit HandPath(std::vector<HandSample> samples, std::vector<std::string> assumptions = {});

  /// The sample at `t`: the pose interpolated, the buttons of the sample before. The ends hold outside the path.
  HandSample at(double t) const;
  double duration() const { return samples_.back().t; }
  const std::vector<HandSample>& samples() const { return samples_; }
  /// What was taken for granted of the file (times of a clock, millimetres), a sentence each without a full stop.
  const std::vector<std::string>& assumptions() const { return assumptions_; }

 private:
  std::vector<HandSample> samples_;
  std::vector<std::string> assumptions_;
};

/// Reads `t,x,y,z,qw,qx,qy,qz,button` (a header line, columns in any order; `qw..qz` and `button` may be missing,
/// foreign columns are ignored; `.` is the decimal point whatever the locale). Errors name line and column. Quaternions
/// are normalised when their length is within 1 % of one, else refused. Times of a clock and positions in millimetres
/// are recognised (recogniseHandUnits()) and told in assumptions().
Expected<HandPath> readHandPath(const std::filesystem::path& file);

/// The same of a text; `name` stands for the file in errors.
Expected<HandPath> parseHandPath(std::string_view text, const std::string& name);

}  // namespace hapticell::haptic
