// SPDX-License-Identifier: Apache-2.0
#include "cli/kit/stop_signal.h"

#include <csignal>

namespace hapticell::cli {

namespace {

std::atomic<bool> stop_asked{false};
static_assert(std::atomic<bool>::is_always_lock_free);  // Set by a signal handler.

void askToStop(int signal) {
  stop_asked = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

StopSignal::StopSignal() : listener_(commandListener()) {
  if (listener_ != nullptr) return;
  stop_asked = false;
  std::signal(SIGINT, askToStop);
  std::signal(SIGTERM, askToStop);
}

StopSignal::~StopSignal() {
  if (listener_ != nullptr) return;
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

const std::atomic<bool>& StopSignal::asked() const {
  return listener_ != nullptr ? listener_->stopAsked() : stop_asked;
}

}  // namespace hapticell::cli
