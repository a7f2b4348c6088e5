// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "config/configuration.h"
#include "tests/haptic/server/live_server.h"

namespace hapticell::app {

/// A haptic server of the test's own with a simulated stylus, made before the window that connects to it: to be the
/// first base of its page.
struct ServerFirst {
  haptic::LiveServer server;
  config::Configuration on(config::Configuration configuration = {}) const {
    configuration.server.host = "127.0.0.1";
    configuration.server.port = server.port();
    return configuration;
  }
};

}  // namespace hapticell::app
