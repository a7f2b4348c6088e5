// SPDX-License-Identifier: Apache-2.0
#include "app/ergonomics/live_scores.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/user_settings.h"
#include "app/kit/thread_pool_task.h"
#include "app/mannequin/mannequin_context.h"
#include "app/style/units.h"

namespace hapticell::app {
namespace {

constexpr auto kLimitsKey = "ergonomics/force_limits";
// ms without motion until advice is looked for (docs/dev/ergonomics.md): a hand that moves pauses for less. Half:
// threads begin for nothing; twice: advice seems late.
constexpr int kRestMilliseconds = 350;
// ms: four bodies are solved ten times a second at most, as numbers cannot be read more often. Half: twice the work
// while dragging; twice: columns lag.
constexpr int kBodiesMilliseconds = 90;
// m that the hands' targets go down and up, and its steps: heights of a table that are chosen between. Our choice.
// Half: good heights are out of range; twice the step: they are known to 60 mm.
constexpr double kLowest = -0.30, kHighest = 0.30, kRise = 0.03;

bool samePosture(const mannequin::Posture& a, const mannequin::Posture& b) {
  return a.angles == b.angles && a.X_WR.p == b.X_WR.p && a.X_WR.q == b.X_WR.q;
}

double workHeight(const mannequin::Figure& figure, const mannequin::Posture& posture) {
  const auto pose = mannequin::forwardKinematics(figure, posture);
  const auto active = ergonomics::activeHands(pose, posture);
  double height = 0.0, count = 0.0;
  for (const auto side : {mannequin::Side::kLeft, mannequin::Side::kRight}) {
    if (!active[static_cast<std::size_t>(side)]) continue;
    height += (mannequin::handPose(pose, side) * figure.p_HandGrip[static_cast<std::size_t>(side)]).z;
    count += 1.0;
  }
  return height / std::max(1.0, count);
}

/// The rise whose worst body fares best; of equal ones the nearest to where it is.
std::optional<double> bestRise(const LiveScores::Advice& advice) {
  std::optional<double> best;
  int least = 99;
  for (std::size_t i = 0; i < advice.rises.size(); ++i) {
    int worst = 0;
    for (const auto& scores : advice.by_height) worst = std::max(worst, scores[i] == 0 ? 99 : scores[i]);
    if (worst < least || (worst == least && best && std::abs(advice.rises[i]) < std::abs(*best) - 1e-9)) {
      least = worst;
      best = advice.rises[i];
    }
  }
  return least < 99 ? best : std::nullopt;
}

std::optional<ergonomics::LiftingAdvice> liftAdvice(const mannequin::Figure& figure, const mannequin::FigurePose& pose,
                                                    const ergonomics::PostureScores& scores,
                                                    const ergonomics::WorkTask& task) {
  if (!task.is_lift) return std::nullopt;
  const auto lift = ergonomics::liftOf(figure, pose, scores, task);
  const auto result = lift ? ergonomics::lift(*lift) : tl::unexpected(lift.error());
  if (!result) return std::nullopt;
  return ergonomics::adviseLift(*lift, *result);
}

/// Which way a shift goes most, for one who looks along `ahead_W`; %1 is how far.
QString shiftText(const dvec3& shift_W, const dvec3& ahead_W) {
  if (std::abs(shift_W.z) > 1e-6)
    return shift_W.z < 0.0 ? LiveScores::tr("Lowering the work by %1") : LiveScores::tr("Raising the work by %1");
  const double forward = glm::dot(shift_W, ahead_W);
  if (forward < -0.5 * glm::length(shift_W)) return LiveScores::tr("Bringing the work %1 nearer");
  if (forward > 0.5 * glm::length(shift_W)) return LiveScores::tr("Moving the work %1 farther away");
  return LiveScores::tr("Moving the work %1 to the side");
}

}  // namespace

LiveScores::LiveScores(MannequinContext& context, QObject* parent)
    : QObject(parent), context_(context), figures_(mannequin::boundaryFigures()) {
  rests_.setSingleShot(true);
  rests_.setInterval(kRestMilliseconds);
  connect(&rests_, &QTimer::timeout, this, &LiveScores::advise);
  const QString limits = context_.host().userSettings().value(kLimitsKey).toString();
  if (limits.isEmpty()) return;
  if (auto read = ergonomics::readForceTable(limits.toStdString())) own_limits_ = std::move(*read);
}

Expected<void> LiveScores::chooseOwnLimits(const QString& file) {
  UserSettings& settings = context_.host().userSettings();
  if (file.isEmpty()) {
    own_limits_ = {};
    settings.remove(kLimitsKey);
  } else {
    auto read = ergonomics::readForceTable(file.toStdString());
    HAPTICELL_TRY(read);
    own_limits_ = std::move(*read);
    settings.setValue(kLimitsKey, file);
  }
  emit changed();
  return {};
}

int LiveScores::ownBody() const {
  if (!figure_) return -1;
  for (std::size_t i = 0; i < figures_.size(); ++i) {
    const mannequin::Figure& other = figures_[i].figure;
    const double off = other.body[mannequin::Dimension::kStature] - figure_->body[mannequin::Dimension::kStature];
    if (other.sex == figure_->sex && std::abs(off) < mannequin::kSameStature) return static_cast<int>(i);
  }
  return -1;
}

void LiveScores::clear() {
  rests_.stop();
  ++question_;
  scores_.reset();
  bodies_.clear();
  advice_.reset();
  figure_.reset();
  task_ = {};
  has_task_ = false;
  emit changed();
}

void LiveScores::look() {
  const workcell::Entity* entity = context_.entity();
  if (!entity) {
    if (!isEmpty()) clear();
    return;
  }
  const mannequin::Posture posture = context_.posture();
  const auto* given = context_.host().documentModel().document().state().workTaskOf(entity->name);
  const ergonomics::WorkTask task = given ? *given : ergonomics::WorkTask{};
  const bool same = figure_ == entity->figure() && scores_ && samePosture(posture, posture_) && task == task_ &&
                    has_task_ == (given != nullptr);
  if (same && !bodies_late_) return;
  figure_ = entity->figure();
  posture_ = posture;
  task_ = task;
  has_task_ = given != nullptr;
  score();
}

void LiveScores::score() {
  const auto pose = mannequin::forwardKinematics(*figure_, posture_);
  scores_ = ergonomics::scorePosture(*figure_, posture_, pose, task_);
  bodies_late_ = since_bodies_.isValid() && since_bodies_.elapsed() < kBodiesMilliseconds;
  if (!bodies_late_) {
    bodies_ = ergonomics::atSameTask(figures_, *figure_, posture_, task_);
    since_bodies_.start();
  }
  advice_.reset();
  ++question_;
  rests_.start();
  emit changed();
}

void LiveScores::advise() {
  if (isEmpty()) return;
  if (asking_) return rests_.start();
  asking_ = true;
  runInThreadPool(
      this,
      [figure = figure_, posture = posture_, task = task_, figures = figures_] {
        Advice advice;
        const auto pose = mannequin::forwardKinematics(*figure, posture);
        const auto scores = ergonomics::scorePosture(*figure, posture, pose, task);
        for (const auto method : ergonomics::kPostureMethods)
          advice.methods[static_cast<std::size_t>(method)] = ergonomics::advise(scores, method, task);
        advice.lift = liftAdvice(*figure, pose, scores, task);
        advice.better = ergonomics::betterPlaces(*figure, posture, task);
        for (double rise = kLowest; rise < kHighest + 1e-9; rise += kRise) advice.rises.push_back(rise);
        advice.by_height = ergonomics::scoresByHeight(figures, *figure, posture, task, advice.rises);
        advice.best_rise = bestRise(advice);
        advice.target_height = workHeight(*figure, posture);
        return advice;
      },
      [this, question = question_](Advice advice) {
        asking_ = false;
        if (question != question_) return;
        advice_ = std::move(advice);
        emit adviceChanged();
      });
}

QString LiveScores::placeText(ergonomics::PostureMethod method) const {
  const auto& better = advice_->better[static_cast<std::size_t>(method)];
  if (!better)
    return tr("Moving the work by up to %1 does not lower the action level for this mannequin.")
        .arg(lengthText(0.6, 0));
  const dvec3 shift = better->shift_W;
  const QString far = lengthText(glm::length(shift), 0);
  const dvec3 ahead = posture_.X_WR.rotate({1.0, 0.0, 0.0});
  const QString how = shiftText(shift, ahead).arg(far);
  return tr("%1 gives %2.").arg(how, shown(ergonomics::scoreWords(method, better->score, shownLanguage())));
}

QString LiveScores::adviceText(ergonomics::PostureMethod method) const {
  if (!advice_) return {};
  const ergonomics::MethodAdvice& advice = advice_->methods[static_cast<std::size_t>(method)];
  if (advice.now.level <= ergonomics::leastLevel(method)) return tr("No change is needed.");
  QString text;
  // Of RULA the sentence before it names what drives it.
  if (const auto drivers = ergonomics::driverWords(advice, shownLanguage());
      !drivers.empty() && method != ergonomics::PostureMethod::kRula)
    text = tr("Driven by %1. ").arg(shown(drivers));
  const QString next = shown(ergonomics::nextLevelWords(advice, shownLanguage()));
  text += advice.next ? tr("Nearest posture: %1. ").arg(next) : next + ' ';
  return text + placeText(method);
}

QString LiveScores::liftAdviceText() const {
  if (!advice_ || !advice_->lift) return {};
  const ergonomics::LiftingAdvice& lift = *advice_->lift;
  QString text = tr("Most important first: %1.").arg(shown(ergonomics::liftingDriverWords(lift)));
  if (lift.drivers.empty()) text = tr("No multiplier is below 1.");
  const QString next = shown(ergonomics::liftingNextWords(lift, shownLanguage()));
  return next.isEmpty() ? text : text + ' ' + tr("To lower it: %1.").arg(next);
}

ergonomics::Language shownLanguage() {
  return ergonomics::languageOf(QLocale().name().toStdString());
}

QString shown(const std::string& text) {
  return QString::fromStdString(text);
}

}  // namespace hapticell::app
