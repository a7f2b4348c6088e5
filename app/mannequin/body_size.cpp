// SPDX-License-Identifier: Apache-2.0
#include "app/mannequin/body_size.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QVBoxLayout>
#include <array>
#include <cmath>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/kit/form.h"
#include "app/kit/thread_pool_task.h"
#include "app/mannequin/mannequin_context.h"
#include "app/mannequin/mannequin_edits.h"
#include "app/style/segmented.h"
#include "app/style/value_field.h"

namespace hapticell::app {
namespace {

using mannequin::Dimension;
using mannequin::Sex;

struct Boundary {
  Sex sex;
  double percentile;
};
constexpr std::array<Boundary, 4> kBoundaries{
    {{Sex::kFemale, 5}, {Sex::kFemale, 50}, {Sex::kMale, 50}, {Sex::kMale, 95}}};
/// Words of the dimensions, in their order; ANSUR II's own names stand in the tool tip.
constexpr std::array<const char*, mannequin::kDimensionCount> kDimensions{
    QT_TRANSLATE_NOOP("BodySize", "Stature"),
    QT_TRANSLATE_NOOP("BodySize", "Height of the neck"),
    QT_TRANSLATE_NOOP("BodySize", "Height of the shoulder"),
    QT_TRANSLATE_NOOP("BodySize", "Height of the sternum"),
    QT_TRANSLATE_NOOP("BodySize", "Height of the tenth rib"),
    QT_TRANSLATE_NOOP("BodySize", "Height of the iliac crest"),
    QT_TRANSLATE_NOOP("BodySize", "Height of the hip joint"),
    QT_TRANSLATE_NOOP("BodySize", "Height of the crotch"),
    QT_TRANSLATE_NOOP("BodySize", "Height of the knee"),
    QT_TRANSLATE_NOOP("BodySize", "Height of the ankle"),
    QT_TRANSLATE_NOOP("BodySize", "Sitting height"),
    QT_TRANSLATE_NOOP("BodySize", "Eye height, sitting"),
    QT_TRANSLATE_NOOP("BodySize", "Upper arm"),
    QT_TRANSLATE_NOOP("BodySize", "Forearm"),
    QT_TRANSLATE_NOOP("BodySize", "Hand length"),
    QT_TRANSLATE_NOOP("BodySize", "Palm length"),
    QT_TRANSLATE_NOOP("BodySize", "Hand breadth"),
    QT_TRANSLATE_NOOP("BodySize", "Distance of the shoulder joints"),
    QT_TRANSLATE_NOOP("BodySize", "Shoulder breadth"),
    QT_TRANSLATE_NOOP("BodySize", "Breadth of the pelvis"),
    QT_TRANSLATE_NOOP("BodySize", "Hip breadth"),
    QT_TRANSLATE_NOOP("BodySize", "Chest depth"),
    QT_TRANSLATE_NOOP("BodySize", "Belly depth, sitting"),
    QT_TRANSLATE_NOOP("BodySize", "Thigh clearance"),
    QT_TRANSLATE_NOOP("BodySize", "Foot length"),
    QT_TRANSLATE_NOOP("BodySize", "Heel to ball"),
    QT_TRANSLATE_NOOP("BodySize", "Foot breadth"),
    QT_TRANSLATE_NOOP("BodySize", "Head length"),
    QT_TRANSLATE_NOOP("BodySize", "Head breadth"),
    QT_TRANSLATE_NOOP("BodySize", "Ear to top of head"),
    QT_TRANSLATE_NOOP("BodySize", "Mass")};
// ms after the last change of a size until a figure is made: a slider's pause. Half: figures for nothing; twice: it
// lags.
constexpr int kDebounceMilliseconds = 180;

QString percentileText(double percentile) {
  if (percentile < 1.0) return BodySize::tr("< P 1");
  return percentile > 99.0 ? BodySize::tr("> P 99") : BodySize::tr("P %1").arg(percentile, 0, 'f', 0);
}

}  // namespace

BodySize::BodySize(MannequinContext& context, QWidget* parent) : QWidget(parent), context_(context) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(6);
  boundary_ = new Segmented({tr("P5 w."), tr("P50 w."), tr("P50 m."), tr("P95 m.")});
  boundary_->setToolTip(tr("The sizes that cover most users: P5 and P50 woman, P50 and P95 man"));
  boundary_->setObjectName("segmentsBoundary");
  rows->addWidget(boundary_);
  sex_ = new Segmented({tr("Woman"), tr("Man")});
  sex_->setObjectName("segmentsSex");
  addRow(*rows, tr("Sex"), sex_, 72);
  stature_ = new ValueField({tr("mm"), 0, 1000.0 * mannequin::kLeastStature, 1000.0 * mannequin::kMostStature, 10.0});
  stature_->setObjectName("fieldStature");
  mass_ = new ValueField({tr("kg"), 1, 20.0, 250.0, 1.0});
  mass_->setObjectName("fieldMass");
  addRow(*rows, tr("Stature, mass"), sideBySide({stature_, mass_}), 92);
  stature_->setAccessibleName(tr("Stature"));
  mass_->setAccessibleName(tr("Mass"));
  auto* line = new QWidget;
  auto* row = new QHBoxLayout(line);
  row->setContentsMargins(0, 0, 0, 0);
  percentile_ = new QSlider(Qt::Horizontal);
  percentile_->setObjectName("sliderPercentile");
  percentile_->setRange(1, 99);
  percentile_text_ = makeLabel({}, TextRole::kText);
  percentile_text_->setMinimumWidth(40);
  percentile_text_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row->addWidget(percentile_, 1);
  row->addWidget(percentile_text_);
  addRow(*rows, tr("Percentile"), line, 92);
  percentile_->setAccessibleName(tr("Percentile of stature"));
  addMeasures();
  wait_.setSingleShot(true);
  wait_.setInterval(kDebounceMilliseconds);
  connect(&wait_, &QTimer::timeout, this, &BodySize::begin);
  connect(boundary_, &Segmented::chosen, this, [this](int i) {
    const Boundary& chosen = kBoundaries[static_cast<std::size_t>(i)];
    ask({chosen.sex, *mannequin::statureOfPercentile(chosen.sex, chosen.percentile)});
  });
  connect(sex_, &Segmented::chosen, this, [this](int i) {
    const mannequin::BodyRequest now = present();
    const double percentile = std::clamp(mannequin::percentileOfStature(now.sex, now.stature), 0.2, 99.8);
    const Sex sex = i == 0 ? Sex::kFemale : Sex::kMale;
    ask({sex, *mannequin::statureOfPercentile(sex, percentile)});
  });
  connect(stature_, &ValueField::edited, this, [this](double millimetres) {
    mannequin::BodyRequest request = present();
    request.stature = millimetres / 1000.0;
    request.mass.reset();
    ask(request);
  });
  connect(mass_, &ValueField::edited, this, [this](double kilograms) {
    mannequin::BodyRequest request = present();
    request.mass = kilograms;
    ask(request);
  });
  connect(percentile_, &QSlider::valueChanged, this, [this](int value) {
    mannequin::BodyRequest request = present();
    request.stature = *mannequin::statureOfPercentile(request.sex, value);
    request.mass.reset();
    percentile_text_->setText(tr("P %1").arg(value));
    wanted_ = request;
    wait_.start();
  });
}

