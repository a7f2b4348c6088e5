// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "app/studies/study_draft.h"

class QLineEdit;
class QStackedWidget;

namespace hapticell::app {

class Segmented;
class ValueField;

/// The values that something takes: a range with steps, a list, or a normal distribution.
class RangeFields : public QWidget {
  Q_OBJECT
 public:
  enum class Unit { kLength, kAngle, kPlain };
  RangeFields(StudyDraft& draft, const studies::StudyPlace& place, Unit unit, QWidget* parent = nullptr);
  /// Shows what the draft says now.
  void refresh();

 private:
  ValueField* addField(QWidget* page, const char* name, const QString& words, const char* key);
  ValueField* addSteps(QWidget* page);
  void chooseForm(int form);
  void setNumber(const char* key, double shown);
  void setList();

  StudyDraft& draft_;
  studies::StudyPlace place_;
  Unit unit_;
  Segmented* form_;
  QStackedWidget* pages_;
  std::vector<std::pair<const char*, ValueField*>> fields_;
  QLineEdit* list_;
};

}  // namespace hapticell::app
