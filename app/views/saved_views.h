// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>
#include <optional>

#include "app/viewport/scene/camera.h"

namespace hapticell::app {

class UserSettings;

/// Named views of a cell, kept in the user's settings by the cell's path: a view is not part of the document. Views of
/// a cell without a file are dropped with it, or assigned to its file once it is saved. GUI thread.
class SavedViews {
 public:
  explicit SavedViews(UserSettings& settings) : settings_(settings) {}
  /// Sets the cell; empty: one without a file. If a file follows that, it takes over the views.
  void setCell(const QString& path);
  /// Closes the cell, because another one follows.
  void closeCell();
  QStringList names() const;
  std::optional<Camera> find(const QString& name) const;
  /// Adds a view, or replaces the one with that name.
  void keep(const QString& name, const Camera& camera);
  void remove(const QString& name);
  /// The first unused name of "View 1", "View 2" ...
  QString freeName() const;

 private:
  QString group() const;
  void removeAll();
  UserSettings& settings_;
  QString cell_;
};

/// Converts a camera to one line of text, and back; empty if the line is invalid.
QString cameraText(const Camera& camera);
std::optional<Camera> cameraFromText(const QString& text);

}  // namespace hapticell::app
