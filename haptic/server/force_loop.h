// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "haptic/devices/device.h"
#include "haptic/protocol/messages.h"
#include "haptic/rendering/force_renderer.h"
#include "haptic/rendering/safety_chain.h"
#include "haptic/server/client_inbox.h"
#include "haptic/server/clock.h"
#include "haptic/server/force_loop_options.h"
#include "haptic/server/loop_output.h"
#include "haptic/server/simulated_hand_driver.h"
#include "haptic/server/stall_watch.h"
#include "haptic/server/stylus_reader.h"
#include "haptic/server/tick_recorder.h"

namespace hapticell::haptic {

/// Timing of a tick, from the caller of tick().
struct TickTiming {
  std::int64_t late_ns = 0;   ///< Delay of the tick's start after its deadline.
  std::uint32_t skipped = 0;  ///< Ticks that were due since the last one and were skipped.
};

/// The 1 kHz loop: reads the device, takes the newest messages, renders, applies the safety chain, commands the force,
/// publishes its state.
///
/// Three threads may use it, and none ever waits for another:
///  - the *force thread* calls tick() (a RealTimeRunner in real time, anybody in virtual time) and shutDown();
///  - the *link thread* (network thread, or InMemoryLink) calls openLink(), closeLink(), heard() and submit();
///  - the same or another thread reads updateState()/state() and updateFigures()/figures(). tick() does not allocate,
///    lock, log or throw. It also advances a simulated device by the elapsed time.
///
/// A link is the session of a controlling client. While it is open and its client is heard, the newest set stays in
/// use, however old. If the link closes, the force falls to zero within 50 ms. If the client is silent for 600 ms, the
/// force falls within 200 ms more (SafetyChain); after the time of expectWithin(), within 20 ms more. If the client is
/// heard but sends no new set for 2 s (its loop hangs), the force falls within 500 ms more. When it is heard again, the
/// force returns through the engage gate.
class ForceLoop {
 public:
  /// `device` must be open; it and `clock` must outlive the loop.
  ForceLoop(Device& device, const Clock& clock, const ForceLoopOptions& options = {});

  // Force thread.
  void tick(const TickTiming& timing = {}) noexcept;
  /// Sets the force to zero and the motors off. Afterwards tick() does nothing.
  void shutDown() noexcept;
  const HapticState& current() const { return state_; }              ///< Of the last tick.
  const RenderResult& lastRender() const { return render_; }         ///< Of the last tick.
  const SafetyResult& lastSafety() const { return safety_result_; }  ///< Of the last tick.
  const ForceRenderer& renderer() const { return renderer_; }        ///< After the last tick.
  const TickLog& log() const { return recorder_.ticks(); }
  /// If this many ticks are missed at once (a stalled machine), a hardware device's motors go off until the client
  /// disables and enables forces again. For a simulated device this is only counted.
  static constexpr std::uint32_t kStall = StallWatch::kStall;
  /// If a device that exerts forces has not measured for kFreshFor, or only poses that no hand can have caused, zero is
  /// written and forces must be enabled again. The limit is half a tick shorter, so that the tick of that age writes
  /// the zero.
  static constexpr double kStale = StylusReader::kStale;
  bool motorsOff() const { return stalls_.motorsOff(); }
  std::uint64_t stalls() const { return stalls_.stalls(); }
  double period() const { return 1.0 / options_.rate_hz; }  ///< Seconds; any thread.

  // Link thread.
  /// A controlling client has connected: forgets the requests of an earlier one; forces are off until the new one
  /// enables them.
  void openLink() noexcept { inbox_.open(clock_.now()); }
  void closeLink() noexcept { inbox_.close(); }
  /// The client was heard (any message; a heart-beat at least every kHeartbeatPeriod).
  void heard() noexcept { inbox_.heard(clock_.now()); }
  /// Sets how long this client may be silent, s, from its heart-beats so far; 0: as in the options.
  void expectWithin(double seconds) noexcept { inbox_.expectWithin(seconds); }
  /// The newest set wins. Its stamp must be in this loop's clock (or 0: its age is then ignored).
  void submit(const ConstraintSet& set) noexcept { inbox_.submit(set); }
  void submit(const HapticControl& control) noexcept { inbox_.submit(control); }
  void submit(const HandTarget& target) noexcept { inbox_.submit(target); }

  // Reader thread.
  bool updateState() noexcept { return output_.states().update(); }  ///< True when there is a newer state.
  const HapticState& state() const { return output_.states().value(); }
  bool updateFigures() noexcept { return output_.figures().update(); }  ///< True about ten times a second.
  const LoopFigures& figures() const { return output_.figures().value(); }

  // Any one other thread: the recording around a fault.
  FaultRecorder& faults() noexcept { return recorder_.faults(); }

  // Any one other thread: the same figures once more, for a report.
  bool updateReport() noexcept { return output_.report().update(); }
  const LoopFigures& report() const { return output_.report().value(); }

 private:
  bool changeSession() noexcept;
  void takeMessages(std::int64_t now) noexcept;
  void record(std::int64_t now, const TickTiming& timing) noexcept;
  void readDevice(double dt) noexcept;
  void guardAndWrite(std::int64_t now, double dt) noexcept;
  void publish(std::int64_t now, const TickTiming& timing) noexcept;

  Device& device_;
  const Clock& clock_;
  const ForceLoopOptions options_;
  ClientInbox inbox_;
  LoopOutput output_;

  // Force thread only.
  StylusReader reader_;
  StallWatch stalls_;
  SimulatedHandDriver hand_;
  ForceRenderer renderer_;
  SafetyChain safety_;
  TickRecorder recorder_;
  bool running_ = true;
  std::uint64_t tick_ = 0;
  HapticControl control_;
  std::int64_t last_set_ns_ = 0;  // When the last set arrived, adopted or not, or the session began.
  bool engaged_ = false;          // The last value passed to the device.
  RenderResult render_;
  SafetyResult safety_result_;
  HapticState state_;
};

}  // namespace hapticell::haptic
