// SPDX-License-Identifier: Apache-2.0
#include "app/ergonomics/work_task_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/mannequin/mannequin_context.h"
#include "app/kit/form.h"
#include "app/style/segmented.h"
#include "app/style/value_field.h"

namespace hapticell::app {
namespace {

using ergonomics::WorkTask;
constexpr int kNamesColumn = 108;

/// A number with a box that says whether it is known.
QWidget* withBox(ValueField* field, QCheckBox*& known, const QString& name) {
  auto* holder = new QWidget;
  auto* row = new QHBoxLayout(holder);
  row->setContentsMargins(0, 0, 0, 0);
  known = new QCheckBox(QObject::tr("known"));
  known->setObjectName(field->objectName() + "Known");
  row->addWidget(field, 1);
  row->addWidget(known);
  field->setAccessibleName(name);
  known->setAccessibleName(QObject::tr("%1 is known").arg(name));
  return holder;
}

/// 0 not entered, 1 no, 2 yes.
int stateOf(const std::optional<bool>& flag) {
  return !flag ? 0 : *flag ? 2 : 1;
}
std::optional<bool> flagOf(int state) {
  return state == 0 ? std::nullopt : std::optional<bool>(state == 2);
}

}  // namespace

WorkTaskPanel::WorkTaskPanel(MannequinContext& context, QWidget* parent) : QWidget(parent), context_(context) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  addPerson(*column);
  addWork(*column);
  addLift(*column);
  column->addStretch(1);
  connect(&context_, &MannequinContext::documentChanged, this, &WorkTaskPanel::showNow);
  connect(&context_, &MannequinContext::mannequinChanged, this, &WorkTaskPanel::showNow);
  showNow();
}

void WorkTaskPanel::addPerson(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, {});
  preset_ = new QComboBox;
  preset_->setObjectName("comboTaskPreset");
  preset_->addItem(tr("Choose a typical task…"));
  for (const WorkTask& preset : ergonomics::workTaskPresets()) preset_->addItem(QString::fromStdString(preset.name));
  addRow(*section, tr("Begin from"), preset_, kNamesColumn);
  name_ = new QLineEdit;
  name_->setObjectName("editTaskName");
  addRow(*section, tr("Task"), name_, kNamesColumn);
  note_ = new QLineEdit;
  note_->setObjectName("editTaskNote");
  addRow(*section, tr("Note"), note_, kNamesColumn);
  connect(preset_, &QComboBox::activated, this, [this](int i) {
    if (i <= 0) return;
    const WorkTask& preset = ergonomics::workTaskPresets()[static_cast<std::size_t>(i - 1)];
    change([&](WorkTask& task) {
      const std::string who = task.mannequin;
      task = preset;
      task.mannequin = who;
    });
  });
  connect(name_, &QLineEdit::editingFinished, this, [this] {
    const std::string text = name_->text().trimmed().toStdString();
    if (!text.empty()) change([&](WorkTask& task) { task.name = text; });
  });
  connect(note_, &QLineEdit::editingFinished, this,
          [this] { change([this](WorkTask& task) { task.note = note_->text().toStdString(); }); });
}

void WorkTaskPanel::connectNumber(ValueField* field, QCheckBox* known,
                                  std::function<std::optional<double>*(WorkTask&)> of) {
  connect(field, &ValueField::edited, this,
          [this, of](double value) { change([&](WorkTask& task) { *of(task) = value; }); });
  connect(known, &QCheckBox::clicked, this, [this, field, of](bool on) {
    change([&](WorkTask& task) { *of(task) = on ? std::optional<double>(field->value()) : std::nullopt; });
  });
}

