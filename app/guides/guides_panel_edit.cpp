// SPDX-License-Identifier: Apache-2.0
// What the panel does: making, editing and showing guides.
#include <QButtonGroup>
#include <QPointer>
#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "app/controls/pose_text.h"
#include "app/guides/guide_curves.h"
#include "app/guides/guide_fields.h"
#include "app/guides/guide_geometry_fields.h"
#include "app/guides/guide_making.h"
#include "app/guides/guides_panel.h"
#include "app/host/document_model.h"
#include "app/host/hold_choice.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/host/selection.h"
#include "app/kit/file_dialog.h"
#include "app/kit/form.h"
#include "app/kit/switch_list.h"
#include "app/viewport/widget/viewport_widget.h"
#include "trajectory/files/trajectory_io.h"

namespace hapticell::app {
namespace {

using workcell::Guide;
using workcell::GuideKind;

constexpr const char* kCurves = "guides";
constexpr const char* kHandle = "handle";

}  // namespace

const Guide* GuidesPanel::guide() const {
  return current_.isEmpty() ? nullptr : host_.documentModel().document().state().findGuide(current_.toStdString());
}

void GuidesPanel::edit(const std::function<void(Guide&)>& change) {
  const Guide* now = guide();
  if (!now) return;
  Guide fresh = *now;
  change(fresh);
  const std::string name = fresh.name;
  const QString before = current_;
  current_ = QString::fromStdString(name);  // The change is told while it is done.
  if (host_.documentModel().execute(workcell::EditGuide{before.toStdString(), std::move(fresh)})) return;
  current_ = before;
  show();
}

void GuidesPanel::choose(const QString& name) {
  current_ = name;
  show();
}

void GuidesPanel::chooseKind(GuideKind kind) {
  wanted_ = kind;
  const Guide* now = guide();
  if (!now || now->kind == kind) return;
  // What can do with the geometry that is there becomes it at once; else new geometry is asked for.
  const bool needs_other = kind == GuideKind::kTube || kind == GuideKind::kSurface;
  if (needs_other) return pickGeometry(kind, false);
  edit([kind](Guide& guide) {
    guide.kind = kind;
    guide.lower.reset();
    guide.upper.reset();
    guide.detents.clear();
  });
}

void GuidesPanel::startNew() {
  pickGeometry(wanted_, true);
}

void GuidesPanel::pickGeometry(GuideKind kind, bool make) {
  const QString prompt = tr("%1 · Esc: end").arg(guidePrompt(kind));
  host_.viewport().startPick(
      {guideFilter(kind), prompt, [self = QPointer(this), kind, make](const std::optional<PickedFeature>& feature) {
         if (!self) return;
         if (feature) return self->take(*feature, kind, make);
         self->show();  // The kind that was not taken.
       }});
}

void GuidesPanel::take(const PickedFeature& feature, GuideKind kind, bool make) {
  const workcell::DocumentState& state = host_.documentModel().document().state();
  const workcell::Entity* picked = state.find(feature.entity);
  const workcell::Entity* selected = state.find(host_.selection().current());
  const Guide* now = make ? nullptr : guide();
  Guide fresh = now ? *now : Guide{};
  if (!make && !now) return;
  fresh.kind = kind;
  if (!now) {
    const workcell::Entity* guided = selected && canBeGuided(*selected) ? selected : picked;
    fresh.entity = guided ? guided->name : std::string();
    for (int n = 1; fresh.name.empty() || state.findGuide(fresh.name); ++n)
      fresh.name = guideKindName(kind) + (n > 1 ? " " + std::to_string(n) : "");
  }
  if (!takeGeometry(feature, picked ? picked->name : std::string(), fresh)) {
    host_.messages().tell(Severity::kInformation,
                          tr("%1 cannot be made from this geometry").arg(tr(guideKindName(kind).c_str())),
                          tr("Picked: %1. %2.").arg(QString::fromStdString(featureText(feature)), guidePrompt(kind)));
    return pickGeometry(kind, make);
  }
  const QString before = current_;
  current_ = QString::fromStdString(fresh.name);
  const bool done = now ? host_.documentModel().execute(workcell::EditGuide{now->name, std::move(fresh)})
                        : host_.documentModel().execute(workcell::AddGuide{std::move(fresh)});
  if (!done) current_ = before;
  show();
}

/// A frame of the entity at the picked point, by which it is then held.
void GuidesPanel::pickHandle() {
  const Guide* now = guide();
  if (!now) return;
  host_.viewport().startPick(
      {{true, true, true},
       tr("Pick the point that the hand holds · Esc: end"),
       [self = QPointer(this), name = now->entity](const std::optional<PickedFeature>& feature) {
         const workcell::Entity* entity =
             self && feature ? self->host_.documentModel().document().findByName(name) : nullptr;
         if (!entity) return;
         std::vector<workcell::Frame> frames = entity->frames;
         std::erase_if(frames, [](const auto& frame) { return frame.name == kHandle; });
         frames.push_back({kHandle, self->host_.viewport().scene().placement_W(*entity).inverse() *
                                        Pose::translation(feature->p_WQ)});
         if (self->host_.documentModel().execute(workcell::SetFrames{entity->id, std::move(frames)}))
           self->host_.holdChoice().set(by::Frame{kHandle});
         self->show();
       }});
}

void GuidesPanel::takePath() {
  const QString path =
      askToOpen(this, tr("Path of a recording"), {}, tr("Recordings (*.htraj *.csv *.json);;All files (*)"));
  if (path.isEmpty()) return;
  Diagnostics diagnostics;
  const auto read = trajectory::readTrajectory(path.toStdString());
  if (!read) {
    host_.messages().reportCause(Severity::kProblem, tr("The recording was not read"), read.error());
    return;
  }
  std::vector<dvec3> points;
  for (const auto& frame : read->frames()) points.push_back(frame.X_WT.p);
  edit([&](Guide& guide) {
    guide.kind = GuideKind::kTube;
    guide.path = thinnedPath(points);
  });
}

void GuidesPanel::removeGuide() {
  if (const Guide* now = guide()) host_.documentModel().execute(workcell::RemoveGuide{now->name});
}

void GuidesPanel::reverseAxis() {
  edit([](Guide& guide) { guide.X_WG.q = glm::normalize(guide.X_WG.q * dquat(0.0, 1.0, 0.0, 0.0)); });
}

void GuidesPanel::placeAtEntity() {
  const Guide* now = guide();
  if (now) edit([p = movedPoint_W(*now)](Guide& guide) { guide.X_WG.p = p; });
}

/// Where the hand holds the guided entity: its tool, its chosen frame, else its origin.
dvec3 GuidesPanel::movedPoint_W(const Guide& guide) const {
  const workcell::Entity* entity = host_.documentModel().document().findByName(guide.entity);
  if (!entity) return guide.X_WG.p;
  const SceneModel& scene = host_.viewport().scene();
  const Pose X_WE = scene.placement_W(*entity);
  const HoldChoice& hold = host_.holdChoice();
  for (const workcell::Frame& frame : entity->frames)
    if (hold.is<by::Frame>() && frame.name == hold.frame()) return X_WE * frame.X_EF.p;
  if (hold.is<by::Center>() && entity->mesh()) {
    const geometry::Bounds bounds = entity->mesh()->bounds();
    return X_WE * (0.5 * (bounds.min + bounds.max));
  }
  if (entity->robot() && !hold.is<by::Base>()) return tcpPose_W(*entity, X_WE, scene.joints(*entity)).p;
  return X_WE.p;
}

void GuidesPanel::showCurves() {
  std::vector<SceneCurve> curves;
  const workcell::DocumentState& state = host_.documentModel().document().state();
  for (const Guide& guide : state.guides) {
    const bool chosen = guide.name == current_.toStdString() && isSeen(*this);
    const std::vector<SceneCurve> own = guideCurves(guide, movedPoint_W(guide), chosen);
    curves.insert(curves.end(), own.begin(), own.end());
  }
  host_.viewport().setCurves(kCurves, std::move(curves));
}

void GuidesPanel::show() {
  const workcell::DocumentState& state = host_.documentModel().document().state();
  if (!guide()) current_ = state.guides.empty() ? QString() : QString::fromStdString(state.guides.back().name);
  std::vector<SwitchList::Row> rows;
  int index = -1;
  for (const Guide& guide : state.guides) {
    if (guide.name == current_.toStdString()) index = static_cast<int>(rows.size());
    rows.push_back({QString::fromStdString(guide.name), guide.enabled});
  }
  const QSignalBlocker blocked(list_);
  list_->setRows(std::move(rows));
  list_->setCurrent(index);
  empty_->setVisible(state.guides.empty());
  remove_->setEnabled(guide());
  editor_->setVisible(guide());
  const Guide* now = guide();
  if (now) wanted_ = now->kind;
  kinds_->button(static_cast<int>(wanted_))->setChecked(true);
  if (now) geometry_->show(*now);
  if (now) fields_->show(*now);
  showCurves();
}

}  // namespace hapticell::app
