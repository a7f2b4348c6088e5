// SPDX-License-Identifier: Apache-2.0
#include "app/panels/cell/solid_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/controls/color_choice.h"
#include "app/controls/pose_text.h"
#include "app/controls/reference_choice.h"
#include "app/edit/moved_entities.h"
#include "app/edit/part_sizes.h"
#include "app/host/document_model.h"
#include "app/host/hold_choice.h"
#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/kit/form.h"
#include "app/kit/swatch_row.h"
#include "app/panels/cell/solid_place.h"
#include "app/style/segmented.h"
#include "app/style/style_painting.h"
#include "app/style/units.h"
#include "app/style/value_field.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

constexpr const char* kCurves = "solid";

/// The middle of the solid's bounds in its own frame, as the hand takes it by kGeometricCenter.
dvec3 centerOf(const workcell::Entity& solid) {
  const geometry::Bounds bounds = solid.mesh()->bounds();
  return 0.5 * (bounds.min + bounds.max);
}

/// Three axes with letters, each `length` long.
void appendAxes(const Pose& X_WF, double length, std::vector<SceneCurve>& curves) {
  const SceneCurve::Role roles[]{SceneCurve::Role::kAxisX, SceneCurve::Role::kAxisY, SceneCurve::Role::kAxisZ};
  for (int i = 0; i < 3; ++i)
    curves.push_back({{X_WF.p, X_WF * (length * dvec3(i == 0, i == 1, i == 2))},
                      roles[i],
                      SceneCurve::Style::kSolid,
                      2.0,
                      std::string(1, "XYZ"[i])});
}

}  // namespace

SolidPanel::SolidPanel(Host& host, QWidget* parent) : QWidget(parent), host_(host) {
  setMinimumWidth(320);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  nothing_ = makeLabel(tr("No solid is selected. Click a part in the scene or in the tree."), TextRole::kText, true);
  nothing_->setWordWrap(true);
  nothing_->setContentsMargins(12, 12, 12, 12);
  column->addWidget(nothing_);
  content_ = new QWidget;
  auto* inside = new QVBoxLayout(content_);
  inside->setContentsMargins(0, 0, 0, 0);
  inside->setSpacing(0);
  addTurn(*inside);
  place_ = new SolidPlace(host_, *inside, this);
  sizes_ = new PartSizes(host_);
  inside->addWidget(sizes_);
  addFeel(*inside);
  addFlags(*inside);
  column->addWidget(content_);
  column->addStretch(1);
  connect(&host_.selection(), &Selection::changed, this, &SolidPanel::rebuild);
  connect(&host_.documentModel(), &DocumentModel::changed, this, &SolidPanel::rebuild);
  connect(&host_.holdChoice(), &HoldChoice::changed, this, &SolidPanel::rebuild);
  rebuild();
}

void SolidPanel::addTurn(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, {});
  title_ = makeLabel({}, TextRole::kPanelState);
  title_->setObjectName("labelSolid");
  section->addWidget(title_);
  turns_ = new Segmented({tr("Own origin"), tr("Centre"), tr("Frame")});
  turns_->setObjectName("segmentsTurns");
  addRow(*section, tr("Pivot"), turns_);
  frame_ = new QComboBox;
  frame_->setObjectName("comboOwnFrame");
  frame_row_ = addRow(*section, tr("Frame"), frame_);
  new_frame_ = new QPushButton(tr("New frame…"));
  new_frame_->setObjectName("buttonNewFrame");
  new_frame_->setToolTip(tr("Add a frame to this solid on picked geometry"));
  addRow(*section, {}, new_frame_);
  turn_note_ = makeLive(2, TextRole::kSecond, true);
  turn_note_->setObjectName("labelTurns");
  turn_note_->setContentsMargins(kLabelColumn, 0, 0, 0);
  section->addWidget(turn_note_);
  connect(turns_, &Segmented::chosen, this, [this](int index) {
    const HoldChoice::MovedBy ways[]{by::Origin{}, by::Center{}, by::Frame{frame_->currentText().toStdString()}};
    host_.holdChoice().set(ways[index]);
  });
  connect(frame_, &QComboBox::activated, this,
          [this] { host_.holdChoice().set(by::Frame{frame_->currentText().toStdString()}); });
  connect(new_frame_, &QPushButton::clicked, this, &SolidPanel::pickFrame);
}

