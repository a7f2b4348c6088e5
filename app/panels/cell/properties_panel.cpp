// SPDX-License-Identifier: Apache-2.0
#include "app/panels/cell/properties_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <cmath>

#include "app/controls/frame_fields.h"
#include "app/controls/pose_text.h"
#include "app/controls/reference_choice.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/host/selection.h"
#include "app/kit/form.h"
#include "app/panels/cell/entity_choices.h"
#include "app/robot/configuration_model.h"
#include "app/style/eliding_label.h"
#include "app/style/library_text.h"
#include "app/style/units.h"
#include "app/style/value_field.h"
#include "app/viewport/widget/viewport_widget.h"
#include "kinematics/closed_form/inverse_factory.h"
#include "kinematics/model/solution_list.h"

namespace hapticell::app {
namespace {

constexpr int kNarrowLabel = 68;  // The dock is narrow.
// Six joints have a few configurations; of more there are infinitely many. Not a matter of half or twice.
constexpr std::size_t kFewJoints = 6;

QString placeHeading(const workcell::Entity& entity, bool in_world) {
  if (entity.figure())
    return in_world ? PropertiesPanel::tr("Placement in world") : PropertiesPanel::tr("Placement in frame");
  if (entity.robot()) return in_world ? PropertiesPanel::tr("Base in world") : PropertiesPanel::tr("Base in frame");
  return in_world ? PropertiesPanel::tr("Origin in world") : PropertiesPanel::tr("Origin in frame");
}

}  // namespace

PropertiesPanel::PropertiesPanel(Host& host, QWidget* parent) : QWidget(parent), host_(host) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  nothing_ = makeLabel(tr("Nothing is selected. Click a part in the scene or in the tree."), TextRole::kText, true);
  nothing_->setWordWrap(true);
  nothing_->setContentsMargins(12, 12, 12, 12);
  column->addWidget(nothing_);
  content_ = new QWidget;
  column->addWidget(content_);
  column->addStretch(1);
  auto* inside = new QVBoxLayout(content_);
  inside->setContentsMargins(12, 10, 8, 10);
  inside->setSpacing(6);
  reference_ = new ReferenceChoice(host_, {tr("World")});
  reference_->setObjectName("comboReference");
  reference_row_ = addRow(*inside, tr("Relative to"), reference_, kNarrowLabel);
  tool_ = addPose(*inside, "tool");
  joints_holder_ = new QWidget;
  joints_column_ = new QVBoxLayout(joints_holder_);
  joints_column_->setContentsMargins(0, 4, 0, 4);
  joints_column_->setSpacing(0);
  inside->addWidget(joints_holder_);
  place_ = addPose(*inside, "place");
  frame_ = new FrameFields(host_);
  inside->addWidget(frame_);
  choices_ = new EntityChoices(host_, *inside, this);
  for (ValueField* field : tool_.fields)
    connect(field, &ValueField::edited, this, [this] { placeTool(reference_W() * typed(tool_)); });
  for (ValueField* field : place_.fields)
    connect(field, &ValueField::edited, this, [this] { placeEntity(placeReference_W() * typed(place_)); });
  connect(reference_, &ReferenceChoice::referenceChanged, this, [this] {
    showReference();
    showNow();
  });
  connect(&host_.selection(), &Selection::changed, this, &PropertiesPanel::rebuild);
  connect(&host_.documentModel(), &DocumentModel::changed, this, &PropertiesPanel::rebuild);
  rebuild();
}

PropertiesPanel::~PropertiesPanel() = default;

PropertiesPanel::PoseBlock PropertiesPanel::addPose(QVBoxLayout& column, const char* name) {
  PoseBlock block;
  block.holder = new QWidget;
  auto* rows = new QVBoxLayout(block.holder);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(6);
  auto* top = new QHBoxLayout;
  block.heading = makeLabel({}, TextRole::kSection);
  auto* units = new ElidingLabel;
  units->setFont(textFont(TextRole::kSecond));
  units->setForegroundRole(kQuietText);
  units->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  units->setObjectName("labelPoseUnits");
  top->addWidget(block.heading);
  top->addWidget(units, 1);
  rows->addLayout(top);
  const char* const axes[6]{"X", "Y", "Z", "A", "B", "C"};
  for (std::size_t line = 0; line < 2; ++line) {
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    auto* letter = makeLabel(line == 0 ? tr("P") : tr("R"), TextRole::kText, true);
    letter->setFixedWidth(24);
    row->addWidget(letter);
    for (std::size_t i = 3 * line; i < 3 * line + 3; ++i) {
      const double range = line == 0 ? 1e6 : 360.0;
      block.fields[i] = new ValueField(
          {{}, 1, -range, range, 1.0, line == 0 ? ValueField::Quantity::kLength : ValueField::Quantity::kAngle});
      block.fields[i]->setObjectName(QStringLiteral("field_%1_%2").arg(QLatin1String(name), QLatin1String(axes[i])));
      block.fields[i]->setAccessibleName(QString::fromLatin1(axes[i]) +
                                         (line == 0 ? tr(" in millimetres") : tr(" in degrees")));
      row->addWidget(block.fields[i], 1);
    }
    rows->addLayout(row);
  }
  column.addWidget(block.holder);
  return block;
}

