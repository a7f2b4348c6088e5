// SPDX-License-Identifier: Apache-2.0
#include "app/studies/range_fields.h"

#include <QLineEdit>
#include <QRegularExpression>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <cmath>

#include "app/kit/form.h"
#include "app/studies/study_fields.h"
#include "app/style/segmented.h"
#include "app/style/value_field.h"
#include "trajectory/motion/number_text.h"

namespace hapticell::app {

using studies::StudyValue;

namespace {

enum Form { kRange, kList, kNormal };

/// Numbers of a document per shown one.
double perShown(RangeFields::Unit unit) {
  return unit == RangeFields::Unit::kLength ? 1e-3 : 1.0;
}

/// Without what arithmetic leaves behind the digits that anybody types.
double tidied(double value) {
  return std::round(value * 1e9) / 1e9;
}

}  // namespace

RangeFields::RangeFields(StudyDraft& draft, const studies::StudyPlace& place, Unit unit, QWidget* parent)
    : QWidget(parent), draft_(draft), place_(place), unit_(unit) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  form_ = new Segmented({tr("Range"), tr("List"), tr("Normal")});
  form_->setObjectName("segmentsRange");
  form_->setAccessibleName(tr("Kind of values"));
  column->addWidget(form_);
  pages_ = new QStackedWidget;
  column->addWidget(pages_);
  for (int i = 0; i < 3; ++i) {
    auto* page = new QWidget;
    auto* rows = new QVBoxLayout(page);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(6);
    pages_->addWidget(page);
  }
  addField(pages_->widget(kRange), "fieldFrom", tr("From"), "from");
  addField(pages_->widget(kRange), "fieldTo", tr("To"), "to");
  addSteps(pages_->widget(kRange));
  list_ = new QLineEdit;
  list_->setObjectName("editValues");
  list_->setPlaceholderText(unit_ == Unit::kLength ? tr("0.1, 0.2, … in metres") : tr("1, 2, …"));
  auto* rows = static_cast<QVBoxLayout*>(pages_->widget(kList)->layout());
  addRow(*rows, tr("Values"), list_, 60);
  rows->addStretch(1);
  addField(pages_->widget(kNormal), "fieldMiddle", tr("Mean"), "middle");
  addField(pages_->widget(kNormal), "fieldSigma", tr("Sigma"), "sigma");
  static_cast<QVBoxLayout*>(pages_->widget(kNormal)->layout())->addStretch(1);
  connect(form_, &Segmented::chosen, this, &RangeFields::chooseForm);
  connect(list_, &QLineEdit::editingFinished, this, &RangeFields::setList);
  refresh();
}

ValueField* RangeFields::addField(QWidget* page, const char* name, const QString& words, const char* key) {
  const char* unit = unit_ == Unit::kLength ? "mm" : "";
  auto* field = new ValueField({unit_ == Unit::kAngle ? tr("°") : QString::fromLatin1(unit),
                                unit_ == Unit::kPlain ? 3 : 1, -1e5, 1e5, unit_ == Unit::kLength ? 50.0 : 5.0});
  field->setObjectName(QString::fromLatin1(name));
  addRow(*static_cast<QVBoxLayout*>(page->layout()), words, field, 60);
  connect(field, &ValueField::edited, this, [this, key](double value) { setNumber(key, value); });
  fields_.emplace_back(key, field);
  return field;
}

ValueField* RangeFields::addSteps(QWidget* page) {
  auto* field = new ValueField({{}, 0, 0.0, 10'000.0, 1.0});
  field->setObjectName("fieldSteps");
  field->setToolTip(tr("Number of values for a grid; 0: any value between, for samples and searches"));
  addRow(*static_cast<QVBoxLayout*>(page->layout()), tr("Values"), field, 60);
  connect(field, &ValueField::edited, this, [this](double value) {
    draft_.set(place_, "steps", value >= 2.0 ? StudyValue(std::round(value)) : StudyValue());
  });
  fields_.emplace_back("steps", field);
  return field;
}

void RangeFields::refresh() {
  const auto has = [&](const char* key) { return !draft_.text().written(place_, key).empty(); };
  int form = has("sigma") || has("middle") ? kNormal : kRange;
  if (has("values")) form = kList;
  form_->setCurrent(form);
  pages_->setCurrentIndex(form);
  for (const auto& [key, field] : fields_) {
    const StudyValue value = draft_.text().value(place_, key);
    const auto* number = std::get_if<double>(&value);
    const double shown = std::string_view(key) == "steps" ? 1.0 : perShown(unit_);
    if (!field->hasFocus() || number != nullptr) field->setValue(number != nullptr ? *number / shown : 0.0);
  }
  const StudyValue values = draft_.text().value(place_, "values");
  if (const auto* numbers = std::get_if<std::vector<double>>(&values)) {
    QStringList words;
    for (const double number : *numbers) words << QString::fromStdString(trajectory::shortestText(number));
    list_->setText(words.join(QStringLiteral(", ")));
  }
}

void RangeFields::setNumber(const char* key, double shown) {
  draft_.set(place_, key, tidied(shown * perShown(unit_)));
}

/// Numbers with commas, spaces or semicolons between them; what is no number is left out and shown so.
void RangeFields::setList() {
  std::vector<double> numbers;
  const QStringList words =
      list_->text().split(QRegularExpression(QStringLiteral("[,;\\s]+")), Qt::SkipEmptyParts);
  for (const QString& word : words) {
    bool good = false;
    const double number = word.toDouble(&good);
    if (good && std::isfinite(number)) numbers.push_back(number);
  }
  if (!numbers.empty()) draft_.set(place_, "values", numbers);
  refresh();
}

void RangeFields::chooseForm(int form) {
  std::vector<std::pair<const char*, StudyValue>> values;
  for (const char* key : rangeKeys()) values.emplace_back(key, StudyValue());
  const auto now = [&](const char* key, double otherwise) {
    const StudyValue value = draft_.text().value(place_, key);
    const auto* number = std::get_if<double>(&value);
    return number != nullptr ? *number : otherwise;
  };
  // What was said stays as far as the other form can say it.
  const double from = now("from", now("middle", 0.0) - now("sigma", 0.1)),
               to = now("to", now("middle", 0.0) + now("sigma", 0.1));
  if (form == kRange) {
    values.insert(values.end(), {{"from", from}, {"to", to > from ? to : from + 1.0}, {"steps", 5.0}});
  } else if (form == kList) {
    values.emplace_back("values", std::vector<double>{from, to});
  } else {
    values.insert(values.end(), {{"middle", 0.5 * (from + to)}, {"sigma", std::max(0.001, 0.5 * (to - from))}});
  }
  draft_.setAll(place_, values);
  refresh();
}

}  // namespace hapticell::app
