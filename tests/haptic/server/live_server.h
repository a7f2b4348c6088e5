// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "haptic/client/tcp_link.h"
#include "haptic/devices/simulated_device.h"
#include "haptic/server/force_loop.h"
#include "haptic/server/network_server.h"
#include "haptic/server/real_time_runner.h"

namespace hapticell::haptic {

/// Waits until `condition` holds and returns true, or false after half a minute: a wait that is ever that long is a
/// fault.
template <typename Condition>
bool eventually(Condition&& condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

/// A whole haptic server in this process, on a port that was free, in real time but without real-time priority.
struct LiveServer {
  explicit LiveServer(NetworkOptions options = {})
      : loop(openedDevice(), clock, loopOptions()), runner(loop, {.fifo = false, .lock_memory = false}) {
    options.report = [this](const std::string& sentence) {
      const std::scoped_lock lock(mutex);
      reports.push_back(sentence);
    };
    if (options.port == NetworkOptions{}.port) options.port = 0;
    auto started = NetworkServer::start(loop, clock, describe(device), options);
    if (!started) throw std::runtime_error(started.error().message());
    network = std::move(*started);
    runner.start();
  }
  ~LiveServer() { stop(); }

  void stop() {
    runner.stop();
    network.reset();
  }

  bool reported(const std::string& part) {
    const std::scoped_lock lock(mutex);
    for (const std::string& report : reports) {
      if (report.find(part) != std::string::npos) return true;
    }
    return false;
  }

  std::uint16_t port() const { return network->port(); }

  RealClock clock;
  SimulatedDevice device;
  std::mutex mutex;
  std::vector<std::string> reports;
  ForceLoop loop;
  RealTimeRunner runner;
  std::unique_ptr<NetworkServer> network;

 private:
  Device& openedDevice() {
    static_cast<void>(device.open());
    device.place(Pose::translation(dvec3(0.0, 0.0, 0.005)));
    return device;
  }
  ForceLoopOptions loopOptions() const {
    ForceLoopOptions options = optionsFor(device);
    options.log_ticks = 60'000;
    options.safety.ramp_time = 0.1;
    options.safety.set_silence_limit = 1e9;  // Tests say a set once and wait as long as the machine takes.
    return options;
  }
};

inline bool connects(TcpLink& link) {
  return eventually([&] { return link.linkState() == LinkState::kConnected; });
}

}  // namespace hapticell::haptic
