// SPDX-License-Identifier: Apache-2.0
#include "app/robot/mechanism_panel.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/host/selection.h"
#include "app/kit/form.h"
#include "app/robot/joint_limit_fields.h"
#include "app/robot/robot_context.h"
#include "app/style/icon.h"
#include "app/style/library_text.h"
#include "app/style/segmented.h"
#include "app/style/value_field.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

using workcell::MechanismJoint;
using workcell::MechanismJointType;

QString axisText(const MechanismJoint& joint) {
  const dvec3 p = 1000.0 * joint.p_MJ;
  const dvec3 z = joint.axis_M;
  const char* const names[3]{"X", "Y", "Z"};
  for (int i = 0; i < 3; ++i)
    if (std::abs(std::abs(z[i]) - glm::length(z)) < 1e-6)
      return QObject::tr("%1%2 through %3, %4, %5")
          .arg(z[i] < 0 ? QStringLiteral("−") : QString(), QLatin1String(names[i]))
          .arg(p.x, 0, 'f', 0)
          .arg(p.y, 0, 'f', 0)
          .arg(p.z, 0, 'f', 0);
  return QObject::tr("%1, %2, %3 through %4, %5, %6")
      .arg(z.x, 0, 'f', 2)
      .arg(z.y, 0, 'f', 2)
      .arg(z.z, 0, 'f', 2)
      .arg(p.x, 0, 'f', 0)
      .arg(p.y, 0, 'f', 0)
      .arg(p.z, 0, 'f', 0);
}

}  // namespace

MechanismPanel::MechanismPanel(RobotContext& context, QWidget* parent) : QWidget(parent), context_(context) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  addHeading(*column);
  details_ = new QWidget;
  auto* inside = new QVBoxLayout(details_);
  inside->setContentsMargins(0, 0, 0, 0);
  inside->setSpacing(0);
  addJoint(*inside);
  addLimits(*inside);
  column->addWidget(details_);
  addFoot(*column);
  column->addStretch(1);
  connect(&context_, &RobotContext::documentChanged, this, [this] {
    if (isVisible()) show();
  });
  // Queued: then the next cell is there.
  connect(&context_.host().documentModel(), &DocumentModel::closing, this, &MechanismPanel::begin,
          Qt::QueuedConnection);
  begin();
}

void MechanismPanel::begin() {
  const workcell::Entity* robot = context_.robot();
  if (context_.isMechanism()) {
    draft_ = draftOf(*robot);
  } else {
    draft_ = {};
    draft_.name = context_.host().documentModel().document().uniqueName(tr("Mechanism").toStdString());
  }
  show();
}

MechanismJoint* MechanismPanel::current() {
  const int row = joints_->currentRow();
  return row >= 0 && row < static_cast<int>(draft_.joints.size()) ? &draft_.joints[static_cast<std::size_t>(row)]
                                                                  : nullptr;
}

void MechanismPanel::edit(const std::function<void(MechanismJoint&)>& change) {
  if (showing_ || !current()) return;
  change(*current());
  show();
}

void MechanismPanel::show() {
  showing_ = true;
  const int row = joints_->currentRow();
  const workcell::DocumentState& state = context_.host().documentModel().document().state();
  const workcell::Entity* edited = draft_.edited ? state.find(draft_.edited) : nullptr;
  if (draft_.edited && (!edited || !edited->mechanism())) draft_ = {0, "Mechanism", {}}, edited = nullptr;
  name_->setText(QString::fromStdString(draft_.name));
  name_->setEnabled(!edited);
  joints_->clear();
  for (const MechanismJoint& joint : draft_.joints)
    joints_->addItem(tr("%1: %2 on %3")
                         .arg(QString::fromStdString(joint.name),
                              joint.child.empty() ? tr("?") : QString::fromStdString(joint.child),
                              joint.parent.empty() ? tr("?") : QString::fromStdString(joint.parent)));
  for (QComboBox* box : {child_, parent_}) {
    box->clear();
    box->addItem(tr("Not chosen yet"), QString());
    const auto add = [&](const std::string& name) {
      box->addItem(icon("cube"), QString::fromStdString(name), QString::fromStdString(name));
    };
    if (edited)
      for (const auto& part : edited->mechanism()->parts) add(part.name);
    else
      for (const auto& entity : state.entities)
        if (entity->mesh() && entity->kind() == workcell::EntityKind::kSolid) add(entity->name);
  }
  joints_->setCurrentRow(std::min(std::max(row, 0), joints_->count() - 1));
  showing_ = false;
  showJoint();
  showFault();
}

