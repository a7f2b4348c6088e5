// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "haptic/devices/simulated_device.h"
#include "haptic/rendering/force_renderer.h"
#include "haptic/rendering/safety_chain.h"
#include "tests/haptic/rendering/feel_scene.h"

namespace hapticell::haptic::test {

/// How often a client sends sets, and how late they arrive.
struct ClientRate {
  double rate_hz = 10.0;
  double latency = 0.05;
};

inline constexpr ClientRate kRates[] = {{10.0, 0.05}, {60.0, 0.01}, {1000.0, 0.001}};

/// A client that looks at the proxy at its rate and whose sets arrive late.
class SlowClient {
 public:
  SlowClient(const FeelScene& scene, ClientRate rate) : scene_(scene), rate_(rate) {}
  /// At time t with the server's proxy: looks when it is due; offers what has arrived.
  void step(double t, ForceRenderer& renderer);
  void stall(double from, double until) {
    stall_from_ = from;
    stall_until_ = until;
  }

 private:
  struct Sent {
    double arrival;
    ConstraintSet set;
  };
  const FeelScene& scene_;
  ClientRate rate_;
  double next_look_ = 0.0;
  double stall_from_ = 1e9, stall_until_ = 1e9;
  std::uint64_t sequence_ = 0;
  std::deque<Sent> on_the_way_;
};

/// What a session measured; the names of the feel trial.
struct FeelFigures {
  double step_n = 0.0;            ///< M1: largest change of force in a millisecond, N.
  double penetration = 0.0;       ///< Of the proxy, m.
  double depth_error_p95 = 0.0;   ///< Part of the exact depth.
  double depth_error_max = 0.0;   ///< m.
  double depth_excess_max = 0.0;  ///< m: felt deeper than exact.
  double direction_p95_deg = 0.0;
  double energy_min = 0.0;      ///< J: worst loss in any second.
  double free_force_max = 0.0;  ///< N, in ticks that are free.
  double force_max = 0.0;
  int contact_ticks = 0;
  int free_ticks = 0;
};

/// Simulated device, hand, renderer and safety chain in virtual time, with a second renderer that is fed the exact set
/// every tick as the reference.
class FeelSession {
 public:
  FeelSession(const FeelScene& scene, ClientRate rate, HandOptions hand = {}, config::DeviceProfile profile = {},
              RendererOptions options = {});

  /// Puts stylus and proxy there and lets the gate open while the hand holds still.
  void begin(const dvec3& start);
  /// Hand along the path for `duration`; nothing is measured if `measured` is false.
  void follow(const std::function<dvec3(double)>& path, double duration, bool measured = true);
  /// The same with the scene's turning of the stylus.
  void followTurning(const std::function<dvec3(double)>& path, double duration);
  /// Lets go for `duration`.
  void letGo(double duration);
  /// Largest excursion of the encoder's readings on any axis over the last `seconds`, m.
  double wobble(double seconds) const;

  FeelFigures figures() const;
  SlowClient& client() { return client_; }
  SimulatedDevice& device() { return device_; }
  const RenderResult& last() const { return result_; }
  const SafetyResult& safety() const { return safety_result_; }
  double time() const { return time_; }

 private:
  void tick(bool measured);
  void measure(const DeviceReading& reading, const dvec3& force_before);
  void accountEnergy(const dvec3& moved);

  const FeelScene& scene_;
  SlowClient client_;
  SimulatedDevice device_;
  ForceRenderer renderer_;
  ForceRenderer exact_;
  SafetyChain safety_;
  RenderResult result_;
  RenderResult exact_result_;
  SafetyResult safety_result_;
  double time_ = 0.0;
  std::uint64_t ticks_ = 0;
  std::size_t exact_rows_ = 0;
  double last_change_ = -1.0;
  double work_ = 0.0;
  std::vector<double> balance_;
  std::vector<dvec3> readings_;
  std::vector<double> depth_errors_, direction_errors_;
  FeelFigures figures_;
};

}  // namespace hapticell::haptic::test
