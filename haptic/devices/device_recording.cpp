// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/device_recording.h"

#include <array>
#include <atomic>
#include <bit>
#include <chrono>
#include <cstring>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>
#include <utility>

#include "geometry/system/atomic_file.h"

#include "geometry/system/nesting_limit.h"
#include "geometry/system/regular_file.h"

namespace hapticell::haptic {

namespace {

using nlohmann::json;

constexpr char kMagic[] = "HCELDEV1";
// Ring: 16 s of ticks for a disk that is busy. Half: 8 s; twice: 4 MB. What does not fit is lost and counted.
constexpr std::size_t kMagicSize = 8, kTickSize = 120, kRing = 16384;
// Bytes of the description of a device in a file: a few lines of JSON. More is a broken file; half and twice still hold
// it.
constexpr std::uint32_t kMostHeader = 1 << 16;
static_assert(std::endian::native == std::endian::little, "the file is little-endian");

json toJson(const dvec3& v) {
  return {v.x, v.y, v.z};
}

json toJson(const DeviceCapabilities& c) {
  return {{"name", c.name},
          {"workspace_min", toJson(c.workspace_min)},
          {"workspace_max", toJson(c.workspace_max)},
          {"resolution", c.resolution},
          {"measured_axes", c.measured_axes},
          {"driven_axes", c.driven_axes},
          {"peak_force", c.peak_force},
          {"continuous_force", c.continuous_force},
          {"peak_torque", c.peak_torque},
          {"stiffness", c.stiffness},
          {"damping", c.damping},
          {"buttons", c.buttons},
          {"delay_ticks", c.delay_ticks},
          {"thermal_time", c.thermal_time}};
}

bool fromJson(const json& from, DeviceCapabilities& c) try {
  for (int i = 0; i < 3; ++i) {
    c.workspace_min[i] = from.at("workspace_min").at(static_cast<std::size_t>(i)).get<double>();
    c.workspace_max[i] = from.at("workspace_max").at(static_cast<std::size_t>(i)).get<double>();
  }
  c.name = from.at("name").get<std::string>();
  for (const auto& [key, value] : {std::pair{"resolution", &c.resolution},
                                   {"peak_force", &c.peak_force},
                                   {"continuous_force", &c.continuous_force},
                                   {"peak_torque", &c.peak_torque},
                                   {"stiffness", &c.stiffness},
                                   {"damping", &c.damping},
                                   {"thermal_time", &c.thermal_time}}) {
    *value = from.at(key).get<double>();
    if (!(*value >= 0.0)) return false;
  }
  for (const auto& [key, value] : {std::pair{"measured_axes", &c.measured_axes},
                                   {"driven_axes", &c.driven_axes},
                                   {"buttons", &c.buttons},
                                   {"delay_ticks", &c.delay_ticks}}) {
    *value = from.at(key).get<int>();
    if (*value < 0 || *value > 32) return false;
  }
  return true;
} catch (const json::exception&) {
  return false;
}

using TickBytes = std::array<char, kTickSize>;

TickBytes pack(const RecordedTick& tick) {
  TickBytes bytes{};
  std::memcpy(bytes.data(), &tick.status, 4);
  std::memcpy(bytes.data() + 4, &tick.buttons, 4);
  const Pose& X = tick.X_DS;
  const double numbers[14] = {X.p.x,           X.p.y,          X.p.z,          X.q.w,
                              X.q.x,           X.q.y,          X.q.z,          tick.motor_temperature,
                              tick.force_D.x,  tick.force_D.y, tick.force_D.z, tick.torque_D.x,
                              tick.torque_D.y, tick.torque_D.z};
  std::memcpy(bytes.data() + 8, numbers, sizeof numbers);
  return bytes;
}

RecordedTick unpack(const char* bytes) {
  RecordedTick tick;
  std::memcpy(&tick.status, bytes, 4);
  std::memcpy(&tick.buttons, bytes + 4, 4);
  double n[14];
  std::memcpy(n, bytes + 8, sizeof n);
  tick.X_DS.p = {n[0], n[1], n[2]};
  tick.X_DS.q = dquat(n[3], n[4], n[5], n[6]);
  tick.motor_temperature = n[7];
  tick.force_D = {n[8], n[9], n[10]};
  tick.torque_D = {n[11], n[12], n[13]};
  return tick;
}

std::uint32_t statusOf(const RecordedTick& tick) {
  return tick.status & ~(RecordedTick::kNotFresh | RecordedTick::kForceless);
}

}  // namespace

Expected<DeviceRecording> readDeviceRecording(const std::filesystem::path& file) {
  const auto refuse = [&](Text place, Text found, Text expected) {
    return makeError(
        {.file = file.string(), .place = std::move(place), .found = std::move(found), .expected = std::move(expected)});
  };
  geometry::RegularFileStream stream(file);
  HAPTICELL_TRY(stream);
  char magic[kMagicSize] = {};
  std::uint32_t length = 0;
  stream.read(magic, sizeof magic);
  stream.read(reinterpret_cast<char*>(&length), sizeof length);
  if (!stream || std::memcmp(magic, kMagic, kMagicSize) != 0 || length > kMostHeader) {
    return refuse(Text("start of file"), Text("another format"), Text("a recorded device session (*.hdev)"));
  }
  std::string header(length, '\0');
  stream.read(header.data(), length);
  DeviceRecording recording;
  if (auto flat = geometry::checkNesting(header, geometry::NestedText::kJson, file.string()); !flat)
    return makeError(flat.error());
  if (!stream || !fromJson(json::parse(header, nullptr, false), recording.capabilities)) {
    return refuse(Text("header"), Text("the capabilities are missing"), Text("the JSON header of a recording"));
  }
  TickBytes bytes{};
  while (stream.read(bytes.data(), bytes.size())) {
    recording.ticks.push_back(unpack(bytes.data()));
    const RecordedTick& tick = recording.ticks.back();
    if (!tick.X_DS.isValid() || statusOf(tick) > static_cast<std::uint32_t>(DeviceStatus::kVanished)) {
      return refuse(Text("tick %1", recording.ticks.size()), Text("the pose or the status is missing or invalid"),
                    Text("a valid pose and status"));
    }
  }
  return recording;
}

/// A ring between the force loop, which fills it, and a thread that writes it down.
class RecordingDevice::Writer {
 public:
  explicit Writer(AtomicFile file) : file_(std::move(file)), ring_(kRing), thread_([this] { run(); }) {}
  ~Writer() {
    stopping_ = true;
    if (thread_.joinable()) thread_.join();
  }
  /// Writes the rest and gives the file its name; the first fault there was.
  Expected<void> finish() {
    stopping_ = true;
    thread_.join();
    if (auto fault = this->fault()) return makeError(*fault);
    return file_.commit();
  }
  std::optional<Error> fault() const {
    const std::scoped_lock lock(mutex_);
    return fault_;
  }
  void add(const RecordedTick& tick) noexcept {
    const std::uint64_t at = written_.load(std::memory_order_relaxed);
    if (at - taken_.load(std::memory_order_acquire) >= kRing) {
      lost_.fetch_add(1, std::memory_order_relaxed);
      return;
    }
    ring_[at % kRing] = tick;
    written_.store(at + 1, std::memory_order_release);
  }
  std::uint64_t lost() const { return lost_.load(std::memory_order_relaxed); }

