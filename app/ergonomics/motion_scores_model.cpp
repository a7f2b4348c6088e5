// SPDX-License-Identifier: Apache-2.0
#include "app/ergonomics/motion_scores_model.h"

#include <QFileInfo>
#include <algorithm>

#include "app/kit/beside.h"
#include "app/mannequin/joint_words.h"
#include "app/style/library_text.h"

namespace hapticell::app {
namespace {

std::vector<int> rulaOf(const mannequin::Figure& figure, const std::vector<mannequin::Posture>& postures,
                        const ergonomics::WorkTask& task) {
  std::vector<int> scores;
  scores.reserve(postures.size());
  mannequin::FigurePose pose;
  for (const mannequin::Posture& posture : postures) {
    mannequin::forwardKinematics(figure, posture, pose);
    scores.push_back(ergonomics::scorePosture(figure, posture, pose, task).rula());
  }
  return scores;
}

}  // namespace

Expected<std::shared_ptr<const MotionScoresModel::Motion>> MotionScoresModel::read(const std::string& path,
                                                                                   const mannequin::Figure& figure,
                                                                                   const ergonomics::WorkTask& task) {
  const auto clip = mannequin::readRecordedMotion(path);
  HAPTICELL_TRY(clip);
  auto motion = std::make_shared<Motion>();
  motion->assumptions = clip->assumptions;
  auto own = mannequin::retarget(figure, *clip);
  HAPTICELL_TRY(own);
  if (own->postures.empty())
    return makeError({.file = path, .place = "frames", .found = "none", .expected = "a motion"});
  motion->own = rulaOf(figure, own->postures, task);
  motion->phase = ergonomics::worstPhase(motion->own, own->frame_time);
  motion->seconds = own->frame_time * static_cast<double>(own->postures.size());
  motion->postures = std::move(own->postures);
  motion->beyond = std::move(own->frames_beyond_limit);
  const auto bodies = mannequin::boundaryFigures();
  const mannequin::Posture& worst = motion->postures[motion->phase.shown];
  motion->bodies = ergonomics::atSameTask(bodies, figure, worst, task);
  motion->places = ergonomics::betterPlaces(figure, worst, task);
  for (std::size_t i = 0; i < motion->bands.size(); ++i) {
    const auto same = mannequin::retarget(bodies[i].figure, *clip);
    HAPTICELL_TRY(same);
    for (const int score : rulaOf(bodies[i].figure, same->postures, task))
      motion->bands[i].push_back(ergonomics::bandOfRula(score));
  }
  return std::shared_ptr<const Motion>(std::move(motion));
}

void MotionScoresModel::open(const QString& path, std::shared_ptr<const mannequin::Figure> figure,
                             const ergonomics::WorkTask& task) {
  if (busy_ || !figure) return;
  path_ = path;
  figure_ = std::move(figure);
  task_ = task;
  start(true);
}

void MotionScoresModel::follow(const std::shared_ptr<const mannequin::Figure>& figure,
                               const ergonomics::WorkTask& task) {
  if (busy_ || !motion_ || !figure || (figure == figure_ && task == task_)) return;
  figure_ = figure;
  task_ = task;
  start(false);
}

void MotionScoresModel::start(bool is_new) {
  busy_ = true;
  emit changed();
  runInThreadPool(
      this, [path = path_.toStdString(), figure = figure_, task = task_] { return read(path, *figure, task); },
      [this, is_new, path = path_, question = question_](Expected<std::shared_ptr<const Motion>> motion) {
        if (question != question_) return;
        busy_ = false;
        if (motion) {
          motion_ = std::move(*motion);
          name_ = QFileInfo(path).completeBaseName();
        } else {
          emit failed(shownText(motion.error()));
        }
        emit changed();
        if (motion_ && is_new) emit opened();
      });
}

std::optional<ergonomics::MotionPhase> MotionScoresModel::phase() const {
  if (!motion_) return std::nullopt;
  const double frame = motion_->seconds / static_cast<double>(motion_->postures.size());
  const auto at = [frame](std::size_t i) { return frame * static_cast<double>(i); };
  const ergonomics::ScorePhase& found = motion_->phase;
  return ergonomics::MotionPhase{name_.toStdString(), at(found.first), at(found.last + 1), at(found.shown),
                                 found.score};
}

void MotionScoresModel::clear() {
  ++question_;
  busy_ = false;
  motion_ = nullptr;
  path_.clear();
  figure_ = nullptr;
  name_.clear();
  emit changed();
}

QString MotionScoresModel::mostBeyond() const {
  if (!motion_ || motion_->beyond.empty()) return {};
  const auto most = std::max_element(motion_->beyond.begin(), motion_->beyond.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  return tr("%1 in %n frames", nullptr, most->second).arg(jointNameWithSide(QString::fromStdString(most->first)));
}

QString MotionScoresModel::beyondLimits() const {
  QStringList said;
  if (motion_)
    for (const auto& [limit, frames] : motion_->beyond)
      said << tr("%1 in %n frames", nullptr, frames).arg(jointNameWithSide(QString::fromStdString(limit)));
  return said.join(", ");
}

QString MotionScoresModel::assumptions() const {
  QStringList said;
  if (motion_)
    for (const Text& each : motion_->assumptions) said << shownText(each);
  return said.join("; ");
}

double MotionScoresModel::shareAbove(std::size_t body) const {
  const auto& all = bands(body);
  const auto high = std::count_if(all.begin(), all.end(), [](int band) { return band >= 2; });
  return all.empty() ? 0.0 : static_cast<double>(high) / static_cast<double>(all.size());
}

std::vector<ergonomics::ReportBlock::Strip> MotionScoresModel::strips() const {
  std::vector<ergonomics::ReportBlock::Strip> strips;
  if (!motion_) return strips;
  const char* const names[]{"P5 woman", "P50 woman", "P50 man", "P95 man"};
  for (std::size_t i = 0; i < 4; ++i) strips.push_back(ergonomics::stripOf(names[i], bands(i)));
  return strips;
}

}  // namespace hapticell::app
