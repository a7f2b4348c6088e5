// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

class QKeyEvent;
class QWidget;

namespace hapticell::app {

class Host;

/// Decides for the whole window (and its floating docks) whether a typed key is a command or text.
///
/// It is a command if the hand is in the scene (the pointer is over it, or the stylus holds a part) and nothing waits
/// for text (a field, a menu, a dialog; a field whose number was entered waits for the next number only). Everywhere
/// else the widget with the focus gets it: a list searches, and a panel whose property `search` marks a field types
/// into that. A closed choice opens its list and searches there, so that typing alone selects nothing. For Delete only
/// the focus counts: a command in the scene, else for the focused widget. Says so once if a command's key was typed
/// outside the scene and nothing used it. GUI thread.
class TypedKeys : public QObject {
  Q_OBJECT
 public:
  explicit TypedKeys(Host& host, QObject* parent = nullptr);
  ~TypedKeys() override;
  /// True while a typed key is a command; for modules that read keys themselves.
  bool act() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool isOurs(const QWidget* widget) const;
  bool keepFromCommands(QWidget& focus, QKeyEvent& key) const;
  bool press(QWidget& widget, const QKeyEvent& key);
  void sayWhere(const QKeyEvent& key);
  Host& host_;
  bool said_ = false;
};

}  // namespace hapticell::app
