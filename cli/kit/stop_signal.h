// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>

#include "cli/kit/command_listener.h"

namespace hapticell::cli {

/// While one of these lives, Ctrl+C and the system's wish to end only set a flag; the second one ends the program. With
/// a CommandListener, signals stay as they are and the listener is asked.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;
  const std::atomic<bool>& asked() const;

 private:
  CommandListener* const listener_;
};

}  // namespace hapticell::cli
