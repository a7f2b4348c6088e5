// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <random>

#include "feel/rendering_way.h"
#include "feel/scene.h"

namespace hapticell::feel {

/// How often a client sends sets, and how late they arrive.
struct ClientRate {
  double rate_hz = 10.0;
  double latency = 0.05;  ///< s.
  // As TCP shows a bad network: late, never out of order, and what was lost comes after a time-out with all behind it.
  double jitter = 0.0;      ///< s: as much later at most, evenly spread.
  double loss = 0.0;        ///< Share of the sets that are sent again.
  double retransmit = 0.2;  ///< s until then: the least time-out of Linux (RFC 6298 would wait a second).
};

inline constexpr ClientRate kRates[] = {{10.0, 0.05}, {60.0, 0.01}, {1000.0, 0.001}};

/// A client that makes sets at its own rate; they arrive late.
class SlowClient {
 public:
  SlowClient(const FeelScene& scene, ClientRate rate) : scene_(scene), rate_(rate) {}

  /// At time t: makes a set if one is due, and returns a set that has arrived.
  void step(double t, RenderingWay& way);

  void stall(double from, double until) {
    stall_from_ = from;
    stall_until_ = until;
  }
  /// Zones only so wide (m); groups that are free all over them are left out.
  void setZone(double radius) { zone_ = radius; }
  /// When the first set after the stall arrived; below 0: not yet.
  double backAt() const { return back_at_; }

 private:
  struct Sent {
    double made, arrival;
    ConstraintSet set;
  };
  ConstraintSet look(const RenderingWay& way, double t) const;
  double arrivalOf(double t);

  const FeelScene& scene_;
  ClientRate rate_;
  double zone_ = 0.0;
  double next_look_ = 0.0;
  double stall_from_ = 1e9, stall_until_ = 1e9;
  double back_at_ = -1.0;
  std::uint64_t sequence_ = 0;
  std::deque<Sent> on_the_way_;
  double last_arrival_ = 0.0;
  std::mt19937_64 random_{20261122};  // The same network each time.
};

}  // namespace hapticell::feel
