// SPDX-License-Identifier: Apache-2.0
#include <libraw1394/raw1394.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include "haptic/devices/device_node.h"
#include "haptic/devices/driver_support.h"
#include "haptic/devices/drivers/omni_firewire/fire_wire_port.h"

namespace hapticell::driver {

namespace {

/// Packets in the kernel's ring: 2 ms at the 8000 cycles a second of FireWire. Half: a thread that is 1 ms late loses
/// packets; twice: forces may wait 4 ms in it.
constexpr unsigned kPacketsBuffered = 16;
constexpr unsigned kMostPacket = 64, kOutPacket = 16;
constexpr unsigned char kOutChannel = 0, kInChannel = 1;

class Raw1394Port final : public FireWirePort {
 public:
  /// `out`: a second handle of the same port; a handle streams in one direction only.
  Raw1394Port(raw1394handle_t handle, raw1394handle_t out, nodeid_t node) : handle_(handle), out_(out), node_(node) {
    raw1394_set_userdata(out_, this);
    raw1394_set_userdata(handle_, this);
    raw1394_set_bus_reset_handler(handle_, [](raw1394handle_t self, unsigned generation) {
      static_cast<Raw1394Port*>(raw1394_get_userdata(self))->reset_ = true;
      raw1394_update_generation(self, generation);
      return 0;
    });
  }
  ~Raw1394Port() override {
    for (const raw1394handle_t handle : {out_, handle_}) {
      if (streaming_) raw1394_iso_stop(handle);
      if (streaming_) raw1394_iso_shutdown(handle);
      if (streaming_) raw1394_channel_modify(handle, handle == out_ ? kOutChannel : kInChannel, RAW1394_MODIFY_FREE);
      raw1394_destroy_handle(handle);
    }
  }

  std::optional<std::uint32_t> readQuadlet(std::uint64_t address) override {
    quadlet_t value = 0;
    if (raw1394_read(handle_, node_, address, sizeof value, &value) < 0) return std::nullopt;
    return std::endian::native == std::endian::little ? __builtin_bswap32(value) : value;
  }
  bool write(std::uint64_t address, std::span<const std::uint8_t> bytes) override {
    std::vector<quadlet_t> copy((bytes.size() + 3) / 4);
    std::memcpy(copy.data(), bytes.data(), bytes.size());
    return raw1394_write(handle_, node_, address, bytes.size(), copy.data()) >= 0;
  }
  bool startStreams(std::uint8_t& to_device, std::uint8_t& from_device) override {
    to_device = kOutChannel;
    from_device = kInChannel;
    if (raw1394_channel_modify(out_, kOutChannel, RAW1394_MODIFY_ALLOC) < 0) return false;
    if (raw1394_channel_modify(handle_, kInChannel, RAW1394_MODIFY_ALLOC) < 0) return false;
    const auto receive = [](raw1394handle_t self, unsigned char* data, unsigned length, unsigned char channel,
                            unsigned char, unsigned char, unsigned, unsigned) {
      static_cast<Raw1394Port*>(raw1394_get_userdata(self))->take(data, length, channel);
      return RAW1394_ISO_OK;
    };
    if (raw1394_iso_recv_init(handle_, receive, kPacketsBuffered, kMostPacket, from_device,
                              RAW1394_DMA_PACKET_PER_BUFFER, 1) < 0) {
      return false;
    }
    const auto transmit = [](raw1394handle_t self, unsigned char* data, unsigned* length, unsigned char* tag,
                             unsigned char* sync, int, unsigned) {
      const auto& packet = static_cast<Raw1394Port*>(raw1394_get_userdata(self))->outgoing_;
      *length = kOutPacket;
      *tag = *sync = 0;
      std::copy(packet.begin(), packet.end(), data);
      return RAW1394_ISO_OK;
    };
    if (raw1394_iso_xmit_init(out_, transmit, kPacketsBuffered, kOutPacket, to_device, RAW1394_ISO_SPEED_100, 1) < 0) {
      return false;
    }
    streaming_ = true;
    return raw1394_iso_recv_start(handle_, -1, -1, 0) >= 0 && raw1394_iso_xmit_start(out_, -1, -1) >= 0;
  }
  void send(std::span<const std::uint8_t> packet) override {
    std::copy_n(packet.begin(), std::min(packet.size(), outgoing_.size()), outgoing_.begin());
  }
  std::optional<std::vector<std::uint8_t>> receive(int wait_ms) override {
    pollfd ready[2]{{raw1394_get_fd(handle_), POLLIN, 0}, {raw1394_get_fd(out_), POLLIN, 0}};
    if (::poll(ready, 2, wait_ms) > 0) {
      if (ready[0].revents != 0 && raw1394_loop_iterate(handle_) < 0 && errno != EAGAIN) return std::nullopt;
      if (ready[1].revents != 0 && raw1394_loop_iterate(out_) < 0 && errno != EAGAIN) return std::nullopt;
    }
    if (reset_) return std::nullopt;
    return std::exchange(newest_, {});
  }

