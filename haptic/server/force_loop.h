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

/// What the caller of tick() knows about its moment.
struct TickTiming {
  std::int64_t late_ns = 0;   ///< How long past its deadline the tick begins.
  std::uint32_t skipped = 0;  ///< Ticks that were due since the last one and are not replayed.
};

/// The 1 kHz loop: reads the device, takes the newest messages, renders, guards, commands the force, tells its state.
///
/// Three threads may hold an end of it, and none ever waits for another:
///  - the *force thread* calls tick() (a RealTimeRunner in real time, anybody in virtual time) and shutDown();
///  - the *link thread* (network thread, or InMemoryLink) calls openLink(), closeLink(), heard() and submit();
///  - the same or another thread reads updateState()/state() and updateFigures()/figures().
/// tick() neither allocates, locks, logs nor throws. A simulated device is also advanced by the time that passed.
///
/// A link is a controlling client's session. While it is open and heard the newest set is held, however old; closed,
/// the force falls to zero within 50 ms; silent for 600 ms, within 200 ms more (SafetyChain), or for as long as
/// expectWithin() says, within 20 ms more; without a new set for 2 s though heard (its loop hangs), within 500 ms more;
/// heard again, it comes back through the engage gate.
class ForceLoop {
 public:
  /// `device` must be open; it and `clock` must outlive the loop.
  ForceLoop(Device& device, const Clock& clock, const ForceLoopOptions& options = {});

  // Force thread.
  void tick(const TickTiming& timing = {}) noexcept;
  /// Force zero, motors off. tick() does nothing afterwards.
  void shutDown() noexcept;
  const HapticState& current() const { return state_; }              ///< Of the last tick.
  const RenderResult& lastRender() const { return render_; }         ///< Of the last tick.
  const SafetyResult& lastSafety() const { return safety_result_; }  ///< Of the last tick.
  const ForceRenderer& renderer() const { return renderer_; }        ///< After the last tick.
  const TickLog& log() const { return recorder_.ticks(); }
  /// Ticks are missed so many times at once (a stalled machine) that a hardware device's motors go off; until the
  /// client takes its enable back and gives it again. A simulated device only counts.
  static constexpr std::uint32_t kStall = StallWatch::kStall;
  /// A device that exerts forces has not measured for kFreshFor, or for so long only what no hand can have made: zero
  /// is written and forces must be enabled anew. Half a tick before, so that the tick of that age writes it.
  static constexpr double kStale = StylusReader::kStale;
  bool motorsOff() const { return stalls_.motorsOff(); }
  std::uint64_t stalls() const { return stalls_.stalls(); }
  double period() const { return 1.0 / options_.rate_hz; }  ///< Seconds; any thread.

  // Link thread.
  /// A controlling client is there: forgets what an earlier one wanted; forces are off until it enables them.
  void openLink() noexcept { inbox_.open(clock_.now()); }
  void closeLink() noexcept { inbox_.close(); }
  /// The client was heard (any message, a heart-beat at least every kHeartbeatPeriod).
  void heard() noexcept { inbox_.heard(clock_.now()); }
  /// How long this client may be silent, s, by the beat of its heart so far; 0: as the options say.
  void expectWithin(double seconds) noexcept { inbox_.expectWithin(seconds); }
  /// Newest wins. The set's stamp must be in this loop's clock (or 0: its age is then not counted).
  void submit(const ConstraintSet& set) noexcept { inbox_.submit(set); }
  void submit(const HapticControl& control) noexcept { inbox_.submit(control); }
  void submit(const HandTarget& target) noexcept { inbox_.submit(target); }

  // Reader thread.
  bool updateState() noexcept { return output_.states().update(); }  ///< True when there is a newer state.
  const HapticState& state() const { return output_.states().value(); }
  bool updateFigures() noexcept { return output_.figures().update(); }  ///< True about ten times a second.
  const LoopFigures& figures() const { return output_.figures().value(); }

  // Any one other thread: what was recorded around a fault.
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

  // Force thread's own.
  StylusReader reader_;
  StallWatch stalls_;
  SimulatedHandDriver hand_;
  ForceRenderer renderer_;
  SafetyChain safety_;
  TickRecorder recorder_;
  bool running_ = true;
  std::uint64_t tick_ = 0;
  HapticControl control_;
  std::int64_t last_set_ns_ = 0;  // When a set came last, whatever became of it, or the session began.
  bool engaged_ = false;          // What the device was told last.
  RenderResult render_;
  SafetyResult safety_result_;
  HapticState state_;
};

}  // namespace hapticell::haptic
