// SPDX-License-Identifier: Apache-2.0
#include "app/edit/move_panel.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "app/controls/pose_text.h"
#include "app/controls/reference_choice.h"
#include "app/host/document_model.h"
#include "app/host/hold_choice.h"
#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/host/user_settings.h"
#include "app/kit/form.h"
#include "app/style/segmented.h"
#include "app/style/value_field.h"

namespace hapticell::app {
namespace {

using Mode = EntityGizmo::Mode;

constexpr int kFrameAxes = static_cast<int>(EditAxes::kFrame);

QCheckBox* makeSwitch(const QString& text, const char* name) {
  auto* box = new QCheckBox(text);
  box->setMinimumHeight(26);
  box->setObjectName(QLatin1String(name));
  return box;
}

QString selectionTitle(int selected, const workcell::Entity* last) {
  if (selected > 1) return MovePanel::tr("%n selected", nullptr, selected);
  return last ? QString::fromStdString(last->name) : MovePanel::tr("Nothing is selected");
}

QString selectionNote(std::size_t selected, bool moves) {
  if (selected == 0) return MovePanel::tr("Click a part, or draw a box around several.");
  if (!moves) return MovePanel::tr("It is locked in place. Unlock it in the tree first.");
  return selected > 1 ? MovePanel::tr("They move together. The last one selected is the pivot.") : QString();
}

}  // namespace

MovePanel::MovePanel(Host& host, EntityGizmo& gizmo, QWidget* parent) : QWidget(parent), host_(host), gizmo_(gizmo) {
  setMinimumWidth(320);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  addTool(*column);
  addNumbers(*column);
  addSteps(*column);
  addOnto(*column);
  column->addStretch(1);
  connect(&gizmo_, &EntityGizmo::modeChanged, this, &MovePanel::showTool);
  connect(&gizmo_, &EntityGizmo::dragged, this, &MovePanel::showMotion);
  connect(&host_.selection(), &Selection::allChanged, this, &MovePanel::showSelection);
  connect(&host_.documentModel(), &DocumentModel::changed, this, &MovePanel::showSelection);
  connect(&host_.holdChoice(), &HoldChoice::changed, this, &MovePanel::showTool);
  readSettings();
  showTool();
  showSelection();
}

void MovePanel::addTool(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, {});
  title_ = makeLabel({}, TextRole::kPanelState);
  title_->setObjectName("labelMoved");
  section->addWidget(title_);
  note_ = makeLive(2, TextRole::kSecond, true);
  section->addWidget(note_);
  mode_ = new Segmented({tr("Select"), tr("Move"), tr("Rotate")});
  mode_->setObjectName("segmentsTool");
  addRow(*section, tr("Tool"), mode_);
  axes_ = new Segmented({tr("World"), tr("Parent"), tr("Local"), tr("Frame")});
  axes_->setObjectName("segmentsEditAxes");
  addRow(*section, tr("Axes"), axes_);
  frame_ = new ReferenceChoice(host_, {});
  frame_->setObjectName("comboEditFrame");
  frame_row_ = addRow(*section, tr("Frame"), frame_);
  about_ = new Segmented({tr("Own origin"), tr("Centre"), tr("Frame")});
  about_->setObjectName("segmentsAbout");
  addRow(*section, tr("Pivot"), about_);
  connect(mode_, &Segmented::chosen, this, [this](int index) { gizmo_.setMode(static_cast<Mode>(index)); });
  connect(axes_, &Segmented::chosen, this, &MovePanel::chooseAxes);
  connect(frame_, &ReferenceChoice::referenceChanged, this, &MovePanel::showFrames);
  connect(frame_, &ReferenceChoice::framesListed, this, &MovePanel::showFrames);
  connect(about_, &Segmented::chosen, this, [this](int index) {
    const workcell::Entity* now = host_.documentModel().document().find(host_.selection().current());
    const std::string frame = now && !now->frames.empty() ? now->frames.front().name : std::string();
    const HoldChoice::MovedBy ways[]{by::Origin{}, by::Center{}, by::Frame{frame}};
    host_.holdChoice().set(ways[index]);
  });
}

