// SPDX-License-Identifier: Apache-2.0
#include "app/edit/part_sizes.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "app/edit/part_names.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/kit/form.h"
#include "app/style/value_field.h"
#include "workcell/document/part_resize.h"
#include "workcell/entity/built_in_parts.h"

namespace hapticell::app {

PartSizes::PartSizes(Host& host, QWidget* parent) : QWidget(parent), host_(host) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout* section = addSection(*column, tr("Size"));
  for (std::size_t i = 0; i < kMost; ++i) {
    fields_[i] = new ValueField({QStringLiteral("mm"), 1, 0.001, 1e6, 10.0});
    fields_[i]->setObjectName(QStringLiteral("fieldPartSize%1").arg(i + 1));
    fields_[i]->setAccessibleName(tr("Size %1").arg(i + 1));  // Its own name comes with the part.
    names_[i] = makeLabel({}, TextRole::kSecond, true);
    names_[i]->setFixedWidth(kLabelColumn);
    rows_[i] = new QWidget;
    auto* row = new QHBoxLayout(rows_[i]);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(names_[i]);
    row->addWidget(fields_[i], 1);
    section->addWidget(rows_[i]);
    connect(fields_[i], &ValueField::edited, this, &PartSizes::resize);
  }
}

void PartSizes::showPart(const workcell::Entity& solid) {
  const std::vector<double> sizes = workcell::partSizes(solid.source);
  id_ = sizes.empty() ? 0 : solid.id;
  setVisible(id_ != 0);
  if (id_ == 0) return;
  const auto* part = workcell::findBuiltInPart(solid.source.path.substr(0, solid.source.path.find(':')));
  for (std::size_t i = 0; i < kMost; ++i) {
    rows_[i]->setVisible(i < sizes.size());
    if (i >= sizes.size()) continue;
    const QString name = sizeName(part->sizes[i]);
    names_[i]->setText(name);
    fields_[i]->setAccessibleName(name);
    fields_[i]->setEnabled(!solid.locked);
    if (!fields_[i]->hasFocus()) fields_[i]->setValue(1000.0 * sizes[i]);
  }
}

void PartSizes::resize() {
  const workcell::Document& document = host_.documentModel().document();
  const workcell::Entity* solid = document.find(id_);
  if (!solid) return;
  std::vector<double> sizes;
  for (std::size_t i = 0; i < kMost; ++i)
    if (!rows_[i]->isHidden()) sizes.push_back(fields_[i]->value() / 1000.0);
  const auto commands = workcell::resizePart(document.state(), id_, sizes);
  if (!commands) {
    host_.messages().reportCause(Severity::kWarning, tr("The size was not changed"), commands.error());
    for (ValueField* field : fields_) field->clearFocus();
    return showPart(*solid);
  }
  host_.documentModel().executeAll(tr("Resize %1").arg(QString::fromStdString(solid->name)), *commands);
}

}  // namespace hapticell::app
