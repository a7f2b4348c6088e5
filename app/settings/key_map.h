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

/// Which keys do what: as shipped, moved for the keyboard, and as the user chose. Watches the window, so that actions
/// of modules that come later have their keys too. GUI thread.
class KeyMap : public QObject {
  Q_OBJECT
 public:
  struct Row {
    QString id;    ///< Name for the settings; stays the same in every language.
    QString text;  ///< What it does.
    QKeySequence shipped, now;
  };
  KeyMap(QMainWindow& window, UserSettings& settings, QObject* parent = nullptr);

  std::vector<Row> rows() const;
  /// An empty sequence: no key. The key of another action is taken from that one.
  void set(const QString& id, const QKeySequence& key);
  /// As shipped again.
  void reset(const QString& id);
  void resetAll();
  /// What else the key does now; empty: nothing.
  QString useOf(const QKeySequence& key, const QString& beside) const;

  /// "qwerty", "qwertz" or "azerty": single keys stay where the left hand finds them.
  void setKeyboard(const QString& keyboard);
  QString keyboard() const;
  /// False: keys without Ctrl or Alt do nothing (function keys stay).
  void setLettersOn(bool on);
  bool lettersOn() const;
  /// The shipped key as it is on that keyboard.
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