void MovePanel::chooseAxes(int index) {
  gizmo_.setAxes(static_cast<EditAxes>(index), frame_->frame_W().value_or(Pose::identity()).q);
  if (index != kFrameAxes) host_.userSettings().setValue("edit/axes", index);  // Another cell has other frames.
  showFrames();
}

/// The row is there as long as the cell has frames, so that nothing moves when one is chosen.
void MovePanel::showFrames() {
  const bool any = frame_->hasFrames();
  if (gizmo_.axes() == EditAxes::kFrame)
    gizmo_.setAxes(any ? EditAxes::kFrame : EditAxes::kWorld, frame_->frame_W().value_or(Pose::identity()).q);
  axes_->setCurrent(static_cast<int>(gizmo_.axes()));
  axes_->setChoiceEnabled(kFrameAxes, any, tr("No frame in this cell yet. Add one with Insert > Frame."));
  frame_row_->setVisible(any);
  frame_->setEnabled(gizmo_.axes() == EditAxes::kFrame);
}

void MovePanel::addNumbers(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("By values"));
  const char* const names[]{"X", "Y", "Z", "A", "B", "C"};
  for (std::size_t i = 0; i < 6; ++i) {
    numbers_[i] = new ValueField(
        {i < 3 ? tr("mm") : QStringLiteral("°"), 1, i < 3 ? -1e6 : -720.0, i < 3 ? 1e6 : 720.0, i < 3 ? 1.0 : 5.0});
    numbers_[i]->setObjectName(QStringLiteral("fieldMove") + QString::fromLatin1(names[i]));
  }
  addRow(*section, tr("X Y Z"), sideBySide({numbers_[0], numbers_[1], numbers_[2]}));
  addRow(*section, tr("A B C"), sideBySide({numbers_[3], numbers_[4], numbers_[5]}));
  for (std::size_t i = 0; i < 6; ++i) numbers_[i]->setAccessibleName(tr("Move by %1").arg(QLatin1String(names[i])));
  apply_ = new QPushButton(tr("Apply"));
  apply_->setObjectName("buttonMoveBy");
  apply_->setProperty("main", true);
  auto* row = new QHBoxLayout;
  row->addStretch(1);
  row->addWidget(apply_);
  section->addLayout(row);
  connect(apply_, &QPushButton::clicked, this, &MovePanel::applyNumbers);
}

void MovePanel::addSteps(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("While dragging"));
  grid_on_ = makeSwitch(tr("Length step"), "switchGrid");
  angle_on_ = makeSwitch(tr("Angle step"), "switchAngle");
  snap_ = makeSwitch(tr("Snap to corner, edge, face, frame"), "switchSnap");
  grid_ = new ValueField({tr("mm"), 1, 0.01, 1e5, 1.0});
  grid_->setObjectName("fieldGrid");
  grid_->setAccessibleName(tr("Length step"));
  angle_ = new ValueField({QStringLiteral("°"), 1, 0.01, 180.0, 1.0});
  angle_->setObjectName("fieldAngle");
  angle_->setAccessibleName(tr("Angle step"));
  for (const auto& [box, field] : {std::pair{grid_on_, grid_}, std::pair{angle_on_, angle_}}) {
    auto* row = new QHBoxLayout;
    row->addWidget(box);
    row->addStretch(1);
    field->setFixedWidth(96);
    row->addWidget(field);
    section->addLayout(row);
    connect(box, &QCheckBox::toggled, this, &MovePanel::storeSteps);
    connect(field, &ValueField::edited, this, &MovePanel::storeSteps);
  }
  section->addWidget(snap_);
  connect(snap_, &QCheckBox::toggled, this, &MovePanel::storeSteps);
}

void MovePanel::addOnto(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Place on"));
  align_ = makeSwitch(tr("Rotate too: axes aligned, faces flush"), "switchAlign");
  align_->setChecked(true);
  section->addWidget(align_);
  onto_ = new QPushButton(tr("Pick start and target"));
  onto_->setObjectName("buttonOnto");
  onto_->setToolTip(tr("First pick a face, edge or corner of the moving part, then the target"));
  auto* row = new QHBoxLayout;
  row->addStretch(1);
  row->addWidget(onto_);
  section->addLayout(row);
  connect(onto_, &QPushButton::clicked, this, &MovePanel::pickFrom);
}

