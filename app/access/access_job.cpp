// SPDX-License-Identifier: Apache-2.0
#include "app/access/access_job.h"

#include <algorithm>

#include "access/removal_check.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "manipulation/scene/scene_service.h"
#include "mannequin/body/anthropometry.h"

namespace hapticell::app {

namespace {

/// m/s of kept motions, as the command line writes them.
constexpr double kKeptSpeed = 0.1;

using access::AccessAnswer;
using access::AccessQuestion;

Expected<std::vector<mannequin::NamedFigure>> personsOf(AccessWish::Persons persons) {
  using Persons = AccessWish::Persons;
  if (persons == Persons::kNobody) return std::vector<mannequin::NamedFigure>();
  if (persons == Persons::kBoundary) return mannequin::boundaryFigures();
  const auto sex = persons == Persons::kMen ? mannequin::Sex::kMale : mannequin::Sex::kFemale;
  std::vector<mannequin::NamedFigure> bodies;
  for (const int percentile : {5, 50, 95}) {
    const auto stature = mannequin::statureOfPercentile(sex, percentile);
    HAPTICELL_TRY(stature);
    auto figure = mannequin::makeFigure({.sex = sex, .stature = *stature});
    HAPTICELL_TRY(figure);
    bodies.push_back({"P" + std::to_string(percentile) + (persons == Persons::kMen ? "M" : "F"), std::move(*figure)});
  }
  return bodies;
}

/// The answer with the shown way in place of that step's.
Expected<AccessAnswer> withShown(const AccessQuestion& question, AccessAnswer answer, std::size_t at,
                                 const trajectory::Trajectory& shown, const std::atomic<bool>& stop) {
  access::RemovalStep& step = answer.order[at];
  auto way = access::checkedWay(*answer.removal, step.unit, step.gone, shown);
  HAPTICELL_TRY(way);
  step.way = std::move(*way);
  step.clearances = access::clearances(*answer.removal, step.unit, step.gone, step.way);
  if (at + 1 == answer.order.size() && !question.people.bodies.empty())
    answer.people = access::bodyAccess(*answer.removal, step.unit, step.gone, step.way, question.people, stop);
  if (stop) return makeError({.found = "stopped before the shown way was checked"});
  return answer;
}

}  // namespace

AccessJob::AccessJob(Host& host, QObject* parent) : QObject(parent), host_(host) {
  connect(&work_, &BackgroundWork::progressed, this, &AccessJob::progressed);
  connect(&host_.documentModel(), &DocumentModel::closing, this, &AccessJob::drop);
}

AccessJob::~AccessJob() {
  *stop_ = true;
}

void AccessJob::drop() {
  cancel();
  answer_.reset();
  emit changed();
}

void AccessJob::cancel() {
  *stop_ = true;
  work_.cancel();
}

void AccessJob::start(const QString& name, BackgroundWork::Work work) {
  work_.start(name, std::move(work),
              [this, number = host_.documentModel().number(), stop = stop_](const Error& error) {
                if (number == host_.documentModel().number() && !*stop) emit failed(error);
              });
}

void AccessJob::ask(const AccessWish& wish) {
  if (isBusy()) return;
  answer_.reset();
  emit changed();
  stop_ = std::make_shared<std::atomic<bool>>(false);
  const workcell::Document& document = host_.documentModel().document();
  AccessQuestion question;
  question.part = wish.part;
  question.tolerance = wish.tolerance;
  question.people.glove = wish.glove;
  if (wish.tool_length > 0.0) question.people.tool = {wish.tool_length, 0.5 * wish.tool_diameter};
  if (const workcell::Entity* part = document.findByName(wish.part)) question.people.load_kg = part->contact.mass;
  X_WE_.clear();
  for (const auto& entity : document.state().entities) X_WE_[entity->id] = entity->X_WE;
  start(tr("Access to %1").arg(QString::fromStdString(wish.part)),
        [this, question, stop = stop_, persons = wish.persons, scenes = host_.scenes(),
         source = manipulation::sourceOf(document, manipulation::pairDefaults(host_.configuration())),
         number = host_.documentModel().number()](
            workcell::ImportMonitor& monitor) mutable -> Expected<BackgroundWork::Then> {
          auto bodies = personsOf(persons);
          HAPTICELL_TRY(bodies);
          question.people.bodies = std::move(*bodies);
          question.scene = scenes->prepare(source);
          auto answer = access::accessOf(question, [&](double share) { monitor.report({}, share); }, *stop);
          HAPTICELL_TRY(answer);
          const auto kept = std::make_shared<const AccessAnswer>(std::move(*answer));
          return BackgroundWork::Then([this, question, kept, number] {
            if (number != host_.documentModel().number() || !kept->is_complete) return emit changed();
            question_ = question;
            answer_ = kept;
            emit changed();
          });
        });
}

void AccessJob::showByHand(std::size_t step, std::shared_ptr<const trajectory::Trajectory> shown) {
  if (isBusy()) return;
  stop_ = std::make_shared<std::atomic<bool>>(false);
  start(tr("Check the shown way"),
        [this, question = question_, given = answer_, step, shown, stop = stop_](
            workcell::ImportMonitor&) -> Expected<BackgroundWork::Then> {
          auto answer = withShown(question, *given, step, *shown, *stop);
          HAPTICELL_TRY(answer);
          const auto kept = std::make_shared<const AccessAnswer>(std::move(*answer));
          return BackgroundWork::Then([this, given, kept] {
            if (answer_ == given) answer_ = kept;
            emit changed();
          });
        });
}

void AccessJob::keep(std::size_t step) {
  if (isBusy()) return;
  stop_ = std::make_shared<std::atomic<bool>>(false);
  start(tr("Measure the way"), [this, given = answer_, step](workcell::ImportMonitor&) -> Expected<BackgroundWork::Then> {
    const access::RemovalStep& asked = given->order[step];
    auto motion = access::keptMotion(*given->removal, asked.unit, asked.gone, asked.way, kKeptSpeed);
    HAPTICELL_TRY(motion);
    const auto measured = std::make_shared<const trajectory::Trajectory>(std::move(*motion));
    return BackgroundWork::Then([this, given, measured] {
      if (answer_ == given) emit kept(measured);
    });
  });
}

bool AccessJob::isOutdated() const {
  if (!answer_) return false;
  const workcell::Document& document = host_.documentModel().document();
  for (const auto& [id, X_WE] : X_WE_) {
    const bool goes = std::any_of(answer_->order.begin(), answer_->order.end(), [&, entity = id](const auto& step) {
      const auto& parts = answer_->removal->units()[step.unit].parts;  // What is attached goes too.
      return std::any_of(parts.begin(), parts.end(), [&](const auto& one) { return one.part->entity == entity; });
    });
    const workcell::Entity* now = document.find(id);
    if (now == nullptr) return true;
    constexpr double kSame = 1e-9;  // m: rounding. Half, twice: the same.
    if (!goes && glm::length(now->X_WE.p - X_WE.p) > kSame) return true;
  }
  return false;
}

}  // namespace hapticell::app
