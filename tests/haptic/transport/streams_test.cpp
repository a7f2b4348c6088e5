// SPDX-License-Identifier: Apache-2.0
// Both ends of a connection in one thread, over a real socket of this machine. Nothing waits for a clock.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <asio.hpp>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "haptic/transport/byte_stream.h"
#include "haptic/transport/haptic_link.h"
#include "haptic/transport/message_stream.h"
#include "haptic/transport/press_latch.h"
#include "haptic/transport/secure_stream.h"

namespace hapticell::haptic {
namespace {

using asio::ip::tcp;
using Streams = std::pair<std::unique_ptr<ByteStream>, std::unique_ptr<ByteStream>>;

class TransportStreams : public ::testing::Test {
 protected:
  std::pair<tcp::socket, tcp::socket> sockets() {
    tcp::acceptor acceptor(io_, tcp::endpoint(asio::ip::address_v4::loopback(), 0));
    tcp::socket client(io_), server(io_);
    client.connect(acceptor.local_endpoint());
    acceptor.accept(server);
    return {std::move(client), std::move(server)};
  }
  Streams plain() {
    auto [client, server] = sockets();
    return {plainStream(std::move(client)), plainStream(std::move(server))};
  }
  Streams secure(const PairingKey& client_key, const PairingKey& server_key) {
    auto [client, server] = sockets();
    return {SecureStreams(SecureStreams::Side::kClient, client_key).make(std::move(client)),
            SecureStreams(SecureStreams::Side::kServer, server_key).make(std::move(server))};
  }
  /// Runs what is ready until `done`, for ten seconds at most.
  void runUntil(const std::function<bool()>& done) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    io_.restart();
    while (!done() && std::chrono::steady_clock::now() < end) io_.run_one_for(std::chrono::milliseconds(50));
    EXPECT_TRUE(done());
  }
  /// Carries `text` from one end to the other.
  std::string carried(ByteStream& from, ByteStream& to, const std::string& text) {
    std::string got;
    std::array<char, 4096> buffer{};
    bool is_written = false;
    from.write(asio::buffer(text), [&](std::error_code failed) {
      EXPECT_FALSE(failed) << failed.message();
      is_written = true;
    });
    std::function<void()> read = [&] {
      to.read(asio::buffer(buffer), [&](std::error_code failed, std::size_t bytes) {
        ASSERT_FALSE(failed) << failed.message();
        got.append(buffer.data(), bytes);
        if (got.size() < text.size()) read();
      });
    };
    read();
    runUntil([&] { return is_written && got.size() >= text.size(); });
    return got;
  }
  /// The outcome of both handshakes.
  std::pair<std::error_code, std::error_code> shakeHands(Streams& ends) {
    std::pair<std::error_code, std::error_code> outcome;
    int done = 0;
    ends.first->handshake([&](std::error_code failed) {
      outcome.first = failed;
      ++done;
      // A client of TLS 1.3 is done before the server has looked at its answer.
      if (failed) ends.first->socket().close();
    });
    ends.second->handshake([&](std::error_code failed) {
      outcome.second = failed;
      ++done;
      if (failed) ends.second->socket().close();
    });
    runUntil([&] { return done == 2; });
    return outcome;
  }
  asio::io_context io_;
};

TEST_F(TransportStreams, PlainBytesArriveAsTheyAreAndTheHandshakeIsNothing) {
  Streams ends = plain();
  bool is_done = false;
  ends.first->handshake([&](std::error_code failed) { is_done = !failed; });
  EXPECT_TRUE(is_done) << "before the call returns";
  EXPECT_EQ(carried(*ends.first, *ends.second, std::string("a\0b\xff", 4)), std::string("a\0b\xff", 4));
  const std::string much(300'000, 'x');
  EXPECT_EQ(carried(*ends.second, *ends.first, much), much);
}

TEST_F(TransportStreams, TwoThatHaveTheKeyUnderstandEachOther) {
  const PairingKey key = *PairingKey::make();
  Streams ends = secure(key, key);
  const auto [client, server] = shakeHands(ends);
  ASSERT_FALSE(client) << client.message();
  ASSERT_FALSE(server) << server.message();
  const std::string much(100'000, 'y');
  EXPECT_EQ(carried(*ends.first, *ends.second, much), much);
  EXPECT_EQ(carried(*ends.second, *ends.first, "back"), "back");
}

TEST_F(TransportStreams, WhatGoesOverTheSocketIsNotThePlainText) {
  const PairingKey key = *PairingKey::make();
  auto [client_socket, middle_left] = sockets();
  auto [middle_right, server_socket] = sockets();
  auto client = SecureStreams(SecureStreams::Side::kClient, key).make(std::move(client_socket));
  auto server = SecureStreams(SecureStreams::Side::kServer, key).make(std::move(server_socket));
  // Somebody in between copies all bytes, and keeps them.
  std::string heard;
  struct Copier {
    tcp::socket& from;
    tcp::socket& to;
    std::string& heard;
    std::array<char, 4096> buffer{};
    void copyNext() {
      from.async_read_some(asio::buffer(buffer), [this](std::error_code failed, std::size_t bytes) {
        if (failed) return;
        heard.append(buffer.data(), bytes);
        asio::write(to, asio::buffer(buffer.data(), bytes));
        copyNext();
      });
    }
  };
  Copier to_server{middle_left, middle_right, heard};
  Copier to_client{middle_right, middle_left, heard};
  to_server.copyNext();
  to_client.copyNext();
  Streams ends{std::move(client), std::move(server)};
  const auto [first, second] = shakeHands(ends);
  ASSERT_FALSE(first || second);
  const std::string secret = "the force is six point four newtons";
  EXPECT_EQ(carried(*ends.first, *ends.second, secret), secret);
  EXPECT_EQ(heard.find(secret), std::string::npos);
  EXPECT_EQ(heard.find(std::string(reinterpret_cast<const char*>(key.secret().data()), 8)), std::string::npos);
  EXPECT_NE(heard.find(key.identity()), std::string::npos) << "the name of the key goes in the clear";
  middle_left.close();
  middle_right.close();
  io_.restart();
  io_.poll();  // the reads end while the copiers are still there
}

TEST_F(TransportStreams, AnotherKeyIsNoKey) {
  Streams ends = secure(*PairingKey::make(), *PairingKey::make());
  const auto [client, server] = shakeHands(ends);
  ASSERT_TRUE(server);
  EXPECT_EQ(handshakeFailure(server), HandshakeFailure::kOtherKey) << server.message();
  EXPECT_EQ(english(handshakeProblem(server)), "the other side has a different pairing key");
  ASSERT_TRUE(client);
}

TEST_F(TransportStreams, SomebodyWithoutTlsIsToldApart) {
  const PairingKey key = *PairingKey::make();
  auto [client, server] = sockets();
  auto stream = SecureStreams(SecureStreams::Side::kServer, key).make(std::move(server));
  std::error_code outcome;
  stream->handshake([&](std::error_code failed) { outcome = failed; });
  asio::write(client, asio::buffer(std::string("GET / HTTP/1.1\r\nHost: stylus\r\n\r\n")));
  runUntil([&] { return static_cast<bool>(outcome); });
  EXPECT_EQ(handshakeFailure(outcome), HandshakeFailure::kOtherSpeech);
  EXPECT_EQ(english(handshakeProblem(outcome)), "it does not speak TLS 1.3");
}

TEST_F(TransportStreams, AConnectionThatEndsEarlySaysNothingOfTheKey) {
  const PairingKey key = *PairingKey::make();
  auto [client, server] = sockets();
  auto stream = SecureStreams(SecureStreams::Side::kServer, key).make(std::move(server));
  std::error_code outcome;
  stream->handshake([&](std::error_code failed) { outcome = failed; });
  client.close();
  runUntil([&] { return static_cast<bool>(outcome); });
  EXPECT_EQ(handshakeFailure(outcome), HandshakeFailure::kEnded);
  EXPECT_THAT(english(handshakeProblem(outcome)), ::testing::HasSubstr("before the keys were checked"));
}

/// One end that carries messages, and what it has heard.
struct MessageEnd {
  std::shared_ptr<MessageStream> stream;
  std::vector<Message> messages;
  std::vector<std::string> garbage;
  bool is_opened = false;
  int closed = 0;

  void start(std::unique_ptr<ByteStream> bytes) {
    stream = std::make_shared<MessageStream>(
        std::move(bytes), MessageStream::Handlers{.message = [this](const Message& m) { messages.push_back(m); },
                                                  .garbage = [this](const Error& e) { garbage.push_back(e.message()); },
                                                  .opened = [this] { is_opened = true; },
                                                  .closed = [this] { ++closed; }});
    stream->start();
  }
};

class MessageStreams : public TransportStreams {
 protected:
  void connect() {
    Streams ends = plain();
    client_.start(std::move(ends.first));
    server_.start(std::move(ends.second));
  }
  void TearDown() override {
    for (MessageEnd* end : {&client_, &server_}) {
      if (end->stream) end->stream->close();
    }
    io_.restart();
    io_.run_for(std::chrono::milliseconds(50));
  }
  MessageEnd client_, server_;
  Encoder encoder_;
};

TEST_F(MessageStreams, CarryWholeMessagesInOrder) {
  connect();
  EXPECT_TRUE(client_.is_opened) << "a plain one at once";
  for (std::uint32_t step = 0; step < 50; ++step) client_.stream->send(encoder_.encode(Calibrate{step}));
  runUntil([&] { return server_.messages.size() == 50; });
  for (std::uint32_t step = 0; step < 50; ++step) EXPECT_EQ(std::get<Calibrate>(server_.messages[step]).step, step);
  EXPECT_THAT(client_.stream->peer(), ::testing::MatchesRegex("127\\.0\\.0\\.1:[0-9]+"));
  EXPECT_EQ(client_.stream->peerNetwork(), "127.0.0.1");
}

TEST_F(MessageStreams, OfTheNewestOnlyTheLastWaits) {
  Streams ends = plain();
  server_.start(std::move(ends.second));
  client_.stream = nullptr;
  client_.start(std::move(ends.first));
  // The first leaves at once; those behind it replace each other while it is under way.
  for (std::uint64_t tick = 1; tick <= 1000; ++tick) {
    HapticState state;
    state.tick = tick;
    client_.stream->sendNewest(MessageStream::Slot::kState, encoder_.encode(state));
  }
  runUntil([&] { return !server_.messages.empty() && std::get<HapticState>(server_.messages.back()).tick == 1000; });
  EXPECT_LE(server_.messages.size(), 3u);
  std::uint64_t before = 0;
  for (const Message& message : server_.messages) {
    EXPECT_GT(std::get<HapticState>(message).tick, before);
    before = std::get<HapticState>(message).tick;
  }
}

TEST_F(MessageStreams, WhatIsNoMessageIsReportedOnceAndReadNoMore) {
  auto [client, server] = sockets();
  server_.start(plainStream(std::move(server)));
  asio::write(client, asio::buffer(std::string("\xff\xff\xff\xff nothing of this protocol")));
  runUntil([&] { return !server_.garbage.empty(); });
  const auto good = encoder_.encode(Calibrate{1});
  asio::write(client, asio::buffer(good.data(), good.size()));
  server_.stream->send(encoder_.encode(Refusal{"Nothing of this protocol."}));
  std::array<char, 4> head{};
  asio::read(client, asio::buffer(head));
  EXPECT_GT(head[0], 0) << "sending still works";
  client.close();
  runUntil([&] { return server_.closed == 1; });
  EXPECT_EQ(server_.garbage.size(), 1u);
  EXPECT_TRUE(server_.messages.empty());
}

TEST_F(MessageStreams, FinishingSendsWhatIsQueuedAndThenEnds) {
  connect();
  client_.stream->send(encoder_.encode(Refusal{"Goodbye."}));
  client_.stream->finish();
  EXPECT_TRUE(client_.stream->finishing());
  client_.stream->send(encoder_.encode(Refusal{"Too late."}));
  runUntil([&] { return server_.closed == 1; });
  ASSERT_EQ(server_.messages.size(), 1u);
  EXPECT_EQ(std::get<Refusal>(server_.messages[0]).sentence, "Goodbye.");
}

TEST_F(MessageStreams, APeerThatDoesNotReadIsGivenUp) {
  auto [client, server] = sockets();
  server_.start(plainStream(std::move(server)));
  const std::string sentence(1000, 'z');
  for (int i = 0; i < 10'000 && server_.closed == 0; ++i) server_.stream->send(encoder_.encode(Refusal{sentence}));
  EXPECT_EQ(server_.closed, 1);
  server_.stream->send(encoder_.encode(Refusal{sentence}));
  EXPECT_EQ(server_.closed, 1) << "once";
  EXPECT_EQ(server_.stream->peer(), "");
}

TEST_F(MessageStreams, AfterClosingNobodyIsCalled) {
  connect();
  client_.stream->close();
  runUntil([&] { return server_.closed == 1; });
  EXPECT_EQ(client_.closed, 0);
  EXPECT_TRUE(client_.messages.empty());
}

TEST(PressLatch, AShortPressIsSeenOnceHoweverLateTheLook) {
  PressLatch latch;
  latch.hear(0b01);
  latch.hear(0b00);
  latch.hear(0b10);
  EXPECT_EQ(latch.take(0b10), 0b11u) << "the first button was pressed between the looks";
  EXPECT_EQ(latch.take(0b10), 0b10u) << "and is not any more";
  EXPECT_EQ(latch.take(0b00), 0b00u);
}

TEST(PressLatch, AButtonThatStaysDownIsPressedOnce) {
  PressLatch latch;
  for (int i = 0; i < 5; ++i) latch.hear(0b1);
  EXPECT_EQ(latch.take(0b0), 0b1u);
  latch.hear(0b1);
  EXPECT_EQ(latch.take(0b0), 0b0u) << "no new press";
  latch.hear(0b0);
  latch.hear(0b1);
  EXPECT_EQ(latch.take(0b0), 0b1u);
}

TEST(PressLatch, AnotherConnectionForgetsWhatWasPressed) {
  PressLatch latch;
  latch.hear(0b11);
  latch.forget();
  EXPECT_EQ(latch.take(0b0), 0b0u);
  latch.hear(0b01);
  EXPECT_EQ(latch.take(0b0), 0b01u) << "held over the change: it is new to this connection";
}

TEST(HapticLink, EachStateHasAWordOfItsOwn) {
  EXPECT_EQ(toString(LinkState::kDisconnected), "disconnected");
  EXPECT_EQ(toString(LinkState::kConnecting), "connecting");
  EXPECT_EQ(toString(LinkState::kConnected), "connected");
  EXPECT_EQ(toString(LinkState::kRefused), "refused");
}

}  // namespace
}  // namespace hapticell::haptic
