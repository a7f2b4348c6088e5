// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>

#include "haptic/devices/device.h"
#include "haptic/protocol/messages.h"
#include "haptic/rendering/force_renderer.h"
#include "haptic/rendering/safety_chain.h"
#include "haptic/rendering/sample_gate.h"
#include "haptic/rendering/triple_buffer.h"
#include "haptic/server/clock.h"
#include "haptic/server/fault_recorder.h"
#include "haptic/server/loop_statistics.h"
#include "haptic/server/tick_log.h"

namespace hapticell::haptic {

class SimulatedDevice;

/// How a force loop runs.
struct ForceLoopOptions {
  double rate_hz = 1000.0;
  RendererOptions renderer;  ///< Stiffness and damping of the device's own, and its delay.
  SafetyOptions safety;
  std::size_t log_ticks = 4096;  ///< How many ticks the log keeps.
};

/// The options that follow from what a device can do: its forces, stiffness, damping and delay.
ForceLoopOptions optionsFor(const Device& device, double rate_hz = 1000.0);

/// What a client is told of a device at connection.
DeviceDescription describe(const Device& device);

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
  const TickLog& log() const { return log_; }
  /// Ticks are missed so many times at once (a stalled machine) that a hardware device's motors go off; until the
  /// client takes its enable back and gives it again. A simulated device only counts.
  static constexpr std::uint32_t kStall = 20;
  /// A device that exerts forces has not measured for kFreshFor, or for so long only what no hand can have made: zero
  /// is written and forces must be enabled anew. Half a tick before, so that the tick of that age writes it.
  static constexpr double kStale = kFreshFor - 0.0005;
  bool motorsOff() const { return motors_off_; }
  std::uint64_t stalls() const { return stalls_; }
  double period() const { return period_; }  ///< Seconds; any thread.

  // Link thread.
  /// A controlling client is there: forgets what an earlier one wanted; forces are off until it enables them.
  void openLink() noexcept;
  void closeLink() noexcept;
  /// The client was heard (any message, a heart-beat at least every kHeartbeatPeriod).
  void heard() noexcept { last_heard_.store(clock_.now(), std::memory_order_relaxed); }
  /// How long this client may be silent, s, by the beat of its heart so far; 0: as the options say.
  void expectWithin(double seconds) noexcept { silence_limit_.store(seconds, std::memory_order_relaxed); }
  /// Newest wins. The set's stamp must be in this loop's clock (or 0: its age is then not counted).
  void submit(const ConstraintSet& set) noexcept;
  void submit(const HapticControl& control) noexcept;
  void submit(const HandTarget& target) noexcept;

  // Reader thread.
  bool updateState() noexcept { return states_.update(); }  ///< True when there is a newer state.
  const HapticState& state() const { return states_.value(); }
  bool updateFigures() noexcept { return figures_.update(); }  ///< True about ten times a second.
  const LoopFigures& figures() const { return figures_.value(); }

  // Any one other thread: what was recorded around a fault.
  FaultRecorder& faults() noexcept { return faults_; }

  // Any one other thread: the same figures once more, for a report.
  bool updateReport() noexcept { return report_.update(); }
  const LoopFigures& report() const { return report_.value(); }

 private:
  /// A message with the session it came from, so that a late one of an earlier client is not taken.
  template <typename T>
  struct Incoming {
    std::uint64_t session = 0;
    T value;
  };
  template <typename T>
  struct Inbox {
    TripleBuffer<Incoming<T>> buffer;
    bool waiting = false;  // Force thread's own: the newest value is not used yet.
  };
  template <typename T>
  void put(Inbox<T>& inbox, const T& value) noexcept;
  template <typename T>
  const T* take(Inbox<T>& inbox) noexcept;

  bool changeSession() noexcept;
  void takeMessages(std::int64_t now) noexcept;
  void takeHandTarget() noexcept;
  void watchStalls(const TickTiming& timing) noexcept;
  void record(std::int64_t now, const TickTiming& timing) noexcept;
  void readDevice(double dt) noexcept;
  bool believes(const DeviceReading& reading) noexcept;
  bool isReady() const noexcept { return reading_.takes_force && !anew_; }
  void guardAndWrite(std::int64_t now, double dt) noexcept;
  void publish(std::int64_t now, const TickTiming& timing) noexcept;
  void publishFigures(std::int64_t now) noexcept;

  Device& device_;
  SimulatedDevice* simulated_;  // The same device, when it is a simulated one.
  const Clock& clock_;
  const ForceLoopOptions options_;
  const double period_;

  std::atomic<std::uint64_t> session_{0};  // 0: closed; else counts the sessions.
  std::atomic<std::int64_t> last_heard_{0};
  std::atomic<double> silence_limit_{0.0};
  std::uint64_t last_session_ = 0;  // Link thread's own.
  Inbox<ConstraintSet> sets_;
  Inbox<HapticControl> controls_;
  Inbox<HandTarget> targets_;
  TripleBuffer<HapticState> states_;
  TripleBuffer<LoopFigures> figures_, report_;

  // Force thread's own.
  ForceRenderer renderer_;
  SafetyChain safety_;
  SampleGate gate_;
  LoopStatistics statistics_;
  TickLog log_;
  bool running_ = true;
  std::uint64_t rendered_session_ = 0;
  std::uint64_t tick_ = 0;
  HapticControl control_;
  std::int64_t last_set_ns_ = 0;  // When a set came last, whatever became of it, or the session began.
  bool hand_from_link_ = false;
  DeviceReading reading_;
  const bool pushes_;      // The device exerts forces.
  const dvec3 middle_D_;   // Of the workspace.
  const double reach_;     // m from there; beyond it is no place of the stylus.
  double age_ = 0.0;       // s since a measurement was believed.
  double judged_ = 0.0;    // s since one was judged.
  double doubt_ = 0.0;     // s of samples that were refused, of late.
  bool measured_ = false;  // One was believed since the start.
  bool anew_ = true;       // Whatever is measured next is believed: nothing pushes.
  bool device_fault_ = false;
  bool motors_off_ = false;
  bool engaged_ = false;                         // What the device was told last.
  bool input_fault_ = false, too_fast_ = false;  // Of the last tick.
  std::uint64_t stalls_ = 0;
  FaultRecorder faults_;
  RenderResult render_;
  SafetyResult safety_result_;
  HapticState state_;
};

}  // namespace hapticell::haptic