const workcell::Entity* PropertiesPanel::entity() const {
  return host_.documentModel().document().find(host_.selection().current());
}

bool PropertiesPanel::isHeld() const {
  return entity() && host_.snapshot() && host_.snapshot()->stylus.held == entity()->id;
}

std::vector<double> PropertiesPanel::joints() const {
  return entity() ? host_.viewport().scene().joints(*entity()) : std::vector<double>{};
}

void PropertiesPanel::rebuild() {
  const workcell::Entity* now = entity();
  nothing_->setVisible(!now);
  content_->setVisible(now);
  if (!now) return;
  for (QLabel* units : findChildren<QLabel*>("labelPoseUnits")) {
    units->setProperty("short", QStringLiteral("%1 · %2").arg(unitsNow().lengthUnit(), unitsNow().angleUnit()));
    units->setText(tr("X Y Z in %1 · A B C in %2").arg(unitsNow().lengthUnit(), unitsNow().angleUnit()));
  }
  const bool robot = now->robot() != nullptr;
  const bool figure = now->figure() != nullptr;
  tool_.holder->setVisible(robot && !figure && !now->jointed().tip_link.empty());
  frame_->showFrame(*now);
  // Nothing is placed in what goes with it; a tool centre point may be given in a frame on its own robot.
  reference_->leaveOut(robot ? 0 : now->id);
  showReference();
  joints_holder_->setVisible(robot && !figure);  // A posture is led by hands and feet: dock Mannequin.
  const void* model = now->robot().get();
  if (model != shown_model_ || now->jointed().tip_link != shown_tip_) rebuildJoints();
  choices_->show();
  showNow();
}

/// The row is there as long as there are frames to choose from.
void PropertiesPanel::showReference() {
  const workcell::Entity* now = entity();
  if (!now) return;
  reference_row_->setVisible(reference_->hasFrames());
  const bool in_world = reference_->fixedEntry() >= 0;
  tool_.heading->setText(in_world ? tr("TCP in world") : tr("TCP in frame"));
  place_.heading->setText(placeHeading(*now, in_world || reference_->goesWith(now->id)));
}

Pose PropertiesPanel::reference_W() const {
  return reference_->frame_W().value_or(Pose::identity());
}

/// What it stands in: the world, where the chosen frame would go with it.
Pose PropertiesPanel::placeReference_W() const {
  return entity() && reference_->goesWith(entity()->id) ? Pose::identity() : reference_W();
}

void PropertiesPanel::rebuildJoints() {
  while (QLayoutItem* item = joints_column_->takeAt(0)) {
    if (QWidget* gone = item->widget()) {
      gone->hide();
      gone->deleteLater();
    }
    delete item;
  }
  rows_.clear();
  inverse_.reset();
  configuration_ = nullptr;
  const workcell::Entity* now = entity();
  shown_model_ = now->robot().get();
  shown_tip_ = now->jointed().tip_link;
  shown_joints_.clear();
  if (!now->robot()) return;
  auto* top = new QWidget;
  auto* top_row = new QHBoxLayout(top);
  top_row->setContentsMargins(0, 0, 0, 0);
  top_row->addWidget(makeLabel(tr("Joints"), TextRole::kSection));
  configuration_ = new ElidingLabel;
  configuration_->setObjectName("labelConfiguration");
  configuration_->setFont(textFont(TextRole::kSecond));
  configuration_->setForegroundRole(kQuietText);
  configuration_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  top_row->addWidget(configuration_, 1);
  top->setFixedHeight(24);
  joints_column_->addWidget(top);
  if (const int tip = now->robot()->findLink(now->jointed().tip_link); tip >= 0 && now->robot()->dof() <= kFewJoints)
    if (auto made = kinematics::createInverse(*now->robot(), tip)) inverse_ = std::move(*made);
  for (std::size_t i = 0; i < now->robot()->dof(); ++i) {
    const auto& joint = now->robot()->joints[static_cast<std::size_t>(now->robot()->moving[i])];
    auto* row = new JointRow(scaleOf(joint, i));
    row->setObjectName(QStringLiteral("joint%1").arg(i + 1));
    connect(row, &JointRow::began, this, [this, row] {
      host_.documentModel().beginStep(
          tr("Rotate %1 of %2")
              .arg(row->accessibleName(), entity() ? QString::fromStdString(entity()->name) : QString()));
    });
    connect(row, &JointRow::moved, this, [this, i](double value) { moveJoint(i, value); });
    connect(row, &JointRow::ended, this,
            [this](bool keep) { keep ? host_.documentModel().endStep() : host_.documentModel().cancelStep(); });
    joints_column_->addWidget(row);
    rows_.push_back(row);
  }
}

