// SPDX-License-Identifier: Apache-2.0
#include "app/ergonomics/ergonomics_panel.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <map>

#include "app/ergonomics/height_strips.h"
#include "app/ergonomics/live_scores.h"
#include "app/ergonomics/load_rows.h"
#include "app/ergonomics/score_columns.h"
#include "app/ergonomics/sub_score_table.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/kit/file_dialog.h"
#include "app/kit/form.h"
#include "app/mannequin/mannequin_context.h"
#include "app/mannequin/mannequin_edits.h"
#include "app/style/library_text.h"
#include "app/style/segmented.h"

namespace hapticell::app {

using ergonomics::ColourMethod;
using ergonomics::PostureMethod;

namespace {
constexpr int kLoadTab = 4;

QVBoxLayout* makeRows(QWidget* page) {
  auto* rows = new QVBoxLayout(page);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(8);
  return rows;
}

QLabel* makeWords(const char* name, bool faint) {
  QLabel* words = makeLive(2, TextRole::kSecond, faint);
  words->setObjectName(name);
  return words;
}

/// Why the lifting equation does not take a lift, and what to do.
QString refusedLiftText(const Error& why, const ergonomics::WorkTask& task) {
  const std::map<std::string, QString> reasons{
      {"load_kg", QObject::tr("enter the load in Task data.")},
      {"repetitions_per_min", QObject::tr("enter the repetition in Task data.")},
      {"duration_h", task.duration_h ? QObject::tr("the equation covers shifts of up to 8 h.")
                                     : QObject::tr("enter the hours in a shift in Task data.")},
      {"grip",
       task.grip ? QObject::tr("it needs a good, fair or poor grip.") : QObject::tr("enter the grip in Task data.")},
      {"one_handed", QObject::tr("only one hand carries the load; it covers lifts with both hands. Use RULA or REBA.")},
      {"seated_or_kneeling",
       QObject::tr("the mannequin sits or kneels; it covers lifts while standing. Use RULA or REBA.")},
  };
  const auto found = reasons.find(english(why.place));
  return found == reasons.end() ? shownText(why) : found->second;
}

QString liftingLevelText(int level) {
  if (level == 1) return ErgonomicsPanel::tr("acceptable for nearly all");
  return level == 2 ? ErgonomicsPanel::tr("an increased risk for some") : ErgonomicsPanel::tr("a high risk");
}

}  // namespace

ErgonomicsPanel::ErgonomicsPanel(MannequinContext& context, LiveScores& scores, QWidget* parent)
    : QWidget(parent), context_(context), scores_(scores) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 10, 12, 10);
  column->setSpacing(8);
  empty_ = makeEmptyPage();
  column->addWidget(empty_);
  content_ = new QWidget;
  auto* parts = new QVBoxLayout(content_);
  parts->setContentsMargins(0, 0, 0, 0);
  parts->setSpacing(8);
  for (QWidget* part : {makeMethodRows(), makeWhyBox(), makeFigures()}) parts->addWidget(part);
  column->addWidget(content_);
  column->addStretch(1);
  listen();
  showScores();
}

QWidget* ErgonomicsPanel::makeEmptyPage() {
  auto* page = new QWidget;
  auto* nothing = new QVBoxLayout(page);
  auto* words = makeLabel(tr("No mannequin in the cell to score."), TextRole::kText, true);
  words->setWordWrap(true);
  auto* add = new QPushButton(tr("Add mannequin"));
  add->setProperty("main", true);
  connect(add, &QPushButton::clicked, this, &ErgonomicsPanel::addWanted);
  nothing->addWidget(words);
  nothing->addWidget(add, 0, Qt::AlignLeft);
  return page;
}

