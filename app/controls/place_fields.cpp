// SPDX-License-Identifier: Apache-2.0
#include "app/controls/place_fields.h"

#include <QPushButton>
#include <QVBoxLayout>

#include "app/host/host.h"
#include "app/kit/form.h"
#include "app/controls/pose_text.h"
#include "app/style/value_field.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {

PlaceFields::PlaceFields(Host& host, const QString& name, const QString& prompt, QWidget* parent)
    : QWidget(parent), host_(host) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  const char* const names[4]{"X", "Y", "Z", "A"};
  for (std::size_t i = 0; i < 4; ++i) {
    fields_[i] = new ValueField({i < 3 ? QStringLiteral("mm") : QStringLiteral("°"), 1, -1e6, 1e6, 1.0});
    fields_[i]->setObjectName(name + QLatin1String(names[i]));
    fields_[i]->setAccessibleName(QLatin1String(names[i]));
    connect(fields_[i], &ValueField::edited, this, &PlaceFields::edited);
  }
  addRow(*rows, tr("X Y Z"), sideBySide({fields_[0], fields_[1], fields_[2]}), 56);
  auto* button = new QPushButton(tr("Pick in the scene"));
  button->setObjectName(name + QStringLiteral("Pick"));
  addRow(*rows, tr("Angle"), sideBySide({fields_[3], button}), 56);
  connect(button, &QPushButton::clicked, this, [this, prompt] { pick(prompt); });
}

Pose PlaceFields::X_W() const {
  return poseFromNumbers({fields_[0]->value(), fields_[1]->value(), fields_[2]->value(), fields_[3]->value(), 0, 0});
}

void PlaceFields::set(const dvec3& p_W) {
  for (int i = 0; i < 3; ++i) fields_[static_cast<std::size_t>(i)]->setValue(1000.0 * p_W[i]);
}

void PlaceFields::pick(const QString& prompt) {
  host_.viewport().startPick(
      {{.faces = true, .edges = false, .vertices = true}, prompt, [this](const std::optional<PickedFeature>& feature) {
         if (!feature) return;
         set(feature->p_WQ);
         emit edited();
       }});
}

}  // namespace hapticell::app
