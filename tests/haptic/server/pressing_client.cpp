// SPDX-License-Identifier: Apache-2.0
// A client process for tests to stop and kill: connects to the port given, presses the hand on a floor, says "pressing"
// when more than 2 N are felt and the stylus rests, and goes on until it is ended.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "haptic/client/tcp_link.h"
#include "tests/haptic/server/virtual_session.h"

using namespace hapticell;
using namespace hapticell::haptic;

int main(int count, char** words) {
  if (count != 2) return 2;
  TcpLinkOptions options;
  options.port = static_cast<std::uint16_t>(std::atoi(words[1]));
  TcpLink link(options);
  bool engaged = false;
  double height = 0.005;
  int steady = 0;
  for (std::uint64_t sequence = 1;; ++sequence) {
    std::this_thread::sleep_for(std::chrono::milliseconds(16));
    const auto state = link.latestState();
    engaged = engaged || (state && state->force_ramp == 1.0);
    if (engaged && height > -0.010) height -= 0.0005;
    link.sendHandTarget({true, Pose::translation(dvec3(0.0, 0.0, height)), 0});
    link.sendControl({.forces_enabled = true});
    link.sendSet(floorSet(sequence));
    const bool rests = state && state->force_D.z > 2.0 && glm::length(state->v_DS) < 0.005;
    steady = rests ? steady + 1 : 0;
    if (steady != 20) continue;
    std::puts("pressing");
    std::fflush(stdout);
  }
}