QWidget* ErgonomicsPanel::makeMethodRows() {
  auto* page = new QWidget;
  auto* rows = makeRows(page);
  methods_ = new Segmented({tr("RULA"), tr("REBA"), tr("OWAS"), tr("EN, ISO"), tr("Load")});
  methods_->setObjectName("segmentsMethod");
  methods_->setCurrent(0);
  methods_->button(3)->setToolTip(
      tr("EN 1005-4 and ISO 11226: zones and holding times of the parts; the outline of EAWS; joint comfort"));
  methods_->button(kLoadTab)->setToolTip(
      tr("The lifting equation and the forces on the hands; colours stay those of RULA"));
  auto* task = new QPushButton(tr("Task data…"));
  task->setObjectName("buttonTaskData");
  connect(task, &QPushButton::clicked, this, &ErgonomicsPanel::taskWanted);
  auto* report = new QPushButton(tr("Report…"));
  report->setObjectName("buttonReport");
  connect(report, &QPushButton::clicked, this, &ErgonomicsPanel::reportWanted);
  live_ = makeWords("labelLive", true);
  lift_ = makeWords("labelLift", false);
  columns_ = new ScoreColumns(scores_);
  all_bodies_ = new QCheckBox(tr("Show all four in the scene"));
  all_bodies_->setObjectName("checkAllBodies");
  all_bodies_->setToolTip(tr("As ghosts at the same task; click a column to show only that mannequin"));
  rows->addWidget(methods_);
  rows->addWidget(sideBySide({task, report}));
  rows->addWidget(live_);
  rows->addWidget(columns_);
  rows->addWidget(lift_);
  rows->addWidget(all_bodies_);
  return page;
}

QWidget* ErgonomicsPanel::makeWhyBox() {
  auto* box = new QFrame;
  box->setFrameShape(QFrame::StyledPanel);
  auto* inside = new QVBoxLayout(box);
  inside->setContentsMargins(10, 8, 10, 8);
  title_ = makeLabel({}, TextRole::kSection);
  title_->setObjectName("labelWhyTitle");
  why_ = makeLive(6, TextRole::kText);
  why_->setObjectName("labelWhy");
  inside->addWidget(title_);
  inside->addWidget(why_);
  auto* buttons = new QHBoxLayout;
  show_posture_ = new QPushButton(tr("Show this posture"));
  show_posture_->setObjectName("buttonShowPosture");
  show_posture_->setProperty("main", true);
  auto* search = new QPushButton(tr("Workplace search…"));
  search->setObjectName("buttonSearchWorkplace");
  connect(search, &QPushButton::clicked, this, &ErgonomicsPanel::searchWanted);
  buttons->addWidget(show_posture_);
  buttons->addWidget(search);
  buttons->addStretch(1);
  inside->addLayout(buttons);
  return box;
}

QWidget* ErgonomicsPanel::makeFigures() {
  auto* page = new QWidget;
  auto* rows = makeRows(page);
  table_title_ = makeLabel({}, TextRole::kSecond, true);
  sub_scores_ = new SubScoreTable;
  sums_ = makeWords("labelSums", true);
  limits_ = new QPushButton(tr("Custom hand force limits…"));
  limits_->setObjectName("buttonOwnLimits");
  limits_->setToolTip(tr("Load your own table of hand force limits; none is included"));
  missing_ = makeWords("labelPartial", false);
  heights_ = new HeightStrips(scores_);
  rows->addWidget(table_title_);
  rows->addWidget(sub_scores_);
  rows->addWidget(sums_);
  rows->addWidget(limits_, 0, Qt::AlignLeft);
  rows->addWidget(missing_);
  rows->addWidget(makeLabel(tr("RULA by working height, four mannequins"), TextRole::kSecond, true));
  rows->addWidget(heights_);
  return page;
}

void ErgonomicsPanel::listen() {
  connect(methods_, &Segmented::chosen, this, [this](int i) {
    tab_.shows_load = i == kLoadTab;
    tab_.method = tab_.shows_load ? ColourMethod::kRula : static_cast<ColourMethod>(i);
    columns_->setMethod(tab_.method);
    showScores();
    emit methodChanged();
  });
  connect(all_bodies_, &QCheckBox::toggled, this, [this] { emit bodyChosen(chosenBody()); });
  connect(&context_.host().documentModel(), &DocumentModel::closing, this, [this] { all_bodies_->setChecked(false); });
  connect(show_posture_, &QPushButton::clicked, this, &ErgonomicsPanel::takeBetterPosture);
  connect(limits_, &QPushButton::clicked, this, &ErgonomicsPanel::chooseOwnLimits);
  connect(columns_, &ScoreColumns::chose, this, &ErgonomicsPanel::bodyChosen);
  connect(&pace_, &PacedRefresh::due, this, &ErgonomicsPanel::showScores);
  connect(&scores_, &LiveScores::changed, this, [this] { pace_.ask(scores_.isEmpty()); });
  connect(&scores_, &LiveScores::adviceChanged, this, &ErgonomicsPanel::showAdvice);
}

