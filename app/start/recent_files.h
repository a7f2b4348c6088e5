// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QObject>
#include <QStringList>

class QMenu;

namespace hapticell::app {

class UserSettings;

/// Workcells that were opened or saved last, newest first, at most ten, without those that no longer exist. GUI thread.
class RecentFiles : public QObject {
  Q_OBJECT
 public:
  static constexpr int kMost = 10;
  explicit RecentFiles(UserSettings& settings, QObject* parent = nullptr) : QObject(parent), settings_(settings) {}
  QStringList files() const;
  void add(const QString& path);
  void clear();
  /// Stores a picture of a cell when it is left or saved (keptPicture()), if settings are kept at all.
  void keepPicture(const QString& path, const QImage& picture) const;
  /// Fills the menu whenever it is opened; a choice emits chosen().
  void fill(QMenu& menu);

 signals:
  void chosen(const QString& path);

 private:
  UserSettings& settings_;
};

}  // namespace hapticell::app
