// SPDX-License-Identifier: Apache-2.0
// What the hand feels when the client's process is killed or stopped. Times are read from the server's own log of
// ticks.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>

#include "haptic/client/tcp_link.h"
#include "haptic/server/peer_process.h"
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

TEST_F(LostClient, KilledTheForceIsZeroWithin50Ticks) {
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

/// As one that dies and whose memory takes long to be freed: its socket stays open and says nothing. TcpLink's heart
/// beats every 10 ms while forces are on, so it is missed long before 600 ms, by as much as its beats came late before.
TEST_F(LostClient, StoppedItIsMissedByItsHeartBeats) {
  ASSERT_TRUE(client.waitUntilPressing());
  const std::int64_t stopped = server.clock.now();
  client.signal(SIGSTOP);
  waitForZeroForce();
  const auto records = recordsFrom(stopped);
  ASSERT_FALSE(records.empty());
  double last_silence_with_force = 0.0;
  for (const TickRecord& record : records) {
    if (record.force_D != dvec3(0.0)) last_silence_with_force = std::max(last_silence_with_force, record.link_silence);
  }
  RecordProperty("silence_until_zero_ms", std::to_string(1e3 * last_silence_with_force));
  EXPECT_LE(last_silence_with_force, 0.8);
}

/// A process of its own at the other end of a socket.
struct Other {
  Other() {
    listener = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in here{};
    here.sin_family = AF_INET;
    here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t length = sizeof here;
    EXPECT_EQ(::bind(listener, reinterpret_cast<sockaddr*>(&here), sizeof here), 0);
    EXPECT_EQ(::listen(listener, 1), 0);
    EXPECT_EQ(::getsockname(listener, reinterpret_cast<sockaddr*>(&here), &length), 0);
    port = ntohs(here.sin_port);
    process = ::fork();
    if (process == 0) {
      const int connected = ::socket(AF_INET, SOCK_STREAM, 0);
      ::close(listener);
      if (::connect(connected, reinterpret_cast<sockaddr*>(&here), sizeof here) != 0) ::_exit(1);
      ::pause();
      ::_exit(0);
    }
    sockaddr_in peer{};
    length = sizeof peer;
    accepted = ::accept(listener, reinterpret_cast<sockaddr*>(&peer), &length);
    client = "127.0.0.1:" + std::to_string(ntohs(peer.sin_port));
  }
  ~Other() {
    ::kill(process, SIGKILL);
    ::waitpid(process, nullptr, 0);
    ::close(accepted);
    ::close(listener);
  }
  int listener = -1, accepted = -1;
  std::uint16_t port = 0;
  pid_t process = -1;
  std::string client;
};

TEST(PeerProcess, IsFoundAndTellsThatItDies) {
  const Other other;
  const auto found = PeerProcess::find(other.client, other.port);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->id(), other.process);
  EXPECT_FALSE(found->isDying());
  ::kill(other.process, SIGSTOP);
  EXPECT_FALSE(found->isDying()) << "one that is stopped lives";
  ::kill(other.process, SIGKILL);
  EXPECT_TRUE(eventually([&] { return found->isDying(); }));
}

TEST(PeerProcess, NobodyIsAtAPortThatNobodyHas) {
  EXPECT_FALSE(PeerProcess::find("127.0.0.1:1", 2));
  EXPECT_FALSE(PeerProcess::find("", 2));
  EXPECT_FALSE(PeerProcess::find("192.0.2.1:4747", 4747));
}

}  // namespace
}  // namespace hapticell::haptic
