// SPDX-License-Identifier: Apache-2.0
// The fields of the mechanism panel and what typing into them does.
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/kit/form.h"
#include "app/robot/joint_limit_fields.h"
#include "app/robot/mechanism_panel.h"
#include "app/style/segmented.h"
#include "app/style/value_field.h"

namespace hapticell::app {
namespace {

using workcell::MechanismJoint;
using workcell::MechanismJointType;

constexpr int kLabel = 72;

ValueField* makeField(const char* name, const ValueField::Format& format) {
  auto* field = new ValueField(format);
  field->setObjectName(QLatin1String(name));
  return field;
}

}  // namespace

void MechanismPanel::addHeading(QVBoxLayout& column) {
  QVBoxLayout* rows = addSection(column, {});
  name_ = new QLineEdit;
  name_->setObjectName("editMechanismName");
  addRow(*rows, tr("Name"), name_, kLabel);
  joints_ = new QListWidget;
  joints_->setObjectName("listJoints");
  joints_->setAccessibleName(tr("Joints"));
  joints_->setFixedHeight(4 * 24 + 4);
  rows->addWidget(joints_);
  auto* add = new QPushButton(tr("New joint"));
  add->setObjectName("buttonNewJoint");
  remove_ = new QPushButton(tr("Remove"));
  remove_->setObjectName("buttonRemoveJoint");
  rows->addWidget(sideBySide({add, remove_}));
  connect(name_, &QLineEdit::editingFinished, this, [this] {
    draft_.name = name_->text().trimmed().toStdString();
    showFault();
  });
  connect(joints_, &QListWidget::currentRowChanged, this, &MechanismPanel::showJoint);
  connect(add, &QPushButton::clicked, this, [this] {
    draft_.joints.push_back(newJoint(draft_, MechanismJointType::kRevolute));
    show();
    joints_->setCurrentRow(joints_->count() - 1);
  });
  connect(remove_, &QPushButton::clicked, this, [this] {
    if (!current()) return;
    draft_.joints.erase(draft_.joints.begin() + joints_->currentRow());
    show();
  });
}

QWidget* MechanismPanel::partRow(QVBoxLayout& rows, const QString& name, const char* object, QComboBox*& box,
                                 const QString& prompt) {
  box = new QComboBox;
  box->setObjectName(QLatin1String(object));
  auto* pick = new QPushButton(tr("Pick"));
  pick->setObjectName(QStringLiteral("%1Pick").arg(QLatin1String(object)));
  pick->setFixedWidth(60);
  auto* holder = new QWidget;
  auto* line = new QHBoxLayout(holder);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(6);
  line->addWidget(box, 1);
  line->addWidget(pick);
  QWidget* row = addRow(rows, name, holder, kLabel);
  box->setAccessibleName(name);
  connect(pick, &QPushButton::clicked, this, [this, box, prompt] { pickPart(box, prompt); });
  connect(box, &QComboBox::activated, this, [this, box](int i) {
    edit([&](MechanismJoint& joint) {
      (box == child_ ? joint.child : joint.parent) = box->itemData(i).toString().toStdString();
    });
  });
  return row;
}

void MechanismPanel::addJoint(QVBoxLayout& column) {
  QVBoxLayout* rows = addSection(column, tr("Joint"));
  joint_name_ = new QLineEdit;
  joint_name_->setObjectName("editJointName");
  addRow(*rows, tr("Name"), joint_name_, kLabel);
  kind_ = new Segmented({tr("Hinge"), tr("Slide"), tr("Screw"), tr("Fixed")});
  kind_->setObjectName("segmentsJointKind");
  addRow(*rows, tr("Type"), kind_, kLabel);
  partRow(*rows, tr("Moves"), "comboChild", child_, tr("Click the part that moves"));
  partRow(*rows, tr("Carried by"), "comboParent", parent_, tr("Click the part that it moves on"));
  axis_ = makeLive(2, TextRole::kText);
  axis_->setObjectName("labelAxis");
  addRow(*rows, tr("Axis"), axis_, kLabel);
  auto* pick = new QPushButton(tr("Pick axis"));
  pick->setObjectName("buttonPickAxis");
  pick->setToolTip(tr("A bore, a shaft, a straight or round edge, or the normal of a face"));
  auto* flip = new QPushButton(tr("Flip"));
  flip->setObjectName("buttonFlipAxis");
  auto* empty = new QWidget;
  empty->setFixedWidth(kLabel - 6);
  auto* line = new QHBoxLayout;
  line->setSpacing(6);
  line->addWidget(empty);
  line->addWidget(pick, 1);
  line->addWidget(flip, 1);
  rows->addLayout(line);
  connect(joint_name_, &QLineEdit::editingFinished, this, [this] {
    const std::string name = joint_name_->text().trimmed().toStdString();
    if (current() && !name.empty() && name != current()->name)
      edit([&](MechanismJoint& joint) {
        for (MechanismJoint& other : draft_.joints)
          if (other.coupling && other.coupling->joint == joint.name) other.coupling->joint = name;
        joint.name = name;
      });
  });
  connect(kind_, &Segmented::chosen, this, [this](int i) {
    edit([&](MechanismJoint& joint) {
      joint.type = kJointKinds[i];
      suitLimits(joint);
    });
  });
  connect(pick, &QPushButton::clicked, this, &MechanismPanel::pickAxis);
  connect(flip, &QPushButton::clicked, this, [this] { edit(flipAxis); });
}

void MechanismPanel::addLimits(QVBoxLayout& column) {
  limits_ = new QWidget;
  auto* outside = new QVBoxLayout(limits_);
  outside->setContentsMargins(0, 0, 0, 0);
  outside->setSpacing(0);
  QVBoxLayout* rows = addSection(*outside, tr("Limits and feel"));
  limit_fields_ = new JointLimitFields(
      *rows, [this](const std::function<void(MechanismJoint&)>& change) { edit(change); }, this);
  coupled_ = new QComboBox;
  coupled_->setObjectName("comboCoupled");
  addRow(*rows, tr("Follows"), coupled_, kLabel);
  ratio_ = makeField("fieldRatio", {{}, 3, -1e4, 1e4, 0.1});
  ratio_row_ = addRow(*rows, tr("Ratio"), ratio_, kLabel);
  column.addWidget(limits_);
  connect(ratio_, &ValueField::edited, this, [this](double value) {
    edit([&](MechanismJoint& joint) {
      if (joint.coupling) joint.coupling->ratio = value;
    });
  });
  connect(coupled_, &QComboBox::activated, this, [this](int i) {
    const std::string name = coupled_->itemData(i).toString().toStdString();
    edit([&](MechanismJoint& joint) {
      if (name.empty())
        joint.coupling.reset();
      else
        joint.coupling = workcell::JointCoupling{name, joint.coupling ? joint.coupling->ratio : 1.0, 0.0};
    });
  });
}

void MechanismPanel::addFoot(QVBoxLayout& column) {
  QVBoxLayout* rows = addSection(column, {});
  fault_ = makeLive(2, TextRole::kSecond, true);
  fault_->setObjectName("labelMechanismFault");
  rows->addWidget(fault_);
  make_ = new QPushButton;
  make_->setObjectName("buttonMakeMechanism");
  make_->setProperty("main", true);
  rows->addWidget(make_);
  connect(make_, &QPushButton::clicked, this, &MechanismPanel::finish);
  QVBoxLayout* samples = addSection(column, tr("Samples"));
  auto* line = new QHBoxLayout;
  line->setSpacing(6);
  for (const MechanismSample sample :
       {MechanismSample::kDoor, MechanismSample::kGripper, MechanismSample::kTurntable}) {
    auto* button = new QPushButton(tr(nameOf(sample)));
    button->setObjectName(QStringLiteral("buttonSample%1").arg(QLatin1String(nameOf(sample))));
    connect(button, &QPushButton::clicked, this, [this, sample] { addSample(sample); });
    line->addWidget(button, 1);
  }
  samples->addLayout(line);
}

}  // namespace hapticell::app
