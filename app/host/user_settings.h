// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QHash>
#include <QObject>
#include <QSettings>
#include <QString>
#include <QVariant>
#include <memory>

namespace hapticell::app {

/// What the user chose for the window, by key ("units/length"), kept in a file from one start to the next. It contains
/// no data of a workcell. GUI thread.
class UserSettings : public QObject {
  Q_OBJECT
 public:
  /// `file` is read and written; empty: all is forgotten at the end (tests, pictures from the command line).
  explicit UserSettings(const QString& file = {}, QObject* parent = nullptr);
  ~UserSettings() override;

  /// $XDG_CONFIG_HOME/hapticell/window.ini.
  static QString defaultFile();
  QVariant value(const QString& key, const QVariant& otherwise = {}) const;
  /// Emits changed() where it is another value.
  void setValue(const QString& key, const QVariant& value);
  /// Back to what is shipped: value() gives `otherwise` again.
  void remove(const QString& key);
  /// Keys below a group ("keys"): "keys/actionFit" gives "actionFit".
  QStringList keysBelow(const QString& group) const;
  /// There is a file: what is chosen is there at the next start.
  bool isKept() const { return file_ != nullptr; }
  /// Writes what was changed; false where the file cannot be written.
  bool flush();

 signals:
  void changed(const QString& key);

 private:
  std::unique_ptr<QSettings> file_;  // Null: only what is in memory.
  QHash<QString, QVariant> values_;
};

}  // namespace hapticell::app