void MechanismPanel::showJoint() {
  if (showing_) return;
  MechanismJoint* joint = current();
  details_->setVisible(joint);
  remove_->setEnabled(joint);
  drawAxes();
  if (!joint) return;
  joint_name_->setText(QString::fromStdString(joint->name));
  kind_->setCurrent(static_cast<int>(std::find(kJointKinds, kJointKinds + 4, joint->type) - kJointKinds));
  child_->setCurrentIndex(std::max(0, child_->findData(QString::fromStdString(joint->child))));
  parent_->setCurrentIndex(std::max(0, parent_->findData(QString::fromStdString(joint->parent))));
  const bool fixed = joint->type == MechanismJointType::kFixed;
  axis_->setText(fixed ? tr("not needed") : axisText(*joint));
  limits_->setVisible(!fixed);
  limit_fields_->show(*joint);
  coupled_->clear();
  coupled_->addItem(tr("No other joint"), QString());
  for (const MechanismJoint& other : draft_.joints)
    if (&other != joint && other.type != MechanismJointType::kFixed)
      coupled_->addItem(QString::fromStdString(other.name), QString::fromStdString(other.name));
  coupled_->setCurrentIndex(
      joint->coupling ? std::max(0, coupled_->findData(QString::fromStdString(joint->coupling->joint))) : 0);
  ratio_row_->setVisible(joint->coupling.has_value());
  if (joint->coupling) ratio_->setValue(joint->coupling->ratio);
}

void MechanismPanel::showFault() {
  const std::optional<Error> fault = faultOf(draft_, context_.host().documentModel().document().state());
  make_->setText(draft_.edited ? tr("Change the mechanism") : tr("Create the mechanism"));
  make_->setEnabled(!fault);
  if (draft_.joints.empty())
    fault_->setText(tr("A joint lets one part move on another. Start with New joint, or use a sample below."));
  else
    fault_->setText(fault ? shownText(*fault) : tr("Ready. One undo step."));
}

void MechanismPanel::drawAxes() {
  std::vector<SceneCurve> curves;
  if (const MechanismJoint* joint = current(); joint && isVisible()) {
    double length = 0.4;
    const SceneModel& scene = context_.host().viewport().scene();
    if (const workcell::Entity* part = context_.host().documentModel().document().findByName(joint->child))
      length = std::max(0.2, 1.3 * scene.boundsOf_W(part->id).radius());
    else if (draft_.edited)
      length = std::max(0.2, 0.9 * scene.boundsOf_W(draft_.edited).radius());
    curves = axisCurves(*joint, length);
  }
  context_.host().viewport().setCurves("mechanism", std::move(curves));
}

void MechanismPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  show();
}

void MechanismPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  drawAxes();
}

void MechanismPanel::pickPart(QComboBox* box, const QString& prompt) {
  const auto take = [this, box](const std::optional<PickedFeature>& feature) {
    const workcell::Entity* picked =
        feature ? context_.host().documentModel().document().find(feature->entity) : nullptr;
    if (!picked || !current()) return;
    std::string name = picked->name;
    if (picked->id == draft_.edited && feature->link >= 0)
      name = picked->robot()->links[static_cast<std::size_t>(feature->link)].name;
    if (box->findData(QString::fromStdString(name)) < 0)
      return context_.host().messages().tell(Severity::kWarning,
                                             tr("%1 cannot be part of a mechanism").arg(QString::fromStdString(name)),
                                             tr("Parts of a mechanism are solids of the cell."));
    edit([&](MechanismJoint& joint) { (box == child_ ? joint.child : joint.parent) = name; });
  };
  context_.host().viewport().startPick({{.faces = true, .edges = false, .vertices = false}, prompt, take});
}

void MechanismPanel::pickAxis() {
  context_.host().viewport().startPick({{.faces = true, .edges = true, .vertices = false},
                                        tr("Click a bore, a shaft, an edge or a face: its axis becomes the joint's"),
                                        [this](const std::optional<PickedFeature>& feature) {
                                          if (feature) edit([&](MechanismJoint& joint) { layAxis(joint, *feature); });
                                        }});
}

void MechanismPanel::finish() {
  const auto command = commandOf(draft_, context_.host().documentModel().document().state());
  if (!command) return showFault();
  const std::string name = draft_.name;
  if (!context_.host().documentModel().execute(*command)) return;
  if (const workcell::Entity* done = context_.host().documentModel().document().findByName(name))
    context_.host().selection().set(done->id);
  begin();
  emit made();
}

void MechanismPanel::addSample(MechanismSample sample) {
  DocumentModel& document = context_.host().documentModel();
  const geometry::Bounds bounds = context_.host().viewport().scene().bounds_W();
  // Beside what stands there.
  const Pose X_WB = bounds.isEmpty() ? Pose::identity() : Pose::translation({bounds.max.x + 1.0, bounds.center().y, 0});
  auto parts = sampleParts(sample, X_WB, document.document());
  if (!parts)
    return context_.host().messages().reportCause(Severity::kProblem, tr("The sample was not added"), parts.error());
  document.beginStep(tr("Add sample %1").arg(tr(nameOf(sample))));
  workcell::MakeMechanism make{parts->name, {}, parts->joints};
  bool done = true;
  for (workcell::Entity& part : parts->parts) {
    const std::string name = part.name;
    done = done && document.execute(workcell::AddEntity{std::move(part)});
    const workcell::Entity* added = document.document().findByName(name);
    if (added) make.parts.push_back(added->id);
  }
  done = done && document.execute(make);
  done ? document.endStep() : document.cancelStep();
  const workcell::Entity* mechanism = document.document().findByName(make.name);
  if (!mechanism) return;
  context_.host().selection().set(mechanism->id);
  context_.host().viewport().fit(context_.host().viewport().scene().boundsOf_W(mechanism->id));
  begin();
  emit made();
}

}  // namespace hapticell::app
