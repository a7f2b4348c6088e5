// SPDX-License-Identifier: Apache-2.0
#include "app/planning/plan_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <initializer_list>
#include <utility>

#include "app/controls/external_axes.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/host/recording_hub.h"
#include "app/host/selection.h"
#include "app/kit/form.h"
#include "app/planning/through_list.h"
#include "app/style/library_text.h"
#include "app/style/value_field.h"

namespace hapticell::app {

PlanPanel::PlanPanel(Host& host, QWidget* parent) : QWidget(parent), host_(host) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  addSettings(*column);
  addRun(*column);
  column->addStretch();
  connect(&host_.selection(), &Selection::changed, this, &PlanPanel::follow);
  connect(&host_.documentModel(), &DocumentModel::changed, this, &PlanPanel::refresh);
  connect(&host_.documentModel(), &DocumentModel::closing, this, [this] {
    planner_.cancel();
    id_ = 0;
    last_.clear();
    blocker_.clear();
    through_->clear();
    refresh();
  });
  connect(&planner_, &PathPlanner::progressed, this, &PlanPanel::refresh);
  connect(&planner_, &PathPlanner::ended, this, &PlanPanel::take);
  connect(&planner_, &PathPlanner::failed, this, [this](const Error& error) {
    if (number_ != host_.documentModel().number()) return refresh();
    last_ = shownText(error);
    host_.messages().reportCause(Severity::kWarning, tr("No path was planned"), error);
    refresh();
  });
  follow();
}

