// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace hapticell::haptic {

/// How long a client may be silent, by the rhythm of its own heart-beats and by their round trips: a client that dies
/// is noticed by what does not come. The kernel closes its sockets only when it has freed its memory, which for some
/// gigabytes takes a third of a second.
///
/// Who beats every 10 ms on the same machine is missed after 28 ms; who beats as slowly as the protocol's oldest
/// clients do (0.1 s) when the server's own limit says so. A beat that was late (a busy machine, a bad line) makes the
/// limit longer, and is forgotten within some seconds. One thread.
class BeatWatch {
 public:
  static constexpr double kShortest = 0.028;  ///< s; with a decay of 20 ms the force is gone 50 ms after the last beat.

  /// A heart-beat came at `now` (steady clock, ns); `round_trip` is the newest one that is known, s, 0: none.
  void heard(std::int64_t now, double round_trip) noexcept;

  /// s of silence that are borne; 0: no quick rhythm is known, the server's own limit counts.
  double limit() const noexcept;

 private:
  std::int64_t last_ns_ = 0;
  int beats_ = 0;
  double gap_ = 0.0, round_trip_ = 0.0;  ///< The longest of late, s.
};

}  // namespace hapticell::haptic
