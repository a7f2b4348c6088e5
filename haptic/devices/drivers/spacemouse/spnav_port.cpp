// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/spacemouse/spacenav_device.h"

#ifdef HAPTICELL_HAVE_SPNAV
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "haptic/devices/driver_support.h"

// Last: with Xlib it brings macros of everyday names.
#include <spnav.h>
#undef Status
#undef None
#undef Bool
#undef True
#undef False
#endif

namespace hapticell::driver {

#ifdef HAPTICELL_HAVE_SPNAV

namespace {

bool is_open = false;  // libspnav has one connection a process.

/// Where libspnav looks, in its order.
std::string socketPath() {
  if (const char* said = std::getenv("SPNAV_SOCKET")) return said;
  std::ifstream file("/etc/spnavrc");
  for (std::string line; std::getline(file, line);) {
    const auto begin = line.find_first_not_of(" \t");
    if (begin == std::string::npos || line.compare(begin, 6, "socket") != 0) continue;
    const auto equals = line.find('=', begin);
    const auto first = equals == std::string::npos ? equals : line.find_first_not_of(" \t", equals + 1);
    if (first != std::string::npos) return line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
  }
  return "/var/run/spnav.sock";
}

/// A socket whose daemon was killed refuses.
bool answers(const std::string& path) {
  sockaddr_un address{};
  if (path.size() >= sizeof address.sun_path) return false;
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  const int probe = socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (probe < 0) return false;
  const bool there = connect(probe, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  close(probe);
  return there;
}

class SpnavPort final : public SpacenavPort {
 public:
  ~SpnavPort() override {
    spnav_close();
    is_open = false;
  }

  int next(SpacenavEvent& event, int wait_ms) override {
    spnav_event raw{};
    while (true) {
      if (spnav_poll_event(&raw) == 0) {
        pollfd waiting{spnav_fd(), POLLIN, 0};
        if (poll(&waiting, 1, wait_ms) <= 0) return 0;
        char byte = 0;
        const auto got = recv(waiting.fd, &byte, 1, MSG_PEEK | MSG_DONTWAIT);
        if (got == 0 || (got < 0 && errno != EAGAIN && errno != EINTR)) return -1;
        if (spnav_poll_event(&raw) == 0) return 0;
      }
      if (raw.type == SPNAV_EVENT_MOTION) {
        const spnav_event_motion& m = raw.motion;
        event = {true, {m.x, m.y, m.z, m.rx, m.ry, m.rz}, 0, false};
        return 1;
      }
      if (raw.type == SPNAV_EVENT_BUTTON) {
        event = {false, {}, raw.button.bnum, raw.button.press != 0};
        return 1;
      }
      wait_ms = 0;  // Devices that come and go, settings: not ours.
    }
  }

  std::string deviceName() override {
    std::array<char, 128> name{};
    return spnav_protocol() > 0 && spnav_dev_name(name.data(), static_cast<int>(name.size())) > 0 ? name.data() : "";
  }

  std::uint32_t buttons() override {
    const int count = spnav_protocol() > 0 ? spnav_dev_buttons() : 2;
    return count > 0 ? static_cast<std::uint32_t>(count) : 2u;
  }
};

class Spnav final : public SpacenavBackend {
 public:
  bool isRunning() override { return is_open || answers(socketPath()); }
  std::string place() override { return socketPath(); }
  std::string trace() override {
    struct stat file {};
    if (stat(socketPath().c_str(), &file) != 0) return {};
    return std::to_string(file.st_ino) + ' ' + std::to_string(file.st_ctim.tv_sec);
  }

  std::string deviceName() override {
    if (is_open) return known_;
    Problem problem;
    const auto port = open(problem);
    return port != nullptr ? port->deviceName() : std::string();
  }

  std::unique_ptr<SpacenavPort> open(Problem& problem) override {
    if (is_open) {
      refuse(problem, Status::kFault, "the connection to spacenavd is in use", "Close the other one first.");
      return nullptr;
    }
    if (spnav_open() != 0) {
      refuse(problem, Status::kFault, "spacenavd does not answer at " + socketPath(), "Start it again.");
      return nullptr;
    }
    is_open = true;
    auto port = std::make_unique<SpnavPort>();
    if (spnav_protocol() > 0) spnav_client_name("hapticell");
    known_ = port->deviceName();
    return port;
  }

 private:
  std::string known_;
};

}  // namespace

std::unique_ptr<SpacenavBackend> makeSpacenav() {
  return std::make_unique<Spnav>();
}

#else

std::unique_ptr<SpacenavBackend> makeSpacenav() {
  return nullptr;
}

#endif

}  // namespace hapticell::driver
