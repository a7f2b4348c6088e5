// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QObject>
#include <QPointer>
#include <QThreadPool>
#include <memory>
#include <utility>

namespace hapticell::app {

/// Runs `work` in a thread of Qt's pool and passes its result to `then` in the GUI thread, unless `owner` no longer
/// exists. For work of a tenth of a second that needs no progress.
template <class Work, class Then>
void runInThreadPool(QObject* owner, Work work, Then then) {
  QThreadPool::globalInstance()->start(
      [owner = QPointer<QObject>(owner), work = std::move(work), then = std::move(then)]() mutable {
        auto result = std::make_shared<decltype(work())>(work());
        QMetaObject::invokeMethod(
            QCoreApplication::instance(),
            [owner, then = std::move(then), result]() mutable {
              if (owner) then(std::move(*result));
            },
            Qt::QueuedConnection);
      });
}

}  // namespace hapticell::app
