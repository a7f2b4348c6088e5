// SPDX-License-Identifier: Apache-2.0
#include "app/ergonomics/work_task_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include "app/ergonomics/known_field.h"
#include "app/ergonomics/lift_fields.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/kit/form.h"
#include "app/mannequin/mannequin_context.h"
#include "app/style/segmented.h"
#include "app/style/value_field.h"

namespace hapticell::app {
namespace {

using ergonomics::WorkTask;
constexpr int kNamesColumn = 108;

/// 0 not entered, 1 no, 2 yes.
int stateOf(const std::optional<bool>& flag) {
  if (!flag) return 0;
  return *flag ? 2 : 1;
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
  lift_ = new LiftFields(
      *column, [this](const std::function<void(WorkTask&)>& edit) { change(edit); }, this);
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
  addRow(*section, tr("Start from"), preset_, kNamesColumn);
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

void WorkTaskPanel::connectNumber(KnownField* field, std::function<std::optional<double>*(WorkTask&)> of) {
  connect(field, &KnownField::edited, this,
          [this, of](const std::optional<double>& value) { change([&](WorkTask& task) { *of(task) = value; }); });
}

void WorkTaskPanel::addWork(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Work"));
  const auto number = [&](const char* name, const QString& words, const ValueField::Format& format) {
    auto* field = new KnownField(name, words, format);
    addRow(*section, words, field, kNamesColumn);
    return field;
  };
  load_left_ = number("fieldLoadLeft", tr("Load, left hand"), {tr("kg"), 1, 0.0, 200.0, 0.5});
  load_right_ = number("fieldLoadRight", tr("Load, right hand"), {tr("kg"), 1, 0.0, 200.0, 0.5});
  load_left_->field().setToolTip(tr("Weight, or a force divided by 9.81"));
  load_right_->field().setToolTip(load_left_->field().toolTip());
  repetitions_ = number("fieldRepetitions", tr("Repetition"), {tr("/min"), 1, 0.0, 120.0, 1.0});
  duration_ = number("fieldDuration", tr("Per shift"), {tr("h"), 1, 0.0, 24.0, 0.5});
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
  connectNumber(load_left_, [](WorkTask& task) { return &task.load_kg[0]; });
  connectNumber(load_right_, [](WorkTask& task) { return &task.load_kg[1]; });
  connectNumber(repetitions_, [](WorkTask& task) { return &task.repetitions_per_min; });
  connectNumber(duration_, [](WorkTask& task) { return &task.duration_h; });
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
  preset_->setCurrentIndex(0);
  if (!name_->hasFocus()) name_->setText(QString::fromStdString(task.name));
  if (!note_->hasFocus()) note_->setText(QString::fromStdString(task.note));
  load_left_->setValue(task.load_kg[0]);
  load_right_->setValue(task.load_kg[1]);
  repetitions_->setValue(task.repetitions_per_min);
  duration_->setValue(task.duration_h);
  static_->setCurrent(stateOf(task.is_static));
  shock_->setCurrent(stateOf(task.has_shock));
  rapid_->setCurrent(stateOf(task.has_rapid_changes));
  grip_->setCurrent(task.grip ? 1 + static_cast<int>(*task.grip) : 0);
  trunk_->setChecked(task.trunk_supported);
  left_arm_->setChecked(task.arm_supported[0]);
  right_arm_->setChecked(task.arm_supported[1]);
  walking_->setChecked(task.is_walking);
  lift_->show(task);
  showing_ = false;
}

}  // namespace hapticell::app
