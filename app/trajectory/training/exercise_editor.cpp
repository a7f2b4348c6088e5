// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/training/exercise_editor.h"

#include <QComboBox>
#include <QFileInfo>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/kit/form.h"
#include "app/style/library_text.h"
#include "app/style/theme.h"
#include "app/style/value_field.h"
#include "app/trajectory/motions/motion_list.h"
#include "app/trajectory/training/exercise_files.h"

namespace hapticell::app {
namespace {

constexpr int kEditorWidth = 440, kEditorLabels = 130, kTaskHeight = 72;

/// The number of an exercise behind a field, and what the field shows for 1 of it.
struct ExerciseNumber {
  double* value;
  double shown;
};

std::array<ExerciseNumber, 7> exerciseNumbers(manipulation::Exercise& exercise) {
  return {{{&exercise.tube_radius, 1e3},
           {&exercise.lead, 1e3},
           {&exercise.stiffness, 1.0},
           {&exercise.pass, 1.0},
           {&exercise.rule.deviation, 1e3},
           {&exercise.rule.force, 1.0},
           {&exercise.rule.slowness, 1.0}}};
}

/// What is wrong with the field above, in the colour of contacts.
QLabel* problemLine(QVBoxLayout& section, const char* name) {
  auto* label = makeLive(1, TextRole::kSecond);
  label->setObjectName(name);
  section.addWidget(label);
  return label;
}

void setProblem(QLabel& label, const QString& problem) {
  QPalette palette = label.palette();
  palette.setColor(QPalette::WindowText, themeOf(palette).words.contact);
  label.setPalette(palette);
  label.setText(problem);
}

}  // namespace

ExerciseEditor::ExerciseEditor(Host& host, MotionList& list, const QString& folder, QWidget* parent)
    : QDialog(parent), host_(host), list_(list), folder_(folder) {
  setObjectName("exerciseEditor");
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowFlag(Qt::Tool);  // The window's own keys go on working: the cell may have to be saved.
  setWindowTitle(tr("New exercise"));
  setMinimumWidth(kEditorWidth);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  addWords(*column);
  addMotion(*column);
  addNumbers(*column);
  QVBoxLayout* end = addSection(*column, {});
  file_problem_ = problemLine(*end, "problemFile");
  auto* save = new QPushButton(tr("Save the exercise"));
  save->setObjectName("buttonSaveExercise");
  save->setProperty("main", true);
  auto* cancel = new QPushButton(tr("Cancel"));
  cancel->setAutoDefault(false);
  end->addWidget(sideBySide({save, cancel}));
  connect(save, &QPushButton::clicked, this, &ExerciseEditor::save);
  connect(cancel, &QPushButton::clicked, this, &QDialog::close);
  const auto look = [this] {
    if (tried_) check();
    showHeld();
  };
  connect(name_, &QLineEdit::textChanged, this, look);
  connect(text_, &QPlainTextEdit::textChanged, this, look);
  connect(motion_, &QComboBox::currentIndexChanged, this, look);
  connect(&host_.documentModel(), &DocumentModel::changed, this, look);
  connect(&host_.documentModel(), &DocumentModel::closing, this, &QDialog::close);
  connect(&list_, &MotionList::changed, this, &ExerciseEditor::takeMotions);
  takeMotions();
  if (list_.current()) motion_->setCurrentIndex(motion_->findData(QString::fromStdString(list_.current()->name)));
  showHeld();
}

void ExerciseEditor::addWords(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Exercise"));
  name_ = new QLineEdit;
  name_->setObjectName("editExerciseName");
  addRow(*section, tr("Name"), name_, kEditorLabels);
  name_problem_ = problemLine(*section, "problemName");
  text_ = new QPlainTextEdit;
  text_->setObjectName("editExerciseText");
  text_->setTabChangesFocus(true);
  text_->setFixedHeight(kTaskHeight);
  text_->setPlaceholderText(tr("Task for the trainee"));
  addRow(*section, tr("Task"), text_, kEditorLabels);
  text_problem_ = problemLine(*section, "problemText");
}

void ExerciseEditor::addMotion(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Expert"));
  motion_ = new QComboBox;
  motion_->setObjectName("comboExpertMotion");
  addRow(*section, tr("Motion"), motion_, kEditorLabels);
  motion_problem_ = problemLine(*section, "problemMotion");
  held_ = makeLive(1, TextRole::kText);
  held_->setObjectName("labelHeldPart");
  addRow(*section, tr("Held"), held_, kEditorLabels);
  cell_ = makeLive(1, TextRole::kText);
  cell_->setObjectName("labelExerciseCell");
  addRow(*section, tr("Cell"), cell_, kEditorLabels);
  cell_problem_ = problemLine(*section, "problemCell");
}

void ExerciseEditor::addNumbers(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Guidance and score"));
  struct Row {
    const char* name;
    QString words, tip;
    ValueField::Format format;
  };
  const Row rows[] = {
      {"fieldExerciseTube", tr("Tube"), tr("Radius around the expert's path"), {tr("mm"), 1, 0.1, 10000, 1}},
      {"fieldExerciseLead",
       tr("Pull ahead"),
       tr("How far ahead of the trainee the guidance pulls"),
       {tr("mm"), 1, 0, 1000, 1}},
      {"fieldExerciseStiffness", tr("Stiffness"), tr("Of the pull at full guidance"), {tr("N/m"), 0, 0, 500, 10}},
      {"fieldExercisePass", tr("Pass mark"), tr("Points needed to pass a run"), {tr("points"), 0, 0, 100, 5}},
      {"fieldExerciseDeviation",
       tr("Deviation"),
       tr("Mean deviation that loses all points for it"),
       {tr("mm"), 1, 0.1, 10000, 1}},
      {"fieldExerciseForce",
       tr("Force"),
       tr("Force above the expert's that loses all points for it"),
       {tr("N"), 1, 0.1, 1000, 1}},
      {"fieldExerciseSlowness",
       tr("Slowness"),
       tr("Multiple of the expert's time that loses all points for it"),
       {tr("times"), 1, 1, 1000, 0.5}}};
  const auto values = exerciseNumbers(exercise_);
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    numbers_[i] = new ValueField(rows[i].format);
    numbers_[i]->setObjectName(rows[i].name);
    numbers_[i]->setToolTip(rows[i].tip);
    numbers_[i]->setValue(values[i].shown * *values[i].value);
    addRow(*section, rows[i].words, numbers_[i], kEditorLabels);
    began_[i] = numbers_[i]->value();
  }
}