 private:
  void run() {
    while (!stopping_) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      flush();
    }
    flush();
  }
  void flush() {
    std::uint64_t at = taken_.load(std::memory_order_relaxed);
    const std::uint64_t end = written_.load(std::memory_order_acquire);
    std::string text;
    for (; at < end; ++at) {
      const TickBytes bytes = pack(ring_[at % kRing]);
      text.append(bytes.data(), bytes.size());
    }
    taken_.store(at, std::memory_order_release);
    if (text.empty() || fault()) return;
    if (auto written = file_.write(text); !written) {
      const std::scoped_lock lock(mutex_);
      fault_ = written.error();
    }
  }

  AtomicFile file_;
  mutable std::mutex mutex_;
  std::optional<Error> fault_;  // Behind mutex_, which the force loop's calls do not take.
  std::vector<RecordedTick> ring_;
  std::atomic<std::uint64_t> written_{0}, taken_{0}, lost_{0};
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

RecordingDevice::RecordingDevice(std::unique_ptr<Device> device, std::filesystem::path file)
    : device_(std::move(device)), file_(std::move(file)) {}

RecordingDevice::~RecordingDevice() {
  close();
}

Expected<void> RecordingDevice::open() {
  if (writer_) return {};
  finished_ = {};
  if (const auto opened = device_->open(); !opened) return opened;
  const std::string header = toJson(device_->capabilities()).dump();
  const auto length = static_cast<std::uint32_t>(header.size());
  std::string text(kMagic, kMagicSize);
  text.append(reinterpret_cast<const char*>(&length), sizeof length).append(header);
  auto file = AtomicFile::begin(file_);
  auto written = file ? file->write(text) : makeError(file.error());
  if (!written) {
    device_->close();
    return written;
  }
  writer_ = std::make_unique<Writer>(std::move(*file));
  return {};
}

Expected<void> RecordingDevice::finish() {
  if (writer_) {
    finished_ = writer_->finish();
    writer_.reset();
  }
  return finished_;
}

std::optional<Error> RecordingDevice::fault() const {
  if (!writer_) return finished_ ? std::nullopt : std::optional<Error>(finished_.error());
  return writer_->fault();
}

DeviceStatus RecordingDevice::read(DeviceReading& reading) noexcept {
  const DeviceStatus status = device_->read(reading);
  tick_.status = static_cast<std::uint32_t>(status);
  if (status != DeviceStatus::kOk) return status;
  if (!reading.fresh) tick_.status |= RecordedTick::kNotFresh;
  if (!reading.takes_force) tick_.status |= RecordedTick::kForceless;
  tick_.buttons = reading.buttons;
  tick_.X_DS = reading.X_DS;
  tick_.motor_temperature = reading.motor_temperature;
  return status;
}

DeviceStatus RecordingDevice::write(const dvec3& force_D, const dvec3& torque_D) noexcept {
  tick_.force_D = force_D;
  tick_.torque_D = torque_D;
  if (writer_) writer_->add(tick_);
  return device_->write(force_D, torque_D);
}

void RecordingDevice::close() noexcept {
  device_->close();
  (void)finish();
}

std::uint64_t RecordingDevice::lost() const {
  return writer_ ? writer_->lost() : 0;
}

ReplayDevice::ReplayDevice(DeviceRecording recording) : recording_(std::move(recording)) {}

Expected<void> ReplayDevice::open() {
  if (recording_.ticks.empty())
    return makeError({.place = "recording", .found = "no ticks", .expected = "a recording with at least one tick"});
  next_ = 0;
  open_ = true;
  return {};
}

DeviceStatus ReplayDevice::read(DeviceReading& reading) noexcept {
  if (!open_) return DeviceStatus::kNotOpen;
  const RecordedTick& tick = ended() ? recording_.ticks.back() : recording_.ticks[next_];
  const auto status = static_cast<DeviceStatus>(statusOf(tick));
  if (status == DeviceStatus::kOk) {
    reading.fresh = ended() || (tick.status & RecordedTick::kNotFresh) == 0;
    reading.takes_force = (tick.status & RecordedTick::kForceless) == 0;
    reading.X_DS = tick.X_DS;
    reading.buttons = ended() ? 0 : tick.buttons;
    reading.motor_temperature = tick.motor_temperature;
  }
  return status;
}

DeviceStatus ReplayDevice::write(const dvec3&, const dvec3&) noexcept {
  if (!ended()) ++next_;
  return open_ ? DeviceStatus::kOk : DeviceStatus::kNotOpen;
}

}  // namespace hapticell::haptic
