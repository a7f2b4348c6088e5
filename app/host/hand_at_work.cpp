// SPDX-License-Identifier: Apache-2.0
#include "app/host/hand_at_work.h"

#include "app/host/host.h"
#include "app/kit/dock_front.h"

namespace hapticell::app {

bool isHandAtWork(const Host& host) {
  const auto& snapshot = host.snapshot();
  return snapshot && (snapshot->stylus.held != 0 || snapshot->stylus.forces_on);
}

void bringToFrontIfIdle(const Host& host, QDockWidget* dock) {
  if (!isHandAtWork(host)) bringToFront(dock);
}

}  // namespace hapticell::app
