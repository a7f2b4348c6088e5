// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace hapticell::driver {

/// spacenavd's socket in the hands of a test: packets of eight 32-bit words. Speaks protocol 1 (requests are answered,
/// the device is a SpaceMouse Compact), or 0 as daemons before 1.0 do (nothing is answered). libspnav is sent there by
/// SPNAV_SOCKET.
class FakeSpacenavd {
 public:
  using Packet = std::array<std::int32_t, 8>;

  FakeSpacenavd(std::string path, int protocol) : path_(std::move(path)), protocol_(protocol) {
    listener_ = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path_.c_str(), sizeof address.sun_path - 1);
    unlink(path_.c_str());
    if (bind(listener_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 || listen(listener_, 8) != 0)
      std::abort();
    setenv("SPNAV_SOCKET", path_.c_str(), 1);
    thread_ = std::thread([this] { serve(); });
  }
  ~FakeSpacenavd() {
    end_ = true;
    thread_.join();
    for (const int client : clients_) close(client);
    close(listener_);
    unlink(path_.c_str());
  }

  /// To every client.
  void send(const Packet& packet) {
    const std::lock_guard lock(mutex_);
    for (const int client : clients_) static_cast<void>(::send(client, packet.data(), sizeof packet, MSG_NOSIGNAL));
  }
  void move(int x, int y, int z, int rx, int ry, int rz) { send({0, x, y, z, rx, ry, rz, 16}); }
  void press(int button) { send({1, button, 0, 0, 0, 0, 0, 0}); }
  void release(int button) { send({2, button, 0, 0, 0, 0, 0, 0}); }
  std::size_t clients() {
    const std::lock_guard lock(mutex_);
    return clients_.size();
  }

 private:
  void serve() {
    while (!end_) {
      std::vector<pollfd> watched{{listener_, POLLIN, 0}};
      for (const int client : clients_) watched.push_back({client, POLLIN, 0});
      if (poll(watched.data(), watched.size(), 5) <= 0) continue;
      const std::lock_guard lock(mutex_);
      for (std::size_t i = 1; i < watched.size(); ++i) {
        if (watched[i].revents != 0 && !answer(watched[i].fd)) {
          close(watched[i].fd);
          std::erase(clients_, watched[i].fd);
        }
      }
      if (watched[0].revents != 0) clients_.push_back(accept(listener_, nullptr, nullptr));
    }
  }

  /// False: the client has gone.
  bool answer(int client) {
    Packet packet{};
    const ssize_t length = recv(client, packet.data(), sizeof packet, 0);
    if (length <= 0) return false;
    if (protocol_ == 0) return true;
    if (length == 4) {  // The change of protocol.
      static_cast<void>(::send(client, packet.data(), 4, MSG_NOSIGNAL));
      return true;
    }
    const std::int32_t request = packet[0] & 0xFFFF;
    Packet reply{packet[0]};
    if (request == 0x2000) {  // The device's name, at most 24 bytes a packet.
      constexpr char kName[] = "SpaceMouse Compact";
      std::memcpy(&reply[1], kName, sizeof kName - 1);
      reply[7] = sizeof kName - 1;
    } else if (request == 0x2003) {
      reply[1] = 2;
    } else if (request == 0x1000) {
      return true;  // Our own name: never answered.
    }
    static_cast<void>(::send(client, reply.data(), sizeof reply, MSG_NOSIGNAL));
    return true;
  }

  std::string path_;
  int protocol_;
  int listener_ = -1;
  std::atomic<bool> end_ = false;
  std::mutex mutex_;
  std::vector<int> clients_;
  std::thread thread_;
};

}  // namespace hapticell::driver
