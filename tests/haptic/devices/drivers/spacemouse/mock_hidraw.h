// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <umockdev.h>
#include <unistd.h>

#include <atomic>
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
    handler_ = umockdev_ioctl_base_new();
    g_signal_connect(handler_, "handle-ioctl", G_CALLBACK(&MockHidraw::onIoctl), this);
    g_signal_connect(handler_, "handle-write", G_CALLBACK(&MockHidraw::onWrite), this);
    g_signal_connect(handler_, "handle-read", G_CALLBACK(&MockHidraw::onRead), this);
    plug();
  }
  ~MockHidraw() {
    release();
    g_object_unref(handler_);
    g_object_unref(testbed_);
  }

  /// Plugged in; again: as the next hidraw device, since numbers count up.
  void plug() {
    release();
    gone_ = false;
    number_ = node_.empty() ? 0 : number_ + 1;
    gchar* const root = umockdev_testbed_get_root_dir(testbed_);
    node_ = root + place();
    g_free(root);
    GError* problem = nullptr;
    added_ = umockdev_testbed_add_from_string(testbed_, numbered(kTree).c_str(), &problem);
    if (problem != nullptr) g_error_free(problem);
    // A queue in packet mode in the place of the device's file: one read a report, as hidraw has it.
    unlink(node_.c_str());
    mkfifo(node_.c_str(), 0666);
    queue_ = open(node_.c_str(), O_RDWR | O_CLOEXEC);
    fcntl(queue_, F_SETFL, O_NONBLOCK | O_DIRECT);
    umockdev_testbed_attach_ioctl(testbed_, place().c_str(), handler_, nullptr);
  }
  /// The cable is pulled out: whoever has it open reads ENODEV, its file is gone and so is what /sys tells of it.
  void unplug() {
    gone_ = true;
    send({0});  // A queue that nobody writes to wakes nobody.
    unlink(node_.c_str());
    for (const char* part :
         {"/1-4:1.0/0003:256F:C635.000#/hidraw/hidraw@", "/1-4:1.0/0003:256F:C635.000#", "/1-4:1.0", ""})
      umockdev_testbed_remove_device(testbed_, numbered(std::string(kUsb) + part).c_str());
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
  void release() {
    if (queue_ < 0) return;
    umockdev_testbed_detach_ioctl(testbed_, place().c_str(), nullptr);
    close(queue_);
    queue_ = -1;
  }
  static gboolean onRead(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
    if (!static_cast<MockHidraw*>(self)->gone_) return FALSE;  // Read from the queue.
    umockdev_ioctl_client_complete(client, -1, ENODEV);
    return TRUE;
  }

  std::string place() const { return "/dev/hidraw" + std::to_string(number_); }
  /// With the kernel's numbers: @ counts from 0, # from 1.
  std::string numbered(std::string text) const {
    for (char& letter : text) {
      if (letter == '@') letter = static_cast<char>('0' + number_);
      if (letter == '#') letter = static_cast<char>('1' + number_);
    }
    return text;
  }

  static constexpr const char* kUsb = "/sys/devices/pci0000:00/0000:00:14.0/usb1/1-4";
  static constexpr const char* kTree = R"(P: /devices/pci0000:00/0000:00:14.0/usb1/1-4
N: bus/usb/001/01#
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

P: /devices/pci0000:00/0000:00:14.0/usb1/1-4/1-4:1.0/0003:256F:C635.000#
E: SUBSYSTEM=hid
E: HID_ID=0003:0000256F:0000C635
E: HID_NAME=3Dconnexion SpaceMouse Compact
E: HID_UNIQ=
H: report_descriptor=05010908A1018501160000260000A1000930C0C0

P: /devices/pci0000:00/0000:00:14.0/usb1/1-4/1-4:1.0/0003:256F:C635.000#/hidraw/hidraw@
N: hidraw@
E: DEVNAME=/dev/hidraw@
E: SUBSYSTEM=hidraw
L: device=../../../0003:256F:C635.000#

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
  int number_ = 0;
  std::atomic<bool> gone_{false};
  std::string node_;
  int queue_ = -1;
  std::mutex mutex_;
  std::vector<std::vector<std::uint8_t>> written_;
};

}  // namespace hapticell::driver
