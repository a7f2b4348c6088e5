// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/cyberglove/serial_port.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>

#include "haptic/devices/device_node.h"
#include "haptic/devices/driver_support.h"

namespace hapticell::driver {

namespace {

// ms: a write of 8 bytes takes 0.7 ms at 115,200 baud. Half: a busy port counts as gone; twice: the driver hangs longer
// on a dead one.
constexpr int kWritePatience = 50;

bool configure(int file) {
  termios settings{};
  if (tcgetattr(file, &settings) != 0) return false;
  cfmakeraw(&settings);
  cfsetispeed(&settings, B115200);
  cfsetospeed(&settings, B115200);
  settings.c_cflag =
      (settings.c_cflag & ~static_cast<tcflag_t>(CSTOPB | PARENB | CRTSCTS | CSIZE)) | CS8 | CLOCAL | CREAD;
  settings.c_cc[VMIN] = 0;
  settings.c_cc[VTIME] = 0;
  if (tcsetattr(file, TCSANOW, &settings) != 0) return false;
  return tcflush(file, TCIOFLUSH) == 0;
}

}  // namespace

std::unique_ptr<SerialPort> SerialPort::open(const std::string& path, Problem& problem) {
  const int file = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) {
    problem = nodeProblem(path, errno);
    return nullptr;
  }
  std::unique_ptr<SerialPort> port(new SerialPort(file));
  if (flock(file, LOCK_EX | LOCK_NB) != 0) {
    problem = nodeProblem(path, EBUSY);
    return nullptr;
  }
  ioctl(file, TIOCEXCL);  // Against programs that do not lock; where that does not work, the lock stands.
  if (!configure(file)) {
    refuse(problem, Status::kFault, path + " is no serial port",
           "Name the glove's port: port = \"/dev/ttyUSB0\" in [driver.cyberglove].");
    return nullptr;
  }
  return port;
}

SerialPort::~SerialPort() {
  ioctl(file_, TIOCNXCL);
  ::close(file_);
}

int SerialPort::read(std::span<std::uint8_t> to, int wait_ms) {
  pollfd ready{file_, POLLIN, 0};
  const int changed = ::poll(&ready, 1, wait_ms);
  if (changed == 0 || (changed < 0 && errno == EINTR)) return 0;
  if (changed < 0) return -1;
  if ((ready.revents & POLLIN) == 0) return -1;  // Hung up.
  const ssize_t count = ::read(file_, to.data(), to.size());
  if (count > 0) return static_cast<int>(count);
  return count < 0 && (errno == EAGAIN || errno == EINTR) ? 0 : -1;
}

bool SerialPort::write(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    pollfd ready{file_, POLLOUT, 0};
    const int changed = ::poll(&ready, 1, kWritePatience);
    if (changed < 0 && errno == EINTR) continue;
    if (changed <= 0 || (ready.revents & POLLOUT) == 0) return false;
    const ssize_t count = ::write(file_, bytes.data(), bytes.size());
    if (count < 0 && errno != EAGAIN && errno != EINTR) return false;
    if (count > 0) bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

}  // namespace hapticell::driver