void PlanPanel::addSettings(QVBoxLayout& column) {
  QVBoxLayout* rows = addSection(column, tr("Path"));
  name_ = makeLabel({}, TextRole::kText);
  name_->setObjectName("labelPlanEntity");
  name_->setWordWrap(true);
  rows->addWidget(name_);
  moving_.hand = new QComboBox;
  moving_.hand->setObjectName("choicePlanHand");
  moving_.hand->addItems({tr("Right hand"), tr("Left hand")});
  moving_.hand_row = addRow(*rows, tr("Moves"), moving_.hand);
  moving_.axes = new QCheckBox;
  moving_.axes->setObjectName("switchPlanAxes");
  moving_.axes->setMinimumHeight(24);
  moving_.axes->setChecked(true);
  moving_.axes->setAccessibleName(tr("Move external axes too"));
  moving_.axes->setToolTip(tr("External axes move with the robot's own joints"));
  moving_.axes_row = addRow(*rows, tr("Axes"), moving_.axes);
  connect(moving_.axes, &QCheckBox::clicked, this, [this] {
    if (const auto* one = entity()) goal_->takeAxes(*one, axes());
  });
  goal_ = new PlanGoalForm(host_);
  rows->addWidget(goal_);
  connect(goal_, &PlanGoalForm::takeWanted, this, [this] {
    if (const auto* one = entity()) goal_->take(*one, hand(), axes());
  });
  connect(moving_.hand, &QComboBox::currentIndexChanged, this, [this] {
    const auto* one = entity();
    if (one && one->figure() && goal_->isAsTaken()) goal_->take(*one, hand());
  });
  through_ = new ThroughList(host_);
  rows->addWidget(through_);
  const auto field = [&](const char* name, const QString& words, const ValueField::Format& format, double value) {
    auto* made = new ValueField(format);
    made->setObjectName(QString::fromLatin1(name));
    made->setValue(value);
    addRow(*rows, words, made);
    return made;
  };
  clearance_ = field("fieldPlanClearance", tr("Clearance"), {"mm", 1, 0.0, 10'000.0, 1.0}, 5.0);
  seed_ = field("fieldPlanSeed", tr("Seed"), {{}, 0, 0.0, 2e9, 1.0}, 1.0);
  time_ = field("fieldPlanTime", tr("Longest time"), {"s", 0, 1.0, 86'400.0, 1.0}, 10.0);
}

void PlanPanel::addRun(QVBoxLayout& column) {
  QVBoxLayout* rows = addSection(column, {});
  plan_ = new QPushButton(tr("Plan"));
  plan_->setObjectName("buttonPlanPath");
  plan_->setProperty("main", true);
  stop_ = new QPushButton(tr("Stop now"));
  stop_->setObjectName("buttonPlanStop");
  rows->addWidget(sideBySide({plan_, stop_}));
  bar_ = new QProgressBar;
  bar_->setTextVisible(false);
  bar_->setMaximumHeight(6);
  rows->addWidget(bar_);
  says_ = makeLive(7, TextRole::kSecond);
  says_->setObjectName("labelPlanResult");
  rows->addWidget(says_);
  show_blocker_ = new QPushButton(tr("Select what blocks"));
  show_blocker_->setObjectName("buttonPlanBlocker");
  rows->addWidget(show_blocker_);
  connect(plan_, &QPushButton::clicked, this, &PlanPanel::plan);
  connect(stop_, &QPushButton::clicked, &planner_, &PathPlanner::cancel);
  connect(show_blocker_, &QPushButton::clicked, this, [this] {
    const auto* found = host_.documentModel().document().findByName(blocker_);
    if (found) host_.selection().set(found->id);
  });
}

const workcell::Entity* PlanPanel::entity() const {
  return id_ ? host_.documentModel().document().find(id_) : nullptr;
}

mannequin::Side PlanPanel::hand() const {
  return moving_.hand->currentIndex() == 0 ? mannequin::Side::kRight : mannequin::Side::kLeft;
}

PlanGoalForm::Axes PlanPanel::axes() const {
  const workcell::Entity* one = entity();
  if (!one || !one->robot() || one->figure() || !moving_.axes->isChecked()) return {};
  return externalAxes(host_.documentModel().document().state(), *one);
}

void PlanPanel::showAxes() {
  const workcell::Entity* one = entity();
  QStringList names;
  if (one && one->robot() && !one->figure()) {
    for (const auto* axis : externalAxes(host_.documentModel().document().state(), *one))
      names << QString::fromStdString(axis->name);
  }
  moving_.axes_row->setVisible(!names.isEmpty());
  moving_.axes->setText(tr("%1 moves too").arg(names.join(QStringLiteral(", "))));
  moving_.axes->setEnabled(!planner_.isBusy());
}

void PlanPanel::follow() {
  const workcell::EntityId chosen = host_.selection().current();
  const auto* found = chosen ? host_.documentModel().document().find(chosen) : nullptr;
  // What blocks was selected to be seen: the path is still that of the entity before.
  const bool is_blocker = found && !blocker_.empty() && found->name == blocker_;
  if (found && !is_blocker && !planner_.isBusy() && chosen != id_) {
    id_ = chosen;
    last_.clear();
    blocker_.clear();
    goal_->take(*found, hand(), axes());
  }
  refresh();
}

void PlanPanel::plan() {
  const workcell::Entity* one = entity();
  if (!one || planner_.isBusy()) return;
  blocker_.clear();
  const auto goal = goal_->goal(*one, axes());
  if (!goal) {
    last_ = shownText(goal.error());
    return refresh();
  }
  if (host_.recording().isRecording()) {
    last_ = tr("A recording runs. Stop it first, then plan.");
    return refresh();
  }
  auto through = through_->poses();
  if (!through) {
    last_ = shownText(through.error());
    return refresh();
  }
  last_.clear();
  number_ = host_.documentModel().number();
  PathRequest request;
  request.scenes = host_.scenes();
  request.configuration = host_.configuration();
  request.source =
      manipulation::sourceOf(host_.documentModel().document(), manipulation::pairDefaults(host_.configuration()));
  request.problem.entity = id_;
  if (one->figure()) request.problem.hand = hand();
  request.problem.goal = *goal;
  // Joints of the robot alone say that its axes stay.
  const auto* joints = std::get_if<planning::goal::ToJoints>(&*goal);
  request.problem.with_axes = !axes().empty() && !(joints && joints->joints.size() == one->joints().size());
  request.problem.clearance = 0.001 * clearance_->value();
  planned_seed_ = static_cast<std::uint64_t>(seed_->value());
  request.problem.seed = planned_seed_;
  request.problem.time_limit_s = time_->value();
  request.problem.leaves_contact = true;
  request.problem.through = std::move(*through);
  planner_.start(std::move(request));
}

void PlanPanel::take(const PathAnswer& answer) {
  if (number_ != host_.documentModel().number()) return refresh();
  if (answer.result.failure) {
    showFailure(*answer.result.failure);
    return refresh();
  }
  if (host_.recording().isRecording()) {
    last_ = tr("A recording began meanwhile, so the path was not added. Stop it, then plan again.");
    return refresh();
  }
  trajectory::Trajectory motion = *answer.motion;
  // A take of its own: motions of one take are checked and played together.
  const auto& document = host_.documentModel().document().state();
  const QString take = tr("Path, seed %1").arg(planned_seed_);
  motion.take = take.toStdString();
  for (int number = 2; document.findTrajectory(motion.entity + ", " + motion.take); ++number)
    motion.take = QStringLiteral("%1 (%2)").arg(take).arg(number).toStdString();
  std::vector<trajectory::Trajectory> motions = answer.axes;
  for (trajectory::Trajectory& axis : motions) axis.take = motion.take;
  last_ = tr("Least clearance %1 mm %2. Length %3 mm, %4 s, seed %5.")
              .arg(1000.0 * answer.clearance, 0, 'f', 1)
              .arg(shownText(answer.clearance_place))
              .arg(1000.0 * answer.result.plan->length, 0, 'f', 0)
              .arg(motion.duration(), 0, 'f', 1)
              .arg(planned_seed_);
  for (const Text& one : answer.tight) last_ += QLatin1Char(' ') + shownText(one) + QLatin1Char('.');
  if (!answer.result.note.empty()) last_ += QLatin1Char(' ') + shownText(answer.result.note);
  motions.push_back(std::move(motion));
  host_.recording().deliver(motions);
  refresh();
}

void PlanPanel::showFailure(const planning::Failure& failure) {
  last_ = shownText(failure.reason);
  if (!last_.isEmpty()) last_[0] = last_[0].toUpper();  // It follows "no plan:" on the command line.
  if (!last_.endsWith(QLatin1Char('.'))) last_ += QLatin1Char('.');
  blocker_ = failure.blocked_by;
  if (!failure.X_WT_nearest) return;
  const dvec3 p = 1000.0 * failure.X_WT_nearest->p;
  last_ += QLatin1Char(' ') + tr("The nearest free place is %1 mm from the goal, at %2; %3; %4 mm.")
                                  .arg(1000.0 * failure.nearest_distance, 0, 'f', 0)
                                  .arg(p.x, 0, 'f', 0)
                                  .arg(p.y, 0, 'f', 0)
                                  .arg(p.z, 0, 'f', 0);
}

void PlanPanel::refresh() {
  const workcell::Entity* one = entity();
  const bool busy = planner_.isBusy();
  name_->setText(one ? QString::fromStdString(one->name) : tr("Select a robot, a mannequin or a solid that shall move."));
  plan_->setEnabled(one && !busy);
  stop_->setEnabled(busy);
  goal_->setEnabled(one && !busy);
  moving_.hand_row->setVisible(one && one->figure());
  moving_.hand->setEnabled(!busy);
  showAxes();
  if (one) goal_->offerFor(*one);
  for (QWidget* setting : std::initializer_list<QWidget*>{through_, clearance_, seed_, time_}) {
    setting->setEnabled(!busy);
  }
  bar_->setValue(static_cast<int>(100.0 * planner_.progress()));
  says_->setText(busy ? tr("Planning…") : last_);
  show_blocker_->setEnabled(!blocker_.empty() && host_.documentModel().document().findByName(blocker_));
}

}  // namespace hapticell::app
