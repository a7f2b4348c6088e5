// SPDX-License-Identifier: Apache-2.0
#include "app/panels/cell/entity_choices.h"

#include <QCheckBox>
#include <QComboBox>
#include <QVBoxLayout>

#include "app/controls/color_choice.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/kit/form.h"
#include "app/kit/swatch_row.h"
#include "app/style/segmented.h"
#include "app/style/style_painting.h"
#include "app/style/value_field.h"

namespace hapticell::app {
namespace {

constexpr int kChoiceLabel = 68;  // The dock is narrow.

}  // namespace

EntityChoices::EntityChoices(Host& host, QVBoxLayout& all, QObject* parent) : QObject(parent), host_(host) {
  feel_ = new QWidget;
  auto* feel_column = new QVBoxLayout(feel_);
  feel_column->setContentsMargins(0, 0, 0, 0);
  feel_column->setSpacing(all.spacing());
  all.addWidget(feel_);
  QVBoxLayout& column = *feel_column;
  on_contact_ = new Segmented({tr("Stop"), tr("Slide"), tr("Pass")});
  on_contact_->setObjectName("segmentsEntityOnContact");
  column.addSpacing(2);
  addRow(column, tr("On contact"), on_contact_, kChoiceLabel);
  force_class_ = new Segmented({tr("Constant"), tr("Contact"), tr("Dynamics")});
  force_class_->setObjectName("segmentsEntityForce");
  addRow(column, tr("Force"), force_class_, kChoiceLabel);
  material_ = new QComboBox;
  for (const auto& [key, material] : host_.configuration().materials)
    material_->addItem(QString::fromStdString(key).replace(0, 1, QString::fromStdString(key).left(1).toUpper()) +
                           tr(", µ %1").arg(material.friction, 0, 'f', 2),
                       QString::fromStdString(key));
  addRow(column, tr("Material"), material_, kChoiceLabel);
  mass_ = new ValueField({tr("kg"), 2, 0.01, 10000.0, 0.1});
  mass_->setObjectName("fieldEntityMass");
  mass_->setToolTip(tr("Felt with force class Dynamics; adds to the load of the robot that carries it"));
  addRow(column, tr("Mass"), mass_, kChoiceLabel);
  swatches_ = new SwatchRow(quietColors());
  swatches_->offerOther();
  addRow(column, tr("Colour"), swatches_, kChoiceLabel);
  checked_ = new QCheckBox(tr("Checked for collision"));
  locked_ = new QCheckBox(tr("Locked in place"));
  for (QCheckBox* box : {checked_, locked_}) box->setMinimumHeight(24);
  column.addWidget(checked_);
  all.addWidget(locked_);
  connectChoices();
}

const workcell::Entity* EntityChoices::entity() const {
  return host_.documentModel().document().find(host_.selection().current());
}

void EntityChoices::execute(workcell::SetProperties change) {
  if (!entity()) return;
  change.id = entity()->id;
  if (!host_.documentModel().execute(change)) show();
}

void EntityChoices::connectChoices() {
  connect(on_contact_, &Segmented::chosen, this,
          [this](int i) { execute({.on_contact = static_cast<workcell::OnContact>(i)}); });
  connect(force_class_, &Segmented::chosen, this,
          [this](int i) { execute({.force_class = static_cast<workcell::ForceClass>(i)}); });
  connect(material_, &QComboBox::activated, this,
          [this](int i) { execute({.material = material_->itemData(i).toString().toStdString()}); });
  connect(mass_, &ValueField::edited, this, [this](double kg) { execute({.mass = kg}); });
  const auto paint = [this](const QColor& color) {
    execute({.color = channelsOf(color)});
  };
  connect(swatches_, &SwatchRow::chosen, this, paint);
  connect(swatches_, &SwatchRow::otherWanted, this,
          [this, paint] { choosePartColor(host_, swatches_->current(), paint); });
  connect(checked_, &QCheckBox::clicked, this, [this](bool on) { execute({.checked = on}); });
  connect(locked_, &QCheckBox::clicked, this, [this](bool on) { execute({.locked = on}); });
}

void EntityChoices::show() {
  const workcell::Entity* now = entity();
  if (!now) return;
  feel_->setVisible(now->kind() != workcell::EntityKind::kFrame);
  on_contact_->setCurrent(static_cast<int>(now->contact.on_contact));
  force_class_->setCurrent(static_cast<int>(now->contact.force_class));
  material_->setCurrentIndex(material_->findData(QString::fromStdString(now->contact.material)));
  mass_->setValue(now->contact.mass);
  swatches_->setCurrent(QColor::fromRgbF(now->color[0], now->color[1], now->color[2]));
  swatches_->parentWidget()->setVisible(!now->robot());
  checked_->setChecked(now->checked);
  locked_->setChecked(now->locked);
}

}  // namespace hapticell::app
