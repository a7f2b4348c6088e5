// SPDX-License-Identifier: Apache-2.0
#include "app/ergonomics/paced_refresh.h"

namespace hapticell::app {
namespace {

// ms between two pictures of numbers, as kRefreshMilliseconds of refresh_timer.cpp.
constexpr int kShowMilliseconds = 100;

}  // namespace

PacedRefresh::PacedRefresh() {
  late_.setSingleShot(true);
  connect(&late_, &QTimer::timeout, this, &PacedRefresh::due);
}

void PacedRefresh::ask(bool at_once) {
  if (late_.isActive()) return;
  const qint64 since = since_shown_.isValid() ? since_shown_.elapsed() : kShowMilliseconds;
  if (since >= kShowMilliseconds || at_once)
    emit due();
  else
    late_.start(static_cast<int>(kShowMilliseconds - since));
}

}  // namespace hapticell::app
