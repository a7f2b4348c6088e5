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

void reportOutOfMemory(Host& host) {
  host.documentModel().cancelStep();
  host.messages().tell(Severity::kProblem, Application::tr("Not enough memory"),
                       Application::tr("Your last action was not carried out, and the workcell is unchanged. Save it, "
                                       "then close other programs or remove parts you do not need."));
}

}  // namespace hapticell::app
