// SPDX-License-Identifier: Apache-2.0
// A client of the haptic server: connects, lets a wall be felt, and reads the stylus. usage: haptic_client [HOST PORT]
// Without a server of that name it starts one with a simulated stylus in this process, and moves that stylus itself.
#include <haptic/client/tcp_link.h>
#include <manipulation/session/local_server.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <thread>

using hapticell::Pose;
namespace haptic = hapticell::haptic;

namespace {

/// Free is what lies before x = 10 mm.
haptic::ConstraintSet wall() {
  haptic::ConstraintSet set;
  set.sequence = 1;
  set.zone_radius = 0.1;
  set.count = 1;
  set.constraints[0].gap = 0.010;
  set.constraints[0].gradient = {-1.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  return set;
}

}  // namespace

int main(int count, char** words) {
  std::unique_ptr<hapticell::manipulation::LocalServer> own;
  haptic::TcpLinkOptions options;  // This machine, no key; another machine is talked to by linkOptionsFor().
  options.program = "example client";
  if (count == 3) {
    options.host = words[1];
    options.port = static_cast<std::uint16_t>(std::atoi(words[2]));
  } else {
    auto started = hapticell::manipulation::LocalServer::start({}, {});
    if (!started) {
      std::fprintf(stderr, "%s\n", started.error().message().c_str());
      return 1;
    }
    own = std::move(*started);
    options.port = static_cast<std::uint16_t>(own->port());
  }

  haptic::TcpLink link(options);  // Connects, and connects again, in a thread of its own; no call waits for it.
  haptic::ConstraintSet set = wall();
  bool told = false;
  haptic::HapticState state;
  for (int step = 0; step < 200; ++step) {  // 2 s
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    const auto device = link.device();
    if (!device) continue;
    if (!told) {
      std::printf("connected to \"%s\", %.1f N\n", device->name.c_str(), device->peak_force);
      link.sendControl({.forces_enabled = true});
      told = true;
    }
    link.sendSet(set);
    ++set.sequence;
    if (device->simulated)  // The hand slowly pushes the stylus 5 mm into the wall.
      link.sendHandTarget({.holding = true, .X_DH = Pose::translation({step < 100 ? 0.0 : 0.015, 0.0, 0.0})});
    if (const auto newest = link.latestState()) state = *newest;
  }
  if (!told) {
    std::fprintf(stderr, "no server: %s\n", english(link.problem()).c_str());
    return 1;
  }
  std::printf("stylus at %.1f mm, force %.1f N against the push: %s\n", 1e3 * state.X_DS.p.x, -state.force_D.x,
              state.force_D.x < -0.3 ? "the wall is felt" : "nothing is felt");
  return 0;
}
