// SPDX-License-Identifier: Apache-2.0
#include "manipulation/session/local_server.h"

#include "haptic/devices/simulated_device.h"
#include "haptic/server/configured_loop.h"
#include "haptic/server/network_server.h"
#include "haptic/server/real_time_runner.h"

namespace hapticell::manipulation {

namespace {

/// The session works in the same process: locked memory would keep all that it ever used.
haptic::RealTimeOptions ownThreadOnly() {
  haptic::RealTimeOptions options;
  options.lock_memory = false;
  return options;
}

}  // namespace

/// In the order in which they need each other; they end the other way round.
struct LocalServer::Parts {
  Parts(const config::DeviceProfile& profile, const config::Configuration& configuration)
      : device(profile),
        loop(device, clock, haptic::configuredLoop(device, configuration)),
        runner(loop, ownThreadOnly()) {
    device.hand().setOptions(haptic::configuredHand(configuration));
  }

  haptic::SimulatedDevice device;
  haptic::RealClock clock;
  haptic::ForceLoop loop;
  std::unique_ptr<haptic::NetworkServer> network;
  haptic::RealTimeRunner runner;
};

Expected<std::unique_ptr<LocalServer>> LocalServer::start(const config::DeviceProfile& profile,
                                                          const config::Configuration& configuration) {
  auto parts = std::make_unique<Parts>(profile, configuration);
  HAPTICELL_TRY(parts->device.open());
  haptic::NetworkOptions options;
  options.port = 0;
  auto network = haptic::NetworkServer::start(parts->loop, parts->clock, haptic::describe(parts->device), options);
  HAPTICELL_TRY(network);
  parts->network = std::move(*network);
  parts->runner.start();
  return std::unique_ptr<LocalServer>(new LocalServer(std::move(parts)));
}

LocalServer::LocalServer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

LocalServer::~LocalServer() {
  parts_->runner.stop();
}

int LocalServer::port() const {
  return parts_->network->port();
}

}  // namespace hapticell::manipulation
