// SPDX-License-Identifier: Apache-2.0
#include "app/ergonomics/known_field.h"

#include <QCheckBox>
#include <QHBoxLayout>

namespace hapticell::app {

KnownField::KnownField(const char* name, const QString& words, const ValueField::Format& format, QWidget* parent)
    : QWidget(parent), field_(new ValueField(format)), known_(new QCheckBox(tr("known"))) {
  field_->setObjectName(name);
  known_->setObjectName(field_->objectName() + "Known");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(field_, 1);
  row->addWidget(known_);
  field_->setAccessibleName(words);
  known_->setAccessibleName(tr("%1 is known").arg(words));
  connect(field_, &ValueField::edited, this, [this](double value) { emit edited(value); });
  connect(known_, &QCheckBox::clicked, this,
          [this](bool on) { emit edited(on ? std::optional<double>(field_->value()) : std::nullopt); });
}

void KnownField::setValue(const std::optional<double>& value) {
  known_->setChecked(value.has_value());
  if (!field_->hasFocus()) field_->setValue(value.value_or(0.0));
}

}  // namespace hapticell::app