void PropertiesPanel::moveJoint(std::size_t variable, double value) {
  const workcell::Entity* now = entity();
  if (!now || !now->robot() || variable >= now->joints().size()) return;
  std::vector<double> all = now->joints();
  all[variable] = value * unitOf(now->robot()->joints[static_cast<std::size_t>(now->robot()->moving[variable])]);
  host_.documentModel().execute(workcell::SetJoints{now->id, all});
}

void PropertiesPanel::show(const PoseBlock& block, const Pose& X) {
  const auto numbers = poseNumbers(X);
  const bool free = entity() && !entity()->locked && !isHeld();
  for (std::size_t i = 0; i < 6; ++i) {
    block.fields[i]->setEnabled(free);
    if (!block.fields[i]->hasFocus()) block.fields[i]->setValue(numbers[i]);
  }
}

Pose PropertiesPanel::typed(const PoseBlock& block) const {
  std::array<double, 6> numbers{};
  for (std::size_t i = 0; i < 6; ++i) numbers[i] = block.fields[i]->value();
  return poseFromNumbers(numbers);
}

void PropertiesPanel::showNow() {
  const workcell::Entity* now = entity();
  if (!now || !isVisible()) return;
  const Pose X_WE = host_.viewport().scene().placement_W(*now);
  show(place_, placeReference_W().inverse() * X_WE);
  if (!now->robot()) return;
  const std::vector<double> q = joints();
  show(tool_, reference_W().inverse() * tcpPose_W(*now, X_WE, q));
  showConfiguration(*now, X_WE, q);
  for (std::size_t i = 0; i < rows_.size() && i < q.size(); ++i) {
    rows_[i]->setEnabled(!now->locked && !isHeld());
    if (!rows_[i]->isDragged())
      rows_[i]->setValue(q[i] / unitOf(now->robot()->joints[static_cast<std::size_t>(now->robot()->moving[i])]));
  }
}

/// Which of its ways the arm stands in, in words.
void PropertiesPanel::showConfiguration(const workcell::Entity& robot, const Pose& X_WE, const std::vector<double>& q) {
  if (!configuration_ || !inverse_ || q == shown_joints_) return;
  shown_joints_ = q;
  QString words;
  const Pose X_BT = X_WE.inverse() * tcpPose_W(robot, X_WE, q) * robot.jointed().X_LT.inverse();
  // As the Robot dock's list says it.
  const auto solutions = kinematics::listSolutions(*robot.robot(), *inverse_, X_BT, q);
  const auto now = std::find_if(solutions.begin(), solutions.end(), [](const auto& one) { return one.is_now; });
  if (now != solutions.end()) words = shortConfiguration(now->configuration);
  configuration_->setText(words);
}

void PropertiesPanel::placeEntity(const Pose& X_WE) {
  if (entity()) host_.documentModel().execute(workcell::SetPlacement{entity()->id, X_WE});
  showNow();
}

void PropertiesPanel::placeTool(const Pose& X_WT) {
  const workcell::Entity* now = entity();
  if (!now || !now->robot()) return;
  const auto model =
      kinematics::createInverse(*now->robot(), now->robot()->findLink(now->jointed().tip_link), now->jointed().X_LT);
  if (!model) return host_.messages().tell(Severity::kWarning, shownText(model.error()));
  const auto solution = (*model)->solve(now->X_WE.inverse() * X_WT, now->joints());
  if (solution.status == kinematics::InverseStatus::kSolved) {
    host_.documentModel().execute(workcell::SetJoints{now->id, solution.q});
  } else {
    const QString why = solution.status == kinematics::InverseStatus::kLimit ? tr("A joint limit prevents this pose")
                                                                             : tr("This pose is out of reach");
    host_.messages().tell(Severity::kWarning, tr("The TCP stays where it is"),
                          tr("%1: the closest %2 gets is %3 away.")
                              .arg(why, QString::fromStdString(now->name), lengthText(solution.position_error)));
  }
  showNow();
}

}  // namespace hapticell::app