void SolidPanel::addFeel(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, {});
  force_class_ = new Segmented({tr("Constant"), tr("Contact"), tr("Dynamics")});
  force_class_->setObjectName("segmentsSolidForce");
  addRow(*section, tr("Force"), force_class_);
  material_ = new QComboBox;
  material_->setObjectName("comboSolidMaterial");
  for (const auto& [key, material] : host_.configuration().materials) {
    QString name = QString::fromStdString(key);
    name[0] = name[0].toUpper();
    material_->addItem(tr("%1, µ %2").arg(name).arg(material.friction, 0, 'f', 2), QString::fromStdString(key));
  }
  addRow(*section, tr("Material"), material_);
  mass_ = new ValueField({tr("kg"), 2, 0.01, 10000.0, 0.1});
  mass_->setObjectName("fieldSolidMass");
  mass_->setToolTip(tr("Felt with force class Dynamics; adds to the load of the robot that carries it"));
  addRow(*section, tr("Mass"), mass_);
  on_contact_ = new Segmented({tr("Stop"), tr("Slide"), tr("Pass")});
  on_contact_->setObjectName("segmentsSolidOnContact");
  addRow(*section, tr("On contact"), on_contact_);
  connect(force_class_, &Segmented::chosen, this,
          [this](int i) { execute({.force_class = static_cast<workcell::ForceClass>(i)}); });
  connect(material_, &QComboBox::activated, this,
          [this](int i) { execute({.material = material_->itemData(i).toString().toStdString()}); });
  connect(mass_, &ValueField::edited, this, [this](double kg) { execute({.mass = kg}); });
  connect(on_contact_, &Segmented::chosen, this,
          [this](int i) { execute({.on_contact = static_cast<workcell::OnContact>(i)}); });
}

void SolidPanel::addFlags(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, {});
  checked_ = new QCheckBox(tr("Checked for collision"));
  locked_ = new QCheckBox(tr("Locked in place"));
  visible_ = new QCheckBox(tr("Visible"));
  checked_->setObjectName("switchChecked");
  locked_->setObjectName("switchLocked");
  visible_->setObjectName("switchShown");
  triangles_ = makeLabel({}, TextRole::kSecond, true);
  for (QCheckBox* box : {checked_, locked_, visible_}) {
    box->setMinimumHeight(24);
    auto* row = new QHBoxLayout;
    row->addWidget(box, 1);
    if (box == checked_) row->addWidget(triangles_);
    section->addLayout(row);
  }
  color_ = new SwatchRow(quietColors());
  color_->offerOther();
  color_->setObjectName("swatchSolid");
  addRow(*section, tr("Colour"), color_);
  connect(checked_, &QCheckBox::clicked, this, [this](bool on) { execute({.checked = on}); });
  connect(locked_, &QCheckBox::clicked, this, [this](bool on) { execute({.locked = on}); });
  connect(visible_, &QCheckBox::clicked, this, [this](bool on) { execute({.visible = on}); });
  const auto paint = [this](const QColor& color) { execute({.color = channelsOf(color)}); };
  connect(color_, &SwatchRow::chosen, this, paint);
  connect(color_, &SwatchRow::otherWanted, this, [this, paint] { choosePartColor(host_, color_->current(), paint); });
}

const workcell::Entity* SolidPanel::solid() const {
  const workcell::Entity* entity = host_.documentModel().document().find(host_.selection().current());
  return entity && entity->kind() == workcell::EntityKind::kSolid && entity->mesh() ? entity : nullptr;
}

const workcell::DocumentState& SolidPanel::state() const {
  return host_.documentModel().document().state();
}

void SolidPanel::execute(workcell::SetProperties change) {
  if (!solid()) return;
  change.id = solid()->id;
  if (!host_.documentModel().execute(change)) rebuild();
}

void SolidPanel::rebuild() {
  const workcell::Entity* now = solid();
  nothing_->setVisible(!now);
  content_->setVisible(now);
  if (now) {
    title_->setText(QString::fromStdString(now->name));
    showTurn(*now);
    showFeel(*now);
    sizes_->showPart(*now);
  }
  showNow();
}

