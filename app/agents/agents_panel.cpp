// SPDX-License-Identifier: Apache-2.0
#include "app/agents/agents_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

#include "agents/task/agent_section.h"
#include "app/agents/agent_arrows.h"
#include "app/agents/agent_row.h"
#include "app/controls/robot_ghosts.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/host/recording_hub.h"
#include "app/host/selection.h"
#include "app/kit/file_dialog.h"
#include "app/kit/form.h"
#include "app/kit/thread_pool_task.h"
#include "geometry/system/atomic_file.h"
#include "app/style/library_text.h"
#include "app/style/units.h"
#include "app/style/value_field.h"
#include "app/viewport/widget/viewport_widget.h"
#include "manipulation/scene/scene_service.h"

namespace hapticell::app {

namespace {

using agents::AgentSession;
using Phase = AgentSession::Phase;

constexpr const char* kOwner = "agents";
/// ms: as often as the loop makes two steps. Half: twice the drawing; twice: the entity jerks.
constexpr int kLookMilliseconds = 40;
/// Of what the planner tries: a run in the window is the first of its kind.
constexpr std::uint64_t kSeed = 1;

}  // namespace

AgentsPanel::AgentsPanel(Host& host, QWidget* parent) : QWidget(parent), host_(host), hand_(host) {
  setObjectName("agentsPanel");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  addSetup(*column);
  addAgents(*column);
  addRun(*column);
  addResult(*column);
  column->addStretch(1);
  auto* timer = new QTimer(this);
  timer->setInterval(kLookMilliseconds);
  connect(timer, &QTimer::timeout, this, &AgentsPanel::look);
  timer->start();
  connect(&host_.selection(), &Selection::changed, this, &AgentsPanel::showButtons);
  connect(&host_.documentModel(), &DocumentModel::changed, this, [this] {
    // The run is of the cell as it was.
    if (session_) stop();
    showSetup();
  });
  connect(&host_.documentModel(), &DocumentModel::closing, this, [this] {
    stop();
    setup_ = {};
    makeRows();
    showSetup();
  });
  showSetup();
}

AgentsPanel::~AgentsPanel() = default;

QPushButton* AgentsPanel::button(const char* name, const QString& text, void (AgentsPanel::*act)()) {
  auto* made = new QPushButton(text);
  made->setObjectName(name);
  connect(made, &QPushButton::clicked, this, act);
  return made;
}

void AgentsPanel::addSetup(QVBoxLayout& column) {
  QVBoxLayout& section = *addSection(column, tr("Task"));
  on_.entity = makeLive(1, TextRole::kText);
  on_.entity->setObjectName("labelAgentEntity");
  addRow(section, tr("Moved"), on_.entity);
  section.addWidget(button("buttonAgentEntity", tr("Move the selected entity"), &AgentsPanel::takeEntity));
  on_.side = new QComboBox;
  on_.side->setObjectName("choiceAgentHand");
  on_.side->addItems({tr("Right hand"), tr("Left hand")});
  connect(on_.side, &QComboBox::currentIndexChanged, this, [this](int index) {
    setup_.left_hand = index == 1;
    stop();
  });
  on_.side_row = addRow(section, tr("By"), on_.side);
  const char* names[] = {"fieldAgentGoalX", "fieldAgentGoalY", "fieldAgentGoalZ"};
  for (int k = 0; k < 3; ++k) {
    on_.goal[k] = new ValueField({.unit = "mm", .decimals = 1, .minimum = -1e5, .maximum = 1e5, .step = 10.0});
    on_.goal[k]->setObjectName(names[k]);
    connect(on_.goal[k], &ValueField::edited, this, [this, k](double value) {
      dvec3 p = setup_.p_WG;
      p[k] = 1e-3 * value;
      setGoal(p, setup_.look_at);
    });
  }
  // A row each: three fields with their units are wider than the dock.
  addRow(section, tr("Goal X"), on_.goal[0]);
  addRow(section, tr("Y"), on_.goal[1]);
  addRow(section, tr("Z"), on_.goal[2]);
  section.addWidget(button("buttonAgentGoal", tr("Goal: selected entity"), &AgentsPanel::takeGoal));
  section.addWidget(button("buttonAgentPick", tr("Goal: pick a point"), &AgentsPanel::pickGoal));
  on_.look_at = makeLive(1, TextRole::kSecond);
  on_.look_at->setObjectName("labelAgentLook");
  section.addWidget(on_.look_at);
}

void AgentsPanel::addAgents(QVBoxLayout& column) {
  QVBoxLayout& section = *addSection(column, tr("Agents: switch, weight, wish"));
  on_.rows = new QVBoxLayout;
  on_.rows->setSpacing(4);
  section.addLayout(on_.rows);
  on_.stylus = new QCheckBox(tr("The stylus leads, too"));
  on_.stylus->setObjectName("switchAgentStylus");
  connect(on_.stylus, &QCheckBox::toggled, this, [this](bool leads) { hand_.setStylusLeads(leads); });
  section.addWidget(on_.stylus);
}

void AgentsPanel::addRun(QVBoxLayout& column) {
  QVBoxLayout& section = *addSection(column, tr("Run"));
  on_.start = button("buttonAgentsStart", tr("Start"), &AgentsPanel::start);
  on_.start->setProperty("main", true);
  on_.pause = button("buttonAgentsPause", tr("Pause"), &AgentsPanel::pause);
  on_.step = button("buttonAgentsStep", tr("Step"), &AgentsPanel::stepOnce);
  on_.stop = button("buttonAgentsStop", tr("Stop now"), &AgentsPanel::stop);
  section.addWidget(sideBySide({on_.start, on_.pause}));
  section.addWidget(sideBySide({on_.step, on_.stop}));
  on_.figures = makeLive(1, TextRole::kSecond);
  on_.figures->setObjectName("labelAgentFigures");
  section.addWidget(on_.figures);
  on_.says = makeLive(4, TextRole::kText);
  on_.says->setObjectName("labelAgentsSay");
  section.addWidget(on_.says);
  on_.planner = button("buttonAgentsPlanner", tr("Hand over to the planner"), &AgentsPanel::askPlanner);
  on_.by_hand = button("buttonAgentsHand", tr("Take over by hand"), &AgentsPanel::takeByHand);
  section.addWidget(on_.planner);
  section.addWidget(on_.by_hand);
}

void AgentsPanel::addResult(QVBoxLayout& column) {
  QVBoxLayout& section = *addSection(column, tr("Result"));
  on_.adopt = button("buttonAgentsAdopt", tr("Adopt the place"), &AgentsPanel::adopt);
  on_.motion = button("buttonAgentsMotion", tr("Keep the motion"), &AgentsPanel::keepMotion);
  on_.wishes = button("buttonAgentsWishes", tr("Save the wishes…"), &AgentsPanel::saveWishes);
  section.addWidget(on_.adopt);
  section.addWidget(on_.motion);
  section.addWidget(on_.wishes);
}

void AgentsPanel::takeEntity() {
  const workcell::Entity* chosen = host_.documentModel().document().find(host_.selection().current());
  if (chosen == nullptr || !canBeMovedByAgents(*chosen)) return;
  stop();
  setup_.entity = chosen->id;
  if (setup_.look_at == chosen->id) setup_.look_at = 0;
  makeRows();
  showSetup();
}

void AgentsPanel::takeGoal() {
  const workcell::Entity* chosen = host_.documentModel().document().find(host_.selection().current());
  if (chosen != nullptr) setGoal(middleOf(*chosen), chosen->id);
}

void AgentsPanel::pickGoal() {
  host_.viewport().startPick({{}, tr("Pick the point to which it is to go"),
                              [this](const std::optional<PickedFeature>& picked) {
                                if (picked) setGoal(picked->p_WQ, picked->entity);
                              }});
}

void AgentsPanel::setGoal(const dvec3& p_WG, workcell::EntityId look_at) {
  stop();
  setup_.p_WG = p_WG;
  setup_.look_at = look_at == setup_.entity ? 0 : look_at;
  showSetup();
}

void AgentsPanel::showSetup() {
  const auto& document = host_.documentModel().document();
  const workcell::Entity* moved = document.find(setup_.entity);
  const workcell::Entity* seen = document.find(setup_.look_at);
  if (moved == nullptr && setup_.entity != 0) {
    setup_.entity = 0;
    makeRows();
  }
  const bool figure = moved != nullptr && moved->figure() != nullptr;
  on_.entity->setText(moved != nullptr ? QString::fromStdString(moved->name) : tr("none yet"));
  on_.side_row->setVisible(figure);
  for (int k = 0; k < 3; ++k) on_.goal[k]->setValue(1e3 * setup_.p_WG[k]);
  on_.look_at->setText(figure && seen != nullptr
                           ? tr("The eyes are to see %1.").arg(QString::fromStdString(seen->name))
                           : QString());
  showRun();
}

void AgentsPanel::makeRows() {
  for (AgentRow* row : rows_) delete row;
  rows_.clear();
  const workcell::Entity* moved = host_.documentModel().document().find(setup_.entity);
  if (moved == nullptr) return;
  const auto task = taskOf(setup_, host_.documentModel().document().state());
  if (!task) return;
  for (const std::string& kind : agentKindsFor(*moved)) {
    double weight = 1.0;
    for (const agents::AgentSection& section : task->agents) {
      if (section.kind == kind) weight = section.weight;
    }
    auto* row = new AgentRow(kind, true, weight);
    on_.rows->addWidget(row);
    connect(row, &AgentRow::changed, this, &AgentsPanel::sendRows);
    rows_.push_back(row);
  }
}

void AgentsPanel::sendRows() {
  if (!session_) return;
  for (const AgentRow* row : rows_) session_->setAgent(row->kind(), row->isOn(), row->weight());
}

void AgentsPanel::start() {
  if (session_) return session_->run();
  begin(false);
}

void AgentsPanel::pause() {
  if (session_) session_->pause();
}

void AgentsPanel::stepOnce() {
  if (session_) return session_->stepOnce();
  begin(true);
}

/// Meshes may still have to be prepared: beside this thread.
void AgentsPanel::begin(bool one_step) {
  if (preparing_) return;
  auto task = taskOf(setup_, host_.documentModel().document().state());
  if (!task) {
    problem_ = shownText(task.error());
    return showRun();
  }
  problem_.clear();
  preparing_ = true;
  showRun();
  const auto& document = host_.documentModel().document();
  auto source = manipulation::sourceOf(document, manipulation::pairDefaults(host_.configuration()));
  const std::uint64_t revision = document.revision();
  using Cell = Expected<std::shared_ptr<const agents::AgentCell>>;
  runInThreadPool(
      this,
      [service = host_.scenes(), source = std::move(source), task = std::move(*task),
       configuration = host_.configuration()]() mutable -> Cell {
        auto scene = service->prepare(std::move(source));
        return agents::AgentCell::create(std::move(task), std::move(scene), configuration);
      },
      [this, one_step, revision, number = host_.documentModel().number()](Cell cell) {
        // Stopped meanwhile, or of another cell.
        const bool wanted = preparing_ && number == host_.documentModel().number() &&
                            revision == host_.documentModel().document().revision();
        preparing_ = false;
        if (!wanted) return showRun();
        if (!cell) {
          problem_ = shownText(cell.error());
          return showRun();
        }
        session_ = std::make_unique<AgentSession>(std::move(*cell), kSeed);
        sendRows();
        hand_.setOn(true);
        one_step ? session_->stepOnce() : session_->run();
        look();
      });
}

void AgentsPanel::stop() {
  problem_.clear();
  preparing_ = false;
  hand_.setOn(false);
  if (session_) {
    session_.reset();
    last_.reset();
    host_.viewport().scene().setPlayed({});
    host_.viewport().setCurves(kOwner, {});
    host_.viewport().refresh();
    for (AgentRow* row : rows_) row->setStrength(0.0);
  }
  showRun();
}

void AgentsPanel::look() {
  if (!session_) return;
  const bool leads = hand_.isDragging();
  session_->setHand(hand_.velocity());
  auto state = session_->state();
  if (last_ && last_->steps == state.steps && last_->phase == state.phase && !leads) return;
  // A hand that begins to lead answers the question.
  if (leads && state.phase == Phase::kDeadlocked) session_->takeByHand();
  hand_.setFrame(state.X_WM);
  last_ = std::move(state);
  const auto& document = host_.documentModel().document();
  ViewportWidget& viewport = host_.viewport();
  viewport.scene().setPlayed(entityGhosts(document.state(), setup_.entity, last_->at.X_WE, last_->at.joints));
  auto curves = agentCurves(*last_, setup_.p_WG, -viewport.camera().forward_W());
  if (const auto& target = hand_.target_W())
    curves.push_back({{last_->X_WM.p, *target}, SceneCurve::Role::kSelection, SceneCurve::Style::kDashed, 2.0, {}});
  curves.push_back({{last_->X_WM.p}, SceneCurve::Role::kSelection, SceneCurve::Style::kSolid, 2.0, {}});
  viewport.setCurves(kOwner, std::move(curves));
  viewport.refresh();
  for (AgentRow* row : rows_) {
    double strength = 0.0;
    for (const agents::ShownWish& wish : last_->wishes) {
      if (wish.name == row->kind()) strength = wish.strength;
    }
    row->setStrength(strength);
  }
  showRun();
}

QString AgentsPanel::words(const AgentSession::State& state) const {
  if (!state.says.empty()) return shownText(state.says);
  switch (state.phase) {
    case Phase::kPlanning:
      return tr("The planner looks for a way…");
    case Phase::kArrived:
      return tr("It is at the goal. Adopt its place, or keep the motion.");
    case Phase::kPaused:
      return tr("Paused.");
    default:
      return tr("Drag the moved frame in the scene to lead.");
  }
}

void AgentsPanel::showRun() {
  if (preparing_) {
    on_.says->setText(tr("Preparing the cell…"));
  } else if (!problem_.isEmpty()) {
    on_.says->setText(problem_);
  } else if (last_) {
    on_.says->setText(words(*last_));
  } else {
    on_.says->setText(setup_.entity == 0 ? tr("Select a robot, a mannequin or a solid, and let it be moved.")
                                         : tr("Set the goal, then start."));
  }
  on_.figures->setText(
      last_ ? tr("%1 s · %2 to the goal · nearest %3")
                  .arg(locale().toString(last_->t, 'f', 1), lengthText(last_->remaining),
                       lengthText(last_->nearest))
            : QString());
  showButtons();
}

void AgentsPanel::showButtons() {
  const auto& document = host_.documentModel().document();
  const workcell::Entity* chosen = document.find(host_.selection().current());
  findChild<QPushButton*>("buttonAgentEntity")->setEnabled(chosen != nullptr && canBeMovedByAgents(*chosen));
  findChild<QPushButton*>("buttonAgentGoal")->setEnabled(chosen != nullptr && chosen->id != setup_.entity);
  const bool asks = last_ && last_->phase == Phase::kDeadlocked;
  const bool runs = last_ && last_->phase == Phase::kRunning;
  const bool busy = preparing_ || (last_ && (last_->phase == Phase::kPlanning || last_->phase == Phase::kArrived));
  on_.start->setEnabled(setup_.entity != 0 && !busy && !runs);
  on_.pause->setEnabled(runs);
  on_.step->setEnabled(setup_.entity != 0 && !busy && !runs);
  on_.stop->setEnabled(preparing_ || session_ != nullptr);
  on_.planner->setEnabled(asks);
  on_.by_hand->setEnabled(asks);
  for (QPushButton* made : {on_.adopt, on_.motion, on_.wishes}) made->setEnabled(last_ && last_->steps > 0 && !runs);
}

void AgentsPanel::askPlanner() {
  if (session_) session_->askPlanner();
}

void AgentsPanel::takeByHand() {
  if (session_) session_->takeByHand();
}

void AgentsPanel::adopt() {
  if (!last_) return;
  const workcell::Entity* moved = host_.documentModel().document().find(setup_.entity);
  if (moved == nullptr) return;
  const QString step = tr("Agents moved %1").arg(QString::fromStdString(moved->name));
  const workcell::SetConfiguration to{setup_.entity, last_->at.X_WE, last_->at.joints};
  host_.documentModel().executeAll(step, {to});  // Its changed() ends the run.
}

void AgentsPanel::keepMotion() {
  if (!session_) return;
  session_->pause();
  trajectory::Trajectory motion = session_->motion();
  // A take of its own: two runs were not recorded together.
  const auto& document = host_.documentModel().document().state();
  int number = 0;
  do {
    motion.take = tr("agents %1").arg(++number).toStdString();
  } while (document.findTrajectory(motion.entity + ", " + motion.take));
  host_.recording().deliver({std::move(motion)});
}

void AgentsPanel::saveWishes() {
  if (!session_) return;
  session_->pause();
  const std::string wishes = session_->wishes();
  const QString path = askToSave(this, tr("Save the wishes of the agents"), "wishes.csv", tr("Tables (*.csv)"));
  if (path.isEmpty()) return;
  const auto written = writeFileAtomically(path.toStdString(), wishes);
  if (!written) host_.messages().tell(Severity::kProblem, tr("The wishes were not saved"), shownText(written.error()));
}

}  // namespace hapticell::app
