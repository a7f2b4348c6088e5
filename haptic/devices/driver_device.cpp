// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/driver_device.h"

#include <pthread.h>
#include <semaphore.h>
#include <time.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstring>
#include <future>
#include <thread>
#include <utility>

#include "geometry/shapes/vector.h"
#include "geometry/system/plain_text.h"
#include "haptic/devices/driver_library.h"
#include "haptic/devices/driver_support.h"
#include "haptic/rendering/triple_buffer.h"

namespace hapticell::haptic {

namespace {

constexpr double kTick = 0.001;  // s between two calls of read().
constexpr std::int64_t kTickNs = 1'000'000;
/// SCHED_FIFO where granted: between the force loop's 80 and the network's 40. Any number between does the same.
constexpr int kWorkerPriority = 70;
/// ns that the thread waits for a command before it reads anyway: a fifth of kSilentLoop. Half: more reads while the
/// loop stalls; twice: silence of the loop is seen up to 10 ms late.
constexpr std::int64_t kWait = 5'000'000;
/// m/s at full deflection of a 3D mouse, and rad/s: the workspace of 16 cm is crossed in 1.3 s, half a turn takes 2.6
/// s. Our choice. Half: slow over the way; twice: hard to stop at a place.
constexpr double kMouseSpeed = 0.12;
constexpr double kMouseTurn = 1.2;
/// m from the middle: the width of a Phantom Desktop, so that cells are the same size for both. Half: more clutching;
/// twice: a part of the way lies outside of the usual view.
constexpr double kMouseReach = 0.08;
/// N/m for the proxy of a device without force: the one that docs/dev/feel.md is about. It exerts none, so half and
/// twice change only the force that is shown.
constexpr double kPlainStiffness = 1000.0;

dvec3 toVector(const double (&from)[3]) {
  return {from[0], from[1], from[2]};
}

/// The clock that nobody can set, ns: sem_clockwait() waits by it.
std::int64_t monotonicNow() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

}  // namespace

DeviceCapabilities toCapabilities(const driver::Capabilities& from) {
  DeviceCapabilities result;
  result.name = plainText(from.name);
  const bool mouse = from.kind == driver::Kind::kSpaceMouse;
  result.workspace_min = mouse ? dvec3(-kMouseReach) : toVector(from.workspace_min);
  result.workspace_max = mouse ? dvec3(kMouseReach) : toVector(from.workspace_max);
  result.resolution = from.resolution;
  result.measured_axes = static_cast<int>(from.measured_axes);
  result.driven_axes =
      from.driven_axes == 6 && from.peak_torque > 0.0 ? 6 : std::min(3, static_cast<int>(from.driven_axes));
  result.peak_force = from.peak_force;
  result.continuous_force = from.continuous_force;
  result.peak_torque = result.driven_axes == 6 ? from.peak_torque : 0.0;
  result.stiffness = from.stiffness > 0.0 ? from.stiffness : kPlainStiffness;
  result.damping = from.damping > 0.0 ? from.damping : 2.0;
  result.buttons = static_cast<int>(from.buttons);
  return result;
}

/// The driver's thread and what lies between it and the force loop.
struct DriverDevice::Worker {
  Worker(driver::Driver& driver, const std::string& id, const DriverSessionOptions& options)
      : session(driver, id, options) {
    sem_init(&due, 0, 0);
  }
  ~Worker() { sem_destroy(&due); }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void run() {
    pthread_setname_np(pthread_self(), "device");
    sched_param priority{};
    priority.sched_priority = kWorkerPriority;
    pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority);
    const driver::Problem problem = session.open();
    const bool good = problem.status == driver::Status::kOk;
    opened.set_value(problem);
    std::int64_t commanded = monotonicNow();
    while (good && !stopping.load(std::memory_order_acquire)) {
      waitForTick();
      if (commands.update())
        commanded = monotonicNow();
      else if (static_cast<double>(monotonicNow() - commanded) > 1e9 * kSilentLoop)
        session.hold();
      answers.write(session.turn(commands.value()));
    }
    session.close();
    ended.set_value();
  }

  /// Until somebody commands, or kWait has passed.
  void waitForTick() {
    const std::int64_t at = monotonicNow() + kWait;
    const timespec until{static_cast<time_t>(at / 1'000'000'000), static_cast<long>(at % 1'000'000'000)};
    if (sem_clockwait(&due, CLOCK_MONOTONIC, &until) != 0) return;
    while (sem_trywait(&due) == 0) {
    }
  }

  DriverSession session;
  TripleBuffer<driver::Command> commands;
  TripleBuffer<DriverAnswer> answers;
  std::atomic<bool> stopping{false};
  sem_t due;
  std::promise<driver::Problem> opened;
  std::promise<void> ended;
  std::future<void> end = ended.get_future();
};

DriverDevice::DriverDevice(driver::Driver& driver, std::string id, DriverDeviceOptions options)
    : driver_(driver), id_(std::move(id)), options_(std::move(options)) {
  options_.session.care = care_;
}

DriverDevice::~DriverDevice() {
  close();
}

