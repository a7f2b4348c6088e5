// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "haptic/devices/device.h"
#include "haptic/rendering/sample_gate.h"

namespace hapticell::haptic {

/// Reads the stylus once a tick and accepts only samples that a hand can have caused.
///
/// A device that exerts forces *fails* if it has not measured for kStale, or only samples that no hand can have caused.
/// The first sample after that is accepted wherever it is, because no force acts then.
///
/// Force thread; never allocates, locks or throws.
class StylusReader {
 public:
  /// Half a tick before kFreshFor, so that the tick of that age writes a zero force.
  static constexpr double kStale = kFreshFor - 0.0005;

  /// Result of one reading.
  struct Outcome {
    bool impossible = false;  ///< An invalid pose, or one outside this device's reach.
    bool jumped = false;      ///< The sample was accepted as a jump, not a motion.
    bool refused = false;     ///< It was measured, but refused.
    bool fails = false;       ///< The device fails as of this reading.
  };

  /// `device` must outlive this. `period`: of the ticks, s.
  StylusReader(Device& device, double period);

  /// Reads the device, `dt` s after the last reading; `engaged`: forces may be exerted.
  Outcome read(double dt, bool engaged) noexcept;

  /// The newest reading, with the newest accepted pose.
  const DeviceReading& reading() const { return reading_; }
  bool failing() const { return failing_; }
  /// Whether a command is exerted now, at an accepted pose.
  bool isReady() const { return reading_.takes_force && !anew_; }

 private:
  bool believes(const DeviceReading& reading, Outcome& outcome) noexcept;

  Device& device_;
  SampleGate gate_;
  const double period_;
  const bool pushes_;     // The device exerts forces.
  const dvec3 middle_D_;  // Middle of the workspace.
  const double reach_;    // m from there; the stylus cannot be farther away.
  DeviceReading reading_;
  double age_ = 0.0;       // s since a measurement was accepted.
  double judged_ = 0.0;    // s since a measurement was judged.
  double doubt_ = 0.0;     // s of recently refused samples.
  bool measured_ = false;  // A measurement was accepted since the start.
  bool anew_ = true;       // The next measurement is accepted wherever it is, because no force acts.
  bool failing_ = false;
};

}  // namespace hapticell::haptic
