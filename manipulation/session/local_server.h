// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "config/configuration.h"
#include "config/device_profile.h"
#include "geometry/system/error.h"

namespace hapticell::manipulation {

/// A private haptic server for one session: force loop and network in threads of this process, listening on a free port
/// of this machine, with a simulated device. It ends with the object, after setting the force to zero.
class LocalServer {
 public:
  /// Errors: the device cannot be opened, no port is free.
  static Expected<std::unique_ptr<LocalServer>> start(const config::DeviceProfile& profile,
                                                      const config::Configuration& configuration);
  ~LocalServer();

  /// On 127.0.0.1.
  int port() const;

 private:
  struct Parts;
  explicit LocalServer(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace hapticell::manipulation
