// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QHash>
#include <QObject>
#include <QSettings>
#include <QString>
#include <QVariant>
#include <memory>

namespace hapticell::app {

/// The user's choices for the window, by key ("units/length"), kept in a file from one start to the next. Contains no
/// data of a workcell. GUI thread.
class UserSettings : public QObject {
  Q_OBJECT
 public:
  /// Reads and writes `file`; empty: nothing is kept at the end (tests, pictures from the command line).
  explicit UserSettings(const QString& file = {}, QObject* parent = nullptr);
  ~UserSettings() override;

  /// $XDG_CONFIG_HOME/hapticell/window.ini.
  static QString defaultFile();
  QVariant value(const QString& key, const QVariant& otherwise = {}) const;
  /// Emits changed() if the value differs.
  void setValue(const QString& key, const QVariant& value);
  /// Restores the default: value() gives `otherwise` again.
  void remove(const QString& key);
  /// Keys in a group ("keys"): "keys/actionFit" gives "actionFit".
  QStringList keysBelow(const QString& group) const;
  /// True if there is a file, so that choices are kept for the next start.
  bool isKept() const { return file_ != nullptr; }
  /// Writes the changes; false if the file cannot be written.
  bool flush();

 signals:
  void changed(const QString& key);

 private:
  std::unique_ptr<QSettings> file_;  // Null: in memory only.
  QHash<QString, QVariant> values_;
};

}  // namespace hapticell::app