 private:
  void take(const unsigned char* data, unsigned length, unsigned char channel) {
    if (channel == kInChannel) newest_.assign(data, data + length);
  }

  raw1394handle_t handle_, out_;
  nodeid_t node_;
  std::array<std::uint8_t, kOutPacket> outgoing_{};
  bool streaming_ = false, reset_ = false;
  std::vector<std::uint8_t> newest_;
};

/// Devices of the juju stack, by its folder in /sys: neither a bus nor a right is needed to look.
class Raw1394Bus final : public FireWireBus {
 public:
  std::vector<FireWireNode> nodes(Problem&) override {
    std::vector<FireWireNode> found;
    std::error_code missing;
    for (const auto& entry : std::filesystem::directory_iterator("/sys/bus/firewire/devices", missing)) {
      std::ifstream file(entry.path() / "guid");
      FireWireNode node;
      if (!(file >> std::hex >> node.guid)) continue;
      node.place = "/dev/" + entry.path().filename().string();
      found.push_back(node);
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.place < b.place; });
    return found;
  }

  std::unique_ptr<FireWirePort> open(const FireWireNode& wanted, Problem& problem) override {
    raw1394handle_t handle = raw1394_new_handle();
    if (handle == nullptr) {
      problem = nodeProblem(wanted.place, errno != 0 ? errno : ENODEV);
      return nullptr;
    }
    const int ports = raw1394_get_port_info(handle, nullptr, 0);
    for (int port = 0; port < ports; ++port) {
      if (raw1394_set_port(handle, port) < 0) break;
      const int count = raw1394_get_nodecount(handle);
      for (int i = 0; i < count; ++i) {
        const auto node = static_cast<nodeid_t>(0xFFC0 | i);
        if (guidOf(handle, node) != wanted.guid) continue;
        if (const raw1394handle_t out = raw1394_new_handle_on_port(port)) {
          return std::make_unique<Raw1394Port>(handle, out, node);
        }
      }
      raw1394_destroy_handle(handle);
      if ((handle = raw1394_new_handle()) == nullptr) break;
    }
    if (handle != nullptr) raw1394_destroy_handle(handle);
    problem = nodeProblem(wanted.place);
    if (problem.status == Status::kOk)
      refuse(problem, Status::kNotFound, "it is not on the bus any more", "Plug it in again.");
    return nullptr;
  }

 private:
  static std::uint64_t guidOf(raw1394handle_t handle, nodeid_t node) {
    quadlet_t high = 0, low = 0;
    constexpr nodeaddr_t kGuid = 0xFFFFF000040CULL;
    if (raw1394_read(handle, node, kGuid, 4, &high) < 0 || raw1394_read(handle, node, kGuid + 4, 4, &low) < 0) return 0;
    return static_cast<std::uint64_t>(__builtin_bswap32(high)) << 32 | __builtin_bswap32(low);
  }
};

}  // namespace

std::unique_ptr<FireWireBus> makeRaw1394() {
  return std::make_unique<Raw1394Bus>();
}

}  // namespace hapticell::driver
