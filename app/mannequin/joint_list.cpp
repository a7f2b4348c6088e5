// SPDX-License-Identifier: Apache-2.0
#include "app/mannequin/joint_list.h"

#include <QComboBox>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/mannequin/joint_words.h"
#include "app/mannequin/mannequin_context.h"
#include "app/mannequin/mannequin_edits.h"
#include "app/kit/form.h"
#include "app/controls/joint_row.h"
#include "mannequin/body/joint_limits.h"

namespace hapticell::app {
namespace {

constexpr double kDegrees = 57.295779513082323;
using mannequin::Dof;

struct Part {
  const char* name;
  Dof first;
  int count;
};
constexpr std::array<Part, 6> kParts{{{QT_TR_NOOP("Trunk"), Dof::kVl5Flexion, 9},
                                      {QT_TR_NOOP("Neck and head"), Dof::kVc7Flexion, 9},
                                      {QT_TR_NOOP("Left arm and hand"), Dof::kLeftClavicleElevation, 12},
                                      {QT_TR_NOOP("Right arm and hand"), Dof::kRightClavicleElevation, 12},
                                      {QT_TR_NOOP("Left leg"), Dof::kLeftHipFlexion, 7},
                                      {QT_TR_NOOP("Right leg"), Dof::kRightHipFlexion, 7}}};

constexpr Dof kNeck = Dof::kVc7Flexion;
constexpr int kNameWidth = 150;  // px

}  // namespace

JointList::JointList(MannequinContext& context, QWidget* parent) : QWidget(parent), context_(context) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(4);
  part_ = new QComboBox;
  part_->setObjectName("comboBodyPart");
  part_->setAccessibleName(tr("Part of the body"));
  for (const Part& part : kParts) part_->addItem(tr(part.name));
  rows->addWidget(part_);
  for (std::size_t i = 0; i < mannequin::kDofCount; ++i) {
    const Dof dof = static_cast<Dof>(i);
    const auto& info = mannequin::dofInfo(dof);
    JointRow* row = addRow(jointName(QString::fromLatin1(info.name)), kDegrees * info.lower, kDegrees * info.upper);
    row->setObjectName(QStringLiteral("joint_") + QString::fromLatin1(info.name));
    row->setToolTip(tr("%1: %2° to %3°, comfortable %4° to %5°")
                        .arg(QString::fromLatin1(info.name))
                        .arg(kDegrees * info.lower, 0, 'f', 0)
                        .arg(kDegrees * info.upper, 0, 'f', 0)
                        .arg(kDegrees * info.comfort_lower, 0, 'f', 0)
                        .arg(kDegrees * info.comfort_upper, 0, 'f', 0));
    connect(row, &JointRow::moved, this, [this, dof](double value) { moveTo(dof, value / kDegrees); });
    rows_.push_back({dof, row});
  }
  const double aside = kDegrees * mannequin::kGazeYawLimit;
  gaze_ = {addRow(tr("gaze to the left"), -aside, aside),
           addRow(tr("gaze down"), -kDegrees * mannequin::kGazeUpLimit, kDegrees * mannequin::kGazeDownLimit)};
  gaze_[0]->setObjectName("joint_gaze_yaw");
  gaze_[1]->setObjectName("joint_gaze_pitch");
  for (const bool to_side : {true, false})
    connect(gaze_[to_side ? 0 : 1], &JointRow::moved, this,
            [this, to_side](double value) { look(value / kDegrees, to_side); });
  connect(part_, &QComboBox::activated, this, &JointList::showPart);
  part_->setCurrentIndex(3);
  showPart(3);
}

JointRow* JointList::addRow(const QString& name, double lower, double upper) {
  auto* row = new JointRow({name, tr("°"), lower, upper, false, kNameWidth});
  connect(row, &JointRow::began, this, [this] {
    if (context_.entity())
      context_.host().documentModel().beginStep(
          tr("Move joints of %1").arg(QString::fromStdString(context_.entity()->name)));
  });
  connect(row, &JointRow::ended, this, [this](bool keep) {
    DocumentModel& document = context_.host().documentModel();
    keep ? document.endStep() : document.cancelStep();
  });
  layout()->addWidget(row);
  return row;
}

void JointList::look(double radians, bool aside) {
  const workcell::Entity* entity = context_.entity();
  if (!entity || !context_.isFree()) return;
  mannequin::Posture posture = postureOf(*entity);
  (aside ? posture.gaze.yaw : posture.gaze.pitch) = radians;
  context_.host().documentModel().execute(postureCommand(*entity, posture));
}

void JointList::showPart(int part) {
  const Part& chosen = kParts[static_cast<std::size_t>(std::max(0, part))];
  const std::size_t first = mannequin::indexOf(chosen.first);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows_[i].row->setVisible(i >= first && i < first + static_cast<std::size_t>(chosen.count));
  }
  for (JointRow* row : gaze_) row->setVisible(chosen.first == kNeck);
}

void JointList::moveTo(Dof dof, double radians) {
  const workcell::Entity* entity = context_.entity();
  if (!entity || !context_.isFree()) return;
  mannequin::Posture posture = postureOf(*entity);
  const auto& info = mannequin::dofInfo(dof);
  const double from = posture[dof];
  posture[dof] = std::clamp(radians, info.lower, info.upper);
  // As far as the coupled limits let it go.
  const auto allowed = [&] { return !mannequin::isCoupled(dof) || mannequin::limitViolations(posture).empty(); };
  if (!allowed()) {
    double good = 0.0, bad = 1.0;
    const double to = posture[dof];
    for (int i = 0; i < 12; ++i) {
      const double middle = 0.5 * (good + bad);
      posture[dof] = from + middle * (to - from);
      (allowed() ? good : bad) = middle;
    }
    posture[dof] = from + good * (to - from);
  }
  context_.host().documentModel().execute(postureCommand(*entity, posture));
}

void JointList::showNow() {
  const workcell::Entity* entity = context_.entity();
  setEnabled(entity && context_.isFree());
  if (!entity || !isVisible()) return;
  const mannequin::Posture posture = context_.posture();
  for (const Row& row : rows_) {
    if (!row.row->isDragged()) row.row->setValue(kDegrees * posture[row.dof]);
  }
  const std::array<double, 2> gaze{posture.gaze.yaw, posture.gaze.pitch};
  for (std::size_t i = 0; i < gaze_.size(); ++i)
    if (!gaze_[i]->isDragged()) gaze_[i]->setValue(kDegrees * gaze[i]);
}

}  // namespace hapticell::app
