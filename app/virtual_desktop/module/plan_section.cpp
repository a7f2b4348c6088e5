// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/module/plan_section.h"

#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <cmath>

#include "app/controls/pose_text.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/kit/form.h"
#include "app/style/icon.h"
#include "app/viewport/scene/frame_triads.h"
#include "app/viewport/widget/viewport_widget.h"
#include "app/virtual_desktop/module/virtual_desktop_controller.h"

namespace hapticell::app {
namespace {

constexpr const char* kCurves = "plan";
constexpr double kTriad = 0.04;  // m: length of the goal's axes.

/// A place of the list: the frame's name in the entity's; both empty: out of the cell.
constexpr int kEntity = Qt::UserRole, kFrame = Qt::UserRole + 1;

/// Where an entity is now, as the hand has moved it.
manipulation::EntityConfiguration presentOf(const workcell::Entity& entity, const manipulation::SceneSnapshot& now) {
  manipulation::EntityConfiguration at{entity.X_WE, entity.robot() ? entity.joints() : std::vector<double>()};
  for (const manipulation::EntityState& state : now.entities)
    if (state.id == entity.id) at = {state.X_WE, state.joints};
  return at;
}

}  // namespace

PlanSection::PlanSection(Host& host, VirtualDesktopController& controller, QVBoxLayout& column, QObject* parent)
    : QObject(parent), host_(host), controller_(controller) {
  QVBoxLayout* section = addSection(column, tr("Planner beside the hand"));
  goals_ = new QComboBox;
  goals_->setObjectName("comboPlanGoal");
  goals_->setMinimumContentsLength(12);
  goals_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  addRow(*section, tr("Goal"), goals_);
  listed_ = makeButton("buttonPlanTowards", tr("Towards this goal"),
                       tr("The held entity, or the one chosen above, should go to the goal in the list"));
  present_ = makeButton("buttonPlanPresent", tr("Goal: here"),
                        tr("Where the entity is now becomes the goal: move it there, press, and move it back"));
  section->addWidget(sideBySide({listed_, present_}));
  addAuthority(*section);
  state_ = makeLive(2, TextRole::kSecond, true);
  state_->setObjectName("labelPlanState");
  section->addWidget(state_);
  start_ = makeButton("buttonPlanStart", tr("Start planner"), {});
  start_->setProperty("main", true);
  section->addWidget(start_);
  connect(listed_, &QPushButton::clicked, this, &PlanSection::takeListed);
  connect(present_, &QPushButton::clicked, this, &PlanSection::takePresent);
  connect(start_, &QPushButton::clicked, this, &PlanSection::startOrStop);
  connect(&host_.documentModel(), &DocumentModel::closing, this, [this] {
    controller_.plan().setTarget(std::nullopt);
    show();
  });
}

PlanSection::~PlanSection() {
  host_.viewport().setCurves(kCurves, {});
}

void PlanSection::addAuthority(QVBoxLayout& section) {
  authority_ = new QSlider(Qt::Horizontal);
  authority_->setObjectName("sliderPlanAuthority");
  authority_->setRange(0, 100);
  authority_->setValue(static_cast<int>(std::lround(100.0 * controller_.plan().authority())));
  authority_->setToolTip(tr("How strongly the way is felt. 0 %: it is only drawn"));
  given_ = makeLabel({}, TextRole::kSecond);
  given_->setObjectName("labelPlanAuthority");
  given_->setMinimumWidth(given_->fontMetrics().horizontalAdvance(QStringLiteral("100 %")));
  given_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  auto* row = new QWidget;
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(0, 0, 0, 0);
  line->addWidget(authority_, 1);
  line->addWidget(given_);
  addRow(section, tr("Authority"), row);
  authority_->setAccessibleName(tr("Authority"));
  acts_ = new QProgressBar;
  acts_->setObjectName("barPlanAuthority");
  acts_->setRange(0, 100);
  acts_->setFormat(tr("%p %"));
  acts_->setToolTip(tr("What acts now: it falls while you push out of the way, and comes back with a new way"));
  addRow(section, tr("Acts now"), acts_);
  connect(authority_, &QSlider::valueChanged, this, [this](int percent) {
    controller_.plan().setAuthority(0.01 * percent);
    show();
  });
}

void PlanSection::listGoals() {
  const QString chosen = goals_->currentText();
  const workcell::Document& document = host_.documentModel().document();
  const workcell::EntityId moved = controller_.settings().entity;
  const QSignalBlocker quiet(goals_);
  goals_->clear();
  goals_->addItem(tr("Out of the cell"));
  for (const auto& entity : document.state().entities) {
    if (entity->id == moved) continue;  // Its own frames go where it goes.
    const QString name = QString::fromStdString(entity->name);
    const auto add = [&](const QString& text, const std::string& frame) {
      goals_->addItem(icon("frame"), text);
      goals_->setItemData(goals_->count() - 1, static_cast<qulonglong>(entity->id), kEntity);
      goals_->setItemData(goals_->count() - 1, QString::fromStdString(frame), kFrame);
    };
    add(name, {});
    for (const workcell::Frame& frame : entity->frames)
      add(name + QStringLiteral(" / ") + QString::fromStdString(frame.name), frame.name);
  }
  goals_->setCurrentIndex(std::max(0, goals_->findText(chosen)));
}

void PlanSection::takeListed() {
  const workcell::Document& document = host_.documentModel().document();
  const manipulation::SceneSnapshot& now = controller_.snapshot();
  const workcell::EntityId id = now.stylus.held != 0 ? now.stylus.held : controller_.settings().entity;
  const workcell::Entity* moved = document.find(id);
  if (!moved) return;
  PlanControl::Target target{id, planning::goal::OutOfCell{}, moved->X_WE, goals_->currentText()};
  if (const workcell::Entity* other = document.find(goals_->currentData(kEntity).toULongLong())) {
    target.X_WT = presentOf(*other, now).X_WE;
    const std::string name = goals_->currentData(kFrame).toString().toStdString();
    for (const workcell::Frame& frame : other->frames)
      if (frame.name == name) target.X_WT = target.X_WT * frame.X_EF;
    target.goal = planning::goal::ToPose{target.X_WT};
  }
  controller_.plan().setTarget(std::move(target));
  show();
}

void PlanSection::takePresent() {
  const manipulation::SceneSnapshot& now = controller_.snapshot();
  const workcell::EntityId id = now.stylus.held != 0 ? now.stylus.held : controller_.settings().entity;
  const workcell::Entity* moved = host_.documentModel().document().find(id);
  if (!moved) return;
  const manipulation::EntityConfiguration at = presentOf(*moved, now);
  PlanControl::Target target{id, planning::goal::ToPose{at.X_WE}, at.X_WE, tr("the place that you showed")};
  const manipulation::MovedBy moved_by = controller_.movedBy();
  const auto* hand = std::get_if<manipulation::by::Hand>(&moved_by);
  if (moved->figure() && !hand)
    return host_.messages().tell(Severity::kWarning, tr("No goal was taken"),
                                 tr("Choose the left or right hand of %1 in 'Moved by' first.")
                                     .arg(QString::fromStdString(moved->name)));
  if (hand) {
    target.X_WT = gripPose_W(*moved, hand->side, at.X_WE, at.joints);
    target.goal = planning::goal::ToPose{target.X_WT};
  } else if (moved->robot()) {
    target.goal = planning::goal::ToJoints{at.joints};
  }
  controller_.plan().setTarget(std::move(target));
  show();
}

void PlanSection::startOrStop() {
  PlanControl& plan = controller_.plan();
  plan.isOn() ? plan.stop() : plan.start();
  show();
}

void PlanSection::show() {
  PlanControl& plan = controller_.plan();
  const manipulation::SceneSnapshot& now = controller_.snapshot();
  if (held_ != now.stylus.held) {  // The planner rests while something else is held.
    held_ = now.stylus.held;
    plan.post();
  }
  const bool chosen = now.stylus.held != 0 || controller_.settings().entity != 0;
  listed_->setEnabled(chosen);
  present_->setEnabled(chosen);
  start_->setText(plan.isOn() ? tr("Stop planner") : tr("Start planner"));
  start_->setEnabled(plan.target().has_value());
  given_->setText(tr("%1 %").arg(authority_->value()));
  const bool felt = plan.isOn() && now.plan.way && now.stylus.forces_on;
  acts_->setValue(felt ? static_cast<int>(std::lround(100.0 * now.plan.authority * now.plan.share)) : 0);
  state_->setText(plan.sentence());
  draw();
}

/// The newest way as a line, the goal as axes.
void PlanSection::draw() {
  const PlanControl& plan = controller_.plan();
  std::vector<SceneCurve> curves;
  const auto& way = controller_.snapshot().plan.way;
  if (plan.isOn() && way) {
    SceneCurve line{{}, SceneCurve::Role::kGuide, SceneCurve::Style::kSolid, 3.0, {}};
    for (const Pose& X_WM : way->X_WM) line.points_W.push_back(X_WM.p);
    curves.push_back(std::move(line));
  }
  const auto& target = plan.target();
  if (target && !std::holds_alternative<planning::goal::OutOfCell>(target->goal))
    for (SceneCurve& axis : triadCurves(target->X_WT, kTriad, tr("Goal").toStdString(), true, 2.5))
      curves.push_back(std::move(axis));
  host_.viewport().setCurves(kCurves, std::move(curves));
}

}  // namespace hapticell::app
