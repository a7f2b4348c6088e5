// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <umockdev.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <mutex>
#include <string>
#include <vector>

// The ioctls of hidraw, by <linux/hidraw.h>.
#include <linux/hidraw.h>

namespace hapticell::driver {

/// A SpaceMouse Compact on a mocked system (umockdev): /sys, udev and /dev/hidraw0 are the test's, hidapi is the real
/// one. Needs the program to run under umockdev-wrapper; no privilege, no kernel module.
class MockHidraw {
 public:
  MockHidraw() {
    testbed_ = umockdev_testbed_new();
    GError* problem = nullptr;
    added_ = umockdev_testbed_add_from_string(testbed_, kTree, &problem);
    if (problem != nullptr) g_error_free(problem);
    gchar* const root = umockdev_testbed_get_root_dir(testbed_);
    node_ = std::string(root) + "/dev/hidraw0";
    g_free(root);
    // A queue in packet mode in the place of the device's file: one read a report, as hidraw has it.
    unlink(node_.c_str());
    mkfifo(node_.c_str(), 0666);
    queue_ = open(node_.c_str(), O_RDWR | O_CLOEXEC);
    fcntl(queue_, F_SETFL, O_NONBLOCK | O_DIRECT);
    handler_ = umockdev_ioctl_base_new();
    g_signal_connect(handler_, "handle-ioctl", G_CALLBACK(&MockHidraw::onIoctl), this);
    g_signal_connect(handler_, "handle-write", G_CALLBACK(&MockHidraw::onWrite), this);
    umockdev_testbed_attach_ioctl(testbed_, "/dev/hidraw0", handler_, nullptr);
  }
  ~MockHidraw() {
    umockdev_testbed_detach_ioctl(testbed_, "/dev/hidraw0", nullptr);
    close(queue_);
    g_object_unref(handler_);
    g_object_unref(testbed_);
  }

  bool isThere() const { return added_; }
  /// Waits for room in the queue: nothing is lost where the program is slow.
  void send(const std::vector<std::uint8_t>& report) const {
    while (::write(queue_, report.data(), report.size()) < 0 && errno == EAGAIN) {
      constexpr int kPatience = 10000;  // ms
      pollfd room{queue_, POLLOUT, 0};
      if (::poll(&room, 1, kPatience) <= 0) return;
    }
  }
  /// Output reports that the program wrote.
  std::vector<std::vector<std::uint8_t>> written() {
    const std::scoped_lock lock(mutex_);
    return written_;
  }
  /// Its file loses the rights of everybody.
  void forbid() const { chmod(node_.c_str(), 0); }
  const std::string& node() const { return node_; }

 private:
  static constexpr const char* kTree = R"(P: /devices/pci0000:00/0000:00:14.0/usb1/1-4
N: bus/usb/001/011
E: DEVTYPE=usb_device
E: SUBSYSTEM=usb
A: idVendor=256f\n
A: idProduct=c635\n
A: product=SpaceMouse Compact\n
A: manufacturer=3Dconnexion\n

P: /devices/pci0000:00/0000:00:14.0/usb1/1-4/1-4:1.0
E: DEVTYPE=usb_interface
E: SUBSYSTEM=usb
A: bInterfaceNumber=00\n

P: /devices/pci0000:00/0000:00:14.0/usb1/1-4/1-4:1.0/0003:256F:C635.0001
E: SUBSYSTEM=hid
E: HID_ID=0003:0000256F:0000C635
E: HID_NAME=3Dconnexion SpaceMouse Compact
E: HID_UNIQ=
H: report_descriptor=05010908A1018501160000260000A1000930C0C0

P: /devices/pci0000:00/0000:00:14.0/usb1/1-4/1-4:1.0/0003:256F:C635.0001/hidraw/hidraw0
N: hidraw0
E: DEVNAME=/dev/hidraw0
E: SUBSYSTEM=hidraw
L: device=../../../0003:256F:C635.0001

)";

  static gboolean onIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer) {
    const gulong request = umockdev_ioctl_client_get_request(client);
    UMockdevIoctlData* const argument = umockdev_ioctl_client_get_arg(client);
    static constexpr std::uint8_t kDescriptor[] = {0x05, 0x01, 0x09, 0x08, 0xA1, 0x01, 0xC0};
    if (request == HIDIOCGRDESCSIZE) {
      UMockdevIoctlData* const size = umockdev_ioctl_data_resolve(argument, 0, sizeof(int), nullptr);
      const int length = sizeof kDescriptor;
      umockdev_ioctl_data_update(size, 0, reinterpret_cast<guint8*>(const_cast<int*>(&length)), sizeof length);
      g_object_unref(size);
      umockdev_ioctl_client_complete(client, 0, 0);
    } else if (request == HIDIOCGRDESC) {
      UMockdevIoctlData* const whole =
          umockdev_ioctl_data_resolve(argument, 0, sizeof(hidraw_report_descriptor), nullptr);
      umockdev_ioctl_data_update(whole, 4, const_cast<guint8*>(kDescriptor), sizeof kDescriptor);
      g_object_unref(whole);
      umockdev_ioctl_client_complete(client, 0, 0);
    } else {
      umockdev_ioctl_client_complete(client, -1, ENOTTY);
    }
    return TRUE;
  }
  static gboolean onWrite(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
    UMockdevIoctlData* const argument = umockdev_ioctl_client_get_arg(client);
    guint8* bytes = nullptr;
    gint length = 0;
    umockdev_ioctl_data_retrieve(argument, &bytes, &length);
    auto* const mock = static_cast<MockHidraw*>(self);
    {
      const std::scoped_lock lock(mock->mutex_);
      mock->written_.emplace_back(bytes, bytes + length);
    }
    g_free(bytes);
    umockdev_ioctl_client_complete(client, static_cast<glong>(length), 0);
    return TRUE;
  }

  UMockdevTestbed* testbed_ = nullptr;
  UMockdevIoctlBase* handler_ = nullptr;
  bool added_ = false;
  std::string node_;
  int queue_ = -1;
  std::mutex mutex_;
  std::vector<std::vector<std::uint8_t>> written_;
};

}  // namespace hapticell::driver
