// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "haptic/devices/device.h"
#include "haptic/rendering/sample_gate.h"

namespace hapticell::haptic {

/// Reads the stylus once a tick and believes only what a hand can have made.
///
/// A device that exerts forces *fails* when it has not measured for kStale, or for so long only what no hand can have
/// made. Whatever is measured after that counts, wherever it is: nothing pushes then.
///
/// Force thread; never allocates, locks or throws.
class StylusReader {
 public:
  /// Half a tick before kFreshFor, so that the tick of that age writes a zero force.
  static constexpr double kStale = kFreshFor - 0.0005;

  /// What one reading brought.
  struct Outcome {
    bool impossible = false;  ///< A pose that is none, or where no stylus of this device can be.
    bool jumped = false;      ///< It was taken wherever it is: the stylus has not gone there.
    bool refused = false;     ///< It was measured, but not believed.
    bool fails = false;       ///< The device fails as of this reading.
  };

  /// `device` must outlive this. `period` of the ticks, s.
  StylusReader(Device& device, double period);

  /// The reading `dt` s after the last one; `engaged`: forces may be exerted.
  Outcome read(double dt, bool engaged) noexcept;

  /// The newest one, with the newest believed pose.
  const DeviceReading& reading() const { return reading_; }
  bool failing() const { return failing_; }
  /// What is commanded now is exerted at a place that is believed.
  bool isReady() const { return reading_.takes_force && !anew_; }

 private:
  bool believes(const DeviceReading& reading, Outcome& outcome) noexcept;

  Device& device_;
  SampleGate gate_;
  const double period_;
  const bool pushes_;     // The device exerts forces.
  const dvec3 middle_D_;  // Of the workspace.
  const double reach_;    // m from there; beyond it is no place of the stylus.
  DeviceReading reading_;
  double age_ = 0.0;       // s since a measurement was believed.
  double judged_ = 0.0;    // s since one was judged.
  double doubt_ = 0.0;     // s of samples that were refused, of late.
  bool measured_ = false;  // One was believed since the start.
  bool anew_ = true;       // Whatever is measured next is believed: nothing pushes.
  bool failing_ = false;
};

}  // namespace hapticell::haptic
