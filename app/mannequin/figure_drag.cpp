// SPDX-License-Identifier: Apache-2.0
#include "app/mannequin/figure_drag.h"

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/mannequin/mannequin_context.h"
#include "mannequin/figure_model.h"
#include "mannequin/forward_kinematics.h"

namespace hapticell::app {
namespace {

constexpr int kMostSteps = 12;     // Of the held entity for one place of the mouse.
constexpr double kArrived = 2e-4;  // m
constexpr double kStands = 2e-5;   // m: a step that brings less is the last.
constexpr double kLook = 2e-3;     // m: what is nearer when the way ends is in the way.

}  // namespace

/// Of the worker's thread alone.
struct FigureDrag::Work {
  config::Configuration configuration;
  std::shared_ptr<const manipulation::PreparedScene> prepared;
  std::unique_ptr<manipulation::HeldEntity> held;
  manipulation::MotionMapping mapping;

  Reach follow(const Pose& X_WM) {
    double before = 1e9;
    Reach reach;
    for (int step = 0; step < kMostSteps; ++step) {
      const auto answer = held->follow(X_WM, mapping, nullptr);
      reach.X_WM = held->movedFrame();
      reach.short_m = glm::length(reach.X_WM.p - X_WM.p);
      if (reach.short_m < kArrived || before - reach.short_m < kStands) {
        if (answer.blocked) reach.obstacle = nearest();
        break;
      }
      before = reach.short_m;
    }
    return reach;
  }

  std::string nearest() {
    std::vector<manipulation::FreeMotion::PairDistance> near;
    held->distances(kLook, near);
    double least = kLook;
    std::string name;
    for (const auto& one : near) {
      if (one.result.distance >= least) continue;
      least = one.result.distance;
      const auto* other = prepared->find(held->pairs()[one.pair].other);
      name = other ? other->name : std::string();
    }
    return name;
  }
};

FigureDrag::FigureDrag(MannequinContext& context, QObject* parent)
    : QObject(parent), context_(context), work_(std::make_shared<Work>()) {
  pool_.setMaxThreadCount(1);
  work_->configuration = context.host().configuration();
}

FigureDrag::~FigureDrag() {
  pool_.clear();
  pool_.waitForDone();
}

void FigureDrag::begin(const QString& text, const manipulation::MovedBy& moved_by) {
  const workcell::Entity* entity = context_.entity();
  if (open_ || !entity || !context_.isFree()) return;
  entity_ = entity->id;
  open_ = true;
  ending_ = false;
  keep_ = true;
  wanted_.reset();
  reach_.reset();
  context_.host().documentModel().beginStep(text);
  const workcell::Document& document = context_.host().documentModel().document();
  busy_ = true;
  const auto& configuration = context_.host().configuration();
  const workcell::PairDefaults defaults{configuration.manipulation.safety_distance,
                                        configuration.manipulation.near_miss};
  manipulation::HoldOptions options{moved_by, entity->on_contact, entity->force_class};
  pool_.start([this, work = work_, id = entity_, options, defaults, entities = document.snapshotEntities(),
               policy = workcell::PairPolicy{document.state().pair_sets, document.state().pair_rules}] {
    work->prepared = manipulation::PreparedScene::prepare(entities, policy, defaults, work->prepared.get());
    auto held = manipulation::HeldEntity::take(work->prepared, id, {}, options, work->configuration);
    QString problem;
    if (held) {
      work->held = std::move(*held);
      work->mapping = {};
      work->mapping.anchor(work->held->movedFrame(), work->held->movedFrame());
    } else {
      work->held.reset();
      problem = QString::fromStdString(held.error().message());
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
  pump();
}

void FigureDrag::end(bool keep) {
  if (!open_) return;
  ending_ = true;
  keep_ = keep;
  if (!keep) wanted_.reset();
  pump();
}

void FigureDrag::pump() {
  if (busy_) return;
  if (!wanted_) {
    if (ending_) finish();
    return;
  }
  busy_ = true;
  pool_.start([this, work = work_, X_WM = *wanted_] {
    const Reach reach = work->follow(X_WM);
    const manipulation::EntityConfiguration stands = work->held->accepted();
    QMetaObject::invokeMethod(
        this, [this, reach, stands] { take(stands, reach); }, Qt::QueuedConnection);
  });
  wanted_.reset();
}

void FigureDrag::take(const manipulation::EntityConfiguration& stands, const Reach& reach) {
  busy_ = false;
  if (!open_) return;
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
  context_.host().messages().tell(Severity::kWarning, tr("The mannequin cannot be drawn so"), why);
  keep_ = false;
  finish();
}

void FigureDrag::finish() {
  open_ = ending_ = false;
  keep_ ? context_.host().documentModel().endStep() : context_.host().documentModel().cancelStep();
  emit ended();
}

Pose movedFrame_W(const workcell::Entity& entity, const manipulation::EntityConfiguration& stands,
                  manipulation::MovedBy::Kind kind) {
  using Kind = manipulation::MovedBy::Kind;
  using mannequin::Side;
  const mannequin::Figure& figure = *entity.figure;
  const auto pose = mannequin::forwardKinematics(figure, mannequin::toPosture(figure, {stands.X_WE, stands.joints}));
  const Pose left = mannequin::handPose(pose, Side::kLeft), right = mannequin::handPose(pose, Side::kRight);
  switch (kind) {
    case Kind::kLeftHand:
      return {left * figure.p_HandGrip[0], left.q};
    case Kind::kRightHand:
      return {right * figure.p_HandGrip[1], right.q};
    case Kind::kBothHands:
      return {0.5 * (left.p + right.p), left.q};
    case Kind::kHead: {
      const Pose head = pose[mannequin::Segment::kHead].pose();
      return {head * figure.p_HeadEyes, head.q};
    }
    default:
      return stands.X_WE;
  }
}

}  // namespace hapticell::app
