// SPDX-License-Identifier: Apache-2.0
#include "app/access/access_panel.h"

#include <QComboBox>
#include <QDate>
#include <QListWidget>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <cmath>

#include "access/access_report.h"
#include "app/controls/robot_ghosts.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/language.h"
#include "app/host/message_log.h"
#include "app/host/recording_hub.h"
#include "app/host/selection.h"
#include "app/kit/file_dialog.h"
#include "app/kit/form.h"
#include "app/style/library_text.h"
#include "app/style/value_field.h"
#include "app/trajectory/motions/motion_list.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {

namespace {

constexpr const char* kAccessOwner = "access";
constexpr int kAlongSteps = 1000;  // Of the slider. Half: visible jumps on ways of a metre; twice: no finer picture.
/// m: wide enough to look for room beside the way. Half: a rail; twice: hardly felt.
constexpr double kTube = 0.01;
/// N/m towards the way. Half: hardly felt; twice: it hides contacts.
constexpr double kHelp = 150.0;
/// m that the guide pulls ahead. Half: it does not lead; twice: it pulls round corners.
constexpr double kLead = 0.02;
/// m between parts that are laid aside, our choice.
constexpr double kAsideGap = 0.05;

}  // namespace

AccessPanel::AccessPanel(Host& host, MotionList& motions, QWidget* parent)
    : QWidget(parent), host_(host), motions_(motions), job_(host) {
  setObjectName("accessPanel");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  addQuestion(*column);
  addAnswer(*column);
  addStep(*column);
  column->addStretch(1);
  connect(&job_, &AccessJob::progressed, this, &AccessPanel::refresh);
  connect(&job_, &AccessJob::changed, this, &AccessPanel::takeAnswer);
  connect(&job_, &AccessJob::failed, this, [this](const Error& error) {
    said_ = shownText(error);
    refresh();
  });
  connect(&job_, &AccessJob::kept, this, [this](const auto& measured) { addMotion(*measured); });
  connect(&host_.documentModel(), &DocumentModel::changed, this, &AccessPanel::refresh);
  connect(&host_.documentModel(), &DocumentModel::closing, this, [this] {
    part_->setText({});
    said_.clear();
    feel_->setChecked(false);
  });
  connect(&host_.selection(), &Selection::changed, this, &AccessPanel::refresh);
  connect(&motions_, &MotionList::currentChanged, this, &AccessPanel::refresh);
  connect(&motions_, &MotionList::changed, this, &AccessPanel::refresh);
  takeAnswer();
}

void AccessPanel::addQuestion(QVBoxLayout& column) {
  auto* section = addSection(column, tr("Part to take out"));
  part_ = makeLive(1, TextRole::kText);
  part_->setObjectName("labelAccessPart");
  section->addWidget(part_);
  auto* use = makeButton("buttonAccessPart", tr("Use selection"));
  section->addWidget(use);
  const auto field = [&](const char* name, const QString& words, double most, double value) {
    auto* made = new ValueField({"mm", 1, 0.0, most, 1.0});
    made->setObjectName(QString::fromLatin1(name));
    made->setValue(value);
    addRow(*section, words, made, 130);
    return made;
  };
  tolerance_ = field("fieldAccessTolerance", tr("Counts as touching"), 2.0, 0.1);
  glove_ = field("fieldAccessGlove", tr("Room for a glove"), 50.0, 2.0);
  tool_length_ = field("fieldAccessToolLength", tr("Tool length"), 2000.0, 0.0);
  tool_length_->setToolTip(tr("0: the hand takes the part itself"));
  tool_diameter_ = field("fieldAccessToolDiameter", tr("Tool diameter"), 200.0, 12.0);
  persons_ = new QComboBox;
  persons_->setObjectName("choiceAccessPersons");
  persons_->addItems({tr("Small woman to tall man"), tr("Women P5, P50, P95"), tr("Men P5, P50, P95"), tr("Nobody")});
  addRow(*section, tr("Persons"), persons_, 130);
  ask_ = makeButton("buttonAccessAsk", tr("Find the way out"));
  ask_->setProperty("main", true);
  section->addWidget(ask_);
  bar_ = new QProgressBar;
  bar_->setTextVisible(false);
  bar_->setMaximumHeight(6);
  bar_->setRange(0, 1000);
  section->addWidget(bar_);
  connect(use, &QPushButton::clicked, this, &AccessPanel::useSelection);
  connect(ask_, &QPushButton::clicked, this, &AccessPanel::ask);
}

