// SPDX-License-Identifier: Apache-2.0
#include "app/shell/application.h"

#include <QEvent>
#include <new>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"

namespace hapticell::app {

bool Application::notify(QObject* receiver, QEvent* event) {
  try {
    return QApplication::notify(receiver, event);
  } catch (const std::bad_alloc&) {
    emit outOfMemory();
    return false;
  }
}

void tellOutOfMemory(Host& host) {
  host.documentModel().cancelStep();
  host.messages().tell(
      Severity::kProblem, Application::tr("There was not enough memory"),
      Application::tr("What you asked for last was not done, and the workcell is as it was before. Save "
                      "it, then close other programs, or remove parts that are not needed."));
}

}  // namespace hapticell::app
