// SPDX-License-Identifier: Apache-2.0
#include "app/mannequin/figure_drag.h"

#include <algorithm>
#include <atomic>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/mannequin/mannequin_context.h"
#include "app/style/library_text.h"
#include "manipulation/scene/scene_service.h"
#include "mannequin/posture/forward_kinematics.h"
#include "mannequin/shape/figure_model.h"

namespace hapticell::app {

namespace {

// m: the hand is where it was put, but for the solver's rounding of 1e-5. Half: it is sought again for nothing; twice:
// no effect.
constexpr double kSamePlace = 2e-5;

}  // namespace

/// Of the worker's thread alone, but for what is newer.
struct FigureDrag::Work {
  std::atomic<bool> has_newer{false};  ///< The mouse is elsewhere, or let go: no way round is looked for any longer.
  config::Configuration configuration;
  std::unique_ptr<manipulation::FigureWay> way;
};

FigureDrag::FigureDrag(MannequinContext& context, QObject* parent)
    : QObject(parent), context_(context), work_(std::make_shared<Work>()) {
  pool_.setMaxThreadCount(1);
  work_->configuration = context.host().configuration();
  connect(&context_, &MannequinContext::documentChanged, this, &FigureDrag::forgetReach);
  connect(&context_.host().documentModel(), &DocumentModel::closing, this, &FigureDrag::forgetCell);
}

FigureDrag::~FigureDrag() {
  pool_.clear();
  pool_.waitForDone();
}

void FigureDrag::begin(const QString& text, const manipulation::MovedBy& moved_by, Turn turn) {
  const workcell::Entity* entity = context_.entity();
  if (open_ || !entity || !context_.isFree()) return;
  entity_ = entity->id;
  moved_by_ = moved_by;
  open_ = true;
  ending_ = under_way_ = false;
  keep_ = true;
  wanted_.reset();
  reach_.reset();
  context_.host().documentModel().beginStep(text);
  busy_ = true;
  const workcell::PairDefaults defaults = manipulation::pairDefaults(context_.host().configuration());
  manipulation::HoldOptions options{moved_by, entity->contact.on_contact, entity->contact.force_class};
  pool_.start([this, work = work_, id = entity_, options, turn, scenes = context_.host().scenes(),
               source = manipulation::sourceOf(context_.host().documentModel().document(), defaults)] {
    auto way = manipulation::FigureWay::take(scenes->prepare(source), id, options, turn, work->configuration);
    QString problem;
    if (way) {
      work->way = std::move(*way);
      work->way->setInterrupted([newer = &work->has_newer] { return newer->load(); });
    } else {
      work->way.reset();
      problem = shownText(way.error());
    }
    QMetaObject::invokeMethod(
        this,
        [this, problem] {
          busy_ = false;
          if (!problem.isEmpty()) return refuse(problem);
          pump();
        },
        Qt::QueuedConnection);
  });
}

void FigureDrag::moveTo(const Pose& X_WM) {
  if (!open_ || ending_) return;
  wanted_ = X_WM;
  work_->has_newer = true;
  pump();
}

void FigureDrag::end(bool keep) {
  if (!open_) return;
  ending_ = true;
  keep_ = keep;
  if (!keep) {
    wanted_.reset();
    work_->has_newer = true;
  }
  pump();
}

void FigureDrag::pump() {
  if (busy_) return;
  if (!wanted_ && !under_way_) {
    if (ending_) finish();
    return;
  }
  busy_ = under_way_ = true;
  work_->has_newer = false;
  pool_.start([this, work = work_, aim = wanted_] {
    if (aim) work->way->aim(*aim);
    const Reach reach = work->way->follow();
    const manipulation::EntityConfiguration stands = work->way->stands();
    QMetaObject::invokeMethod(
        this,
        [this, reach, stands, work] {
          if (work == work_) return take(stands, reach);
          busy_ = false;  // Of a cell that is closed; what was begun since waits for it.
          pump();
        },
        Qt::QueuedConnection);
  });
  wanted_.reset();
}

void FigureDrag::take(const manipulation::EntityConfiguration& stands, const Reach& reach) {
  busy_ = false;
  if (!open_) return;
  under_way_ = !reach.arrived && keep_;
  if (!ending_ || keep_) {
    reach_ = reach;
    context_.host().documentModel().execute(workcell::SetConfiguration{entity_, stands.X_WE, stands.joints});
    emit moved();
  }
  pump();
}

bool FigureDrag::isOwnBody() const {
  const workcell::Entity* entity = context_.entity();
  return entity && reach_ && reach_->obstacle == entity->name;
}

void FigureDrag::refuse(const QString& why) {
  context_.host().messages().tell(Severity::kWarning, tr("The mannequin cannot be dragged there"), why);
  keep_ = false;
  finish();
}

void FigureDrag::forgetReach() {
  if (open_ || !reach_) return;
  const workcell::Entity* entity = context_.host().documentModel().document().find(entity_);
  if (entity && entity->figure() &&
      glm::length(movedFrame_W(*entity, {entity->X_WE, entity->joints()}, moved_by_).p - reach_->X_WM.p) < kSamePlace)
    return;
  reach_.reset();
  emit moved();
}

void FigureDrag::forgetCell() {
  open_ = ending_ = under_way_ = false;
  work_->has_newer = true;
  auto fresh = std::make_shared<Work>();
  fresh->configuration = work_->configuration;
  work_ = std::move(fresh);
  wanted_.reset();
  reach_.reset();
  entity_ = 0;
}

void FigureDrag::finish() {
  open_ = ending_ = under_way_ = false;
  keep_ ? context_.host().documentModel().endStep() : context_.host().documentModel().cancelStep();
  emit ended();
}

Pose movedFrame_W(const workcell::Entity& entity, const manipulation::EntityConfiguration& stands,
                  const manipulation::MovedBy& held) {
  namespace by = manipulation::by;
  using mannequin::Side;
  const mannequin::Figure& figure = *entity.figure();
  const auto pose = mannequin::forwardKinematics(figure, mannequin::toPosture(figure, {stands.X_WE, stands.joints}));
  const Pose left = mannequin::handPose(pose, Side::kLeft), right = mannequin::handPose(pose, Side::kRight);
  if (const auto* hand = std::get_if<by::Hand>(&held)) {
    const bool is_left = hand->side == Side::kLeft;
    const Pose& one = is_left ? left : right;
    return {one * figure.p_HandGrip[is_left ? 0 : 1], one.q};
  }
  if (std::holds_alternative<by::BothHands>(held)) return {0.5 * (left.p + right.p), left.q};
  if (std::holds_alternative<by::Head>(held)) {
    const Pose head = pose[mannequin::Segment::kHead].pose();
    return {head * figure.p_HeadEyes, head.q};
  }
  return stands.X_WE;
}

}  // namespace hapticell::app
