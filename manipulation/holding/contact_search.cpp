// SPDX-License-Identifier: Apache-2.0
#include "manipulation/holding/contact_search.h"

#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include "geometry/system/assertion.h"

namespace hapticell::manipulation {

struct ContactSearch::Worker {
  Worker() {
    thread = std::thread([this] { run(); });
  }
  ~Worker() {
    {
      const std::lock_guard lock(mutex);
      stopping = true;
    }
    asked_for.notify_one();
    thread.join();
  }

  void run() {
    for (;;) {
      std::unique_ptr<Question> at;
      {
        std::unique_lock lock(mutex);
        asked_for.wait(lock, [this] { return stopping || asked; });
        if (stopping) return;
        at = std::move(asked);
        searching = true;
        dropped = false;
      }
      at->options.pair_mask = at->mask;
      at->found = at->finder->find(at->moving, at->environment, at->options);
      const std::lock_guard lock(mutex);
      searching = false;
      if (!dropped) answered = std::move(at);
    }
  }

  std::mutex mutex;  // Guards what follows; held only while pointers are moved.
  std::condition_variable asked_for;
  std::unique_ptr<Question> asked, answered;
  bool searching = false, dropped = false, stopping = false;

  std::thread thread;
};

ContactSearch::ContactSearch() : worker_(std::make_unique<Worker>()) {}
ContactSearch::~ContactSearch() = default;

bool ContactSearch::isFree() const {
  const std::lock_guard lock(worker_->mutex);
  return !worker_->asked && !worker_->answered && !worker_->searching;
}

void ContactSearch::ask(std::unique_ptr<Question> question) {
  {
    const std::lock_guard lock(worker_->mutex);
    HAPTICELL_DEMAND(!worker_->asked && !worker_->answered && !worker_->searching);
    worker_->asked = std::move(question);
  }
  worker_->asked_for.notify_one();
}

bool ContactSearch::isAnswered() const {
  const std::lock_guard lock(worker_->mutex);
  return worker_->answered != nullptr;
}

std::unique_ptr<ContactSearch::Question> ContactSearch::take() {
  const std::lock_guard lock(worker_->mutex);
  return std::move(worker_->answered);
}

void ContactSearch::drop() {
  std::unique_ptr<Question> asked, answered;  // Freed after the lock.
  const std::lock_guard lock(worker_->mutex);
  asked = std::move(worker_->asked);
  answered = std::move(worker_->answered);
  worker_->dropped = true;
}

}  // namespace hapticell::manipulation
