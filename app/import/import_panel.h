// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <optional>

#include "app/import/import_session.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace hapticell::app {

class ImportChoiceFields;
class ImportProgress;
class PreviewBox;

/// Work other than an import that takes time: opening a workcell.
struct OtherWork {
  QString name;
  QString stage;
  double share = 0.0;
};

/// The import dialog: what a file is, what is made of it, and the progress. It shows one file at a time; the others are
/// in the list on top. The session keeps all choices; this panel only shows them and asks.
class ImportPanel : public QWidget {
  Q_OBJECT
 public:
  explicit ImportPanel(ImportSession& session, QWidget* parent = nullptr);
  /// Shown while no file is shown: nothing hides it.
  void setOtherWork(const std::optional<OtherWork>& work);
  /// Id of the shown file; 0 for none.
  int current() const { return current_; }
  QString title() const;

 signals:
  void otherCancelled();
  void titleChanged(const QString& title);

 private:
  void addFacts();
  void addButtons();
  void refresh();
  void showFile(const FileImport& file);
  void showProgress();
  void fillFiles();

  ImportSession& session_;
  std::optional<OtherWork> other_;
  int current_ = 0;
  QComboBox* file_;
  PreviewBox* preview_;
  QWidget* facts_;
  QLabel *size_, *kind_, *undo_hint_;
  ImportChoiceFields* choices_;
  ImportProgress* progress_;
  QPushButton *cancel_, *import_, *import_all_;
};

}  // namespace hapticell::app