void WorkTaskPanel::addWork(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Work"));
  const auto number = [&](const char* name, const QString& words, const ValueField::Format& format, QCheckBox*& known) {
    auto* field = new ValueField(format);
    field->setObjectName(name);
    addRow(*section, words, withBox(field, known, words), kNamesColumn);
    return field;
  };
  load_left_ = number("fieldLoadLeft", tr("Load, left hand"), {tr("kg"), 1, 0.0, 200.0, 0.5}, knows_left_);
  load_right_ = number("fieldLoadRight", tr("Load, right hand"), {tr("kg"), 1, 0.0, 200.0, 0.5}, knows_right_);
  load_left_->setToolTip(tr("Weight, or a force divided by 9.81"));
  load_right_->setToolTip(load_left_->toolTip());
  repetitions_ = number("fieldRepetitions", tr("Repetition"), {tr("/min"), 1, 0.0, 120.0, 1.0}, knows_repetitions_);
  duration_ = number("fieldDuration", tr("In a shift"), {tr("h"), 1, 0.0, 24.0, 0.5}, knows_duration_);
  const QStringList answers{tr("Not entered"), tr("No"), tr("Yes")};
  const auto question = [&](const char* name, const QString& words) {
    auto* segments = new Segmented(answers);
    segments->setObjectName(name);
    addRow(*section, words, segments, kNamesColumn);
    return segments;
  };
  static_ = question("segmentsStatic", tr("Held over 1 min"));
  shock_ = question("segmentsShock", tr("Sudden loads"));
  rapid_ = question("segmentsRapid", tr("Rapid changes"));
  grip_ = new Segmented({tr("–"), tr("Good"), tr("Fair"), tr("Poor"), tr("None")});
  grip_->setObjectName("segmentsGrip");
  addRow(*section, tr("Grip"), grip_, kNamesColumn);
  const auto box = [&](const char* name, const QString& words) {
    auto* check = new QCheckBox(words);
    check->setObjectName(name);
    section->addWidget(check);
    return check;
  };
  trunk_ = box("checkTrunkSupported", tr("The trunk is supported (backrest)"));
  left_arm_ = box("checkLeftArm", tr("The left arm is supported"));
  right_arm_ = box("checkRightArm", tr("The right arm is supported"));
  walking_ = box("checkWalking", tr("Walking"));
  connectNumber(load_left_, knows_left_, [](WorkTask& task) { return &task.load_kg[0]; });
  connectNumber(load_right_, knows_right_, [](WorkTask& task) { return &task.load_kg[1]; });
  connectNumber(repetitions_, knows_repetitions_, [](WorkTask& task) { return &task.repetitions_per_min; });
  connectNumber(duration_, knows_duration_, [](WorkTask& task) { return &task.duration_h; });
  const auto answer = [this](Segmented* segments, std::optional<bool> WorkTask::*flag) {
    connect(segments, &Segmented::chosen, this,
            [this, flag](int i) { change([&](WorkTask& task) { task.*flag = flagOf(i); }); });
  };
  answer(static_, &WorkTask::is_static);
  answer(shock_, &WorkTask::has_shock);
  answer(rapid_, &WorkTask::has_rapid_changes);
  connect(grip_, &Segmented::chosen, this, [this](int i) {
    change([&](WorkTask& task) {
      task.grip = i == 0 ? std::nullopt : std::optional(static_cast<ergonomics::Grip>(i - 1));
    });
  });
  connect(trunk_, &QCheckBox::clicked, this, [this](bool on) { change([&](WorkTask& t) { t.trunk_supported = on; }); });
  connect(left_arm_, &QCheckBox::clicked, this,
          [this](bool on) { change([&](WorkTask& t) { t.arm_supported[0] = on; }); });
  connect(right_arm_, &QCheckBox::clicked, this,
          [this](bool on) { change([&](WorkTask& t) { t.arm_supported[1] = on; }); });
  connect(walking_, &QCheckBox::clicked, this, [this](bool on) { change([&](WorkTask& t) { t.is_walking = on; }); });
}

