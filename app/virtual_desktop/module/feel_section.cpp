// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/module/feel_section.h"

#include <QComboBox>
#include <QVBoxLayout>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/kit/form.h"
#include "app/style/segmented.h"
#include "app/style/value_field.h"
#include "app/virtual_desktop/module/virtual_desktop_controller.h"

namespace hapticell::app {

FeelSection::FeelSection(Host& host, VirtualDesktopController& controller, QVBoxLayout& column, QObject* parent)
    : QObject(parent), host_(host), controller_(controller) {
  QVBoxLayout* section = addSection(column, tr("Feel of this entity"));
  force_class_ = new Segmented({tr("Constant"), tr("Contact"), tr("Dynamics")});
  force_class_->setObjectName("segmentsForce");
  addRow(*section, tr("Force"), force_class_);
  material_ = new QComboBox;
  material_->setObjectName("comboMaterial");
  for (const auto& [key, material] : host_.configuration().materials) {
    QString name = QString::fromStdString(key);
    name[0] = name[0].toUpper();
    material_->addItem(tr("%1, µ %2").arg(name).arg(material.friction, 0, 'f', 2), QString::fromStdString(key));
  }
  addRow(*section, tr("Material"), material_);
  stiffness_ = new ValueField({tr("N/mm"), 2, 0.0, 100.0, 0.1});
  damping_ = new ValueField({tr("N s/m"), 1, 0.0, 100.0, 0.1});
  for (ValueField* field : {stiffness_, damping_}) {
    field->setReadOnly(true);
    field->setFocusPolicy(Qt::NoFocus);
    field->setToolTip(tr("From the material (hapticell.toml). The server limits it to what the device supports"));
  }
  addRow(*section, tr("Stiffness"), sideBySide({stiffness_, damping_}));
  connect(force_class_, &Segmented::chosen, this,
          [this](int index) { controller_.setForceClass(static_cast<workcell::ForceClass>(index)); });
  connect(material_, &QComboBox::activated, this, [this](int index) {
    workcell::SetProperties wanted;
    wanted.id = controller_.settings().entity;
    wanted.material = material_->itemData(index).toString().toStdString();
    if (wanted.id) host_.documentModel().execute(wanted);
    showSettings();
  });
}

void FeelSection::showMaterial(const workcell::Entity* entity) {
  material_->setEnabled(entity);
  const std::string key = entity ? entity->contact.material : "steel";
  material_->setCurrentIndex(material_->findData(QString::fromStdString(key)));
  const auto& materials = host_.configuration().materials;
  const auto material = materials.find(key);
  if (material == materials.end()) return;
  stiffness_->setValue(material->second.stiffness / 1000.0);
  damping_->setValue(material->second.damping);
}

void FeelSection::showSettings() {
  force_class_->setCurrent(static_cast<int>(controller_.settings().force_class));
  showMaterial(host_.documentModel().document().find(controller_.settings().entity));
}

}  // namespace hapticell::app
