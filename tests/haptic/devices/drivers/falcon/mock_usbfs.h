// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <umockdev.h>

#include <gtest/gtest.h>

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <deque>
#include <string>
#include <vector>

#include "tests/haptic/devices/drivers/falcon/fake_falcon.h"

namespace hapticell::driver {

/// A Falcon on a mocked USB (umockdev): /sys and usbfs are the test's, libusb is the real one, the device's chip, boot
/// loader and firmware are FakeFalcon. Needs the program to run under umockdev-wrapper; no privilege.
class MockUsbfs {
 public:
  explicit MockUsbfs(FakeFalcon& falcon) : port_(falcon), falcon_(falcon) {
    testbed_ = umockdev_testbed_new();
    GError* problem = nullptr;
    added_ = umockdev_testbed_add_from_string(testbed_, kTree, &problem);
    if (problem != nullptr) {
      ADD_FAILURE() << problem->message;
      g_error_free(problem);
    }
    gchar* const root = umockdev_testbed_get_root_dir(testbed_);
    node_ = std::string(root) + "/dev/bus/usb/001/011";
    g_free(root);
    handler_ = umockdev_ioctl_base_new();
    g_signal_connect(handler_, "handle-ioctl", G_CALLBACK(&MockUsbfs::onIoctl), this);
    umockdev_testbed_attach_ioctl(testbed_, "/dev/bus/usb/001/011", handler_, nullptr);
  }
  ~MockUsbfs() {
    umockdev_testbed_detach_ioctl(testbed_, "/dev/bus/usb/001/011", nullptr);
    for (UMockdevIoctlData* urb : pending_) g_object_unref(urb);
    g_object_unref(handler_);
    g_object_unref(testbed_);
  }
  MockUsbfs(const MockUsbfs&) = delete;
  MockUsbfs& operator=(const MockUsbfs&) = delete;

  bool isThere() const { return added_; }
  void forbid() const { chmod(node_.c_str(), 0); }

  bool in_use = false;  ///< Another program has claimed its interface.

 private:
  static constexpr const char* kTree = R"(P: /devices/pci0000:00/0000:00:14.0/usb1/1-4
N: bus/usb/001/011=1201000200000040030448CB0004010203010902200001010080320904000002FFFFFF000705810240000007050202400000
E: DEVNAME=/dev/bus/usb/001/011
E: DEVTYPE=usb_device
E: SUBSYSTEM=usb
E: BUSNUM=001
E: DEVNUM=011
A: busnum=1\n
A: devnum=11\n
A: speed=12\n
A: bConfigurationValue=1\n
A: idVendor=0403\n
A: idProduct=cb48\n
A: product=FALCON HAPTIC\n
A: serial=FL0042\n
H: descriptors=1201000200000040030448CB0004010203010902200001010080320904000002FFFFFF000705810240000007050202400000

)";

  static gboolean onIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
    return static_cast<MockUsbfs*>(self)->handle(client);
  }
  static gboolean complete(UMockdevIoctlClient* client, glong result, int error = 0) {
    umockdev_ioctl_client_complete(client, result, error);
    return TRUE;
  }

  gboolean handle(UMockdevIoctlClient* client) {
    const gulong request = umockdev_ioctl_client_get_request(client);
    UMockdevIoctlData* const argument = umockdev_ioctl_client_get_arg(client);
    if (falcon_.gone) return complete(client, -1, ENODEV);
    switch (request) {
      case USBDEVFS_CLAIMINTERFACE:
        return in_use ? complete(client, -1, EBUSY) : complete(client, 0);
      case USBDEVFS_RELEASEINTERFACE:
      case USBDEVFS_CLEAR_HALT:
      case USBDEVFS_RESET:
        return complete(client, 0);
      case USBDEVFS_GETDRIVER:
      case USBDEVFS_IOCTL:
        return complete(client, -1, ENODATA);  // The kernel has no driver on it.
      case USBDEVFS_GET_CAPABILITIES: {
        UMockdevIoctlData* const data = umockdev_ioctl_data_resolve(argument, 0, sizeof(guint32), nullptr);
        guint32 none = 0;
        umockdev_ioctl_data_update(data, 0, reinterpret_cast<guint8*>(&none), sizeof none);
        g_object_unref(data);
        return complete(client, 0);
      }
      case USBDEVFS_SUBMITURB:
        pending_.push_back(perform(argument));
        return complete(client, 0);
      case USBDEVFS_REAPURB:
      case USBDEVFS_REAPURBNDELAY:
        return reap(client, argument);
      case USBDEVFS_DISCARDURB:
        return complete(client, -1, EINVAL);  // All are done when they are submitted.
      default:
        return complete(client, -1, ENOTTY);
    }
  }

  /// Does what the request asks of the device and fills it in; it waits to be reaped.
  UMockdevIoctlData* perform(UMockdevIoctlData* argument) {
    UMockdevIoctlData* const data = umockdev_ioctl_data_resolve(argument, 0, sizeof(usbdevfs_urb), nullptr);
    auto* const urb = reinterpret_cast<usbdevfs_urb*>(data->data);
    UMockdevIoctlData* const buffer = umockdev_ioctl_data_resolve(data, offsetof(usbdevfs_urb, buffer),
                                                                  static_cast<gsize>(urb->buffer_length), nullptr);
    const auto length = static_cast<std::size_t>(urb->buffer_length);
    urb->status = 0;
    urb->actual_length = 0;
    if (urb->type == USBDEVFS_URB_TYPE_CONTROL) {
      const guint8* const set_up = buffer->data;  // bmRequestType, bRequest, wValue ...
      port_.control(set_up[1], static_cast<std::uint16_t>(set_up[2] | set_up[3] << 8));
    } else if (urb->endpoint == 0x02) {
      port_.write({buffer->data, length});
      urb->actual_length = urb->buffer_length;
    } else {
      std::vector<std::uint8_t> packet(length, 0);
      const int count = length > 2 ? port_.read(std::span(packet).subspan(2), 0) : 0;
      packet[0] = 0x01;  // Modem status in front of each packet, as the chip has it.
      packet[1] = 0x60;
      umockdev_ioctl_data_update(buffer, 0, packet.data(), count + 2);
      urb->actual_length = count + 2;
    }
    return data;
  }

  gboolean reap(UMockdevIoctlClient* client, UMockdevIoctlData* argument) {
    if (pending_.empty()) return complete(client, -1, EAGAIN);
    UMockdevIoctlData* const urb = pending_.front();
    pending_.pop_front();
    UMockdevIoctlData* const place = umockdev_ioctl_data_resolve(argument, 0, sizeof(void*), nullptr);
    umockdev_ioctl_data_set_ptr(place, 0, urb);
    g_object_unref(place);
    g_object_unref(urb);
    return complete(client, 0);
  }

  FakeFalconPort port_;
  FakeFalcon& falcon_;
  UMockdevTestbed* testbed_ = nullptr;
  UMockdevIoctlBase* handler_ = nullptr;
  bool added_ = false;
  std::string node_;
  std::deque<UMockdevIoctlData*> pending_;
};

}  // namespace hapticell::driver
