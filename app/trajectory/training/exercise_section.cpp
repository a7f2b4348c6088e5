// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/training/exercise_section.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "app/kit/file_dialog.h"
#include "app/kit/form.h"
#include "app/trajectory/training/exercise_files.h"

namespace hapticell::app {

ExerciseSection::ExerciseSection(QVBoxLayout& column, QObject* parent)
    : QObject(parent), own_folder_(ownExercisesFolder()) {
  QVBoxLayout* section = addSection(column, tr("Exercise"));
  exercises_ = new QComboBox;
  exercises_->setObjectName("comboExercise");
  fill({});
  addRow(*section, tr("Exercise"), exercises_);
  text_ = makeLive(4, TextRole::kText);
  text_->setObjectName("labelExercise");
  section->addWidget(text_);
  show_me_ = new QPushButton(tr("Show me"));
  show_me_->setObjectName("buttonShowMe");
  show_me_->setToolTip(tr("The part follows the expert's path; the cell is unchanged"));
  new_ = new QPushButton(tr("New…"));
  new_->setObjectName("buttonNewExercise");
  new_->setToolTip(tr("Make an exercise from this cell and an expert's motion"));
  edit_ = new QPushButton(tr("Edit…"));
  edit_->setObjectName("buttonEditExercise");
  edit_->setToolTip(tr("Edit name, task and guidance; a shipped exercise is copied"));
  section->addWidget(sideBySide({show_me_, new_, edit_}));
  connect(show_me_, &QPushButton::clicked, this, &ExerciseSection::playWanted);
  connect(new_, &QPushButton::clicked, this, &ExerciseSection::newWanted);
  connect(edit_, &QPushButton::clicked, this, &ExerciseSection::editWanted);
  use_ = new QPushButton(tr("Teach the current motion"));
  use_->setObjectName("buttonTeachMotion");
  use_->setToolTip(tr("Use the selected motion as the expert's, in the current cell"));
  section->addWidget(use_);
  connect(exercises_, &QComboBox::activated, this, &ExerciseSection::choose);
  connect(use_, &QPushButton::clicked, this, &ExerciseSection::teachWanted);
}

void ExerciseSection::fill(const QString& file) {
  const QSignalBlocker quiet(exercises_);
  exercises_->clear();
  exercises_->addItem(tr("Choose an exercise"), QString());
  for (const auto& each : exercisesWith(own_folder_))
    if (const auto exercise = manipulation::readExercise(each))
      exercises_->addItem(QString::fromStdString(exercise->name), QString::fromStdString(each.string()));
  exercises_->addItem(tr("From a file…"), QStringLiteral("?"));
  exercises_->setCurrentIndex(std::max(0, file.isEmpty() ? 0 : exercises_->findData(file)));
}

void ExerciseSection::choose(int index) {
  QString path = exercises_->itemData(index).toString();
  if (path == QStringLiteral("?"))
    path = askToOpen(exercises_->window(), tr("Open an exercise"), {}, tr("Exercises (*.hexercise)"));
  if (!path.isEmpty()) emit chosen(path);
}

void ExerciseSection::chooseNone() {
  exercises_->setCurrentIndex(0);
}

void ExerciseSection::show(const State& state) {
  const auto& exercise = *state.exercise;
  use_->setEnabled(!state.is_running && state.has_motion);
  show_me_->setEnabled(exercise && !state.is_running);
  show_me_->setText(state.is_playing ? tr("Stop now") : tr("Show me"));
  new_->setEnabled(!state.is_running);
  edit_->setEnabled(exercise && !state.is_running);
  text_->setText(exercise ? QString::fromStdString(exercise->text)
                          : tr("An expert's recording guides the stylus along its path and waits for the trainee."));
  exercises_->setEnabled(!state.is_running);
}

}  // namespace hapticell::app
