// SPDX-License-Identifier: Apache-2.0
#include "app/mannequin/figure_drag.h"

#include <algorithm>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/mannequin/mannequin_context.h"
#include "mannequin/figure_model.h"
#include "mannequin/forward_kinematics.h"

namespace hapticell::app {
namespace {

constexpr int kMostSteps = 12;    // Of the held entity between two pictures.
constexpr double kStride = 5e-3;  // m that one of them goes at the most,
constexpr double kTurn = 0.035;   // and rad. Longer ones leave the straight way, as each turns the joints only so far.
constexpr double kForearmLever = 0.1;  // m that a radian counts like.
constexpr double kArrived = 2e-4;      // m
constexpr double kStands = 2e-5;       // m: steps that bring less than this
constexpr int kIdleSteps = 6;          // one after the other are the last.
constexpr double kLook = 2e-3;         // m: what is nearer when the way ends is in the way.

/// The arm that a hand goes along with.
struct Forearm {
  std::shared_ptr<const mannequin::Figure> figure;
  mannequin::Segment segment = mannequin::Segment::kRightWrist;
  glm::dquat q_FM{1.0, 0.0, 0.0, 0.0};  ///< The moved frame's turn against it, kept.

  glm::dquat turnAt(const manipulation::EntityConfiguration& stands) const {
    const auto posture = mannequin::toPosture(*figure, {stands.X_WE, stands.joints});
    return mannequin::forwardKinematics(*figure, posture)[segment].pose().q;
  }
};

std::optional<Forearm> forearmOf(const workcell::Entity& entity, manipulation::MovedBy::Kind kind) {
  using Kind = manipulation::MovedBy::Kind;
  if (kind != Kind::kLeftHand && kind != Kind::kRightHand) return std::nullopt;
  const auto side = kind == Kind::kLeftHand ? mannequin::Side::kLeft : mannequin::Side::kRight;
  return Forearm{entity.figure, mannequin::armSegment(side, mannequin::Segment::kLeftWrist)};
}

}  // namespace

/// Of the worker's thread alone.
struct FigureDrag::Work {
  config::Configuration configuration;
  std::shared_ptr<const manipulation::PreparedScene> prepared;
  std::unique_ptr<manipulation::HeldEntity> held;
  manipulation::MotionMapping mapping;
  std::optional<Forearm> forearm;  ///< None: the target says how the frame turns.
  Pose X_WTarget;
  double nearest_yet = 1e9;  ///< m that was missing at the best,
  int idle_steps = 0;        ///< and since when it was not bettered.

  /// The mouse wants the frame elsewhere.
  void aim(const Pose& X_WM) {
    X_WTarget = X_WM;
    nearest_yet = 1e9;
    idle_steps = 0;
  }

  /// A few steps straight towards the target; `Reach::arrived` once it is there or comes no nearer. The way is the same
  /// however many places of the mouse were left out meanwhile.
  Reach follow() {
    Reach reach;
    for (int step = 0; step < kMostSteps && !reach.arrived; ++step) {
      const auto answer = held->follow(stride(), mapping, nullptr);
      const double left = missing();
      idle_steps = left > nearest_yet - kStands ? idle_steps + 1 : 0;
      nearest_yet = std::min(nearest_yet, left);
      reach.arrived = left < kArrived || idle_steps >= kIdleSteps;
      if (reach.arrived && answer.blocked) reach.obstacle = nearest();
    }
    reach.X_WM = held->movedFrame();
    reach.short_m = glm::length(reach.X_WM.p - X_WTarget.p);
    return reach;
  }

  double missing() const {
    const Twist left = difference(X_WTarget, held->movedFrame());
    return glm::length(left.linear) + (forearm ? 0.0 : kForearmLever * glm::length(left.angular));
  }

  /// What the next step wants: a piece of the way; all of it where pieces do not help any more.
  Pose stride() const {
    const Pose X_WM = held->movedFrame();
    Pose X_WT = X_WTarget;
    if (forearm) X_WT.q = forearm->turnAt(held->accepted()) * forearm->q_FM;
    const Twist left = difference(X_WT, X_WM);
    const double parts = std::max(glm::length(left.linear) / kStride, glm::length(left.angular) / kTurn);
    if (parts <= 1.0 || idle_steps > kIdleSteps / 2) return X_WT;
    return interpolate(X_WM, X_WT, 1.0 / parts);
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
  connect(&context_, &MannequinContext::documentChanged, this, &FigureDrag::forgetReach);
}

FigureDrag::~FigureDrag() {
  pool_.clear();
  pool_.waitForDone();
}

void FigureDrag::begin(const QString& text, const manipulation::MovedBy& moved_by, Turn turn) {
  const workcell::Entity* entity = context_.entity();
  if (open_ || !entity || !context_.isFree()) return;
  entity_ = entity->id;
  kind_ = moved_by.kind;
  open_ = true;
  ending_ = under_way_ = false;
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
  const auto forearm = turn == Turn::kWithTheForearm ? forearmOf(*entity, moved_by.kind) : std::nullopt;
  pool_.start([this, work = work_, id = entity_, options, defaults, forearm, entities = document.snapshotEntities(),
               policy = workcell::PairPolicy{document.state().pair_sets, document.state().pair_rules}] {
    work->prepared = manipulation::PreparedScene::prepare(entities, policy, defaults, work->prepared.get());
    auto held = manipulation::HeldEntity::take(work->prepared, id, {}, options, work->configuration);
    QString problem;
    if (held) {
      work->held = std::move(*held);
      work->forearm = forearm;
      if (forearm) {
        const glm::dquat q_WF = forearm->turnAt(work->held->accepted());
        work->forearm->q_FM = glm::conjugate(q_WF) * work->held->movedFrame().q;
      }
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
  if (!wanted_ && !under_way_) {
    if (ending_) finish();
    return;
  }
  busy_ = under_way_ = true;
  pool_.start([this, work = work_, aim = wanted_] {
    if (aim) work->aim(*aim);
    const Reach reach = work->follow();
    const manipulation::EntityConfiguration stands = work->held->accepted();
    QMetaObject::invokeMethod(
        this, [this, reach, stands] { take(stands, reach); }, Qt::QueuedConnection);
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
  context_.host().messages().tell(Severity::kWarning, tr("The mannequin cannot be drawn so"), why);
  keep_ = false;
  finish();
}

void FigureDrag::forgetReach() {
  if (open_ || !reach_) return;
  const workcell::Entity* entity = context_.host().documentModel().document().find(entity_);
  if (entity && entity->figure &&
      glm::length(movedFrame_W(*entity, {entity->X_WE, entity->joints}, kind_).p - reach_->X_WM.p) < kStands)
    return;
  reach_.reset();
  emit moved();
}

void FigureDrag::finish() {
  open_ = ending_ = under_way_ = false;
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
