// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QKeySequence>
#include <QObject>
#include <QString>

class QAction;

namespace hapticell::app {

/// Name, look and shortcut of an action.
struct ActionFace {
  const char* name;  ///< objectName, for tests and for key settings.
  QString text;      ///< As shown in the menu; "…" if more input follows.
  QString icon;      ///< Empty for none.
  QKeySequence key;
  QString word;  ///< Below the icon in the tool bar; empty: uses `text`.
};

/// Makes an action with a tool tip that names its key.
QAction* makeAction(QObject* parent, const ActionFace& face);

}  // namespace hapticell::app
