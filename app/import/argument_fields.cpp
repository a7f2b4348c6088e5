// SPDX-License-Identifier: Apache-2.0
#include "app/import/argument_fields.h"

#include <QLineEdit>
#include <QVBoxLayout>

#include "app/kit/form.h"

namespace hapticell::app {

ArgumentFields::ArgumentFields(QWidget* parent) : QWidget(parent) {
  setObjectName("importArguments");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
}

void ArgumentFields::setArguments(int file, const std::vector<xacro::DeclaredArgument>& arguments,
                                  const std::map<std::string, std::string>& values) {
  bool same = file == file_ && fields_.size() == arguments.size();
  for (const xacro::DeclaredArgument& one : arguments) same = same && fields_.count(one.name) > 0;
  if (!same) fill(arguments);
  file_ = file;
  setVisible(!arguments.empty());
  for (const auto& [name, field] : fields_) {
    const auto value = values.find(name);
    const QString text = value == values.end() ? QString() : QString::fromStdString(value->second);
    if (!field->hasFocus() && field->text() != text) field->setText(text);
  }
}

void ArgumentFields::fill(const std::vector<xacro::DeclaredArgument>& arguments) {
  delete rows_;
  fields_.clear();
  rows_ = new QWidget;
  auto* column = new QVBoxLayout(rows_);
  column->setContentsMargins(0, 0, 0, 0);
  layout()->addWidget(rows_);
  QVBoxLayout* section = addSection(*column, tr("Arguments"));
  for (const xacro::DeclaredArgument& one : arguments) {
    auto* field = new QLineEdit;
    const QString name = QString::fromStdString(one.name);
    field->setObjectName(QStringLiteral("importArgument_") + name);
    field->setAccessibleName(name);
    field->setPlaceholderText(one.otherwise ? QString::fromStdString(*one.otherwise) : tr("A value is needed"));
    addRow(*section, name, field);
    fields_[one.name] = field;
    connect(field, &QLineEdit::editingFinished, this, [this] { emit changed(values()); });
  }
}

std::map<std::string, std::string> ArgumentFields::values() const {
  std::map<std::string, std::string> values;
  for (const auto& [name, field] : fields_) {
    if (!field->text().isEmpty()) values[name] = field->text().toStdString();
  }
  return values;
}

}  // namespace hapticell::app
