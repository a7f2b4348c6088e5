// SPDX-License-Identifier: Apache-2.0
#include "app/studies/section_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/kit/file_dialog.h"
#include "app/kit/form.h"
#include "app/studies/range_fields.h"
#include "app/style/value_field.h"

namespace hapticell::app {

using studies::StudyPlace;
using studies::StudyValue;

namespace {

QString shownList(const StudyValue& value) {
  QStringList words;
  if (const auto* list = std::get_if<std::vector<std::string>>(&value))
    for (const std::string& word : *list) words << QString::fromStdString(word);
  return words.join(QStringLiteral(", "));
}

std::vector<std::string> listOf(const QString& text) {
  std::vector<std::string> words;
  for (const QString& word : text.split(',', Qt::SkipEmptyParts))
    if (!word.trimmed().isEmpty()) words.push_back(word.trimmed().toStdString());
  return words;
}

StudyValue wordOrNothing(const QString& word) {
  return word.isEmpty() ? StudyValue() : StudyValue(word.toStdString());
}

}  // namespace

SectionForm::SectionForm(Host& host, StudyDraft& draft, QWidget* parent)
    : QWidget(parent), host_(host), draft_(draft) {
  setObjectName("studySection");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  connect(&draft_, &StudyDraft::changed, this, &SectionForm::refresh);
  connect(&host_.documentModel(), &DocumentModel::changed, this, &SectionForm::refresh);
}

void SectionForm::show(const std::optional<StudyPlace>& place) {
  place_ = place;
  build();
}

/// What decides which fields there are.
QString SectionForm::shape() const {
  if (!place_ || place_->index >= draft_.text().count(place_->table)) return {};
  return QString::fromStdString(place_->table + "|" + std::to_string(place_->index) + "|" +
                                draft_.text().word(*place_, "what"));
}

void SectionForm::build() {
  shape_ = shape();
  refreshers_.clear();
  if (holder_ != nullptr) {
    // One of its fields may be what asked for this.
    holder_->hide();
    holder_->setParent(nullptr);
    holder_->deleteLater();
  }
  holder_ = new QWidget;
  auto* rows = new QVBoxLayout(holder_);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(6);
  layout()->addWidget(holder_);
  if (shape_.isEmpty()) {
    auto* none = makeLabel(tr("Choose a line above, or add one."), TextRole::kSecond, true);
    none->setWordWrap(true);
    rows->addWidget(none);
    return;
  }
  if (place_->table == "require") return addRequirement(*rows);
  if (place_->table == "objective") return addObjective(*rows);
  addName(*rows);
  if (const StudyKind* kind = studyKind(place_->table, draft_.text().word(*place_, "what")))
    for (const StudyField& field : kind->fields) addField(*rows, field);
  addUnknown(*rows);
  refresh();
}

void SectionForm::refresh() {
  if (shape() != shape_) {
    // Not at once: a field of this form may be the one that changed it.
    QMetaObject::invokeMethod(this, [this] {
      if (shape() != shape_) build();
    }, Qt::QueuedConnection);
    return;
  }
  if (shape_.isEmpty()) return;
  for (const auto& refresher : refreshers_) refresher();
}

QStringList SectionForm::entities(StudyEdit edit) const {
  QStringList names;
  for (const auto& entity : host_.documentModel().document().state().entities) {
    if (edit == StudyEdit::kRobot && !workcell::isMachine(*entity)) continue;
    if (edit != StudyEdit::kMannequin || entity->figure() != nullptr) names << QString::fromStdString(entity->name);
  }
  return names;
}

void SectionForm::addField(QVBoxLayout& rows, const StudyField& field) {
  const QString label = studyFieldLabel(field.label);
  switch (field.edit) {
    case StudyEdit::kName:
      return addWord(rows, label, field.key);
    case StudyEdit::kEntity:
    case StudyEdit::kRobot:
    case StudyEdit::kMannequin:
      addChoice(rows, label, field.key, [this, edit = field.edit] { return entities(edit); });
      return;
    case StudyEdit::kAxis:
      addChoice(rows, label, field.key, [] { return QStringList{"x", "y", "z"}; });
      return;
    case StudyEdit::kRange: {
      const std::string what = draft_.text().word(*place_, "what");
      auto unit = RangeFields::Unit::kLength;
      if (what == "rotation") unit = RangeFields::Unit::kAngle;
      if (what == "joint") unit = RangeFields::Unit::kPlain;
      auto* range = new RangeFields(draft_, *place_, unit);
      rows.addWidget(range);
      refreshers_.push_back([range] { range->refresh(); });
      return;
    }
    case StudyEdit::kWords:
      return addWordList(rows, label, field.key);
    case StudyEdit::kMethods:
      return addMethods(rows, field);
    case StudyEdit::kFile:
      return addFile(rows, field);
    case StudyEdit::kFrames:
      return addFrames(rows, field);
    case StudyEdit::kLength:
    case StudyEdit::kSeconds:
    case StudyEdit::kWhole:
    case StudyEdit::kYes:
      return addNumber(rows, field);
  }
}

void SectionForm::addName(QVBoxLayout& rows) {
  auto* edit = new QLineEdit;
  edit->setObjectName("editSection_name");
  edit->setMaxLength(60);
  addRow(rows, tr("Name"), edit);
  refreshers_.push_back([this, edit] {
    if (!edit->hasFocus()) edit->setText(QString::fromStdString(draft_.nameOf(*place_)));
  });
  connect(edit, &QLineEdit::editingFinished, this, [this, edit] {
    const std::string name = edit->text().trimmed().toStdString();
    if (name != draft_.nameOf(*place_)) draft_.set(*place_, "name", wordOrNothing(edit->text().trimmed()));
  });
}

void SectionForm::addWord(QVBoxLayout& rows, const QString& label, const char* key) {
  auto* edit = new QLineEdit;
  edit->setObjectName(QStringLiteral("editSection_") + key);
  addRow(rows, label, edit);
  refreshers_.push_back([this, edit, key] {
    if (!edit->hasFocus()) edit->setText(QString::fromStdString(draft_.text().word(*place_, key)));
  });
  connect(edit, &QLineEdit::editingFinished, this,
          [this, edit, key] { draft_.set(*place_, key, wordOrNothing(edit->text().trimmed())); });
}

void SectionForm::addWordList(QVBoxLayout& rows, const QString& label, const char* key) {
  auto* edit = new QLineEdit;
  edit->setObjectName(QStringLiteral("editSection_") + key);
  edit->setPlaceholderText(tr("one, another, …"));
  addRow(rows, label, edit);
  refreshers_.push_back([this, edit, key] {
    if (!edit->hasFocus()) edit->setText(shownList(draft_.text().value(*place_, key)));
  });
  connect(edit, &QLineEdit::editingFinished, this, [this, edit, key] {
    const auto words = listOf(edit->text());
    draft_.set(*place_, key, words.empty() ? StudyValue() : StudyValue(words));
  });
}

QComboBox* SectionForm::addChoice(QVBoxLayout& rows, const QString& label, const char* key,
                                  const std::function<QStringList()>& words) {
  auto* choice = new QComboBox;
  choice->setObjectName(QStringLiteral("choiceSection_") + key);
  addRow(rows, label, choice);
  refreshers_.push_back([this, choice, key, words] {
    const QSignalBlocker quiet(choice);
    const QString now = QString::fromStdString(draft_.text().word(*place_, key));
    QStringList all = words();
    all.prepend({});
    if (!all.contains(now)) all << now;  // Of another cell, or a kind that is new: it stays.
    choice->clear();
    choice->addItems(all);
    choice->setCurrentText(now);
  });
  connect(choice, &QComboBox::activated, this, [this, choice, key] {
    draft_.set(*place_, key, wordOrNothing(choice->currentText()));
  });
  return choice;
}

void SectionForm::addFile(QVBoxLayout& rows, const StudyField& field) {
  auto* edit = new QLineEdit;
  edit->setObjectName(QStringLiteral("editSection_") + field.key);
  edit->setPlaceholderText(tr("table of poses (.csv)"));
  auto* browse = new QPushButton(tr("Choose…"));
  browse->setObjectName("buttonTargets");
  addRow(rows, studyFieldLabel(field.label), sideBySide({edit, browse}));
  const auto set = [this, key = field.key](const QString& path) {
    std::vector<std::pair<const char*, StudyValue>> values{{key, wordOrNothing(path)}};
    // Only one list of targets may be named.
    if (!path.isEmpty()) values.emplace_back("frames", StudyValue());
    draft_.setAll(*place_, values);
  };
  refreshers_.push_back([this, edit, key = field.key] {
    if (!edit->hasFocus()) edit->setText(QString::fromStdString(draft_.text().word(*place_, key)));
  });
  connect(edit, &QLineEdit::editingFinished, this, [edit, set] { set(edit->text().trimmed()); });
  connect(browse, &QPushButton::clicked, this, [this, set] {
    const QString base = QFileInfo(draft_.file().isEmpty() ? draft_.cell() : draft_.file()).absolutePath();
    const QString chosen = askToOpen(window(), tr("Targets"), base, tr("Tables (*.csv)"));
    if (chosen.isEmpty()) return;
    const auto relative = std::filesystem::path(chosen.toStdString()).lexically_relative(base.toStdString());
    const bool below = !relative.empty() && *relative.begin() != "..";
    set(below ? QString::fromStdString(relative.generic_string()) : chosen);
  });
}

/// The frames of the cell with a tick at those that are targets.
void SectionForm::addFrames(QVBoxLayout& rows, const StudyField& field) {
  auto* list = new QListWidget;
  list->setObjectName("listFrames");
  list->setMaximumHeight(110);
  list->setAccessibleName(tr("Frames that are targets"));
  rows.addWidget(makeLabel(tr("These frames are the targets"), TextRole::kText, true));
  rows.addWidget(list);
  auto* take = new QPushButton(tr("Add the selected frames"));
  take->setObjectName("buttonFrames");
  rows.addWidget(take, 0, Qt::AlignLeft);
  const auto named = [this, key = field.key] {
    const StudyValue value = draft_.text().value(*place_, key);
    const auto* words = std::get_if<std::vector<std::string>>(&value);
    return words != nullptr ? *words : std::vector<std::string>{};
  };
  const auto set = [this, key = field.key](const std::vector<std::string>& frames) {
    std::vector<std::pair<const char*, StudyValue>> values{{key, frames.empty() ? StudyValue() : StudyValue(frames)}};
    // Frames have their own places, and only one list of targets may be named.
    if (!frames.empty()) values.insert(values.end(), {{"targets", StudyValue()}, {"frame", StudyValue()}});
    draft_.setAll(*place_, values);
  };
  refreshers_.push_back([this, list, named] {
    const QSignalBlocker quiet(list);
    std::vector<std::string> all;
    for (const auto& entity : host_.documentModel().document().state().entities) {
      if (entity->kind() == workcell::EntityKind::kFrame) all.push_back(entity->name);
      for (const workcell::Frame& frame : entity->frames) all.push_back(entity->name + "/" + frame.name);
    }
    const std::vector<std::string> chosen = named();
    for (const std::string& one : chosen)
      if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
    list->clear();
    for (const std::string& one : all) {
      auto* item = new QListWidgetItem(QString::fromStdString(one), list);
      const bool on = std::find(chosen.begin(), chosen.end(), one) != chosen.end();
      item->setCheckState(on ? Qt::Checked : Qt::Unchecked);
    }
  });
  connect(list, &QListWidget::itemChanged, this, [list, named, set](QListWidgetItem* item) {
    std::vector<std::string> frames = named();
    const std::string name = item->text().toStdString();
    std::erase(frames, name);
    if (item->checkState() == Qt::Checked) frames.push_back(name);
    // After the list has told everybody of its change.
    QMetaObject::invokeMethod(list, [set, frames] { set(frames); }, Qt::QueuedConnection);
  });
  connect(take, &QPushButton::clicked, this, [this, named, set] {
    std::vector<std::string> frames = named();
    for (const workcell::EntityId id : host_.selection().all()) {
      const workcell::Entity* entity = host_.documentModel().document().find(id);
      if (entity == nullptr || entity->kind() != workcell::EntityKind::kFrame) continue;
      if (std::find(frames.begin(), frames.end(), entity->name) == frames.end()) frames.push_back(entity->name);
    }
    set(frames);
  });
}

void SectionForm::addMethods(QVBoxLayout& rows, const StudyField& field) {
  auto* list = new QListWidget;
  list->setObjectName("listMethods");
  list->setMaximumHeight(132);
  list->setAccessibleName(studyFieldLabel(field.label));
  addRow(rows, studyFieldLabel(field.label), list);
  for (const char* method : postureMethods()) {
    auto* item = new QListWidgetItem(QString::fromLatin1(method).toUpper().replace('_', ' '), list);
    item->setData(Qt::UserRole, QString::fromLatin1(method));
    item->setCheckState(Qt::Unchecked);
  }
  refreshers_.push_back([this, list, key = field.key] {
    const QSignalBlocker quiet(list);
    const StudyValue value = draft_.text().value(*place_, key);
    const auto* words = std::get_if<std::vector<std::string>>(&value);
    for (int i = 0; i < list->count(); ++i) {
      const std::string method = list->item(i)->data(Qt::UserRole).toString().toStdString();
      const bool on = words != nullptr ? std::find(words->begin(), words->end(), method) != words->end()
                                       : method != "lifting_index";
      list->item(i)->setCheckState(on ? Qt::Checked : Qt::Unchecked);
    }
  });
  connect(list, &QListWidget::itemChanged, this, [this, list, key = field.key] {
    std::vector<std::string> words;
    for (int i = 0; i < list->count(); ++i)
      if (list->item(i)->checkState() == Qt::Checked)
        words.push_back(list->item(i)->data(Qt::UserRole).toString().toStdString());
    QMetaObject::invokeMethod(this, [this, key, words] { draft_.set(*place_, key, words); }, Qt::QueuedConnection);
  });
}

void SectionForm::addNumber(QVBoxLayout& rows, const StudyField& field) {
  const QString label = studyFieldLabel(field.label);
  if (field.edit == StudyEdit::kYes) {
    auto* check = new QCheckBox(label);
    check->setObjectName(QStringLiteral("checkSection_") + field.key);
    rows.addWidget(check);
    refreshers_.push_back([this, check, field] {
      const StudyValue value = draft_.text().value(*place_, field.key);
      const auto* yes = std::get_if<bool>(&value);
      check->setChecked(yes != nullptr ? *yes : field.otherwise > 0.0);
    });
    connect(check, &QCheckBox::clicked, this, [this, field](bool on) { draft_.set(*place_, field.key, on); });
    return;
  }
  const double per = field.edit == StudyEdit::kLength ? 1e-3 : 1.0;
  ValueField::Format format{{}, 0, 0.0, 24.0, 1.0};
  if (field.edit == StudyEdit::kLength) format = {tr("mm"), 1, 0.0, 1e5, 1.0};
  if (field.edit == StudyEdit::kSeconds) format = {tr("s"), 2, 0.0, 1e5, 0.1};
  auto* number = new ValueField(format);
  number->setObjectName(QStringLiteral("fieldSection_") + field.key);
  addRow(rows, label, number);
  refreshers_.push_back([this, number, field, per] {
    const StudyValue value = draft_.text().value(*place_, field.key);
    const auto* now = std::get_if<double>(&value);
    number->setValue((now != nullptr ? *now : field.otherwise) / per);
  });
  connect(number, &ValueField::edited, this, [this, field, per](double value) {
    draft_.set(*place_, field.key, std::round(value * per * 1e9) / 1e9);
  });
}

void SectionForm::addUnknown(QVBoxLayout& rows) {
  auto* unknown = makeLive(2, TextRole::kSecond, true);
  unknown->setObjectName("labelUnknownKeys");
  rows.addWidget(unknown);
  refreshers_.push_back([this, unknown] {
    QStringList keys;
    for (const std::string& key : draft_.unknownKeys(*place_))
      keys << QString::fromStdString(key + " = " + draft_.text().written(*place_, key));
    unknown->setText(keys.isEmpty() ? QString() : tr("Not editable here, kept unchanged: %1").arg(keys.join(QStringLiteral("; "))));
  });
}

void SectionForm::addBound(QVBoxLayout& rows, const QString& label, const char* key) {
  auto* edit = new QLineEdit;
  edit->setObjectName(QStringLiteral("editSection_") + key);
  edit->setPlaceholderText(tr("no bound"));
  addRow(rows, label, edit);
  refreshers_.push_back([this, edit, key] {
    if (!edit->hasFocus()) edit->setText(QString::fromStdString(draft_.text().written(*place_, key)));
  });
  connect(edit, &QLineEdit::editingFinished, this, [this, edit, key] {
    bool good = false;
    const double number = edit->text().toDouble(&good);
    if (good) draft_.set(*place_, key, number);
    if (edit->text().trimmed().isEmpty()) draft_.set(*place_, key, {});
    edit->setText(QString::fromStdString(draft_.text().written(*place_, key)));
  });
}

void SectionForm::addRequirement(QVBoxLayout& rows) {
  addChoice(rows, tr("Result"), "value", [this] {
    QStringList names;
    for (const std::string& name : draft_.resultNames()) names << QString::fromStdString(name);
    return names;
  });
  addBound(rows, tr("At least"), "at_least");
  addBound(rows, tr("At most"), "at_most");
  refresh();
}

void SectionForm::addObjective(QVBoxLayout& rows) {
  addChoice(rows, tr("Result"), "value", [this] {
    QStringList names;
    for (const std::string& name : draft_.resultNames()) names << QString::fromStdString(name);
    return names;
  });
  auto* goal = new QComboBox;
  goal->setObjectName("choiceGoal");
  goal->addItems({tr("Small"), tr("Large")});
  addRow(rows, tr("Should be"), goal);
  refreshers_.push_back(
      [this, goal] { goal->setCurrentIndex(draft_.text().word(*place_, "goal") == "greatest" ? 1 : 0); });
  connect(goal, &QComboBox::activated, this, [this](int index) {
    draft_.set(*place_, "goal", index == 1 ? StudyValue(std::string("greatest")) : StudyValue());
  });
  addBound(rows, tr("Weight"), "weight");
  refresh();
}

}  // namespace hapticell::app
