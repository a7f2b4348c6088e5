// SPDX-License-Identifier: Apache-2.0
// What the hand feels when the client's process is killed or stopped. Times are read from the server's own log of
// ticks.
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>

#include "haptic/client/tcp_link.h"
#include "tests/haptic/server/live_server.h"

extern char** environ;

namespace hapticell::haptic {
namespace {

/// The client process of pressing_client.cpp; killed with the object.
class PressingClient {
 public:
  explicit PressingClient(std::uint16_t port) {
    std::array<int, 2> pipe{};
    if (::pipe(pipe.data()) != 0) return;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, pipe[1], STDOUT_FILENO);
    posix_spawn_file_actions_addclose(&actions, pipe[0]);
    std::string program = HAPTICELL_PRESSING_CLIENT, argument = std::to_string(port);
    std::array<char*, 3> words = {program.data(), argument.data(), nullptr};
    if (posix_spawn(&process_, program.c_str(), &actions, nullptr, words.data(), environ) != 0) process_ = -1;
    posix_spawn_file_actions_destroy(&actions);
    ::close(pipe[1]);
    output_ = pipe[0];
  }
  ~PressingClient() {
    signal(SIGKILL);
    if (process_ > 0) ::waitpid(process_, nullptr, 0);
    ::close(output_);
  }
  bool waitUntilPressing() {
    std::array<char, 9> text{};
    std::size_t length = 0;
    while (length < text.size() - 1) {
      const ssize_t count = ::read(output_, text.data() + length, text.size() - 1 - length);
      if (count <= 0) return false;
      length += static_cast<std::size_t>(count);
    }
    return std::string(text.data()) == "pressing";
  }
  void signal(int number) const {
    if (process_ > 0) ::kill(process_, number);
  }

 private:
  pid_t process_ = -1;
  int output_ = -1;
};

struct LostClient : ::testing::Test {
  LostClient() : client(server.port()) {
    TcpLinkOptions options;
    options.port = server.port();
    options.kind = ClientKind::kWatcher;
    watcher.emplace(options);
  }

  /// Waits until a watcher sees no force, then stops the loop so that its log can be read.
  void waitForZeroForce() {
    ASSERT_TRUE(eventually([&] {
      const auto state = watcher->latestState();
      return state && state->force_D == dvec3(0.0) && !state->forces_on;
    }));
    server.stop();
  }

  std::vector<TickRecord> recordsFrom(std::int64_t stamp) const {
    std::vector<TickRecord> records;
    const TickLog& log = server.loop.log();
    for (std::size_t i = 0; i < log.size(); ++i) {
      if (log.at(i).stamp_ns >= stamp) records.push_back(log.at(i));
    }
    return records;
  }

  LiveServer server;
  PressingClient client;
  std::optional<TcpLink> watcher;
};

TEST_F(LostClient, killed_the_force_is_zero_within_50_ticks) {
  ASSERT_TRUE(client.waitUntilPressing());
  const std::int64_t killed = server.clock.now();
  client.signal(SIGKILL);
  waitForZeroForce();
  const auto records = recordsFrom(killed);
  const auto zero = std::find_if(records.begin(), records.end(), [](const auto& r) { return r.force_D == dvec3(0.0); });
  ASSERT_NE(zero, records.end());
  // Ticks that were done, so that a host that takes the processor away does not count.
  EXPECT_LE(zero - records.begin(), 50);
  RecordProperty("milliseconds_from_kill_to_zero", std::to_string(1e-6 * static_cast<double>(zero->stamp_ns - killed)));
  for (std::size_t i = 1; i < records.size(); ++i) {
    EXPECT_LE(glm::length(records[i].force_D - records[i - 1].force_D), 1.0 + 1e-9) << "slew limit";
  }
}

TEST_F(LostClient, stopped_the_force_is_held_for_600_ms_and_zero_at_800) {
  ASSERT_TRUE(client.waitUntilPressing());
  const std::int64_t stopped = server.clock.now();
  client.signal(SIGSTOP);
  waitForZeroForce();
  const auto records = recordsFrom(stopped);
  ASSERT_FALSE(records.empty());
  const double held = glm::length(records.front().force_D);
  double last_silence_with_force = 0.0;
  for (const TickRecord& record : records) {
    if (record.link_silence <= 0.6) {
      EXPECT_GT(glm::length(record.force_D), 0.9 * held) << record.link_silence;
    }
    if (record.force_D != dvec3(0.0)) last_silence_with_force = std::max(last_silence_with_force, record.link_silence);
  }
  EXPECT_GT(last_silence_with_force, 0.6);
  EXPECT_LE(last_silence_with_force, 0.8);
}

}  // namespace
}  // namespace hapticell::haptic
