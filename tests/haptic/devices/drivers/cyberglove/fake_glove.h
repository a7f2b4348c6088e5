// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace hapticell::driver {

/// A CyberGlove's box at the other end of a pseudo-terminal, in a thread of its own: answers questions and polls, and
/// sends whatever the test wants besides.
class FakeGlove {
 public:
  FakeGlove() {
    char name[128] = {};
    openpty(&master_, &slave_, name, nullptr, nullptr);
    path_ = name;
    termios raw{};
    tcgetattr(slave_, &raw);
    cfmakeraw(&raw);
    tcsetattr(slave_, TCSANOW, &raw);
    thread_ = std::thread([this] { serve(); });
  }
  ~FakeGlove() { unplug(); }

  const std::string& path() const { return path_; }

  /// The cable is pulled out: the port hangs up.
  void unplug() {
    stopping_ = true;
    if (thread_.joinable()) thread_.join();
    if (slave_ >= 0) close(slave_);
    if (master_ >= 0) close(master_);
    master_ = slave_ = -1;
  }
  void send(const std::vector<std::uint8_t>& bytes) {
    for (std::size_t done = 0; done < bytes.size();) {
      const ssize_t count = write(master_, bytes.data() + done, bytes.size() - done);
      if (count <= 0) return;
      done += static_cast<std::size_t>(count);
    }
  }
  /// A sample as the 8-bit protocol has it.
  std::vector<std::uint8_t> frame(char head) const {
    std::vector<std::uint8_t> bytes{static_cast<std::uint8_t>(head)};
    for (int i = 0; i < sensors; ++i) bytes.push_back(static_cast<std::uint8_t>(first + i));
    if (status_enabled) bytes.push_back(status);
    bytes.push_back(0);
    return bytes;
  }
  std::vector<std::vector<std::uint8_t>> vibrations() {
    const std::scoped_lock lock(mutex_);
    return vibrations_;
  }

  // Set before it is opened.
  std::atomic<int> sensors{22};
  std::atomic<int> connected{3};
  std::atomic<std::uint8_t> touch_flags{2};
  std::atomic<int> first{10};           ///< Reading of the first sensor; the others count up.
  std::atomic<std::uint8_t> status{2};  ///< The switch is on. Must not be 0 on the wire.
  std::atomic<bool> status_enabled{false};
  std::atomic<bool> silent{false};  ///< Answers nothing.
  std::atomic<int> polls{0};

 private:
  void serve() {
    std::vector<std::uint8_t> heard;
    while (!stopping_) {
      pollfd ready{master_, POLLIN, 0};
      if (::poll(&ready, 1, 5) <= 0 || (ready.revents & POLLIN) == 0) continue;
      std::array<std::uint8_t, 128> bytes{};
      const ssize_t count = read(master_, bytes.data(), bytes.size());
      if (count <= 0) continue;
      heard.insert(heard.end(), bytes.begin(), bytes.begin() + count);
      while (answer(heard)) {
      }
    }
  }
  /// Takes one request off the front; false where none is whole.
  bool answer(std::vector<std::uint8_t>& heard) {
    if (heard.empty()) return false;
    const auto drop = [&](std::size_t count) {
      heard.erase(heard.begin(), heard.begin() + static_cast<std::ptrdiff_t>(count));
      return true;
    };
    if (heard[0] == '?') {
      if (heard.size() < 2) return false;
      if (!silent) answerQuestion(heard[1]);
      return drop(2);
    }
    if (heard[0] == 'A') {
      if (heard.size() < 8) return false;
      const std::scoped_lock lock(mutex_);
      vibrations_.emplace_back(heard.begin() + 2, heard.begin() + 8);
      return drop(8);
    }
    if (heard[0] == 'u' || heard[0] == 't') {
      for (std::size_t i = 0; i < heard.size(); ++i) {
        if (heard[i] != '\r') continue;
        if (heard[0] == 'u') status_enabled = true;
        return drop(i + 1);
      }
      return false;
    }
    if (heard[0] == 'G' || heard[0] == 'S') {
      ++polls;
      if (!silent) send(frame(static_cast<char>(heard[0])));
    }
    return drop(1);
  }
  void answerQuestion(std::uint8_t what) {
    if (what == 'G') send({'?', 'G', static_cast<std::uint8_t>(connected), 0});
    if (what == 'S') send({'?', 'S', static_cast<std::uint8_t>(sensors), 0});
    if (what == 'R') send({'?', 'R', 1, 0});
    if (what == 'P') send({'?', 'P', 0, 0, touch_flags, 0});
  }

  int master_ = -1, slave_ = -1;
  std::string path_;
  std::thread thread_;
  std::atomic<bool> stopping_{false};
  std::mutex mutex_;
  std::vector<std::vector<std::uint8_t>> vibrations_;
};

}  // namespace hapticell::driver
