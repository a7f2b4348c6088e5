// SPDX-License-Identifier: Apache-2.0
#include "app/mannequin/figure_drawings.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/kit/form.h"
#include "app/kit/thread_pool_task.h"
#include "app/mannequin/mannequin_context.h"
#include "app/mannequin/mannequin_edits.h"
#include "app/style/style_painting.h"
#include "app/style/units.h"
#include "app/viewport/widget/viewport_widget.h"
#include "manipulation/checks/mannequin_sight.h"
#include "manipulation/scene/scene_service.h"
#include "mannequin/ergonomics/advice/body_sizes.h"
#include "mannequin/posture/reach_envelope.h"
#include "mannequin/posture/support_polygon.h"
#include "mannequin/posture/work_zones.h"

namespace hapticell::app {
namespace {

// ms without motion until the reach is drawn, as live_scores.cpp's; a solve of many directions. Half: for nothing while
// dragging; twice: late.
constexpr int kRestMilliseconds = 400, kMeridians = 18;
constexpr double kSightLength = 1.4;  // m

using mannequin::Side;
using Mesh = std::shared_ptr<const geometry::TriangleMesh>;

RenderItem volume(Mesh mesh, const std::array<float, 3>& color) {
  RenderItem item;
  item.mesh = std::move(mesh);
  item.color = color;
  item.ghost = Ghost::kOwn;
  return item;
}

constexpr double kPercentiles[]{5.0, 50.0, 95.0};

/// The surfaces of both arms of the 5th, 50th and 95th percentile of the figure's sex, where it stands.
std::vector<Mesh> reachOfSizes(const mannequin::Figure& figure, const mannequin::Posture& posture) {
  std::vector<Mesh> found;
  for (const double percentile : kPercentiles) {
    const auto stature = mannequin::statureOfPercentile(figure.sex, percentile);
    const auto other = stature ? mannequin::makeFigure({figure.sex, *stature}) : tl::unexpected(stature.error());
    if (!other) continue;
    const mannequin::Posture stands = ergonomics::standingAt(figure, posture, *other);
    for (const Side side : {Side::kLeft, Side::kRight})
      found.push_back(std::make_shared<geometry::TriangleMesh>(
          mannequin::reachEnvelope(*other, stands, side, {false, kMeridians})));
  }
  return found;
}

}  // namespace

FigureDrawings::FigureDrawings(MannequinContext& context, QWidget* parent) : QWidget(parent), context_(context) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  addSwitches(*column);
  balance_ = makeLabel({}, TextRole::kSecond, true);
  balance_->setObjectName("labelBalance");
  column->addWidget(balance_);
  eyes_ = new QPushButton(tr("Through its eyes"));
  eyes_->setObjectName("buttonEyes");
  sight_ = new QPushButton(tr("Visible share"));
  sight_->setObjectName("buttonSees");
  sight_->setToolTip(tr("How much of the last selected part the mannequin sees"));
  gaze_ = new QPushButton(tr("Look at part"));
  gaze_->setObjectName("buttonLookAt");
  gaze_->setToolTip(tr("Turns the eyes towards the last selected part, as far as they go"));
  column->addWidget(sideBySide({eyes_, gaze_}));
  column->addWidget(sight_);
  seen_ = makeLive(2, TextRole::kSecond);
  seen_->setObjectName("labelSees");
  column->addWidget(seen_);
  rests_.setSingleShot(true);
  rests_.setInterval(kRestMilliseconds);
  connect(&context_.host().documentModel(), &DocumentModel::closing, this, [this] {
    for (QCheckBox* drawn : switches_) drawn->setChecked(false);
    ++question_;
    figure_.reset();
    reach_.clear();
    balance_->clear();
    seen_->clear();
  });
  connect(&rests_, &QTimer::timeout, this, &FigureDrawings::askReach);
  connect(eyes_, &QPushButton::clicked, this, &FigureDrawings::lookThroughEyes);
  connect(gaze_, &QPushButton::clicked, this, &FigureDrawings::lookAtTarget);
  connect(sight_, &QPushButton::clicked, this, &FigureDrawings::askSight);
}

void FigureDrawings::addSwitches(QVBoxLayout& column) {
  const std::array<QString, kKinds> words{
      tr("Reach of the arms"), tr("Reach with the trunk"),       tr("Working zones (as EN ISO 14738)"),
      tr("Field of view"),     tr("Centre of mass and support"), tr("Reach of P5, P50 and P95")};
  for (std::size_t i = 0; i < switches_.size(); ++i) {
    auto* button = switches_[i] = new QCheckBox(words[i]);
    button->setObjectName(QStringLiteral("draw%1").arg(i));
    if (i == kSizesReach) button->setToolTip(tr("Reach of people of the same sex in the same stance"));
    connect(button, &QCheckBox::clicked, this, [this] {
      figure_.reset();  // Reads it again.
      showNow();
    });
    column.addWidget(button);
  }
}

