// SPDX-License-Identifier: Apache-2.0
#include "app/mannequin/hands_to_part.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <cmath>

#include "app/host/document_model.h"
#include "app/host/hold_choice.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/kit/action_face.h"
#include "app/kit/thread_pool_task.h"
#include "app/mannequin/mannequin_context.h"
#include "app/mannequin/mannequin_edits.h"
#include "app/style/units.h"
#include "app/viewport/widget/viewport_widget.h"
#include "mannequin/ergonomics/advice/body_sizes.h"
#include "mannequin/posture/hands_to.h"
#include "mannequin/shape/sitting.h"
#include "workcell/entity/built_in_parts.h"

namespace hapticell::app {
namespace {

using Hands = HandsToPart::Hands;
using Targets = std::array<std::optional<mannequin::HandTarget>, 2>;

constexpr std::array kAllHands{Hands::kLeft, Hands::kRight, Hands::kBoth};
constexpr std::array kHereNames{"actionLeftHandHere", "actionRightHandHere", "actionBothHandsHere"};
constexpr std::array kToNames{"actionLeftHandTo", "actionRightHandTo", "actionBothHandsTo"};
// m; less is there: kThere of hands_to.cpp and half a mm. Half: reached places count as missed; twice: 5 mm go unsaid.
constexpr double kMissed = 2.5e-3;

// Of a face's normal upwards, 45 degrees: a body stays on it. Half: one sits on walls; over 1: on nothing.
constexpr double kLevel = 0.7;

bool isSeat(const workcell::Entity& part) {
  const std::string& source = part.source.path;
  return (source.starts_with("chair:") || source.starts_with("stool:")) && !workcell::partSizes(part.source).empty() &&
         part.X_WE.rotate({0.0, 0.0, 1.0}).z > kLevel;
}

/// What the hands are to reach; empty: the part has no sides.
std::optional<Targets> targetsOf(Hands hands, const PickedFeature& place, const mannequin::Posture& posture) {
  Targets targets;
  if (hands != Hands::kBoth) {
    targets[hands == Hands::kLeft ? 0 : 1] = mannequin::HandTarget{place.p_WHit, -place.nhat_W};
    return targets;
  }
  if (!place.mesh) return std::nullopt;
  // Left as seen by who stands in front of it, wherever that one looks.
  dvec3 ahead = place.p_WHit - posture.X_WR.p;
  ahead.z = 0.0;
  if (glm::length(ahead) < 1e-3) ahead = posture.X_WR.rotate({1.0, 0.0, 0.0});
  const dvec3 left = glm::normalize(glm::cross(dvec3(0.0, 0.0, 1.0), ahead));
  const auto sides = mannequin::oppositeSides(*place.mesh, place.X_WM, place.p_WHit, place.nhat_W, left);
  if (!sides) return std::nullopt;
  targets[0] = (*sides)[0];
  targets[1] = (*sides)[1];
  return targets;
}

/// What stays as it is: what is locked, and the pelvis of who sits.
mannequin::PostureTask taskOf(const mannequin::Figure& figure, const mannequin::Posture& posture,
                              const by::BothHands& chosen) {
  const manipulation::BodyLocks& locks = chosen.locks;
  mannequin::PostureTask task = ergonomics::taskAt(figure, posture, figure, dvec3(0.0));
  task.hands = {};
  task.trunk_locked = locks.trunk;
  task.pelvis_locked = task.pelvis_locked || locks.pelvis || locks.seat;
  task.may_step = chosen.may_step && !task.pelvis_locked && !task.trunk_locked;
  if (locks.seat) task.balance = false;
  return task;
}

}  // namespace

HandsToPart::HandsToPart(MannequinContext& context, QMenu& menu, QObject* parent) : QObject(parent), context_(context) {
  QMainWindow& window = context.host().window();
  const std::array here{tr("Left hand here"), tr("Right hand here"), tr("Both hands to this part")};
  const std::array to{tr("Left hand to a part…"), tr("Right hand to a part…"), tr("Both hands to a part…")};
  menu.addSeparator();
  for (std::size_t i = 0; i < kAllHands.size(); ++i) {
    here_[i] = makeAction(&window, {kHereNames[i], here[i], {}, {}, {}});
    to_[i] = makeAction(&window, {kToNames[i], to[i], {}, {}, {}});
    window.addAction(to_[i]);
    menu.addAction(to_[i]);
    connect(to_[i], &QAction::triggered, this, [this, hands = kAllHands[i]] { pick(hands); });
    connect(here_[i], &QAction::triggered, this, [this, hands = kAllHands[i]] {
      if (place_) send(hands, *place_);
    });
  }
  sit_ = makeAction(&window, {"actionSitHere", tr("Sit here"), {}, {}, {}});
  connect(sit_, &QAction::triggered, this, [this] {
    if (place_) sit(*place_);
  });
  connect(&context_.host().viewport(), &ViewportWidget::contextMenuWanted, this, &HandsToPart::remember);
  connect(&context_, &MannequinContext::mannequinChanged, this, &HandsToPart::showActions);
  connect(&context_, &MannequinContext::documentChanged, this, &HandsToPart::showActions);
  connect(&context_.host().documentModel(), &DocumentModel::closing, this, [this] {
    place_.reset();
    showActions();
  });
  showActions();
}

void HandsToPart::showActions() {
  const bool ready = context_.entity() && context_.isFree() && !busy_;
  for (QAction* action : to_) action->setEnabled(ready);
  for (QAction* action : here_) {
    action->setVisible(ready && place_);
    action->setEnabled(ready && place_);
  }
  const workcell::Entity* part = place_ ? context_.host().documentModel().document().find(place_->entity) : nullptr;
  const bool bears = part && (isSeat(*part) || place_->nhat_W.z > kLevel);
  sit_->setVisible(ready && bears);
  sit_->setEnabled(ready && bears);
}

void HandsToPart::remember(workcell::EntityId entity, const QPoint& global) {
  place_.reset();
  const workcell::Entity* figure = context_.entity();
  ViewportWidget& viewport = context_.host().viewport();
  if (entity != 0 && figure && figure->id != entity)
    place_ = viewport.featureAt(viewport.mapFromGlobal(global), {.faces = true, .edges = false, .vertices = false});
  showActions();
}

void HandsToPart::pick(Hands hands) {
  const workcell::Entity* entity = context_.entity();
  if (!entity || !context_.isFree() || busy_) return;
  const QString prompt =
      hands == Hands::kBoth ? tr("Click the part for both hands to hold") : tr("Click where to put the hand");
  context_.host().viewport().startPick({{.faces = true, .edges = false, .vertices = false},
                                        prompt,
                                        [this, hands](const std::optional<PickedFeature>& place) {
                                          if (place) send(hands, *place);
                                        }});
}

void HandsToPart::send(Hands hands, const PickedFeature& place) {
  const workcell::Entity* entity = context_.entity();
  if (!entity || !context_.isFree() || busy_) return;
  DocumentModel& document = context_.host().documentModel();
  const workcell::Entity* part = document.document().find(place.entity);
  if (!part || part->id == entity->id)
    return context_.host().messages().tell(Severity::kWarning, tr("The hands were not moved"),
                                           tr("Click a part, not the mannequin."));
  const mannequin::Posture from = postureOf(*entity);
  const auto targets = targetsOf(hands, place, from);
  if (!targets) return;
  busy_ = true;
  showActions();
  runInThreadPool(
      this,
      [figure = entity->figure(), from, targets = *targets,
       task = taskOf(*entity->figure(), from, context_.host().holdChoice().hands())] {
        return mannequin::handsTo(*figure, from, task, targets);
      },
      [this, hands, id = entity->id, from, part = QString::fromStdString(part->name),
       number = document.number()](const mannequin::HandsReach& reach) {
        busy_ = false;
        const workcell::Entity* now = context_.host().documentModel().document().find(id);
        // Another cell, or it was moved meanwhile: what was found is not for that.
        const bool same = number == context_.host().documentModel().number() && now && now->figure() &&
                          postureOf(*now).angles == from.angles && postureOf(*now).X_WR.p == from.X_WR.p;
        if (same && context_.isFree()) {
          const QString name = QString::fromStdString(now->name);
          context_.host().documentModel().executeAll(hands == Hands::kBoth
                                                         ? tr("Both hands of %1 to %2").arg(name, part)
                                                         : tr("Hand of %1 to %2").arg(name, part),
                                                     {postureCommand(*now, reach.posture)});
          told(hands, part, reach.short_m);
        }
        showActions();
      });
}

void HandsToPart::sit(const PickedFeature& place) {
  const workcell::Entity* entity = context_.entity();
  const workcell::Entity* part = context_.host().documentModel().document().find(place.entity);
  if (!entity || !part || !context_.isFree() || busy_) return;
  const dvec3 ahead = postureOf(*entity).X_WR.rotate({1.0, 0.0, 0.0});
  dvec3 p_WSeat = place.p_WHit;
  double heading = std::atan2(ahead.y, ahead.x);
  if (isSeat(*part)) {
    p_WSeat = part->X_WE * dvec3(0.0, 0.0, workcell::partSizes(part->source).front());
    if (part->source.path.starts_with("chair:")) {  // Who sits on it looks along its -y.
      const dvec3 looks = part->X_WE.rotate({0.0, -1.0, 0.0});
      heading = std::atan2(looks.y, looks.x);
    }
  }
  const mannequin::Sitting sitting = mannequin::sitOn(*entity->figure(), *entity->robot(), p_WSeat, heading);
  const QString name = QString::fromStdString(entity->name), seat = QString::fromStdString(part->name);
  if (!context_.host().documentModel().executeAll(tr("%1 sits on %2").arg(name, seat),
                                                  {postureCommand(*entity, sitting.posture)}))
    return;
  by::BothHands hands = context_.host().holdChoice().hands();
  hands.locks.seat = true;  // The seat bears it when a hand is drawn next.
  context_.host().holdChoice().setHands(hands);
  if (sitting.feet_above_floor_m > 0.0)
    context_.host().messages().tell(
        Severity::kWarning, tr("The feet of %1 do not reach the floor").arg(name),
        tr("They are %1 above it. Lower the seat or add a footrest.").arg(lengthText(sitting.feet_above_floor_m, 0)));
}

void HandsToPart::told(Hands hands, const QString& part, const std::array<double, 2>& short_m) {
  QStringList missed;
  if (hands != Hands::kRight && short_m[0] > kMissed)
    missed << tr("The left hand is %1 short.").arg(lengthText(short_m[0], 0));
  if (hands != Hands::kLeft && short_m[1] > kMissed)
    missed << tr("The right hand is %1 short.").arg(lengthText(short_m[1], 0));
  if (missed.isEmpty()) return;
  missed << tr("Move the mannequin or the part nearer, or unlock the feet so that it can step.");
  context_.host().messages().tell(Severity::kWarning, tr("%1 is out of reach").arg(part), missed.join(' '));
}

}  // namespace hapticell::app
