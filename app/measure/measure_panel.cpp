// SPDX-License-Identifier: Apache-2.0
#include "app/measure/measure_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/kit/form.h"
#include "app/style/icon.h"
#include "app/style/segmented.h"
#include "app/style/units.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

constexpr const char* kCurves = "measure";

QString pickPrompt(bool part, bool second) {
  if (part) return second ? MeasurePanel::tr("Pick the other part") : MeasurePanel::tr("Pick a part to measure from");
  return second ? MeasurePanel::tr("Pick what to measure to") : MeasurePanel::tr("Pick what to measure");
}

QString aboutParts(const QString& both, const collision::DistanceResult& result) {
  if (result.contained) return MeasurePanel::tr("%1: one lies inside the other").arg(both);
  if (result.colliding) return MeasurePanel::tr("%1: they touch or overlap").arg(both);
  return MeasurePanel::tr("%1, minimum distance").arg(both);
}

}  // namespace

MeasurePanel::MeasurePanel(Host& host, QWidget* parent)
    : QWidget(parent), host_(host), cache_(std::make_shared<ColliderCache>()) {
  setMinimumWidth(320);
  worker_.setMaxThreadCount(1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  addTop(*column);
  QVBoxLayout* section = addSection(*column, {});
  about_ = makeLive(2, TextRole::kSecond, true);
  about_->setObjectName("labelMeasured");
  number_ = makeLabel({}, TextRole::kPanelNumber);
  number_->setObjectName("labelMeasure");
  number_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  number_->setAccessibleName(tr("Measure"));
  section->addWidget(number_);
  section->addWidget(about_);
  rows_ = new QFormLayout;
  rows_->setHorizontalSpacing(12);
  rows_->setVerticalSpacing(6);
  section->addLayout(rows_);
  copy_ = new QPushButton(icon("copy"), tr("Copy"));
  copy_->setObjectName("buttonCopyMeasure");
  clear_ = new QPushButton(tr("Clear"));
  clear_->setObjectName("buttonClearMeasure");
  auto* buttons = new QHBoxLayout;
  buttons->addStretch(1);
  buttons->addWidget(clear_);
  buttons->addWidget(copy_);
  section->addLayout(buttons);
  column->addStretch(1);
  connect(copy_, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(text()); });
  connect(clear_, &QPushButton::clicked, this, [this] {
    picked_.clear();
    measurePicked();
  });
  connect(&host_.documentModel(), &DocumentModel::closing, this, [this] {
    end();
    picked_.clear();
    measurePicked();
    pick_->setEnabled(true);
    note_->setText({});
  });
  measurePicked();
}

MeasurePanel::~MeasurePanel() {
  if (current_) *current_ = false;
  worker_.waitForDone();
}

void MeasurePanel::addTop(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, {});
  what_ = new Segmented({tr("Any"), tr("Corner"), tr("Edge"), tr("Face"), tr("Parts")});
  what_->setObjectName("segmentsMeasure");
  what_->setCurrent(0);
  what_->setAccessibleName(tr("What to pick"));
  section->addWidget(what_);
  note_ = makeLive(2, TextRole::kSecond, true);
  pick_ = new QPushButton(tr("Pick"));
  pick_->setObjectName("buttonMeasurePick");
  pick_->setProperty("main", true);
  auto* row = new QHBoxLayout;
  row->addWidget(note_, 1);
  row->addWidget(pick_);
  section->addLayout(row);
  connect(pick_, &QPushButton::clicked, this, &MeasurePanel::begin);
  connect(what_, &Segmented::chosen, this, [this] {
    picked_.clear();
    measurePicked();
    begin();
  });
}

MeasurePanel::What MeasurePanel::what() const {
  return static_cast<What>(std::max(0, what_->current()));
}

void MeasurePanel::begin() {
  if (host_.viewport().isPicking()) host_.viewport().cancelPick();
  picking_ = true;
  pick();
}