Expected<void> DriverDevice::open() {
  if (worker_ || session_) return {};
  const std::string what = std::string(driver_.information().name) + (id_.empty() ? "" : ":" + id_);
  driver::Problem problem;
  if (options_.calls == DriverCalls::kInline) {
    DriverSessionOptions in_ticks = options_.session;
    if (!in_ticks.now) in_ticks.now = [this] { return turns_ns_; };
    session_ = std::make_unique<DriverSession>(driver_, id_, std::move(in_ticks));
    problem = session_->open();
    driver_capabilities_ = session_->capabilities();
  } else {
    worker_ = std::make_shared<Worker>(driver_, id_, options_.session);
    auto opened = worker_->opened.get_future();
    std::thread([worker = worker_] { worker->run(); }).detach();
    if (opened.wait_for(std::chrono::duration<double>(options_.open_patience_s)) != std::future_status::ready) {
      driver::refuse(problem, driver::Status::kFault, "the driver did not open it in time",
                     "Unplug the device and plug it in again.");
    } else {
      problem = opened.get();
      driver_capabilities_ = worker_->session.capabilities();
    }
  }
  if (problem.status != driver::Status::kOk) {
    close();
    return tl::unexpected(toError(problem, what));
  }
  capabilities_ = toCapabilities(driver_capabilities_);
  status_ = driver::Status::kOk;
  silent_ticks_ = 0;
  measurements_ = 0;
  heard_ = false;
  motors_ = true;
  engaged_ = false;
  return {};
}

void DriverDevice::takeAnswer(const DriverAnswer& answer, DeviceReading& reading) noexcept {
  status_ = answer.status;
  if (status_ != driver::Status::kOk) return;
  const driver::State& state = answer.state;
  // What exerts no force may say something only when it is moved.
  const bool pushes = driver_capabilities_.driven_axes > 0;
  reading_.fresh = !pushes || std::exchange(measurements_, answer.measurements) != answer.measurements;
  reading_.takes_force = !pushes || answer.takes_force;
  if (driver_capabilities_.kind == driver::Kind::kSpaceMouse) {
    const dvec3 step(state.motion[0], state.motion[1], state.motion[2]);
    const dvec3 turn(state.motion[3], state.motion[4], state.motion[5]);
    reading_.X_DS.p = glm::clamp(reading_.X_DS.p + kMouseSpeed * kTick * step, dvec3(-kMouseReach), dvec3(kMouseReach));
    reading_.X_DS.q = glm::normalize(quaternionFromRotationVector(kMouseTurn * kTick * turn) * reading_.X_DS.q);
  } else if (answer.measurements > 0) {
    reading_.X_DS.p = toVector(state.position);
    const dquat q(state.orientation[0], state.orientation[1], state.orientation[2], state.orientation[3]);
    const double length = glm::length(q);
    if (std::abs(length - 1.0) < 0.05) reading_.X_DS.q = q / length;
  }
  reading_.buttons = state.buttons;
  reading_.motor_temperature = state.motor_temperature;
  reading = reading_;
}

DeviceStatus DriverDevice::read(DeviceReading& reading) noexcept {
  if (session_) {
    turns_ns_ += kTickNs;
    takeAnswer(session_->turn(command_), reading);
  } else if (worker_) {
    const bool answered = worker_->answers.update();
    silent_ticks_ = answered ? 0 : silent_ticks_ + 1;
    heard_ = heard_ || answered;
    if (silent_ticks_ > kPatience) return DeviceStatus::kFault;
    if (!heard_) {  // Opened, and about to answer.
      reading.fresh = reading.takes_force = false;
      return DeviceStatus::kOk;
    }
    takeAnswer(worker_->answers.value(), reading);
  } else {
    return DeviceStatus::kNotOpen;
  }
  if (status_ == driver::Status::kOk) return DeviceStatus::kOk;
  return status_ == driver::Status::kVanished ? DeviceStatus::kVanished : DeviceStatus::kFault;
}

DeviceStatus DriverDevice::write(const dvec3& force_D, const dvec3& torque_D) noexcept {
  if (!worker_ && !session_) return DeviceStatus::kNotOpen;
  const bool good = isFinite(force_D) && isFinite(torque_D);
  command_.motors = good && motors_ && engaged_;
  for (int i = 0; i < 3; ++i) {
    command_.force[i] = command_.motors ? force_D[i] : 0.0;
    command_.torque[i] = command_.motors ? torque_D[i] : 0.0;
  }
  if (worker_) {
    worker_->commands.write(command_);
    sem_post(&worker_->due);
  }
  return good ? DeviceStatus::kOk : DeviceStatus::kFault;
}

void DriverDevice::setMotors(bool on) noexcept {
  motors_ = on;
}

void DriverDevice::setEngaged(bool engaged) noexcept {
  engaged_ = engaged;
}

void DriverDevice::close() noexcept {
  session_.reset();
  if (!worker_) return;
  worker_->commands.write(driver::Command{});
  worker_->stopping.store(true, std::memory_order_release);
  sem_post(&worker_->due);
  worker_->end.wait_for(std::chrono::milliseconds(500));
  worker_.reset();
}

}  // namespace hapticell::haptic
