// SPDX-License-Identifier: Apache-2.0
#include "app/import/import_progress.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QVBoxLayout>
#include <cmath>

#include "app/kit/form.h"
#include "app/style/units.h"

namespace hapticell::app {

ImportProgress::ImportProgress(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 10, 12, 10);
  column->setSpacing(6);
  auto* line = new QHBoxLayout;
  stage_ = makeLabel({}, TextRole::kText);
  stage_->setObjectName("importStage");
  share_ = makeLabel({}, TextRole::kText, true);
  share_->setObjectName("importShare");
  line->addWidget(stage_, 1);
  line->addWidget(share_);
  column->addLayout(line);
  bar_ = new QProgressBar;
  bar_->setRange(0, 1000);
  bar_->setTextVisible(false);
  bar_->setFixedHeight(6);
  column->addWidget(bar_);
  auto* note = makeLabel(tr("You can keep working in the cell."), TextRole::kSecond, true);
  note->setWordWrap(true);
  column->addWidget(note);
}

void ImportProgress::showWork(const QString& words, double share, double seconds_left) {
  stage_->setText(stage_->fontMetrics().elidedText(words, Qt::ElideRight, parentWidget()->width() - 130));
  stage_->setToolTip(words);
  QString text = QStringLiteral("%1 %").arg(std::lround(100.0 * share));
  // Seconds left that are worth saying. Half, twice: flashes at the end, or a wait without a word.
  constexpr double kWorthSaying = 2.0;
  if (seconds_left > kWorthSaying) text += tr(" · %1 left").arg(durationText(seconds_left));
  share_->setText(text);
  bar_->setValue(static_cast<int>(std::lround(1000.0 * share)));
}

}  // namespace hapticell::app
