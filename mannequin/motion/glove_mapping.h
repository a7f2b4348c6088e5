// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>

#include "mannequin/posture/posture.h"

namespace hapticell::mannequin {

/// Sensors of a 22-sensor glove in the order of its frames (CyberGlove): thumb rotation, MPJ, IJ, abduction; index MPJ,
/// PIJ, DIJ; middle MPJ, PIJ, DIJ, abduction to the index; ring likewise to the middle; little finger likewise to the
/// ring; palm arch; wrist pitch and yaw.
inline constexpr std::size_t kGloveSensors = 22;
using GloveReadings = std::array<double, kGloveSensors>;

/// 22 readings of a glove with 18 or 22 sensors; the outer finger joints that the smaller one lacks repeat the joint
/// before them. Empty if there are neither 18 nor 22 numbers.
std::optional<GloveReadings> gloveReadings(std::span<const double> readings);

/// The four poses of a calibration; the user holds each while readings are taken.
struct GloveCalibrationPoses {
  GloveReadings flat{};         ///< Fingers straight and together, thumb next to the palm.
  GloveReadings fist{};         ///< Fingers curled by 90 deg at every joint.
  GloveReadings spread{};       ///< Fingers 20 deg apart, thumb 50 deg.
  GloveReadings thumb_under{};  ///< Thumb across under the palm.
};

/// angle = gain * reading + offset of each sensor, rad.
struct GloveCalibration {
  GloveReadings gain{};
  GloveReadings offset{};
};

/// Two poses calibrate each sensor. Empty if a sensor hardly differs between its two poses (by less than 4 of 255): the
/// poses were not held, or the sensor is dead; `bad_sensor`, if given, is its index.
std::optional<GloveCalibration> calibrateGlove(const GloveCalibrationPoses& poses, std::size_t* bad_sensor = nullptr);

/// Joint angles of all sensors, rad.
GloveReadings gloveAngles(const GloveCalibration& calibration, const GloveReadings& readings);

/// Applies them to a hand of the figure, within its limits: curl of the fingers (mean of MPJ and PIJ of the four),
/// thumb flexion (MPJ and IJ), thumb abduction. The wrist is unchanged: a tracker gives its pose.
void setHandFromGlove(const GloveReadings& angles, Side side, Posture& posture);

}  // namespace hapticell::mannequin
