// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "app/studies/study_draft.h"

class QComboBox;
class QMenu;
class QPushButton;
class QVBoxLayout;

namespace hapticell::app {

class Host;
class LiveLabel;
class SectionForm;
class StudyRunner;
class StudyTree;
class ValueField;

/// Sets up a study, reads and writes its document, and runs it.
class StudyPanel : public QWidget {
  Q_OBJECT
 public:
  StudyPanel(Host& host, StudyDraft& draft, StudyRunner& runner, QWidget* parent = nullptr);
  /// Asks for a file.
  void open();
  Q_INVOKABLE void openFile(const QString& file);
  /// Absolute path of the cell of the study; empty: no study is open.
  QString cell() const { return draft_.cell(); }
  /// A study of the open workcell.
  void begin();
  /// Writes its file, which is asked for if it has none: true if it is written.
  bool save();

 private:
  void addTop(QVBoxLayout& column);
  void addContent(QVBoxLayout& column);
  void addVariants(QVBoxLayout& column);
  void fillMenu(QMenu& menu);
  void addKind(const std::string& table, const std::string& what);
  void addArea();
  /// Tells what is needed to add something; false if a study is open.
  bool lacksStudy();
  void addWorkplace();
  void removeChosen();
  void saveAs();
  bool mayDrop();
  void refresh();
  /// What a new line is about: the selected entity, its carrier where it hangs on something.
  std::string selectedEntity(bool carrier) const;
  std::string entityFor(const std::string& what) const;

  Host& host_;
  StudyDraft& draft_;
  StudyTree* tree_;
  SectionForm* form_;
  LiveLabel *about_, *fault_, *count_;
  QPushButton *save_, *save_as_, *add_, *area_, *remove_;
  QComboBox *method_, *search_;
  ValueField *samples_, *evaluations_, *starts_;
  QWidget *samples_row_, *search_row_, *evaluations_row_, *starts_row_;
};

}  // namespace hapticell::app
