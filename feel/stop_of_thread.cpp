// SPDX-License-Identifier: Apache-2.0
#include "feel/stop_of_thread.h"

namespace hapticell::feel {

namespace {

thread_local const std::atomic<bool>* stop_of_thread = nullptr;

}  // namespace

StopOfThread::StopOfThread(const std::atomic<bool>* stop) : before_(stop_of_thread) {
  stop_of_thread = stop;
}

StopOfThread::~StopOfThread() {
  stop_of_thread = before_;
}

void endWhereStopped() {
  if (stop_of_thread != nullptr && *stop_of_thread) throw MeasurementStopped();
}

}  // namespace hapticell::feel
