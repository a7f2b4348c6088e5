// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/host/motion_memory.h"

namespace hapticell::app {

class Host;

/// "Go back ten seconds of motion": remembers what moves, and lets go of what is held before it goes back. GUI thread.
class GoBack {
 public:
  /// The host must outlive it.
  explicit GoBack(Host& host);
  /// Ten seconds of motion; where something is held, once it is let go.
  void start();
  /// The scene has another snapshot: goes back where that waits for it.
  void snapshotCame();
  /// Keeps what moved since the last look.
  void look() { memory_.look(); }
  /// Another document follows: nothing is waited for any more.
  void cancel() { waits_ = false; }
  /// Another document is there.
  void forget() { memory_.forget(); }

 private:
  MotionMemory::Places placesNow() const;

  Host& host_;
  MotionMemory memory_;
  bool waits_ = false;  ///< Until what is held is let go.
};

}  // namespace hapticell::app
