// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QKeySequence>
#include <QMainWindow>
#include <QObject>
#include <QString>
#include <vector>

class QAction;

namespace hapticell::app {

class UserSettings;

/// Shortcuts of all actions: the defaults, adapted to the keyboard, and the user's choices. Watches the window, so that
/// actions of modules that are loaded later get their keys too. GUI thread.
class KeyMap : public QObject {
  Q_OBJECT
 public:
  struct Row {
    QString id;    ///< Name in the settings, the same in every language.
    QString text;  ///< What it does.
    QKeySequence shipped, now;
  };
  KeyMap(QMainWindow& window, UserSettings& settings, QObject* parent = nullptr);

  std::vector<Row> rows() const;
  /// Sets a shortcut; an empty sequence removes it. An action that used the key loses it.
  void set(const QString& id, const QKeySequence& key);
  /// Restores the default.
  void reset(const QString& id);
  void resetAll();
  /// Name of another action that uses the key now; empty: none.
  QString useOf(const QKeySequence& key, const QString& beside) const;

  /// "qwerty", "qwertz" or "azerty": keys without modifiers keep their position under the left hand.
  void setKeyboard(const QString& keyboard);
  QString keyboard() const;
  /// False: keys without Ctrl or Alt do nothing (function keys stay).
  void setLettersOn(bool on);
  bool lettersOn() const;
  /// The default key at the same position on that keyboard.
  static QKeySequence movedTo(const QString& keyboard, const QKeySequence& shipped);

 signals:
  void changed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Entry {
    QString id;
    QAction* action;
    QKeySequence shipped;
  };
  std::vector<Entry> entries() const;
  void apply();
  QMainWindow& window_;
  UserSettings& settings_;
  bool waiting_ = false, applying_ = false;
};

}  // namespace hapticell::app