bool ErgonomicsPanel::showsAllBodies() const {
  return all_bodies_->isChecked();
}

int ErgonomicsPanel::chosenBody() const {
  return columns_->chosen();
}

void ErgonomicsPanel::takeBetterPosture() {
  const workcell::Entity* entity = context_.entity();
  const ergonomics::BetterPlace* better = betterPlace();
  if (!entity || !context_.isFree() || !better) return;
  context_.host().documentModel().executeAll(tr("Improve the posture of %1").arg(shown(entity->name)),
                                             {postureCommand(*entity, better->posture)});
}

void ErgonomicsPanel::chooseOwnLimits() {
  const QString file = askToOpen(this, tr("Custom hand force limits"), {}, tr("Tables (*.csv);;All files (*)"));
  if (file.isEmpty()) return;
  const auto read = scores_.chooseOwnLimits(file);
  if (!read) context_.host().messages().reportCause(Severity::kProblem, tr("The limits were not read"), read.error());
}

void ErgonomicsPanel::showScores() {
  pace_.shown();
  const bool any = !scores_.isEmpty();
  empty_->setVisible(!any);
  content_->setVisible(any);
  if (!any) return;
  const auto& scores = scores_.scores();
  live_->setText(tr("RULA left %1, right %2 · EAWS outline %3 points")
                     .arg(scores.sides[0].rula_score)
                     .arg(scores.sides[1].rula_score)
                     .arg(scores.eaws_points, 0, 'f', 0));
  columns_->update();
  sub_scores_->setRows(tab_.shows_load ? loadRows(scores_) : subScoreRows(scores, tab_.method));
  table_title_->setText(tab_.shows_load ? tr("Lift (NIOSH) and forces on the hands")
                                        : tr("Sub-scores of the worse side"));
  const QString sums = sumsText();
  sums_->setText(sums);
  limits_->setVisible(tab_.shows_load);
  lift_->setText(liftText());
  QStringList missing;
  for (const auto& name : scores.missing) missing << shown(ergonomics::word(name, shownLanguage()));
  missing_->setText(missing.isEmpty()
                        ? QString()
                        : tr("Partial scores: %1 not entered. Complete them in Task data…").arg(missing.join(", ")));
  showAdvice();
}

QString ErgonomicsPanel::sumsText() const {
  if (tab_.shows_load) {
    return tr("The limit of a method is the start of its next class. Moments include the weight of the arms.") + ' ' +
           (scores_.ownLimits().isEmpty() ? tr("No strength table is included; you can load your own.")
                                          : tr("Custom limits: %1").arg(shown(scores_.ownLimits().source)));
  }
  if (tab_.method != ColourMethod::kRula && tab_.method != ColourMethod::kReba) return {};
  const bool rula = tab_.method == ColourMethod::kRula;
  const ergonomics::Rula by_rula;
  const ergonomics::Reba by_reba;
  const ergonomics::ScoredMethod* method = &by_rula;
  if (!rula) method = &by_reba;
  std::vector<int> values;
  const auto& side = scores_.scores().worse();
  for (std::size_t i = 0; i < method->subScores().size(); ++i)
    values.push_back(rula ? side.rula[i].value_or(method->subScores()[i].least)
                          : side.reba[i].value_or(method->subScores()[i].least));
  const auto evaluation = method->evaluate(values);
  QString sums;
  for (const auto& sum : evaluation.sums)
    sums += QString::fromLatin1(sum.name.data(), static_cast<qsizetype>(sum.name.size())).replace('_', ' ') +
            QStringLiteral(" %1, ").arg(sum.value);
  return sums + tr("final %1. A value on a class boundary belongs to the lower class.").arg(evaluation.score);
}