void MovePanel::readSettings() {
  reading_ = true;
  const UserSettings& settings = host_.userSettings();
  grid_on_->setChecked(settings.value("edit/grid_on", false).toBool());
  angle_on_->setChecked(settings.value("edit/angle_on", false).toBool());
  snap_->setChecked(settings.value("edit/snap", false).toBool());
  grid_->setValue(settings.value("edit/grid_mm", 10.0).toDouble());
  angle_->setValue(settings.value("edit/angle_deg", 15.0).toDouble());
  gizmo_.setAxes(static_cast<EditAxes>(std::clamp(settings.value("edit/axes", 0).toInt(), 0, 2)));
  reading_ = false;
  storeSteps();
  showTool();
}

void MovePanel::storeSteps() {
  if (reading_) return;
  gizmo_.setSteps({grid_on_->isChecked() ? grid_->value() / 1000.0 : 0.0,
                   angle_on_->isChecked() ? angle_->value() * kDegree : 0.0});
  gizmo_.setSnapping(snap_->isChecked());
  grid_->setEnabled(grid_on_->isChecked());
  angle_->setEnabled(angle_on_->isChecked());
  UserSettings& settings = host_.userSettings();
  settings.setValue("edit/grid_on", grid_on_->isChecked());
  settings.setValue("edit/angle_on", angle_on_->isChecked());
  settings.setValue("edit/snap", snap_->isChecked());
  settings.setValue("edit/grid_mm", grid_->value());
  settings.setValue("edit/angle_deg", angle_->value());
}

void MovePanel::showTool() {
  mode_->setCurrent(static_cast<int>(gizmo_.mode()));
  showFrames();
  about_->setCurrent(host_.holdChoice().turnsAbout());
}

void MovePanel::showSelection() {
  const auto& all = host_.selection().all();
  const workcell::Document& document = host_.documentModel().document();
  const workcell::Entity* now = document.find(host_.selection().current());
  const auto moved = movedTogether(document.state(), all);
  title_->setText(selectionTitle(static_cast<int>(all.size()), now));
  note_->setText(selectionNote(all.size(), !moved.empty()));
  about_->setChoiceEnabled(2, now && !now->frames.empty(), tr("It has no frame yet. Add one in the Solid panel."));
  apply_->setEnabled(!moved.empty());
  onto_->setEnabled(!moved.empty());
}

void MovePanel::showMotion(const Twist& motion_G) {
  for (int i = 0; i < 3; ++i) {
    numbers_[static_cast<std::size_t>(i)]->setValue(1000.0 * motion_G.linear[i]);
    // Drags turn about one axis at a time: A about z, B about y, C about x.
    numbers_[static_cast<std::size_t>(5 - i)]->setValue(motion_G.angular[i] / kDegree);
  }
}

void MovePanel::applyNumbers() {
  std::array<double, 6> values{};
  for (std::size_t i = 0; i < 6; ++i) values[i] = numbers_[i]->value();
  const Pose X = poseFromNumbers(values);
  gizmo_.moveBy({X.p, rotationVector(X.q)});
}

void MovePanel::pickFrom() {
  host_.viewport().startPick({{true, true, true},
                              tr("Pick a face, edge or corner of the moving part · Esc: end"),
                              [self = QPointer(this)](const std::optional<PickedFeature>& feature) {
                                if (self && feature) self->pickTo(*feature);
                              }});
}

void MovePanel::pickTo(const PickedFeature& from) {
  host_.viewport().startPick(
      {{true, true, true},
       tr("Pick the target · Esc: end"),
       [self = QPointer(this), from](const std::optional<PickedFeature>& to) {
         if (!self || !to) return;
         if (!self->host_.selection().contains(from.entity)) self->host_.selection().set(from.entity);
         const bool faces = from.kind == FeatureKind::kFace && to->kind == FeatureKind::kFace;
         const bool corner = from.kind == FeatureKind::kVertex || to->kind == FeatureKind::kVertex;
         const Pose M_W =
             motionOnto(featureFrame_W(from), featureFrame_W(*to), self->align_->isChecked() && !corner, faces);
         self->gizmo_.applyMotion(
             M_W, tr("Place %1 on %2")
                      .arg(QString::fromStdString(featureText(from)), QString::fromStdString(featureText(*to))));
       }});
}

}  // namespace hapticell::app
