// SPDX-License-Identifier: Apache-2.0
#include "haptic/client/link_report.h"

#include <utility>

namespace hapticell::haptic {

LinkProblem LinkReport::problem() const {
  const std::scoped_lock lock(mutex_);
  return state() == LinkState::kConnected ? LinkProblem() : problem_;
}

std::optional<DeviceDescription> LinkReport::device() const {
  const std::scoped_lock lock(mutex_);
  return state() == LinkState::kConnected ? std::optional(welcome_.device) : std::nullopt;
}

std::optional<DeviceCondition> LinkReport::condition() const {
  const std::scoped_lock lock(mutex_);
  return state() == LinkState::kConnected ? condition_ : std::nullopt;
}

ClientKind LinkReport::grantedKind() const {
  const std::scoped_lock lock(mutex_);
  return welcome_.kind;
}

void LinkReport::become(LinkState state, LinkProblem problem) {
  const std::scoped_lock lock(mutex_);
  problem_ = std::move(problem);
  state_.store(state, std::memory_order_release);
}

void LinkReport::tryAgain() {
  if (state() == LinkState::kDisconnected) state_ = LinkState::kConnecting;
}

void LinkReport::take(const Welcome& welcome) {
  const std::scoped_lock lock(mutex_);
  welcome_ = welcome;
  condition_.reset();
  has_stylus_ = welcome.kind == ClientKind::kController;
}

void LinkReport::take(const DeviceCondition& condition) {
  const std::scoped_lock lock(mutex_);
  condition_ = condition;
}

void LinkReport::connect() {
  ++connections_;
  become(LinkState::kConnected, {});
}

}  // namespace hapticell::haptic