void AccessPanel::addAnswer(QVBoxLayout& column) {
  auto* section = addSection(column, tr("Answer"));
  result_ = makeLive(4, TextRole::kSecond);
  result_->setObjectName("labelAccessResult");
  section->addWidget(result_);
  steps_ = new QListWidget;
  steps_->setObjectName("listAccessSteps");
  steps_->setAccessibleName(tr("Order of removal"));
  steps_->setFixedHeight(170);
  section->addWidget(steps_);
  people_ = new QListWidget;
  people_->setObjectName("listAccessPersons");
  people_->setAccessibleName(tr("Persons"));
  people_->setWordWrap(true);
  people_->setFixedHeight(170);
  section->addWidget(people_);
  report_ = makeButton("buttonAccessReport", tr("Write the report…"));
  section->addWidget(report_);
  connect(steps_, &QListWidget::currentRowChanged, this, [this] {
    said_.clear();
    showStep();
  });
  connect(report_, &QPushButton::clicked, this, &AccessPanel::writeReport);
}

void AccessPanel::addStep(QVBoxLayout& column) {
  auto* section = addSection(column, tr("Chosen step"));
  facts_ = makeLive(4, TextRole::kSecond);
  facts_->setObjectName("labelAccessStep");
  section->addWidget(facts_);
  along_ = new QSlider(Qt::Horizontal);
  along_->setObjectName("sliderAccessWay");
  along_->setAccessibleName(tr("Along the way"));
  along_->setRange(0, kAlongSteps);
  along_->setPageStep(kAlongSteps / 10);
  along_->setSingleStep(kAlongSteps / 100);
  section->addWidget(along_);
  aside_ = makeButton("buttonAccessAside", tr("Lay earlier parts aside"));
  aside_->setToolTip(tr("Moves the parts that go first next to the assembly, as one undo step"));
  feel_ = makeButton("buttonAccessFeel", tr("Feel it by hand"));
  feel_->setCheckable(true);
  feel_->setToolTip(tr("Selects the part and guides it softly along the way while you hold it"));
  section->addWidget(sideBySide({aside_, feel_}));
  keep_ = makeButton("buttonAccessKeep", tr("Keep as a motion"));
  by_hand_ = makeButton("buttonAccessByHand", tr("Show by hand instead"));
  section->addWidget(sideBySide({keep_, by_hand_}));
  connect(along_, &QSlider::valueChanged, this, &AccessPanel::showAlong);
  connect(aside_, &QPushButton::clicked, this, &AccessPanel::layAside);
  connect(feel_, &QPushButton::toggled, this, &AccessPanel::feel);
  connect(keep_, &QPushButton::clicked, this, &AccessPanel::keepMotion);
  connect(by_hand_, &QPushButton::clicked, this, &AccessPanel::useShown);
}

void AccessPanel::setShown(bool on) {
  shown_ = on;
  if (!on) feel_->setChecked(false);
  showStep();
}

void AccessPanel::useSelection() {
  const workcell::Entity* entity = host_.documentModel().document().find(host_.selection().current());
  if (entity == nullptr) {
    said_ = tr("Nothing is selected. Select the part that is to be taken out in the scene or in the tree.");
  } else {
    part_->setText(QString::fromStdString(entity->name));
    said_.clear();
  }
  refresh();
}

void AccessPanel::ask() {
  if (job_.isBusy()) return job_.cancel();
  said_.clear();
  AccessWish wish;
  wish.part = part_->text().toStdString();
  wish.persons = static_cast<AccessWish::Persons>(persons_->currentIndex());
  wish.tolerance = 1e-3 * tolerance_->value();
  wish.glove = 1e-3 * glove_->value();
  wish.tool_length = 1e-3 * tool_length_->value();
  wish.tool_diameter = 1e-3 * tool_diameter_->value();
  job_.ask(wish);
}

const access::RemovalStep* AccessPanel::step() const {
  const int row = steps_->currentRow();
  if (job_.answer() == nullptr || row < 0 || row >= static_cast<int>(job_.answer()->order.size())) return nullptr;
  return &job_.answer()->order[static_cast<std::size_t>(row)];
}

workcell::EntityId AccessPanel::entityOf(const access::RemovalStep& step) const {
  return job_.answer()->removal->units()[step.unit].entity;
}

QString AccessPanel::wordsOf(const access::RemovalStep& step) const {
  using Kind = access::RemovalWay::Kind;
  const QString length = shownText(Text("%1", Text::Length{step.way.length()}));
  switch (step.way.kind) {
    case Kind::kStraight: return tr("straight, %1").arg(length);
    case Kind::kBent: return tr("in several pieces, %1").arg(length);
    case Kind::kPlanned: return tr("planned, %1").arg(length);
    case Kind::kShown: return tr("shown by hand, %1").arg(length);
  }
  return {};
}