void MeasurePanel::end() {
  const bool was = std::exchange(picking_, false);
  if (was && host_.viewport().isPicking()) host_.viewport().cancelPick();
  host_.viewport().setCurves(kCurves, {});
}

void MeasurePanel::pick() {
  if (!picking_) return;
  const What kind = what();
  const bool any = kind == What::kAny;
  FeatureFilter filter{any || kind == What::kFaces || kind == What::kParts, any || kind == What::kEdges,
                       any || kind == What::kCorners};
  const QString prompt = pickPrompt(kind == What::kParts, picked_.size() == 1);
  note_->setText(prompt);
  pick_->setEnabled(false);
  host_.viewport().startPick(
      {filter, prompt + tr(" · Esc: end"), [self = QPointer(this)](const std::optional<PickedFeature>& feature) {
         if (!self) return;
         if (feature) return self->take(*feature);
         self->picking_ = false;
         self->pick_->setEnabled(true);
         self->note_->setText(self->tr("Click Pick to measure again."));
       }});
}

void MeasurePanel::take(const PickedFeature& feature) {
  if (picked_.size() >= 2) picked_.clear();
  picked_.push_back(feature);
  measurePicked();
  // Queued: the viewport is still answering.
  QMetaObject::invokeMethod(this, &MeasurePanel::pick, Qt::QueuedConnection);
}

QString MeasurePanel::nameOf(const PickedFeature& feature) const {
  const workcell::Entity* entity = host_.documentModel().document().find(feature.entity);
  const QString of = entity ? QString::fromStdString(entity->name) : QString();
  if (what() == What::kParts) return of;
  return tr("%1 of %2").arg(QString::fromStdString(featureText(feature)), of);
}

void MeasurePanel::measurePicked() {
  if (current_) *current_ = false;
  clearRows();
  copy_->setEnabled(false);
  clear_->setEnabled(!picked_.empty());
  if (picked_.empty()) {
    number_->setText(QStringLiteral("–"));
    about_->setText(tr("Nothing is picked yet. The middle button and the wheel still move the view."));
    host_.viewport().setCurves(kCurves, {});
    host_.viewport().refresh();
    return;
  }
  if (what() == What::kParts) {
    number_->setText(QStringLiteral("–"));
    about_->setText(nameOf(picked_.front()));
    if (picked_.size() == 2) measureParts(picked_[0].entity, picked_[1].entity);
    return;
  }
  const Measurement m = picked_.size() == 1 ? measure(picked_[0]) : measure(picked_[0], picked_[1]);
  showRows(m, picked_.size() == 1 ? nameOf(picked_[0]) : tr("%1 to %2").arg(nameOf(picked_[0]), nameOf(picked_[1])));
  draw(m);
}

void MeasurePanel::measureParts(workcell::EntityId a, workcell::EntityId b) {
  if (a == b) {
    about_->setText(tr("That is the same part. Pick another one to measure to."));
    picked_.pop_back();
    return;
  }
  about_->setText(tr("%1 to %2: measuring…").arg(nameOf(picked_[0]), nameOf(picked_[1])));
  const SceneModel& scene = host_.viewport().scene();
  auto meshes_a = placedMeshes(scene, a), meshes_b = placedMeshes(scene, b);
  auto current = std::make_shared<std::atomic<bool>>(true);
  current_ = current;
  worker_.start(
      [self = QPointer(this), current, cache = cache_, meshes_a = std::move(meshes_a), meshes_b = std::move(meshes_b)] {
        const auto result = partDistance(meshes_a, meshes_b, *cache, [current] { return !current->load(); });
        QMetaObject::invokeMethod(qApp, [self, current, result] {
          if (self && *current) self->showParts(result);
        });
      });
}

void MeasurePanel::showParts(const std::optional<collision::DistanceResult>& result) {
  if (picked_.size() != 2) return;
  const QString both = tr("%1 to %2").arg(nameOf(picked_[0]), nameOf(picked_[1]));
  if (!result) {
    about_->setText(tr("%1: one part has no shape to measure.").arg(both));
    return;
  }
  Measurement m;
  m.distance = result->distance;
  m.p_WA = result->p_WA;
  m.p_WB = result->p_WB;
  showRows(m, aboutParts(both, *result));
  draw(m);
}

