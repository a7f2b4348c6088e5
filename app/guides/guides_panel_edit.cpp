// SPDX-License-Identifier: Apache-2.0
// What the panel does: making, editing and showing guides.
#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QSlider>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/controls/pose_text.h"
#include "app/guides/detents_text.h"
#include "app/guides/guide_curves.h"
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
#include "app/style/value_field.h"
#include "app/viewport/widget/viewport_widget.h"
#include "trajectory/files/trajectory_io.h"

namespace hapticell::app {
namespace {

using workcell::Guide;
using workcell::GuideKind;

constexpr const char* kCurves = "guides";
constexpr const char* kHandle = "handle";

bool hasStops(GuideKind kind) {
  return kind == GuideKind::kLine || kind == GuideKind::kHinge || kind == GuideKind::kSlider ||
         kind == GuideKind::kScrew;
}

/// What has no shape of its own is not led.
bool canBeGuided(const workcell::Entity& entity) {
  return entity.kind != workcell::EntityKind::kAssembly && entity.kind != workcell::EntityKind::kFrame;
}

bool hasDetents(GuideKind kind) {
  return hasStops(kind) && kind != GuideKind::kScrew;
}

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

void GuidesPanel::editStop(bool upper) {
  const Guide* now = guide();
  if (!now) return;
  const std::size_t side = upper ? 1 : 0;
  std::optional<double> stop;
  if (has_stop_[side]->isChecked())
    stop = now->kind == GuideKind::kHinge ? kDegree * degree_stop_[side]->value() : 1e-3 * mm_stop_[side]->value();
  // A stop that is switched on stands where it makes sense.
  const bool fresh = stop && !(upper ? now->upper : now->lower);
  if (fresh && *stop == 0.0 && upper) stop = now->kind == GuideKind::kHinge ? 1.2 : 0.1;
  edit([&](Guide& guide) { (upper ? guide.upper : guide.lower) = stop; });
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
    host_.messages().tell(Severity::kInformation, tr("%1 cannot be made of that").arg(tr(guideKindName(kind).c_str())),
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
    host_.messages().tell(Severity::kProblem, tr("The recording was not read"),
                          QString::fromStdString(read.error().message()));
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
  if (hold.is<by::Center>() && entity->mesh) {
    const geometry::Bounds bounds = entity->mesh->bounds();
    return X_WE * (0.5 * (bounds.min + bounds.max));
  }
  if (entity->robot && !hold.is<by::Base>()) return tcpPose_W(*entity, X_WE, scene.joints(*entity)).p;
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
  showGuide(guide());
  showCurves();
}

void GuidesPanel::showGuide(const Guide* guide) {
  kinds_->button(static_cast<int>(guide ? guide->kind : wanted_))->setChecked(true);
  if (!guide) return;
  wanted_ = guide->kind;
  if (!name_->hasFocus()) name_->setText(QString::fromStdString(guide->name));
  entity_->clear();
  for (const auto& entity : host_.documentModel().document().state().entities)
    if (canBeGuided(*entity)) entity_->addItem(QString::fromStdString(entity->name));
  entity_->setCurrentText(QString::fromStdString(guide->entity));
  geometry_->setText(geometryText(*guide));
  geometry_->setCursorPosition(0);
  geometry_->setToolTip(geometry_->text());
  const HoldChoice& hold = host_.holdChoice();
  handle_->setText(hold.is<by::Frame>() ? QString::fromStdString(hold.frame()) : tr("as it is held"));
  radius_->setValue(1e3 * guide->radius);
  pitch_->setValue(1e3 * guide->pitch);
  offset_->setValue(1e3 * guide->offset);
  friction_->setValue(guide->friction);
  detent_width_->setValue(1e3 * guide->detent_width);
  detent_force_->setValue(1e-3 * guide->detent_stiffness);
  const int help = static_cast<int>(std::lround(guide->help / 5.0));
  if (!help_->isSliderDown()) help_->setValue(help);
  help_value_->setText(tr("%1 %").arg(help));
  for (std::size_t i = 0; i < 6; ++i) locks_[i]->setChecked(guide->locked[i]);
  const GuideKind kind = guide->kind;
  radius_row_->setVisible(kind == GuideKind::kCircle || kind == GuideKind::kTube);
  path_row_->setVisible(kind == GuideKind::kTube);
  help_row_->setVisible(kind == GuideKind::kTube);
  pitch_row_->setVisible(kind == GuideKind::kScrew);
  offset_row_->setVisible(kind == GuideKind::kSurface);
  locks_row_->setVisible(kind == GuideKind::kLock);
  showStops(*guide);
}

void GuidesPanel::showStops(const Guide& guide) {
  const bool turns = guide.kind == GuideKind::kHinge;
  stops_row_->setVisible(hasStops(guide.kind));
  detents_row_->setVisible(hasDetents(guide.kind));
  detent_row_->setVisible(hasDetents(guide.kind) && !guide.detents.empty());
  for (std::size_t i = 0; i < 2; ++i) {
    const std::optional<double>& stop = i == 0 ? guide.lower : guide.upper;
    has_stop_[i]->setChecked(stop.has_value());
    mm_stop_[i]->setVisible(!turns);
    degree_stop_[i]->setVisible(turns);
    mm_stop_[i]->setEnabled(stop.has_value());
    degree_stop_[i]->setEnabled(stop.has_value());
    (turns ? degree_stop_[i] : mm_stop_[i])->setValue(stop ? *stop / (turns ? kDegree : 1e-3) : 0.0);
  }
  if (!detents_->hasFocus()) detents_->setText(detentsText(guide.detents, turns));
  const std::array<double, 2> example{0.0, turns ? 60.0 * kDegree : 0.12};
  detents_->setPlaceholderText(tr("none; e.g. %1").arg(detentsText(example, turns)));
}

}  // namespace hapticell::app
