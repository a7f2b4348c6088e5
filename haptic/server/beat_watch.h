// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace hapticell::haptic {

/// Computes how long a client may be silent, from the interval of its heart-beats and their round trips. So the server
/// notices a dead client by missing heart-beats. The kernel closes a dead client's sockets only after it has freed its
/// memory, which takes a third of a second for some gigabytes.
///
/// A client on the same machine that sends a heart-beat every 10 ms is missed after 28 ms. For a client that sends one
/// every 0.1 s, the server's own limit applies. A late heart-beat (a busy machine, a bad network) makes the limit
/// longer for some seconds. One thread.
class BeatWatch {
 public:
  /// s: with a decay of 20 ms the force is gone 50 ms after the last beat (Safety analysis). Half: one beat that is
  /// late by 4 ms costs the force; twice: 78 ms, which the tests refuse.
  static constexpr double kShortest = 0.028;

  /// A heart-beat arrived at `now` (steady clock, ns); `round_trip` is the newest known one, s; 0: unknown.
  void heard(std::int64_t now, double round_trip) noexcept;

  /// Allowed silence, s; 0: no fast heart-beats are known, the server's own limit applies.
  double limit() const noexcept;

 private:
  std::int64_t last_ns_ = 0;
  int beats_ = 0;
  double gap_ = 0.0, round_trip_ = 0.0;  ///< The recent maxima, s.
};

}  // namespace hapticell::haptic