void MeasurePanel::showRows(const Measurement& m, const QString& about) {
  about_->setText(about);
  lines_ = {about};
  if (m.distance)
    addRow(m.between_picks ? tr("Between the picked places") : tr("Distance"), lengthText(*m.distance), true);
  if (m.length) addRow(tr("Length"), lengthText(*m.length), !m.distance);
  if (m.radius) {
    addRow(tr("Radius"), lengthText(*m.radius), !m.distance && !m.length);
    addRow(tr("Diameter"), lengthText(2.0 * *m.radius));
  }
  const dvec3 d = m.p_WB - m.p_WA;
  if (m.distance) {
    addRow(QStringLiteral("ΔX"), lengthText(d.x));
    addRow(QStringLiteral("ΔY"), lengthText(d.y));
    addRow(QStringLiteral("ΔZ"), lengthText(d.z));
  } else {
    addRow(tr("At X"), lengthText(m.p_WA.x), !m.length && !m.radius);
    addRow(tr("At Y"), lengthText(m.p_WA.y));
    addRow(tr("At Z"), lengthText(m.p_WA.z));
  }
  if (m.angle) addRow(tr("Angle"), angleText(*m.angle));
  if (m.between_axes) addRow(tr("Between centres or axes"), lengthText(*m.between_axes));
  copy_->setEnabled(true);
}

void MeasurePanel::addRow(const QString& name, const QString& value, bool main) {
  lines_ << name + QLatin1Char('\t') + value;
  if (main) number_->setText(value);
  auto* label = makeLabel(name, TextRole::kText, true);
  auto* shown = makeLabel(value, TextRole::kText);
  shown->setAlignment(Qt::AlignRight);
  shown->setTextInteractionFlags(Qt::TextSelectableByMouse);
  rows_->addRow(label, shown);
}

void MeasurePanel::clearRows() {
  while (rows_->rowCount() > 0) rows_->removeRow(0);
  lines_.clear();
}

QString MeasurePanel::text() const {
  return lines_.join(QLatin1Char('\n'));
}

void MeasurePanel::draw(const Measurement& m) {
  using Role = SceneCurve::Role;
  using Style = SceneCurve::Style;
  std::vector<SceneCurve> curves;
  for (const PickedFeature& feature : picked_)
    if (what() != What::kParts)
      for (const auto& line : feature.outline_W) curves.push_back({line, Role::kSelection, Style::kSolid, 2.5});
  if (!m.distance) {
    curves.push_back({{m.p_WA}, Role::kSelection, Style::kSolid, 2.0, number_->text().toStdString()});
  } else {
    const dvec3 x(m.p_WB.x, m.p_WA.y, m.p_WA.z), y(m.p_WB.x, m.p_WB.y, m.p_WA.z);
    curves.push_back({{m.p_WA, x}, Role::kAxisX, Style::kDashed, 1.5});
    curves.push_back({{x, y}, Role::kAxisY, Style::kDashed, 1.5});
    curves.push_back({{y, m.p_WB}, Role::kAxisZ, Style::kDashed, 1.5});
    curves.push_back({{m.p_WA, m.p_WB}, Role::kSelection, Style::kSolid, 2.5});
    curves.push_back({{m.p_WA}, Role::kSelection, Style::kSolid, 2.0});
    curves.push_back({{m.p_WB}, Role::kSelection, Style::kSolid, 2.0});
    curves.push_back(
        {{0.5 * (m.p_WA + m.p_WB)}, Role::kSelection, Style::kSolid, 1.0, lengthText(*m.distance).toStdString()});
  }
  host_.viewport().setCurves(kCurves, std::move(curves));
  host_.viewport().refresh();
}

}  // namespace hapticell::app
