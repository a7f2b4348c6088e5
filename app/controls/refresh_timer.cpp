// SPDX-License-Identifier: Apache-2.0
#include "app/controls/refresh_timer.h"

#include <QMainWindow>
#include <QTimer>

#include "app/host/host.h"

namespace hapticell::app {

QTimer& refreshTimer(Host& host) {
  // ms: more often no number can be read. Half: numbers flicker, twice the work; twice: they lag behind the hand.
  constexpr int kRefreshMilliseconds = 100;
  const QString name = QStringLiteral("refreshTimer");
  if (auto* timer = host.window().findChild<QTimer*>(name, Qt::FindDirectChildrenOnly)) return *timer;
  auto* timer = new QTimer(&host.window());
  timer->setObjectName(name);
  timer->start(kRefreshMilliseconds);
  return *timer;
}

}  // namespace hapticell::app
