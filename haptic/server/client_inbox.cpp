// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/client_inbox.h"

#include <algorithm>

#include "haptic/server/clock.h"

namespace hapticell::haptic {

void ClientInbox::open(std::int64_t now) noexcept {
  heard(now);
  silence_limit_.store(0.0, std::memory_order_relaxed);
  session_.store(++last_session_, std::memory_order_release);
}

void ClientInbox::submit(const ConstraintSet& set) noexcept {
  Incoming<GroupedSet>& incoming = sets_.buffer.writeSlot();
  incoming.session = last_session_;
  incoming.value.prepare(set);
  sets_.buffer.publish();
}

bool ClientInbox::beginSession() noexcept {
  const std::uint64_t session = session_.load(std::memory_order_acquire);
  if (session == 0 || session == begun_) return false;
  begun_ = session;
  return true;
}

double ClientInbox::silence(std::int64_t now) const noexcept {
  const std::int64_t silence = now - last_heard_.load(std::memory_order_relaxed);
  return std::max(0.0, kSecondsPerNanosecond * static_cast<double>(silence));
}

}  // namespace hapticell::haptic
