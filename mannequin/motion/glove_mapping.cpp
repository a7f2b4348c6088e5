// SPDX-License-Identifier: Apache-2.0
#include "mannequin/motion/glove_mapping.h"

#include <algorithm>
#include <cmath>

#include "mannequin/body/rotations.h"

namespace hapticell::mannequin {

namespace {

// Of 255 steps between two poses: less is noise, or a dead sensor. Half: a step of noise makes gains 50 % wrong; twice:
// sensors with a small range are called bad.
constexpr double kLeastChange = 4.0;
constexpr std::array<std::size_t, 4> kOuterJoints = {6, 9, 13, 17};
constexpr std::size_t kWristPitch = 20, kWristYaw = 21;

/// The second pose that fixes a sensor, with its angle in both, degrees.
struct SensorRule {
  GloveReadings GloveCalibrationPoses::*second;
  double flat, other;
};
SensorRule ruleOf(std::size_t sensor) {
  switch (sensor) {
    case 0:
      return {&GloveCalibrationPoses::thumb_under, 0.0, 60.0};
    case 1:
      return {&GloveCalibrationPoses::thumb_under, 0.0, 50.0};
    case 2:
      return {&GloveCalibrationPoses::thumb_under, 0.0, 80.0};
    case 3:
      return {&GloveCalibrationPoses::spread, 5.0, 50.0};
    case 10:
    case 14:
    case 18:
      return {&GloveCalibrationPoses::spread, 0.0, 20.0};
    case 19:
      return {&GloveCalibrationPoses::thumb_under, 0.0, 40.0};
    default:
      return {&GloveCalibrationPoses::fist, 0.0, 90.0};
  }
}

}  // namespace

std::optional<GloveReadings> gloveReadings(std::span<const double> readings) {
  GloveReadings all{};
  if (readings.size() == kGloveSensors) {
    std::copy(readings.begin(), readings.end(), all.begin());
    return all;
  }
  if (readings.size() != kGloveSensors - kOuterJoints.size()) return std::nullopt;
  std::size_t next = 0;
  for (std::size_t i = 0; i < kGloveSensors; ++i) {
    const bool outer = std::find(kOuterJoints.begin(), kOuterJoints.end(), i) != kOuterJoints.end();
    all[i] = outer ? all[i - 1] : readings[next++];
  }
  return all;
}

std::optional<GloveCalibration> calibrateGlove(const GloveCalibrationPoses& poses, std::size_t* bad_sensor) {
  GloveCalibration calibration;
  for (std::size_t i = 0; i < kGloveSensors; ++i) {
    if (i == kWristPitch || i == kWristYaw) {
      // No pose bends the wrist by a known angle: flat is zero, and the whole range of the sensor is taken for 180 deg.
      calibration.gain[i] = 180.0 / 255.0 * kDegree;
      calibration.offset[i] = -calibration.gain[i] * poses.flat[i];
      continue;
    }
    const SensorRule rule = ruleOf(i);
    const GloveReadings& second = poses.*rule.second;
    const double change = second[i] - poses.flat[i];
    if (!(std::abs(change) >= kLeastChange)) {
      if (bad_sensor != nullptr) *bad_sensor = i;
      return std::nullopt;
    }
    calibration.gain[i] = (rule.other - rule.flat) * kDegree / change;
    calibration.offset[i] = rule.flat * kDegree - calibration.gain[i] * poses.flat[i];
  }
  return calibration;
}

GloveReadings gloveAngles(const GloveCalibration& calibration, const GloveReadings& readings) {
  GloveReadings angles{};
  for (std::size_t i = 0; i < kGloveSensors; ++i) {
    angles[i] = calibration.gain[i] * readings[i] + calibration.offset[i];
  }
  return angles;
}

void setHandFromGlove(const GloveReadings& angles, Side side, Posture& posture) {
  double curl = 0.0;
  for (const std::size_t knuckle : {4u, 7u, 11u, 15u}) curl += (angles[knuckle] + angles[knuckle + 1]) / 8.0;
  const auto set = [&](Dof left, double angle) {
    const Dof dof = armDof(side, left);
    posture[dof] = std::clamp(std::isfinite(angle) ? angle : 0.0, dofInfo(dof).lower, dofInfo(dof).upper);
  };
  set(Dof::kLeftFingersCurl, curl);
  set(Dof::kLeftThumbFlexion, 0.5 * (angles[1] + angles[2]));
  set(Dof::kLeftThumbAbduction, angles[3]);
}

}  // namespace hapticell::mannequin