void BodySize::addMeasures() {
  dimension_ = new QComboBox;
  dimension_->setObjectName("comboMeasure");
  for (std::size_t i = 0; i < mannequin::kDimensionCount; ++i) {
    const auto dimension = static_cast<Dimension>(i);
    if (dimension == Dimension::kStature || dimension == Dimension::kMass) continue;
    const auto name = mannequin::nameOf(dimension);
    dimension_->addItem(tr(kDimensions[i]), static_cast<int>(i));
    dimension_->setItemData(dimension_->count() - 1,
                            QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size())), Qt::ToolTipRole);
  }
  dimension_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  dimension_->setMinimumContentsLength(8);
  measure_ = new ValueField({tr("mm"), 0, 10.0, 2300.0, 1.0});
  measure_->setObjectName("fieldMeasure");
  measure_->setToolTip(tr("A measure of the person replaces the most likely value of the survey (ANSUR II)"));
  auto* pair = sideBySide({dimension_, measure_});
  if (auto* line = qobject_cast<QHBoxLayout*>(pair->layout())) line->setStretch(0, 2);
  addRow(*qobject_cast<QVBoxLayout*>(layout()), tr("Measured value"), pair, 92);
  connect(dimension_, &QComboBox::activated, this, &BodySize::showMeasure);
  connect(measure_, &ValueField::edited, this, [this](double millimetres) {
    mannequin::BodyRequest request = present();
    request.own[dimension_->currentData().toUInt()] = millimetres / 1000.0;
    ask(request);
  });
}

