// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/input_reader.h"

#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <mutex>
#include <thread>
#include <utility>

#include "haptic/devices/driver_session.h"

namespace hapticell::haptic {

namespace {

// Between two turns of a glove or 3D mouse, which give at most some hundred samples a second. Half: twice the wake-ups;
// twice: a sample is up to 4 ms late.
constexpr std::chrono::milliseconds kTurn(2);
// Turns of 2 ms, a second: between two tries to open a device that was unplugged. Half: twice the tries; twice: it is
// back after 2 s.
constexpr std::uint32_t kReopenTurns = 500;

}  // namespace

struct InputReader::Shared {
  std::mutex mutex;
  Snapshot newest;
  std::uint32_t pressed = 0;  // Since they were asked for.
  driver::Command command;
  std::vector<std::string> news;
  std::atomic<bool> stopping{false};
  std::promise<void> ended;
  std::future<void> end = ended.get_future();

  void tell(const std::string& sentence) {
    const std::scoped_lock lock(mutex);
    news.push_back(sentence);
    newest.problem = sentence;
  }

  void run(driver::Driver& driver, const std::string& id) {
    pthread_setname_np(pthread_self(), "input-device");
    DriverSession session(driver, id,
                          {.reopen_turns = kReopenTurns, .report = [this](const std::string& text) { tell(text); }});
    const driver::Problem problem = session.open();
    if (problem.status != driver::Status::kOk) {
      tell(std::string(driver.information().title) + ": " + problem.found + ". " + problem.fix);
    }
    while (!stopping) {
      driver::Command wanted;
      {
        const std::scoped_lock lock(mutex);
        wanted = command;
      }
      const DriverAnswer& answer = session.turn(wanted);
      {
        const std::scoped_lock lock(mutex);
        pressed |= answer.state.buttons & ~newest.state.buttons;
        newest.open = session.isOpen();
        newest.measurements = answer.measurements;
        newest.state = answer.state;
        newest.capabilities = session.capabilities();
        if (newest.open) newest.problem.clear();
      }
      std::this_thread::sleep_for(kTurn);
    }
  }
};

InputReader::InputReader(driver::Driver& driver, std::string id) : shared_(std::make_shared<Shared>()) {
  std::thread([shared = shared_, &driver, id = std::move(id)] {
    shared->run(driver, id);
    shared->ended.set_value();
  }).detach();
}

InputReader::~InputReader() {
  shared_->stopping = true;
  shared_->end.wait_for(std::chrono::milliseconds(500));
}

InputReader::Snapshot InputReader::latest() const {
  const std::scoped_lock lock(shared_->mutex);
  return shared_->newest;
}

std::uint32_t InputReader::takePressed() {
  const std::scoped_lock lock(shared_->mutex);
  return std::exchange(shared_->pressed, 0u);
}

void InputReader::vibrate(const double (&strength)[6]) {
  const std::scoped_lock lock(shared_->mutex);
  std::copy_n(strength, 6, shared_->command.vibration);
}

std::vector<std::string> InputReader::takeNews() {
  const std::scoped_lock lock(shared_->mutex);
  return std::exchange(shared_->news, {});
}

}  // namespace hapticell::haptic