void WorkTaskPanel::addLift(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Lifting (NIOSH)"));
  lift_ = new QCheckBox(tr("The load is lifted or lowered"));
  lift_->setObjectName("checkLift");
  section->addWidget(lift_);
  lift_rows_ = new QWidget;
  auto* rows = new QVBoxLayout(lift_rows_);
  rows->setContentsMargins(0, 0, 0, 0);
  lift_distance_ = new ValueField({tr("mm"), 0, 0.0, 2000.0, 10.0});
  lift_distance_->setObjectName("fieldLiftDistance");
  asymmetry_ = new ValueField({tr("°"), 0, 0.0, 180.0, 5.0});
  asymmetry_->setObjectName("fieldAsymmetry");
  addRow(*rows, tr("By"), lift_distance_, kNamesColumn);
  addRow(*rows, tr("Beside the middle"), asymmetry_, kNamesColumn);
  section->addWidget(lift_rows_);
  connect(lift_, &QCheckBox::clicked, this, [this](bool on) { change([&](WorkTask& t) { t.is_lift = on; }); });
  connect(lift_distance_, &ValueField::edited, this,
          [this](double mm) { change([&](WorkTask& t) { t.lift_distance_m = mm / 1000.0; }); });
  connect(asymmetry_, &ValueField::edited, this,
          [this](double degrees) { change([&](WorkTask& t) { t.asymmetry_deg = degrees; }); });
}

WorkTask WorkTaskPanel::present() const {
  const workcell::Entity* entity = context_.entity();
  const auto& state = context_.host().documentModel().document().state();
  if (entity) {
    if (const WorkTask* task = state.workTaskOf(entity->name)) return *task;
  }
  WorkTask task;
  if (entity) task.mannequin = entity->name;
  task.name = entity ? tr("Task of %1").arg(QString::fromStdString(entity->name)).toStdString() : task.name;
  return task;
}

void WorkTaskPanel::change(const std::function<void(WorkTask&)>& edit) {
  if (showing_ || !context_.entity()) return;
  WorkTask task = present();
  const WorkTask had = task;
  const bool is_new = context_.host().documentModel().document().state().findWorkTask(task.name) == nullptr;
  edit(task);
  if (task == had && !is_new) return;
  context_.host().documentModel().execute(workcell::SetWorkTask{task, is_new ? std::string() : had.name});
  showNow();
}

void WorkTaskPanel::showNow() {
  setEnabled(context_.entity() != nullptr);
  showing_ = true;
  const WorkTask task = present();
  const auto number = [](ValueField* field, QCheckBox* known, const std::optional<double>& value) {
    known->setChecked(value.has_value());
    if (!field->hasFocus()) field->setValue(value.value_or(0.0));
  };
  preset_->setCurrentIndex(0);
  if (!name_->hasFocus()) name_->setText(QString::fromStdString(task.name));
  if (!note_->hasFocus()) note_->setText(QString::fromStdString(task.note));
  number(load_left_, knows_left_, task.load_kg[0]);
  number(load_right_, knows_right_, task.load_kg[1]);
  number(repetitions_, knows_repetitions_, task.repetitions_per_min);
  number(duration_, knows_duration_, task.duration_h);
  static_->setCurrent(stateOf(task.is_static));
  shock_->setCurrent(stateOf(task.has_shock));
  rapid_->setCurrent(stateOf(task.has_rapid_changes));
  grip_->setCurrent(task.grip ? 1 + static_cast<int>(*task.grip) : 0);
  trunk_->setChecked(task.trunk_supported);
  left_arm_->setChecked(task.arm_supported[0]);
  right_arm_->setChecked(task.arm_supported[1]);
  walking_->setChecked(task.is_walking);
  lift_->setChecked(task.is_lift);
  lift_rows_->setVisible(task.is_lift);
  if (!lift_distance_->hasFocus()) lift_distance_->setValue(1000.0 * task.lift_distance_m);
  if (!asymmetry_->hasFocus()) asymmetry_->setValue(task.asymmetry_deg);
  showing_ = false;
}

}  // namespace hapticell::app
