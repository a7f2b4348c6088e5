// SPDX-License-Identifier: Apache-2.0
// Many who connect and few who may: silent sockets keep nobody out, and fill no log.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <thread>

#include "tests/haptic/server/live_server.h"
#include "tests/haptic/server/raw_client.h"

namespace hapticell::haptic {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// A connection from an address of this machine's own net, 127.0.0.0/8, that says what it is told and no more.
class Knock {
 public:
  Knock(std::uint16_t port, const char* from) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in own{}, to{};
    own.sin_family = to.sin_family = AF_INET;
    ::inet_pton(AF_INET, from, &own.sin_addr);
    ::bind(socket_, reinterpret_cast<const sockaddr*>(&own), sizeof own);
    to.sin_port = htons(port);
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (::connect(socket_, reinterpret_cast<const sockaddr*>(&to), sizeof to) != 0) close();
  }
  ~Knock() { close(); }
  Knock(const Knock&) = delete;
  Knock& operator=(const Knock&) = delete;
  void close() {
    if (socket_ >= 0) ::close(socket_);
    socket_ = -1;
  }
  void say(const std::string& bytes) const {
    static_cast<void>(::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL));
  }
  int socket() const { return socket_; }
  /// Bytes that come; empty: the other side has ended the connection.
  std::string hear() const {
    std::string bytes(4096, '\0');
    const ssize_t got = ::recv(socket_, bytes.data(), bytes.size(), 0);
    return bytes.substr(0, got > 0 ? static_cast<std::size_t>(got) : 0);
  }
  bool ended() const { return hear().empty(); }
  /// The same without waiting.
  bool isEnded() const {
    char one = 0;
    return socket_ < 0 || ::recv(socket_, &one, 1, MSG_DONTWAIT | MSG_PEEK) == 0 || (errno != EAGAIN && errno != EINTR);
  }

 private:
  int socket_;
};

/// Keeps so many silent connections open, and opens each that was ended anew, until the end.
class Crowd {
 public:
  Crowd(std::uint16_t port, std::size_t count)
      : thread_([this, port, count] {
          std::vector<std::unique_ptr<Knock>> knocks(count);
          while (!over_) {
            std::vector<pollfd> ends;
            for (auto& knock : knocks) {
              if (!knock || knock->isEnded()) knock = std::make_unique<Knock>(port, "127.0.0.1");
              ends.push_back({knock->socket(), POLLIN, 0});
            }
            stands_ = true;
            ::poll(ends.data(), ends.size(), 20);
          }
        }) {
    eventually([&] { return stands_.load(); });
  }
  ~Crowd() {
    over_ = true;
    thread_.join();
  }

 private:
  std::atomic<bool> over_{false}, stands_{false};
  std::thread thread_;
};

NetworkOptions patient(std::optional<PairingKey> key = {}) {
  NetworkOptions options;
  options.key = std::move(key);
  options.hello_time = 600.0;  // Longer than any test waits: only making room helps.
  options.handshake_time = 600.0;
  return options;
}

TcpLinkOptions to(std::uint16_t port, const std::optional<PairingKey>& key, ClientKind kind) {
  TcpLinkOptions options;
  options.port = port;
  options.key = key;
  options.kind = kind;
  options.retry_time = 0.1;
  return options;
}

class Crowded : public ::testing::TestWithParam<bool> {};

TEST_P(Crowded, TheRightfulOwnerGetsInAndComesBackThroughSilentSockets) {
  const auto key = GetParam() ? std::optional(*PairingKey::make()) : std::nullopt;
  LiveServer server(patient(key));
  const Crowd crowd(server.port(), 200);
  for (int time = 0; time < 3; ++time) {
    TcpLink owner(to(server.port(), key, ClientKind::kController));
    ASSERT_TRUE(connects(owner)) << english(owner.problem());
    EXPECT_EQ(owner.grantedKind(), ClientKind::kController);
    TcpLink watcher(to(server.port(), key, ClientKind::kWatcher));
    ASSERT_TRUE(connects(watcher)) << english(watcher.problem());
  }
}

INSTANTIATE_TEST_SUITE_P(Links, Crowded, ::testing::Bool(),
                         [](const auto& entry) { return entry.param ? "keyed" : "plain"; });

TEST(Crowd, MakesRoomAtTheCostOfTheAddressWithMostConnections) {
  NetworkOptions options = patient();
  options.max_waiting = 8;
  options.max_waiting_of_address = 6;
  LiveServer server(options);
  const Knock honest(server.port(), "127.0.0.2");
  std::vector<std::unique_ptr<Knock>> crowd;
  for (int i = 0; i < 60; ++i)
    crowd.push_back(std::make_unique<Knock>(server.port(), i % 2 == 0 ? "127.0.0.3" : "127.0.0.4"));
  EXPECT_TRUE(eventually([&] { return crowd[50]->isEnded(); }));
  honest.say(frameText(Hello{}));
  EXPECT_FALSE(honest.ended()) << "it was there first and is alone";
}