void AccessPanel::takeAnswer() {
  const int row = steps_->currentRow();
  {
    const QSignalBlocker quiet(steps_);
    steps_->clear();
    people_->clear();
    if (const access::AccessAnswer* answer = job_.answer()) {
      for (std::size_t i = 0; i < answer->order.size(); ++i)
        steps_->addItem(QStringLiteral("%1  %2: %3").arg(i + 1).arg(
            QString::fromStdString(answer->order[i].name), wordsOf(answer->order[i])));
      for (const access::BodyAccess& person : answer->people) {
        QString words = shownText(access::personText(person));
        if (person.reached) words += ' ' + tr("RULA %1, REBA %2.").arg(person.scores.rula()).arg(person.scores.reba());
        people_->addItem(words);
      }
      steps_->setCurrentRow(row >= 0 && row < steps_->count() ? row : steps_->count() - 1);
    }
  }
  showStep();
}

void AccessPanel::refresh() {
  const access::AccessAnswer* answer = job_.answer();
  const bool busy = job_.isBusy();
  ask_->setText(busy ? tr("Stop now") : tr("Find the way out"));
  ask_->setEnabled(busy || !part_->text().isEmpty());
  bar_->setValue(busy ? static_cast<int>(1000 * job_.progress()) : 0);
  report_->setEnabled(answer != nullptr && !busy);
  const access::RemovalStep* chosen = step();
  for (QWidget* one : {static_cast<QWidget*>(along_), static_cast<QWidget*>(feel_)}) one->setEnabled(chosen != nullptr);
  for (QWidget* one : {keep_, by_hand_}) one->setEnabled(chosen != nullptr && !busy);
  aside_->setEnabled(chosen != nullptr && steps_->currentRow() > 0);
  if (busy) return result_->setText(tr("Looking for ways, hands and persons. The cell stays as it is."));
  if (!said_.isEmpty()) return result_->setText(said_);
  if (answer == nullptr)
    return result_->setText(part_->text().isEmpty() ? tr("Select a part in the scene, then press Use selection.")
                                                    : QString());
  QString words = shownText(access::resultText(job_.question().part, *answer));
  if (!answer->blocked_by.empty()) {
    QStringList names;
    for (const std::string& name : answer->blocked_by) names << QString::fromStdString(name);
    words += ' ' + tr("In its way: %1.").arg(names.join(QStringLiteral(", ")));
  }
  if (job_.isOutdated()) words += ' ' + tr("The cell has changed since then. Ask again.");
  result_->setText(words);
}

void AccessPanel::showStep() {
  refresh();
  const access::RemovalStep* chosen = step();
  feel_->setChecked(false);
  {
    const QSignalBlocker quiet(along_);
    along_->setValue(kAlongSteps);
  }
  std::vector<SceneCurve> curves;
  if (chosen != nullptr && shown_) {
    SceneCurve line;
    for (const Pose& X_WE : chosen->way.X_WE) line.points_W.push_back(X_WE.p);
    line.role = SceneCurve::Role::kSelection;
    line.style = SceneCurve::Style::kSolid;
    curves.push_back(std::move(line));
  }
  host_.viewport().setCurves(kAccessOwner, std::move(curves));
  QString words = chosen == nullptr ? QString() : QString::fromStdString(chosen->name) + ": " + wordsOf(*chosen) + '.';
  if (chosen != nullptr && !chosen->clearances.empty() && std::isfinite(chosen->clearances.front().least_m)) {
    const access::NeighbourClearance& nearest = chosen->clearances.front();
    words += ' ' + tr("Least clearance %1, to %2.")
                       .arg(shownText(Text("%1", Text::Length{nearest.least_m})), QString::fromStdString(nearest.name));
    if (nearest.slides_m > 0.0)
      words += ' ' + tr("It slides along it for %1.").arg(shownText(Text("%1", Text::Length{nearest.slides_m})));
  }
  facts_->setText(words);
  showAlong();
}

void AccessPanel::showAlong() {
  const access::RemovalStep* chosen = step();
  std::vector<GhostPose> ghosts;
  if (chosen != nullptr && shown_ && !feel_->isChecked())
    ghosts = entityGhosts(host_.documentModel().document().state(), entityOf(*chosen),
                          chosen->way.at(static_cast<double>(along_->value()) / kAlongSteps), {});
  host_.viewport().scene().setGhosts(kAccessOwner, std::move(ghosts));
  host_.viewport().refresh();
}

