// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <functional>

#include "app/import/import_session.h"

class QComboBox;
class QLabel;

namespace hapticell::app {

class ArgumentFields;
class Segmented;
class UnitQuestion;

/// The choices for a file to import: arguments, unit, up axis, mesh, one solid or a tree. GUI thread.
class ImportChoiceFields : public QWidget {
  Q_OBJECT
 public:
  /// The session must outlive it and keeps the choices for the shown file.
  explicit ImportChoiceFields(ImportSession& session, QWidget* parent = nullptr);
  /// The file must have facts.
  void showFile(const FileImport& file);

 signals:
  void unitAnswered();  ///< A size was chosen, possibly the same as before.

 private:
  void connectFields();
  void showUnits(const FileImport& file);
  void showMesh(const FileImport& file);
  void change(const std::function<void(ImportChoices&)>& edit);

  ImportSession& session_;
  int shown_ = 0;  ///< Id of the file.
  bool filling_ = false;
  QComboBox* unit_;
  QLabel *estimate_, *unit_asked_;
  UnitQuestion* unit_question_;
  ArgumentFields* arguments_;
  QWidget* mesh_choices_;
  Segmented *up_, *quality_, *tree_;
};

}  // namespace hapticell::app