QString ErgonomicsPanel::liftText() const {
  const ergonomics::WorkTask& task = scores_.task();
  if (!task.is_lift) {
    return task.totalLoad().value_or(0.0) > 0.0
               ? tr("NIOSH does not apply: the load is held. If it is lifted, tick that in Task data.")
               : tr("NIOSH does not apply: nothing is lifted. Enter a lift and its load in Task data.");
  }
  const auto pose = mannequin::forwardKinematics(*scores_.figure(), scores_.posture());
  const auto lift = ergonomics::scoreLift(*scores_.figure(), pose, scores_.scores(), task);
  if (!lift) return tr("NIOSH does not apply: %1").arg(refusedLiftText(lift.error(), task));
  const double limit = lift->recommended_weight_limit_kg;
  if (!lift->lifting_index) return tr("NIOSH: limit 0 kg, no load is acceptable at this place");
  return tr("NIOSH: lifting index %1, %2 (%3 kg of a limit of %4 kg)")
      .arg(*lift->lifting_index, 0, 'f', 2)
      .arg(liftingLevelText(ergonomics::liftingLevel(lift->lifting_index)))
      .arg(*task.totalLoad(), 0, 'f', 1)
      .arg(limit, 0, 'f', 1);
}

ergonomics::PostureMethod ErgonomicsPanel::labelledMethod() const {
  const auto methods = shownMethods();
  return methods.empty() ? PostureMethod::kRula : methods.front();
}

std::vector<ergonomics::PostureMethod> ErgonomicsPanel::shownMethods() const {
  if (tab_.shows_load) return {};
  switch (tab_.method) {
    case ColourMethod::kRula:
      return {PostureMethod::kRula};
    case ColourMethod::kReba:
      return {PostureMethod::kReba};
    case ColourMethod::kOwas:
      return {PostureMethod::kOwas};
    case ColourMethod::kEn1005:
      break;
  }
  return {PostureMethod::kEn1005, PostureMethod::kIso11226, PostureMethod::kEaws};
}

const ergonomics::BetterPlace* ErgonomicsPanel::betterPlace() const {
  if (!scores_.advice()) return nullptr;
  const auto methods = tab_.shows_load ? std::vector{PostureMethod::kRula} : shownMethods();
  for (const PostureMethod method : methods) {
    if (const auto& better = scores_.advice()->better[static_cast<std::size_t>(method)]) return &*better;
  }
  return nullptr;
}

QString ErgonomicsPanel::whyTitle() const {
  const workcell::Entity* entity = context_.entity();
  QString what;
  if (tab_.shows_load) {
    what = tr("the lift and the forces");
  } else if (tab_.method == ColourMethod::kRula) {
    what = QString::number(scores_.scores().rula());
  } else {
    const PostureMethod method = labelledMethod();
    what = shown(ergonomics::scoreWords(method, ergonomics::scoreBy(scores_.scores(), method), shownLanguage()));
  }
  return tr("%1: why %2, and how to lower it").arg(entity ? shown(entity->name) : QString(), what);
}

QString ErgonomicsPanel::whyText() const {
  const QString later = tr("Suggestions appear when the mannequin stops moving.");
  if (tab_.shows_load) {
    const QString lift = scores_.liftAdviceText();
    if (!scores_.task().is_lift) return tr("The task is not a lift. The forces are below.");
    if (!lift.isEmpty()) return lift;
    return scores_.advice() ? tr("The lifting equation does not cover this lift.") : later;
  }
  if (tab_.method == ColourMethod::kRula) {
    const QString advice = scores_.adviceText(PostureMethod::kRula);
    return shown(ergonomics::whySentence(scores_.scores(), shownLanguage())) + ' ' +
           (advice.isEmpty() ? later : advice);
  }
  QStringList lines;
  for (const PostureMethod method : shownMethods()) {
    const QString advice = scores_.adviceText(method);
    const QString score =
        shown(ergonomics::scoreWords(method, ergonomics::scoreBy(scores_.scores(), method), shownLanguage()));
    if (!advice.isEmpty()) lines << (shownMethods().size() > 1 ? score + ". " + advice : advice);
  }
  return lines.isEmpty() ? later : lines.join('\n');
}

void ErgonomicsPanel::showAdvice() {
  if (scores_.isEmpty()) return;
  title_->setText(whyTitle());
  why_->setText(whyText());
  show_posture_->setEnabled(betterPlace() != nullptr && context_.isFree());
  heights_->update();
}

}  // namespace hapticell::app
