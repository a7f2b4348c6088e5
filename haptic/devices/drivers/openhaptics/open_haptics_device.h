// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <string>

#include "geometry/shapes/pose.h"
#include "haptic/devices/command_steps.h"
#include "haptic/devices/drivers/openhaptics/hd_library.h"
#include "haptic/rendering/triple_buffer.h"

namespace hapticell::driver {

/// HDAPI's frame (x right, y up, z to the user, mm) against D (x right, y away, z up, m, origin in the middle).
struct HdFrame {
  dvec3 middle_hd{0.0};  ///< Middle of the usable workspace, mm.

  dvec3 position(const double* position_hd) const;
  /// Orientation from the 4x4 transform, whose translation is in [12..14].
  static dquat orientation(const double* transform_hd);
  /// N, or N m, from D to HDAPI's axes.
  static dvec3 toHd(const dvec3& v_D);
};

/// A Phantom, Touch or Touch X driven by OpenHaptics in the vendor's scheduler.
///
/// The scheduler's callback measures and commands once a tick, in one frame. Triple buffers pass the values to and from
/// the host's thread. If the host commands nothing for 50 ticks, the force is zero.
class OpenHapticsDevice final : public Device {
 public:
  /// `handle` is an initialised device; it is the current device when this object is made.
  OpenHapticsDevice(const HdLibrary& hd, unsigned handle);
  /// Disables the device. The scheduler must not run.
  ~OpenHapticsDevice();
  OpenHapticsDevice(const OpenHapticsDevice&) = delete;
  OpenHapticsDevice& operator=(const OpenHapticsDevice&) = delete;

  /// Registers the callback with the vendor's scheduler, which must not run yet.
  void schedule();
  const Capabilities& capabilities() const noexcept override { return capabilities_; }
  Status read(State& state) noexcept override;
  Status write(const Command& command) noexcept override;
  const Problem& problem() const noexcept override { return problem_; }
  const char* calibrationText(std::uint32_t step) const noexcept override;
  Status calibrate(std::uint32_t step) noexcept override;

 private:
  /// Results of one tick of the scheduler.
  struct Sample {
    State state;
    unsigned error = 0;  ///< The most serious error of this tick, HDAPI's code; 0: no error.
    int internal = 0;
  };

  void readCapabilities();
  unsigned tick();
  void measure(Sample& sample);
  void calibrateIfAsked(Sample& sample);
  void command();
  void collectErrors(Sample& sample);
  Status statusOf(const Sample& sample) noexcept;

  const HdLibrary& hd_;
  unsigned handle_;
  unsigned long callback_ = 0;
  bool scheduled_ = false;
  Capabilities capabilities_;
  HdFrame frame_;
  unsigned calibration_style_ = 0;

  haptic::TripleBuffer<Command> commands_;
  haptic::TripleBuffer<Sample> samples_;
  std::atomic<bool> asked_to_calibrate_{false};

  // Scheduler's thread only.
  int ticks_without_command_ = 0;
  int quiet_ticks_ = 0;  // Ticks without force after the vendor's library has refused one.
  int warm_ticks_ = 0;
  CommandSteps steps_;
  bool force_output_ = false;
  bool let_go_ = false;  // Commands are not exerted until a command without motors arrives.

  // Host's thread only.
  int reads_without_sample_ = 0;
  bool switched_off_ = false;  // Without the scheduler, because it does not run.
  Problem problem_;
};

/// Converts an HDAPI error to a problem with its fix; `code` is HDAPI's, `text` the library's text.
Problem hdProblem(unsigned code, int internal, const std::string& text);

}  // namespace hapticell::driver
