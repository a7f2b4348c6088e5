// SPDX-License-Identifier: Apache-2.0
#include "app/kit/action_face.h"

#include <QAction>

#include "app/style/icon.h"

namespace hapticell::app {

QAction* makeAction(QObject* parent, const ActionFace& face) {
  auto* action = new QAction(face.text, parent);
  action->setObjectName(QString::fromLatin1(face.name));
  if (!face.icon.isEmpty()) action->setIcon(icon(face.icon));
  action->setShortcut(face.key);
  action->setIconText(face.word.isEmpty() ? QString(face.text).remove(QChar(0x2026)) : face.word);
  const QString plain = QString(face.text).remove(QChar(0x2026));
  action->setToolTip(face.key.isEmpty() ? plain : plain + "  (" + face.key.toString(QKeySequence::NativeText) + ")");
  return action;
}

}  // namespace hapticell::app
