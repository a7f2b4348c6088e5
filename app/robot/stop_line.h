// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "app/viewport/scene/strip_text.h"

class QLabel;

namespace hapticell::app {

/// One line that says why a robot stops or is about to stop: mark and sentence. Keeps its room while it has nothing to
/// say.
class StopLine : public QWidget {
  Q_OBJECT
 public:
  explicit StopLine(QWidget* parent = nullptr);
  void show(Mark mark, const QString& sentence);
  QString sentence() const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Mark mark_ = Mark::kNone;
  QLabel* words_;
};

}  // namespace hapticell::app