bool FigureDrawings::isOn(Kind kind) const {
  return switches_[kind]->isChecked();
}

void FigureDrawings::showNow() {
  const workcell::Entity* entity = context_.entity();
  if (!entity) {
    if (!figure_) return;
    figure_.reset();
    context_.host().viewport().scene().setExtras("figure", {});
    context_.host().viewport().setCurves("figure", {});
    return;
  }
  const mannequin::Posture posture = context_.posture();
  const bool same = figure_ == entity->figure() && posture.angles == posture_.angles &&
                    posture.gaze.yaw == posture_.gaze.yaw && posture.gaze.pitch == posture_.gaze.pitch &&
                    posture.X_WR.p == posture_.X_WR.p && posture.X_WR.q == posture_.X_WR.q;
  if (same) return;
  figure_ = entity->figure();
  posture_ = posture;
  reach_.clear();
  nameSizes();
  ++question_;
  if (isOn(kReach) || isOn(kTrunkReach) || isOn(kSizesReach)) rests_.start();
  drawVolumes();
  drawBalance();
}

void FigureDrawings::drawVolumes() {
  const Theme& theme = themeOf(palette());
  std::vector<RenderItem> items;
  for (const auto& [kind, meshes] : reach_) {
    const QColor sizes[]{theme.scene.guide, theme.selection, theme.near_miss};
    const QColor own = kind == kReach ? theme.selection : theme.scene.axis_z;
    for (std::size_t i = 0; i < meshes.size(); ++i)
      items.push_back(volume(meshes[i], channelsOf(kind == kSizesReach ? sizes[i / 2 % 3] : own)));
  }
  if (isOn(kZones)) {
    for (const auto zone : {mannequin::WorkZone::kPreferred, mannequin::WorkZone::kAcceptable}) {
      const bool preferred = zone == mannequin::WorkZone::kPreferred;
      items.push_back(volume(std::make_shared<geometry::TriangleMesh>(mannequin::workZone(*figure_, posture_, zone)),
                             channelsOf(preferred ? theme.scene.guide : theme.near_miss)));
    }
  }
  if (isOn(kSight)) {
    const auto pose = mannequin::forwardKinematics(*figure_, posture_);
    using mannequin::VisionZone;
    constexpr std::pair<VisionZone, std::size_t> kTones[]{
        {VisionZone::kPreferred, 1}, {VisionZone::kEyes, 0}, {VisionZone::kHead, 2}};
    for (const auto& [zone, tone] : kTones) {
      items.push_back(volume(std::make_shared<geometry::TriangleMesh>(
                                 mannequin::visionVolume(*figure_, pose, posture_.gaze, zone, kSightLength)),
                             channelsOf(theme.score[tone])));
    }
  }
  context_.host().viewport().scene().setExtras("figure", std::move(items));
  context_.host().viewport().refresh();
}

void FigureDrawings::drawBalance() {
  const auto pose = mannequin::forwardKinematics(*figure_, posture_);
  const dvec3 com = mannequin::centerOfMass(*figure_, pose);
  const auto support =
      mannequin::supportPolygon(*figure_, {pose[mannequin::Segment::kLeftFoot], pose[mannequin::Segment::kRightFoot]},
                                mannequin::standingFeet(*figure_, pose));
  const double margin = support.margin(glm::dvec2(com));
  balance_->setText(margin >= 0.0 ? tr("Balance: %1 inside the soles").arg(lengthText(margin, 0))
                                  : tr("Out of balance by %1").arg(lengthText(-margin, 0)));
  std::vector<SceneCurve> curves;
  if (isOn(kBalance)) {
    double floor = 1e9;
    for (const Side side : {Side::kLeft, Side::kRight})
      floor = std::min(floor, (mannequin::footPose(pose, side) * dvec3(0.0, 0.0, figure_->sole.z)).z);
    const auto role = margin >= 0.0 ? SceneCurve::Role::kSelection : SceneCurve::Role::kLimit;
    SceneCurve outline{{}, role, SceneCurve::Style::kSolid, 2.0, {}};
    for (std::size_t i = 0; i <= support.count && support.count > 0; ++i) {
      const glm::dvec2& p = support.points[i % support.count];
      outline.points_W.emplace_back(p.x, p.y, floor + 0.002);
    }
    const dvec3 below(com.x, com.y, floor + 0.002);
    curves.push_back(outline);
    curves.push_back({{com, below}, role, SceneCurve::Style::kDashed, 1.5, {}});
    curves.push_back({{com}, role, SceneCurve::Style::kSolid, 2.0, tr("centre of mass").toStdString()});
    curves.push_back({{below}, role, SceneCurve::Style::kSolid, 2.0, lengthText(margin, 0).toStdString()});
  }
  context_.host().viewport().setCurves("figure", std::move(curves));
}

