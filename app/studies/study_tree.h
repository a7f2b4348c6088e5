// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTreeWidget>
#include <optional>

#include "app/studies/study_draft.h"

namespace hapticell::app {

/// What a study says, as a tree of four groups: what varies, what is asked, what must hold, what is wanted.
class StudyTree : public QTreeWidget {
  Q_OBJECT
 public:
  explicit StudyTree(StudyDraft& draft, QWidget* parent = nullptr);
  /// The table that is chosen; nothing: a group, or none.
  std::optional<studies::StudyPlace> chosen() const;
  void choose(const studies::StudyPlace& place);
  /// "Position of robot along x: -500 mm to 500 mm, 7 values" in few words.
  static QString summary(const StudyDraft& draft, const studies::StudyPlace& place);
  QSize sizeHint() const override { return {300, 210}; }

 signals:
  void placeChosen();

 private:
  void refresh();
  StudyDraft& draft_;
};

}  // namespace hapticell::app
