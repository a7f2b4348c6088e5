// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>
#include <optional>

#include "app/viewport/scene/camera.h"

namespace hapticell::app {

class UserSettings;

/// Views of a cell with names, kept in the user's settings by the cell's path: a view is not part of the document.
/// Those of a cell that has no file yet go with it, or to its file once it is saved. GUI thread.
class SavedViews {
 public:
  explicit SavedViews(UserSettings& settings) : settings_(settings) {}
  /// Of which cell from now on; empty: one that has no file yet. A file that follows it takes its views over.
  void setCell(const QString& path);
  /// Another cell follows.
  void closeCell();
  QStringList names() const;
  std::optional<Camera> find(const QString& name) const;
  /// Adds it or takes the place of the one of that name.
  void keep(const QString& name, const Camera& camera);
  void remove(const QString& name);
  /// "View 1", or the first that is free.
  QString freeName() const;

 private:
  QString group() const;
  void removeAll();
  UserSettings& settings_;
  QString cell_;
};

/// The camera as one line, and back; empty if the line is invalid.
QString cameraText(const Camera& camera);
std::optional<Camera> cameraFromText(const QString& text);

}  // namespace hapticell::app
