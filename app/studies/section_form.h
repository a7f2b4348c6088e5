// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "app/studies/study_draft.h"
#include "app/studies/study_fields.h"

class QComboBox;
class QVBoxLayout;

namespace hapticell::app {

class Host;

/// The keys of one table of a study as fields; created for each table.
class SectionForm : public QWidget {
  Q_OBJECT
 public:
  SectionForm(Host& host, StudyDraft& draft, QWidget* parent = nullptr);
  /// Shows this table; nothing: none is chosen.
  void show(const std::optional<studies::StudyPlace>& place);
  const std::optional<studies::StudyPlace>& place() const { return place_; }

 private:
  void build();
  void refresh();
  void addField(QVBoxLayout& rows, const StudyField& field);
  void addName(QVBoxLayout& rows);
  void addUnknown(QVBoxLayout& rows);
  void addRequirement(QVBoxLayout& rows);
  void addObjective(QVBoxLayout& rows);
  void addWord(QVBoxLayout& rows, const QString& label, const char* key);
  void addWordList(QVBoxLayout& rows, const QString& label, const char* key);
  void addFile(QVBoxLayout& rows, const StudyField& field);
  void addFrames(QVBoxLayout& rows, const StudyField& field);
  void addMethods(QVBoxLayout& rows, const StudyField& field);
  void addNumber(QVBoxLayout& rows, const StudyField& field);
  void addBound(QVBoxLayout& rows, const QString& label, const char* key);
  QComboBox* addChoice(QVBoxLayout& rows, const QString& label, const char* key,
                       const std::function<QStringList()>& words);
  QStringList entities(StudyEdit edit) const;
  QString shape() const;

  Host& host_;
  StudyDraft& draft_;
  std::optional<studies::StudyPlace> place_;
  QWidget* holder_ = nullptr;
  QString shape_;  ///< Which fields there are: kinds of the table.
  std::vector<std::function<void()>> refreshers_;
};

}  // namespace hapticell::app