void SolidPanel::showTurn(const workcell::Entity& solid) {
  frame_->clear();
  for (const workcell::Frame& frame : solid.frames) frame_->addItem(QString::fromStdString(frame.name));
  const HoldChoice& hold = host_.holdChoice();
  const int index = hold.turnsAbout();
  turns_->setChoiceEnabled(2, !solid.frames.empty(), tr("This solid has no frame yet. Add one below."));
  turns_->setCurrent(index);
  frame_row_->setVisible(index == 2);
  if (index == 2) frame_->setCurrentText(QString::fromStdString(hold.frame()));
  if (index == 1)
    turn_note_->setText(tr("Geometric centre, %1 from own origin").arg(lengthText(glm::length(centerOf(solid)))));
  else if (index == 2)
    turn_note_->setText(tr("Own frame %1").arg(frame_->currentText()));
  else
    turn_note_->setText(tr("Own origin, from the file"));
}

void SolidPanel::showFeel(const workcell::Entity& solid) {
  force_class_->setCurrent(static_cast<int>(solid.contact.force_class));
  on_contact_->setCurrent(static_cast<int>(solid.contact.on_contact));
  material_->setCurrentIndex(material_->findData(QString::fromStdString(solid.contact.material)));
  if (!mass_->hasFocus()) mass_->setValue(solid.contact.mass);
  checked_->setChecked(solid.checked);
  locked_->setChecked(solid.locked);
  visible_->setChecked(solid.visible);
  triangles_->setText(
      tr("%1 triangles").arg(QLocale().toString(static_cast<qulonglong>(solid.mesh()->triangles.size()))));
  color_->setCurrent(QColor::fromRgbF(solid.color[0], solid.color[1], solid.color[2]));
  place_->showChoices(solid);
}

void SolidPanel::showNow() {
  const workcell::Entity* now = solid();
  if (now && isSeen(*this)) place_->showNow(*now);
  showMarks();
}

/// Own origin, centre and frames in the scene; what it turns about has axes.
void SolidPanel::showMarks() {
  std::vector<SceneCurve> curves;
  const workcell::Entity* now = solid();
  if (now && isSeen(*this)) {
    const Pose X_WE = host_.viewport().scene().placement_W(*now);
    const HoldChoice& hold = host_.holdChoice();
    const double length = 0.5 * glm::length(now->mesh()->bounds().size()) + 0.03;
    const Pose center = X_WE * Pose::translation(centerOf(*now));
    const bool by_center = hold.is<by::Center>();
    const Pose* taken = by_center ? &center : &X_WE;
    std::vector<std::pair<Pose, std::string>> marks{{X_WE, tr("origin").toStdString()},
                                                    {center, tr("centre").toStdString()}};
    for (const workcell::Frame& frame : now->frames) marks.emplace_back(X_WE * frame.X_EF, frame.name);
    for (std::size_t i = 2; i < marks.size(); ++i)
      if (hold.is<by::Frame>() && marks[i].second == hold.frame()) taken = &marks[i].first;
    for (const auto& [X_WF, name] : marks)
      curves.push_back({{X_WF.p}, SceneCurve::Role::kSelection, SceneCurve::Style::kSolid, 1.6, name});
    appendAxes(*taken, length, curves);
  }
  host_.viewport().setCurves(kCurves, std::move(curves));
}

void SolidPanel::pickFrame() {
  const workcell::Entity* now = solid();
  if (!now) return;
  host_.viewport().startPick(
      {{true, true, true},
       tr("Pick the place for the frame · Esc: end"),
       [self = QPointer(this), id = now->id](const std::optional<PickedFeature>& feature) {
         const workcell::Entity* entity = self && feature ? self->host_.documentModel().document().find(id) : nullptr;
         if (!entity) return;
         std::vector<workcell::Frame> frames = entity->frames;
         std::string name;
         const auto taken = [&] {
           return std::any_of(frames.begin(), frames.end(), [&](const auto& frame) { return frame.name == name; });
         };
         for (int n = 1; name.empty() || taken(); ++n) name = "frame " + std::to_string(n);
         const Pose X_WE = self->host_.viewport().scene().placement_W(*entity);
         frames.push_back({name, X_WE.inverse() * featureFrame_W(*feature)});
         if (self->host_.documentModel().execute(workcell::SetFrames{id, std::move(frames)}))
           self->host_.holdChoice().set(by::Frame{name});
       }});
}

}  // namespace hapticell::app
