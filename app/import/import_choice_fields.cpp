// SPDX-License-Identifier: Apache-2.0
#include "app/import/import_choice_fields.h"

#include <QComboBox>
#include <QLabel>
#include <QVBoxLayout>
#include <array>
#include <cmath>

#include "app/import/argument_fields.h"
#include "app/import/unit_question.h"
#include "app/kit/form.h"
#include "app/style/segmented.h"
#include "app/style/units.h"

namespace hapticell::app {
namespace {

constexpr std::array<double, 5> kUnits{0.001, 0.01, 1.0, 0.0254, 0.3048};

/// A deviation of a mesh: a decimal more than the user's.
QString fineLengthText(double metres) {
  const Units units = unitsNow();
  return numberText(units.perMetre() * metres, units.length_decimals + 1) + QLatin1Char(' ') + units.lengthUnit();
}

QString capitalUnit(QString text) {
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

}  // namespace

ImportChoiceFields::ImportChoiceFields(ImportSession& session, QWidget* parent) : QWidget(parent), session_(session) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  arguments_ = new ArgumentFields;
  column->addWidget(arguments_);
  mesh_choices_ = new QWidget;
  column->addWidget(mesh_choices_);
  auto* mesh_column = new QVBoxLayout(mesh_choices_);
  mesh_column->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout* section = addSection(*mesh_column, {});
  unit_asked_ = makeLabel({}, TextRole::kText);
  unit_asked_->setObjectName("importUnitAsked");
  unit_asked_->setWordWrap(true);
  section->addWidget(unit_asked_);
  unit_question_ = new UnitQuestion;
  section->addWidget(unit_question_);
  unit_ = new QComboBox;
  unit_->setPlaceholderText(tr("Unknown"));
  unit_->setObjectName("importUnit");
  addRow(*section, tr("Unit"), unit_);
  up_ = new Segmented({tr("X"), tr("Y"), tr("Z")});
  up_->setObjectName("importUp");
  addRow(*section, tr("Up axis"), up_);
  quality_ = new Segmented({tr("Coarse"), tr("Medium"), tr("Fine")});
  quality_->setObjectName("importQuality");
  addRow(*section, tr("Mesh"), quality_);
  estimate_ = makeLive(2, TextRole::kSecond, true);
  estimate_->setObjectName("importEstimate");
  addRow(*section, {}, estimate_);
  tree_ = new Segmented({tr("One solid"), tr("Tree")});
  tree_->setObjectName("importTree");
  addRow(*section, tr("Import as"), tree_);
  connectFields();
}

void ImportChoiceFields::connectFields() {
  connect(arguments_, &ArgumentFields::changed, this, [this](const std::map<std::string, std::string>& values) {
    change([&values](ImportChoices& choices) { choices.arguments = values; });
  });
  connect(unit_, &QComboBox::activated, this, [this](int row) {
    change([&](ImportChoices& choices) {
      const QVariant metres = unit_->itemData(row);
      choices.metres_per_unit = metres.isNull() ? std::nullopt : std::optional(metres.toDouble());
    });
  });
  connect(unit_question_, &UnitQuestion::chosen, this, [this](double metres) {
    change([metres](ImportChoices& choices) { choices.metres_per_unit = metres; });
    emit unitAnswered();  // A card that was chosen already stays so.
  });
  connect(up_, &Segmented::chosen, this, [this](int axis) {
    change([axis](ImportChoices& choices) { choices.up_axis = static_cast<workcell::UpAxis>(axis); });
  });
  connect(quality_, &Segmented::chosen, this, [this](int quality) {
    change([quality](ImportChoices& choices) { choices.quality = static_cast<MeshQuality>(quality); });
  });
  connect(tree_, &Segmented::chosen, this,
          [this](int row) { change([row](ImportChoices& choices) { choices.merge = row == 0; }); });
}

void ImportChoiceFields::change(const std::function<void(ImportChoices&)>& edit) {
  const FileImport* file = session_.find(shown_);
  if (!file || filling_) return;
  ImportChoices choices = file->choices;
  edit(choices);
  session_.choose(shown_, choices);
}

void ImportChoiceFields::showFile(const FileImport& file) {
  filling_ = true;
  shown_ = file.id;
  const ImportFacts& facts = *file.facts;
  arguments_->setArguments(file.id, facts.arguments, file.choices.arguments);
  mesh_choices_->setVisible(!facts.robot);
  setEnabled(file.stage != FileImport::Stage::kImporting);
  if (!facts.robot) {
    showUnits(file);
    showMesh(file);
  }
  filling_ = false;
}

void ImportChoiceFields::showMesh(const FileImport& file) {
  const ImportFacts& facts = *file.facts;
  up_->setCurrent(static_cast<int>(file.choices.up_axis.value_or(facts.up_axis)));
  quality_->setCurrent(facts.can_be_cut_finer ? static_cast<int>(file.choices.quality) : -1);
  for (int k = 0; k < 3; ++k) quality_->setChoiceEnabled(k, facts.can_be_cut_finer, tr("The file contains triangles."));
  const ImportEstimate estimate = ImportSession::estimateOf(file);
  const bool same = file.choices.quality == file.examined_with.quality;
  const QString triangles = tr("%1%2 triangles").arg(same ? QString() : tr("about "), countText(estimate.triangles));
  estimate_->setText(
      facts.can_be_cut_finer
          ? QStringLiteral("%1, %2, %3").arg(fineLengthText(estimate.chord), triangles, durationText(estimate.seconds))
          : triangles);
  tree_->setCurrent(file.choices.merge ? 0 : 1);
  const bool several = facts.parts > 1 || file.examined_with.merge;
  tree_->button(1)->setText(several && !file.examined_with.merge
                                ? tr("Tree of %1").arg(countText(static_cast<double>(facts.parts)))
                                : tr("Tree"));
  for (int k = 0; k < 2; ++k) tree_->setChoiceEnabled(k, several, tr("The file contains one part."));
}

void ImportChoiceFields::showUnits(const FileImport& file) {
  const ImportFacts& facts = *file.facts;
  unit_->clear();
  const bool stated = facts.unit_is_stated;
  if (stated) unit_->addItem(tr("%1, from the file").arg(capitalUnit(unitText(facts.metres_per_unit))));
  for (const double metres : kUnits) {
    QString text = capitalUnit(unitText(metres));
    if (!stated && !facts.unit_is_open && metres == facts.likely_metres_per_unit) text += tr(", guessed from the size");
    unit_->addItem(text, metres);
  }
  unit_asked_->setVisible(!stated);
  unit_asked_->setText(file.unit_is_open ? tr("The file states no unit. Which size is right?")
                                         : tr("The file states no unit. Is this size right?"));
  unit_question_->setVisible(!stated);
  if (file.unit_is_open) {
    unit_->setCurrentIndex(-1);
    return unit_question_->setFile(facts, std::nullopt);
  }
  const double now = file.choices.metres_per_unit.value_or(facts.metres_per_unit);
  unit_question_->setFile(facts, now);
  if (stated && !file.choices.metres_per_unit) return unit_->setCurrentIndex(0);
  for (int row = 0; row < unit_->count(); ++row)
    if (!unit_->itemData(row).isNull() && std::abs(unit_->itemData(row).toDouble() / now - 1.0) < 1e-9)
      unit_->setCurrentIndex(row);
}

}  // namespace hapticell::app
