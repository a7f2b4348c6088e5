// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/host/motion_memory.h"

namespace hapticell::app {

class Host;

/// "Go back ten seconds of motion": remembers what moves, and releases what is held before it goes back. GUI thread.
class GoBack {
 public:
  /// The host must outlive it.
  explicit GoBack(Host& host);
  /// Goes back ten seconds of motion; if something is held, after its release.
  void start();
  /// Call it for each new snapshot of the scene: goes back if that waits for the release.
  void snapshotCame();
  /// Keeps what moved since the last call.
  void look() { memory_.look(); }
  /// Stops waiting, because another document follows.
  void cancel() { waits_ = false; }
  /// Forgets everything, because there is another document.
  void forget() { memory_.forget(); }

 private:
  MotionMemory::Places placesNow() const;

  Host& host_;
  MotionMemory memory_;
  bool waits_ = false;  ///< Waits for the release of what is held.
};

}  // namespace hapticell::app