void AccessPanel::feel(bool on) {
  const access::RemovalStep* chosen = step();
  if (!on || chosen == nullptr) {
    host_.recording().setGuide(std::nullopt);
    return showAlong();
  }
  workcell::Guide guide;
  guide.name = kAccessOwner;
  guide.kind = workcell::GuideKind::kTube;
  guide.entity = chosen->name;
  guide.radius = kTube;
  guide.help = kHelp;
  guide.lead = kLead;
  for (const Pose& X_WE : chosen->way.X_WE) guide.path.push_back(X_WE.p);
  host_.selection().set(entityOf(*chosen));
  host_.recording().setGuide(guide);
  said_ = host_.recording().isLive()
              ? tr("Take %1: a soft tube leads it along the way, and neighbours are felt. Lay earlier parts aside first.")
                    .arg(QString::fromStdString(chosen->name))
              : tr("The guide is set. Start the Virtual Desktop to feel it.");
  showAlong();
  refresh();
  said_.clear();
}

/// Measured as the command line measures what it writes; a way that misses is not kept.
void AccessPanel::keepMotion() {
  if (step() == nullptr) return;
  said_.clear();
  job_.keep(static_cast<std::size_t>(steps_->currentRow()));
}

void AccessPanel::addMotion(const trajectory::Trajectory& measured) {
  const std::string name = motions_.uniqueName(measured.name);
  const QString part = QString::fromStdString(measured.entity);
  if (!motions_.add(tr("Keep the way of %1").arg(part), {{name, measured}})) return;
  said_ = tr("The dock Trajectory plays it: %1.").arg(QString::fromStdString(name));
  refresh();
}

/// Beside the box, in a row along y: parts on top of each other would be in the way of the next.
void AccessPanel::layAside() {
  const access::RemovalStep* chosen = step();
  if (chosen == nullptr) return;
  const access::RemovalScene& removal = *job_.answer()->removal;
  const workcell::Document& document = host_.documentModel().document();
  dvec3 corner_W(removal.box_W().max.x + kAsideGap, removal.box_W().min.y, removal.box_W().min.z);
  std::vector<workcell::Command> commands;
  for (const access::RemovalStep& earlier : job_.answer()->order) {
    if (&earlier == chosen) break;
    const access::RemovalUnit& unit = removal.units()[earlier.unit];
    if (document.find(unit.entity) == nullptr) continue;
    Pose X_WE = earlier.way.X_WE.front();
    X_WE.p += corner_W - unit.bounds_W.min;
    corner_W.y += unit.bounds_W.max.y - unit.bounds_W.min.y + kAsideGap;
    commands.push_back(workcell::SetPlacement{unit.entity, X_WE});
  }
  host_.documentModel().executeAll(tr("Lay parts aside"), commands);
}

void AccessPanel::useShown() {
  const access::RemovalStep* chosen = step();
  if (chosen == nullptr) return;
  const Motion* motion = motions_.current();
  if (motion == nullptr || !motion->trajectory || motion->trajectory->entity != chosen->name) {
    said_ = tr("Record %1 while you take it out, from where it stands until it is out of the assembly. Then press this "
               "button with that motion chosen in the dock Trajectory.")
                .arg(QString::fromStdString(chosen->name));
  } else {
    said_.clear();
    job_.showByHand(static_cast<std::size_t>(steps_->currentRow()), motion->trajectory);
  }
  refresh();
}

void AccessPanel::writeReport() {
  if (job_.answer() == nullptr) return;
  const QString path = askToSave(this, tr("Write the report"), part_->text() + QStringLiteral(".pdf"),
                                 tr("Pages (*.pdf);;Web pages (*.html);;Tables (*.csv)"));
  if (path.isEmpty() || job_.answer() == nullptr) return;
  const access::Saying say = [](const Text& text) { return shownText(text).toStdString(); };
  const auto page = access::accessReport(job_.question(), *job_.answer(),
                                         {host_.documentModel().title().toStdString(),
                                          QDate::currentDate().toString(Qt::ISODate).toStdString(),
                                          languageNow().toStdString()},
                                         say);
  const auto written = ergonomics::writeReport(page, path.toStdString());
  if (written) return host_.messages().tell(Severity::kInformation, tr("The report is saved"), path);
  host_.messages().reportCause(Severity::kProblem, tr("The report was not saved"), written.error());
}

}  // namespace hapticell::app