mannequin::BodyRequest BodySize::present() const {
  return wait_.isActive() || busy_ ? wanted_ : requestOf(*context_.entity());
}

void BodySize::ask(const mannequin::BodyRequest& request) {
  wanted_ = request;
  begin();
}

void BodySize::begin() {
  wait_.stop();
  const workcell::Entity* entity = context_.entity();
  if (!entity || !context_.isFree()) return showNow();
  if (busy_) {
    again_ = true;
    return;
  }
  busy_ = true;
  runInThreadPool(
      this, [entity = *entity, request = wanted_] { return resizeCommands(entity, request); },
      [this, id = entity->id](Expected<std::vector<workcell::Command>> commands) {
        busy_ = false;
        const workcell::Entity* now = context_.entity();
        if (!commands) {
          context_.host().messages().reportCause(Severity::kWarning, tr("No mannequin of that size"), commands.error());
        } else if (now && now->id == id && context_.isFree()) {
          context_.host().documentModel().executeAll(tr("Resize %1").arg(QString::fromStdString(now->name)), *commands);
        }
        if (again_) {
          again_ = false;
          return begin();
        }
        showNow();
      });
}

void BodySize::showNow() {
  const workcell::Entity* entity = context_.entity();
  setEnabled(entity && context_.isFree());
  if (!entity || wait_.isActive() || busy_) return;
  const mannequin::Figure& figure = *entity->figure();
  const double stature = figure.body[Dimension::kStature];
  int boundary = -1;
  for (std::size_t i = 0; i < kBoundaries.size(); ++i) {
    const Boundary& one = kBoundaries[i];
    const double its = *mannequin::statureOfPercentile(one.sex, one.percentile);
    if (one.sex == figure.sex && std::abs(its - stature) < mannequin::kSameStature) boundary = static_cast<int>(i);
  }
  boundary_->setCurrent(boundary);
  sex_->setCurrent(figure.sex == Sex::kFemale ? 0 : 1);
  if (!stature_->hasFocus()) stature_->setValue(1000.0 * stature);
  if (!mass_->hasFocus()) mass_->setValue(figure.totalMass());
  const double percentile = mannequin::percentileOfStature(figure.sex, stature);
  const QSignalBlocker quiet(percentile_);
  if (!percentile_->isSliderDown()) percentile_->setValue(static_cast<int>(std::lround(percentile)));
  percentile_text_->setText(percentileText(percentile));
  showMeasure();
}

void BodySize::showMeasure() {
  if (!context_.entity() || measure_->hasFocus()) return;
  measure_->setValue(1000.0 * context_.entity()->figure()->body.values[dimension_->currentData().toUInt()]);
}

}  // namespace hapticell::app
