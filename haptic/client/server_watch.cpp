// SPDX-License-Identifier: Apache-2.0
#include "haptic/client/server_watch.h"

#include <chrono>
#include <thread>

#include "haptic/protocol/link_problem.h"

namespace hapticell::haptic {

Expected<std::unique_ptr<TcpLink>> openWatcher(const std::string& host, std::uint16_t port,
                                               const std::string& program) {
  auto options = linkOptionsFor(host, port);
  HAPTICELL_TRY(options);
  options->kind = ClientKind::kWatcher;
  options->program = program;
  return std::make_unique<TcpLink>(*options);
}

bool waitUntilConnected(const TcpLink& link, double seconds) {
  using Clock = std::chrono::steady_clock;
  // Between two looks. Half, twice: nobody notices.
  constexpr auto kLook = std::chrono::milliseconds(5);
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  while (link.linkState() != LinkState::kConnected) {
    if (link.linkState() == LinkState::kRefused || Clock::now() > end) return false;
    std::this_thread::sleep_for(kLook);
  }
  return true;
}

Expected<std::unique_ptr<TcpLink>> watchServer(const std::string& host, std::uint16_t port, const std::string& program,
                                               double seconds) {
  auto link = openWatcher(host, port, program);
  HAPTICELL_TRY(link);
  if (waitUntilConnected(**link, seconds)) return link;
  const std::string address = host + ":" + std::to_string(port);
  const LinkProblem problem = (*link)->problem();
  if ((*link)->linkState() == LinkState::kRefused && !problem.empty())
    return makeError({.file = address, .found = problem.what, .fix = problem.fix});
  return makeError({.file = address,
                    .found = "no haptic server answers",
                    .expected = "a running server",
                    .fix = "Start one with 'hapticell-haptic-server', or open the window."});
}

}  // namespace hapticell::haptic
