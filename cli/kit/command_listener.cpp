// SPDX-License-Identifier: Apache-2.0
#include "cli/kit/command_listener.h"

namespace hapticell::cli {

namespace {

thread_local CommandListener* listener_of_thread = nullptr;

}  // namespace

const std::atomic<bool>* stopFlag() {
  return listener_of_thread == nullptr ? nullptr : &listener_of_thread->stopAsked();
}

CommandListener* commandListener() {
  return listener_of_thread;
}

ListenerOfThread::ListenerOfThread(CommandListener& listener) : before_(listener_of_thread) {
  listener_of_thread = &listener;
}

ListenerOfThread::~ListenerOfThread() {
  listener_of_thread = before_;
}

void stopWhereAsked() {
  if (listener_of_thread != nullptr && listener_of_thread->stopAsked()) throw Stopped();
}

}  // namespace hapticell::cli