void ExerciseEditor::edit(const QString& file, const manipulation::Exercise& exercise,
                          const trajectory::Trajectory& expert) {
  file_ = isOwnExercise(file, folder_) ? file : QString();
  exercise_ = exercise;
  if (!file.isEmpty()) expert_ = expert;
  setWindowTitle(file_.isEmpty() ? tr("Exercise, a copy") : tr("Exercise"));
  const auto values = exerciseNumbers(exercise_);
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    numbers_[i]->setValue(values[i].shown * *values[i].value);
    began_[i] = numbers_[i]->value();
  }
  name_->setText(QString::fromStdString(exercise.name));
  text_->setPlainText(QString::fromStdString(exercise.text));
  takeMotions();
  if (!expert_.empty()) motion_->setCurrentIndex(0);
  showHeld();
}

void ExerciseEditor::takeMotions() {
  const QVariant chosen = motion_->currentData();
  const QSignalBlocker quiet(motion_);
  motion_->clear();
  if (!expert_.empty()) motion_->addItem(tr("Current motion"), QString());
  for (const Motion& motion : list_.motions())
    motion_->addItem(QString::fromStdString(motion.name), QString::fromStdString(motion.name));
  const int index = motion_->findData(chosen);
  if (index >= 0) motion_->setCurrentIndex(index);
  if (tried_) check();
  showHeld();
}

const trajectory::Trajectory* ExerciseEditor::chosenMotion() const {
  if (motion_->currentIndex() < 0) return nullptr;
  if (!usesOpenCell()) return &expert_;
  const Motion* motion = list_.find(motion_->currentData().toString().toStdString());
  return motion && motion->trajectory ? motion->trajectory.get() : nullptr;
}

bool ExerciseEditor::usesOpenCell() const {
  return expert_.empty() || motion_->currentIndex() > 0;
}

QString ExerciseEditor::nameProblem() const {
  const QString name = name_->text().trimmed();
  if (name.isEmpty()) return tr("Enter a name.");
  for (const auto& file : exercisesWith(folder_)) {
    const auto other = manipulation::readExercise(file);
    if (other && QString::fromStdString(file.string()) != file_ && QString::fromStdString(other->name) == name)
      return tr("An exercise with this name exists. Choose another name.");
  }
  return {};
}

QString ExerciseEditor::motionProblem() const {
  if (motion_->count() == 0) return tr("Record the expert's motion first (R), then choose it here.");
  const trajectory::Trajectory* motion = chosenMotion();
  if (!motion || motion->size() < 2) return tr("This motion has no path. Choose another.");
  if (usesOpenCell() && !host_.documentModel().document().findByName(motion->entity))
    return tr("%1 is not in this cell.").arg(QString::fromStdString(motion->entity));
  return {};
}

QString ExerciseEditor::cellProblem() const {
  if (!usesOpenCell()) return {};
  if (host_.documentModel().document().path().empty() || host_.documentModel().isDirty())
    return tr("Save the cell first (Ctrl+S). The exercise needs its file.");
  return {};
}

bool ExerciseEditor::check() {
  const QString name = nameProblem(), motion = motionProblem(), cell = cellProblem();
  const QString text = text_->toPlainText().trimmed().isEmpty() ? tr("Describe the task for the trainee.") : QString();
  setProblem(*name_problem_, name);
  setProblem(*text_problem_, text);
  setProblem(*motion_problem_, motion);
  setProblem(*cell_problem_, cell);
  return name.isEmpty() && text.isEmpty() && motion.isEmpty() && cell.isEmpty();
}

void ExerciseEditor::showHeld() {
  const trajectory::Trajectory* motion = chosenMotion();
  held_->setText(motion ? QString::fromStdString(motion->entity) : tr("what the motion moves"));
  const auto& path = usesOpenCell() ? host_.documentModel().document().path() : exercise_.workcell;
  cell_->setText(path.empty() ? tr("not saved yet") : QString::fromStdString(path.filename().string()));
}

void ExerciseEditor::save() {
  tried_ = true;
  if (!check()) return;
  manipulation::Exercise exercise = exercise_;
  exercise.name = name_->text().trimmed().toStdString();
  exercise.text = text_->toPlainText().trimmed().toStdString();
  const auto values = exerciseNumbers(exercise);
  // What was not touched keeps the digits that the field does not show.
  for (std::size_t i = 0; i < numbers_.size(); ++i)
    if (numbers_[i]->value() != began_[i]) *values[i].value = numbers_[i]->value() / values[i].shown;
  if (usesOpenCell()) {
    exercise.workcell = host_.documentModel().document().path();
    exercise.recording.clear();
  }
  const QString file = file_.isEmpty() ? newExerciseFile(name_->text().trimmed(), folder_) : file_;
  const auto written = saveExercise(exercise, *chosenMotion(), file);
  if (!written) return setProblem(*file_problem_, shownText(written.error()));
  emit saved(file);
  close();
}

}  // namespace hapticell::app
