// SPDX-License-Identifier: Apache-2.0
#include "app/controls/refresh_timer.h"

#include <QMainWindow>
#include <QTimer>

#include "app/host/host.h"

namespace hapticell::app {

QTimer& refreshTimer(Host& host) {
  constexpr int kRefreshMilliseconds = 100;  // More often no number can be read.
  const QString name = QStringLiteral("refreshTimer");
  if (auto* timer = host.window().findChild<QTimer*>(name, Qt::FindDirectChildrenOnly)) return *timer;
  auto* timer = new QTimer(&host.window());
  timer->setObjectName(name);
  timer->start(kRefreshMilliseconds);
  return *timer;
}

}  // namespace hapticell::app