TEST(Crowd, WhoeverMayControlHasAPlaceHoweverManyWatch) {
  LiveServer server({.max_clients = 2});
  RawClient one(server.port()), two(server.port()), three(server.port());
  ASSERT_TRUE(one.hello(ClientKind::kWatcher) && two.hello(ClientKind::kWatcher));
  ASSERT_TRUE(three.send(Hello{.kind = ClientKind::kWatcher}));
  EXPECT_THAT(three.refusalThenEnd(), HasSubstr("has its 2 connections already"));
  for (int time = 0; time < 3; ++time) {
    EXPECT_TRUE(eventually([&] {
      RawClient owner(server.port());
      const auto answer = owner.hello();
      return answer && std::holds_alternative<Welcome>(*answer) &&
             std::get<Welcome>(*answer).kind == ClientKind::kController;
    }));
  }
}

TEST(Crowd, AnotherMachineHasItsShareOfThoseThatWatch) {
  // 127.0.0.0/8 counts as this machine, whose programs are not limited to a share.
  LiveServer server({.max_clients = 6, .max_clients_of_address = 1});
  RawClient one(server.port()), two(server.port());
  EXPECT_TRUE(one.hello(ClientKind::kWatcher).has_value());
  const auto answer = two.hello(ClientKind::kWatcher);
  EXPECT_TRUE(answer && std::holds_alternative<Welcome>(*answer));
}

TEST(Crowd, AThousandRefusalsAreFewLines) {
  LiveServer server;
  for (int i = 0; i < 1000; ++i) {
    RawClient stranger(server.port());
    stranger.sendBytes("GET / HTTP/1.1\r\n\r\n");
    EXPECT_THAT(stranger.refusalThenEnd(), HasSubstr("Not understood"));
  }
  const std::scoped_lock lock(server.mutex);
  EXPECT_GE(server.reports.size(), 5u);
  EXPECT_LE(server.reports.size(), 60u) << "ten at once, one in five seconds, a summary in ten";
}

TEST(Crowd, WhatAClientCallsItselfIsOneShortLine) {
  LiveServer server;
  RawClient forger(server.port());
  const std::string name = "x\n12:00:00.000 warning: FORGED: your licence \x1B[2J has expired" + std::string(900, 'y');
  ASSERT_TRUE(forger.hello(ClientKind::kController, false, name));
  ASSERT_TRUE(eventually([&] { return server.reported("controls the stylus"); }));
  RawClient second(server.port());
  const auto answer = second.hello();
  ASSERT_TRUE(answer && std::holds_alternative<Refusal>(*answer));
  const std::string sentence = std::get<Refusal>(*answer).sentence;
  EXPECT_THAT(sentence, HasSubstr("x 12:00:00.000 warning: FORGED"));
  EXPECT_LT(sentence.size(), 300u);
  const std::scoped_lock lock(server.mutex);
  for (const std::string& text : server.reports) {
    EXPECT_EQ(text.find_first_of("\n\x1B"), std::string::npos) << text;
    EXPECT_LT(text.size(), 420u);
  }
}

/// Takes connections on a port of its own and ends them at once, as a server without room does.
class Closer {
 public:
  Closer() : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    ::bind(socket_, reinterpret_cast<const sockaddr*>(&address), size);
    ::listen(socket_, 8);
    ::getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size);
    port = ntohs(address.sin_port);
    thread_ = std::thread([this] {
      for (int one = 0; (one = ::accept(socket_, nullptr, nullptr)) >= 0;) ::close(one);
    });
  }
  ~Closer() {
    ::shutdown(socket_, SHUT_RDWR);
    thread_.join();
    ::close(socket_);
  }
  std::uint16_t port = 0;

 private:
  int socket_;
  std::thread thread_;
};

TEST(Crowd, AServerWithoutRoomIsNoReasonToPairAnew) {
  const Closer closer;
  TcpLink link(to(closer.port, *PairingKey::make(), ClientKind::kController));
  ASSERT_TRUE(eventually([&] { return english(link.problem()).find("tries again by itself") != std::string::npos; }))
      << english(link.problem());
  EXPECT_THAT(english(link.problem()), Not(HasSubstr("Pair them again")));
}

}  // namespace
}  // namespace hapticell::haptic
