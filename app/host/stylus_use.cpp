// SPDX-License-Identifier: Apache-2.0
#include "app/host/stylus_use.h"

#include <QObject>

#include "app/host/host.h"
#include "app/host/message_log.h"

namespace hapticell::app {

bool isStylusInUse(const Host& host) {
  const auto& snapshot = host.snapshot();
  if (!snapshot) return false;
  const bool second = snapshot->second && snapshot->second->held != 0;
  return second || snapshot->stylus.held != 0 || snapshot->stylus.forces_on;
}

bool tellsStylusInUse(Host& host) {
  if (!isStylusInUse(host)) return false;
  host.messages().tell(Severity::kInformation, QObject::tr("The panel was not opened"),
                       QObject::tr("Switch the forces off first. Panels stay in place while the stylus is in use."));
  return true;
}

}  // namespace hapticell::app
