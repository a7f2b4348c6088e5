// SPDX-License-Identifier: Apache-2.0
#include "app/robot/holding_view.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QPushButton>
#include <QStandardItemModel>
#include <QVBoxLayout>
#include <cmath>

#include "app/controls/external_axes.h"
#include "app/host/document_model.h"
#include "app/host/hold_choice.h"
#include "app/host/host.h"
#include "app/kit/form.h"
#include "app/robot/robot_context.h"
#include "app/style/icon.h"
#include "app/style/segmented.h"
#include "app/style/units.h"
#include "kinematics/closed_form/inverse_factory.h"

namespace hapticell::app {
namespace {

/// As `robot.at_singularity` has them.
constexpr const char* kChoices[]{"keep_position", "keep_joint_4", "keep_orientation", "stop"};
constexpr int kKeepJoint = 1;

/// In the order of the segments; -1 for a way that they do not offer.
int heldBy(const HoldChoice& choice) {
  if (manipulation::toolOf(choice.movedBy())) return 0;
  if (!choice.is<by::Base>()) return -1;
  return choice.keepsTool() ? 2 : 1;
}

}  // namespace

HoldingView::HoldingView(RobotContext& context, QWidget* parent) : QWidget(parent), context_(context) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(6);
  held_by_ = new Segmented({tr("TCP"), tr("Base"), tr("Base, TCP fixed")});
  held_by_->setObjectName("segmentsHeldBy");
  held_by_->button(2)->setToolTip(tr("The base follows the hand; the joints keep the tool in place"));
  addRow(*rows, tr("Held by"), held_by_);
  tool_ = new QComboBox;
  tool_->setObjectName("comboTool");
  auto* edit = new QPushButton(tr("Edit…"));
  edit->setObjectName("buttonTools");
  auto* pair = new QWidget;
  auto* line = new QHBoxLayout(pair);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(6);
  line->addWidget(tool_, 1);
  line->addWidget(edit);
  addRow(*rows, tr("TCP"), pair);
  tool_->setAccessibleName(tr("Tool centre point"));
  axes_ = new QCheckBox;
  axes_->setObjectName("switchAxes");
  axes_->setMinimumHeight(24);
  axes_row_ = addRow(*rows, tr("Axes"), axes_);
  axes_->setAccessibleName(tr("Move external axes too"));
  addSingularity(*rows);
  connect(edit, &QPushButton::clicked, this, &HoldingView::toolsWanted);
  connect(held_by_, &Segmented::chosen, this, [this](int i) {
    HoldChoice& choice = context_.host().holdChoice();
    i == 0 ? choice.set(by::Tool{}) : choice.setBase(i == 2);
  });
  connect(axes_, &QCheckBox::clicked, this, [this](bool on) {
    HoldChoice& choice = context_.host().holdChoice();
    by::Tool tool = choice.tool();
    tool.with_axes = on;
    choice.setTool(tool);
  });
  connect(tool_, &QComboBox::activated, this, [this](int i) {
    const workcell::Entity* robot = context_.robot();
    const QString name = tool_->itemData(i).toString();
    if (robot && !name.isEmpty() && name.toStdString() != robot->jointed().tool)
      context_.host().documentModel().execute(workcell::ChooseTool{robot->id, name.toStdString()});
    showNow();
  });
  connect(&context_.host().holdChoice(), &HoldChoice::changed, this, &HoldingView::showNow);
}

void HoldingView::addSingularity(QVBoxLayout& rows) {
  singularity_ = new QComboBox;
  singularity_->setObjectName("comboSingularity");
  for (const QString& text :
       {tr("Keep position"), tr("Keep position, wrist joint fixed"), tr("Keep orientation"), tr("Stop before it")})
    singularity_->addItem(text);
  addRow(rows, tr("Singularity"), singularity_);
  singularity_->setToolTip(tr("What to keep where the wrist would have to turn faster than it can"));
  connect(singularity_, &QComboBox::activated, this, [this](int i) {
    HoldChoice& choice = context_.host().holdChoice();
    by::Tool tool = choice.tool();
    tool.at_singularity = kChoices[i];
    choice.setTool(tool);
  });
}

void HoldingView::showNow() {
  if (!context_.robot()) return;
  held_by_->setCurrent(heldBy(context_.host().holdChoice()));
  showTools();
  showAxes();
  showSingularity();
}

void HoldingView::setFree(bool free) {
  tool_->setEnabled(free);
}

void HoldingView::showTools() {
  const workcell::Entity* robot = context_.robot();
  tool_->clear();
  for (const auto& tool : robot->jointed().tools) {
    const QString name = QString::fromStdString(tool.name);
    const double reach = glm::length(tool.X_LT.p);
    tool_->addItem(icon("frame"), reach > 5e-4 ? tr("%1, %2").arg(name, lengthText(reach, 0)) : name, name);
  }
  if (robot->jointed().tool.empty()) {
    const QString link = QString::fromStdString(robot->jointed().tip_link);
    const double reach = glm::length(robot->jointed().X_LT.p);
    tool_->insertItem(0, icon("frame"), reach > 5e-4 ? tr("%1, %2").arg(link, lengthText(reach, 0)) : link, QString());
    tool_->setCurrentIndex(0);
  } else {
    tool_->setCurrentIndex(tool_->findData(QString::fromStdString(robot->jointed().tool)));
  }
  tool_->setEnabled(context_.isFree());
}

void HoldingView::showAxes() {
  QStringList names;
  for (const auto* axis : externalAxes(context_.host().documentModel().document().state(), *context_.robot()))
    names << QString::fromStdString(axis->name);
  axes_row_->setVisible(!names.isEmpty());
  if (names.isEmpty()) return;
  axes_->setText(tr("%1 moves too").arg(names.join(QStringLiteral(", "))));
  const HoldChoice& choice = context_.host().holdChoice();
  axes_->setChecked(choice.tool().with_axes);
  const bool by_tool = manipulation::toolOf(choice.movedBy()) != nullptr;
  axes_->setEnabled(by_tool);
  axes_->setToolTip(by_tool ? tr("External axes follow the tool with the robot's own joints")
                            : tr("Only while the robot is held by its tool"));
}

/// The wrist's joint by its name; greyed, with the reason, where the arm has no wrist.
void HoldingView::showSingularity() {
  const auto* inverse = context_.inverse();
  const kinematics::Chain* chain = inverse ? inverse->chain() : nullptr;
  const int wrist = chain ? kinematics::wristJoint(*chain) : -1;
  auto* item = qobject_cast<QStandardItemModel*>(singularity_->model())->item(kKeepJoint);
  item->setEnabled(wrist >= 0);
  if (wrist >= 0) {
    const int variable = chain->variables()[static_cast<std::size_t>(wrist)];
    item->setText(tr("Keep position, %1 fixed").arg(context_.jointName(static_cast<std::size_t>(variable))));
    item->setToolTip({});
  } else {
    item->setText(tr("Keep position, wrist joint fixed"));
    item->setToolTip(tr("Needs six or more revolute joints, of which the last three form a wrist"));
  }
  singularity_->setEnabled(chain != nullptr);
  const std::string& own = context_.host().holdChoice().tool().at_singularity;
  const std::string& chosen = own.empty() ? context_.host().configuration().robot.at_singularity : own;
  int index = 0;
  for (int i = 0; i < 4; ++i) {
    if (chosen == kChoices[i]) index = i;
  }
  singularity_->setCurrentIndex(index == kKeepJoint && wrist < 0 ? 0 : index);
}

}  // namespace hapticell::app
