// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "feel/rendering_way.h"
#include "feel/scene.h"
#include "feel/slow_client.h"
#include "haptic/devices/simulated_device.h"
#include "haptic/rendering/safety_chain.h"

namespace hapticell::feel {

/// Everything about a session but its scene.
struct SessionSetup {
  ClientRate rate;
  std::optional<haptic::HandOptions> hand = {};  ///< None: the scene's.
  config::DeviceProfile device{};
  haptic::RendererOptions renderer{};
  bool classic = false;             ///< A single moving plane instead (see ClassicWay).
  const FeelScene* seen = nullptr;  ///< What the client sees where that is not the scene itself (a mesh of it).
};

/// What a session measured; the names of the benchmark (docs/dev/feel.md).
struct FeelFigures {
  double step_n = 0.0;       ///< M1: largest change of the wanted force in a millisecond, N, before the slew limit.
  double pull_step_n = 0.0;  ///< The same of load and pulls alone, at all times, N.
  double penetration = 0.0;  ///< Of what is displayed (the proxy), m.
  double round_penetration = 0.0;  ///< See FeelScene::roundPenetration(), m.
  double depth_error_p95 = 0.0;    ///< Part of the exact depth.
  double depth_error_max = 0.0;    ///< m.
  double depth_excess_max = 0.0;   ///< m: felt deeper than exact.
  double direction_p95_deg = 0.0;
  double energy_min = 0.0;      ///< J: worst loss in any second.
  double free_force_max = 0.0;  ///< N, in ticks that are free.
  double force_max = 0.0;       ///< N, commanded.
  int contact_ticks = 0;
  int free_ticks = 0;
};

/// Simulated device, hand, renderer and safety chain in virtual time, with a second renderer that is fed the exact set
/// of the true moment every tick: the reference for depth and direction.
class FeelSession {
 public:
  /// A device of six driven axes is rendered with its torque; M1 to M4 are then of force and torque together, in the
  /// metric (a torque counts with the lever kRotationLever).
  FeelSession(const FeelScene& scene, const SessionSetup& setup);

  /// Puts stylus and proxy there. The hand then holds still for `rest` seconds; if that is long enough, the engage gate
  /// opens and the force reaches its full value.
  void begin(const dvec3& start, double rest = 1.2);
  /// Hand along the path for `duration`; nothing is measured if `measured` is false.
  void follow(const std::function<dvec3(double)>& path, double duration, bool measured = true);
  /// The same with the scene's turning of the stylus.
  void followTurning(const std::function<dvec3(double)>& path, double duration);
  /// Lets go for `duration`.
  void letGo(double duration);
  /// Largest excursion of the encoder's readings on any axis over the last `seconds`, m.
  double wobble(double seconds) const;
  /// Restarts the figures.
  void forgetFigures();

  FeelFigures figures() const;
  /// The same so far, without percentiles and energy: quick enough for every tick.
  const FeelFigures& latest() const { return figures_; }
  SlowClient& client() { return client_; }
  const haptic::HandOptions& hand() const { return hand_; }
  haptic::SimulatedDevice& device() { return device_; }
  const haptic::RenderResult& last() const { return result_; }
  const haptic::SafetyResult& safety() const { return safety_result_; }
  double time() const { return time_; }

 private:
  void tick(bool measured);
  void measure(const haptic::DeviceReading& reading, const haptic::MetricVector& force_before,
               const dvec3& load_before);
  haptic::MetricVector wantedForce() const;

  const FeelScene& scene_;
  SessionSetup setup_;
  haptic::HandOptions hand_;
  SlowClient client_;
  haptic::SimulatedDevice device_;
  std::unique_ptr<RenderingWay> way_;
  haptic::ForceRenderer exact_;
  haptic::SafetyChain safety_;
  haptic::RenderResult result_;
  haptic::RenderResult exact_result_;
  haptic::SafetyResult safety_result_;
  double time_ = 0.0;
  std::uint64_t ticks_ = 0;
  std::size_t exact_rows_ = 0;
  double last_change_ = -1.0;
  haptic::EnergyLossMeter energy_;
  Pose X_DSBefore_;
  std::vector<dvec3> readings_;
  std::vector<double> depth_errors_, direction_errors_;
  FeelFigures figures_;
};

/// Depth (m) of the intended pose at which about `force` newtons are felt: the hand's spring and the coupling (1 N/mm)
/// in series.
constexpr double pressDepth(const haptic::HandOptions& hand, double force = 2.0) {
  return force / hand.stiffness + force / 1000.0;
}
/// Of the usual hand for 2 N.
inline constexpr double kPress = pressDepth({});

/// From the scene's start onto the surface in 0.3 s, then along the scene's path, pressing 2 N.
void touchAndSlide(FeelSession& session, const FeelScene& scene, double duration);
/// Onto the scene's place of rest, and stays there; 2 s in all.
void pressAtRest(FeelSession& session, const FeelScene& scene);

}  // namespace hapticell::feel