void FigureDrawings::askReach() {
  if (!figure_) return;
  if (asking_) return rests_.start();
  asking_ = true;
  const bool arms = isOn(kReach), trunk = isOn(kTrunkReach), sizes = isOn(kSizesReach);
  using Found = std::map<int, std::vector<Mesh>>;
  runInThreadPool(
      this,
      [figure = figure_, posture = posture_, arms, trunk, sizes] {
        Found found;
        for (const int kind : {static_cast<int>(kReach), static_cast<int>(kTrunkReach)}) {
          if (!(kind == kReach ? arms : trunk)) continue;
          for (const Side side : {Side::kLeft, Side::kRight})
            found[kind].push_back(std::make_shared<geometry::TriangleMesh>(
                mannequin::reachEnvelope(*figure, posture, side, {kind == kTrunkReach, kMeridians})));
        }
        if (sizes) found[kSizesReach] = reachOfSizes(*figure, posture);
        return found;
      },
      [this, question = question_](Found found) {
        asking_ = false;
        if (question != question_) return;
        reach_ = std::move(found);
        drawVolumes();
        nameSizes();
      });
}

/// The percentile's name at the top of each surface.
void FigureDrawings::nameSizes() {
  std::vector<SceneCurve> names;
  if (const auto sizes = reach_.find(kSizesReach); sizes != reach_.end() && isOn(kSizesReach)) {
    for (std::size_t i = 0; i < sizes->second.size(); i += 2) {
      dvec3 highest(0.0, 0.0, -1e9);
      for (const auto& p : sizes->second[i]->vertices)
        if (p.z > highest.z) highest = p;
      names.push_back({{highest},
                       SceneCurve::Role::kSelection,
                       SceneCurve::Style::kSolid,
                       2.0,
                       "P" + std::to_string(static_cast<int>(kPercentiles[i / 2]))});
    }
  }
  context_.host().viewport().setCurves("figure sizes", std::move(names));
}

void FigureDrawings::lookThroughEyes() {
  const workcell::Entity* entity = context_.entity();
  if (!entity) return;
  const mannequin::Posture posture = context_.posture();
  const auto pose = mannequin::forwardKinematics(*entity->figure(), posture);
  const Pose eyes = mannequin::eyePose(*entity->figure(), pose, posture.gaze);
  constexpr double kAhead = 0.8, kBefore = 0.11;  // m; before the face, which would else be in the picture.
  const dvec3 forward = eyes.rotate({0.0, 0.0, -1.0});
  ViewportWidget& viewport = context_.host().viewport();
  Camera camera = viewport.camera().looking(eyes.p + kBefore * forward, eyes.p + kAhead * forward);
  camera.perspective = true;
  viewport.setCamera(camera);
}

void FigureDrawings::lookAtTarget() {
  const workcell::Entity* entity = context_.entity();
  const workcell::Entity* target = context_.target();
  if (!entity || !context_.isFree()) return;
  if (!target) return seen_->setText(tr("Click a part first."));
  mannequin::Posture posture = postureOf(*entity);
  const geometry::Bounds bounds = context_.host().viewport().scene().boundsOf_W(target->id);
  const dvec3 where = bounds.isEmpty() ? target->X_WE.p : bounds.center();
  const auto pose = mannequin::forwardKinematics(*entity->figure(), posture);
  posture.gaze = mannequin::gazeAt(*entity->figure(), pose, where);
  context_.host().documentModel().executeAll(tr("Gaze of %1").arg(QString::fromStdString(entity->name)),
                                             {postureCommand(*entity, posture)});
}

void FigureDrawings::askSight() {
  const workcell::Entity* entity = context_.entity();
  const workcell::Entity* target = context_.target();
  if (!entity || !target) return seen_->setText(tr("Click a part first."));
  const workcell::Document& document = context_.host().documentModel().document();
  const workcell::PairDefaults defaults = manipulation::pairDefaults(context_.host().configuration());
  runInThreadPool(
      this,
      [scenes = context_.host().scenes(), source = manipulation::sourceOf(document, defaults), mannequin = *entity,
       posture = context_.posture(),
       id = target->id] { return manipulation::sightOfTarget(*scenes->prepare(source), mannequin, posture, id); },
      [this, name = QString::fromStdString(target->name)](const manipulation::TargetSight& sight) {
        QString text = tr("%1: %2 % seen, %3 away, %4")
                           .arg(name)
                           .arg(100.0 * sight.seen, 0, 'f', 0)
                           .arg(lengthText(sight.distance, 0))
                           .arg(QString::fromLatin1(mannequin::wordOf(sight.zone)));
        if (!sight.hidden_by.empty()) text += tr(", hidden by %1").arg(QString::fromStdString(sight.hidden_by));
        if (sight.clearance > 0.0) text += tr(", %1 clear").arg(lengthText(sight.clearance, 0));
        seen_->setText(text + '.');
      });
}

}  // namespace hapticell::app
