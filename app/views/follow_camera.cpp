// SPDX-License-Identifier: Apache-2.0
#include "app/views/follow_camera.h"

#include "app/controls/pose_text.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/viewport/widget/viewport_widget.h"
#include "mannequin/posture/forward_kinematics.h"
#include "mannequin/posture/vision.h"
#include "mannequin/shape/figure_model.h"

namespace hapticell::app {
namespace {

// ms between two looks, 30 a second. Half: twice the work; twice: it jerks.
constexpr int kMilliseconds = 33;
// m to the target in front of the eyes: what the view turns about; an arm's length and more. Half, twice: turning
// swings less or more.
constexpr double kEyesAhead = 1.0;
// rad, vertical, 60 degrees: what one takes in without turning the head. Half: as through a tube; twice: distorted.
constexpr double kEyesField = 1.05;
// m: rounding. Half, twice: no effect.
constexpr double kStill = 1e-6;

/// The selected entity where it is of that kind, else the first one that is.
template <typename Is>
const workcell::Entity* find(Host& host, Is is) {
  const workcell::Document& document = host.documentModel().document();
  if (const workcell::Entity* now = document.find(host.selection().current()); now && is(*now)) return now;
  for (const auto& entity : document.state().entities)
    if (is(*entity)) return entity.get();
  return nullptr;
}

bool hasTool(const workcell::Entity& entity) {
  return entity.kind() == workcell::EntityKind::kRobot && entity.robot() && !entity.jointed().tip_link.empty();
}

bool hasEyes(const workcell::Entity& entity) {
  return entity.figure() != nullptr;
}

}  // namespace

FollowCamera::FollowCamera(Host& host, QObject* parent) : QObject(parent), host_(host) {
  connect(&timer_, &QTimer::timeout, this, &FollowCamera::look);
  connect(&host_.documentModel(), &DocumentModel::closing, this, [this] { follow(What::kNothing); });
}

bool FollowCamera::canFollow(What what) const {
  return what == What::kTool ? find(host_, hasTool) != nullptr : what == What::kEyes && find(host_, hasEyes) != nullptr;
}

void FollowCamera::follow(What what) {
  if (what != What::kNothing && !canFollow(what)) what = What::kNothing;
  if (what == what_) return;
  // Eyes take the camera over; afterwards one is where one was.
  if (what_ == What::kEyes && before_) host_.viewport().setCamera(*before_);
  before_ = what == What::kEyes ? std::optional(host_.viewport().camera()) : std::nullopt;
  p_WTool_.reset();
  what_ = what;
  what == What::kNothing ? timer_.stop() : timer_.start(kMilliseconds);
  look();
  emit changed();
}

std::optional<Pose> FollowCamera::tool_W() const {
  const workcell::Entity* robot = find(host_, hasTool);
  if (!robot) return std::nullopt;
  const SceneModel& scene = host_.viewport().scene();
  return tcpPose_W(*robot, scene.placement_W(*robot), scene.joints(*robot));
}

std::optional<Pose> FollowCamera::eyes_W() const {
  const workcell::Entity* person = find(host_, hasEyes);
  if (!person) return std::nullopt;
  const SceneModel& scene = host_.viewport().scene();
  const auto posture = mannequin::toPosture(*person->figure(), {scene.placement_W(*person), scene.joints(*person)});
  return mannequin::eyePose(*person->figure(), mannequin::forwardKinematics(*person->figure(), posture), posture.gaze);
}

void FollowCamera::look() {
  if (what_ == What::kNothing) return;
  const auto X_WF = what_ == What::kTool ? tool_W() : eyes_W();
  if (!X_WF) return follow(What::kNothing);
  ViewportWidget& viewport = host_.viewport();
  Camera camera = viewport.camera();
  if (what_ == What::kTool) {
    const dvec3 before = p_WTool_.value_or(X_WF->p);
    p_WTool_ = X_WF->p;
    if (glm::length(X_WF->p - before) < kStill) return;
    camera.target_W += X_WF->p - before;
  } else {
    camera = camera.looking(X_WF->p, X_WF->p + kEyesAhead * X_WF->rotate(dvec3(0, 0, -1)));
    camera.field_of_view = kEyesField;
    camera.perspective = true;
    if (camera.target_W == viewport.camera().target_W && camera.azimuth == viewport.camera().azimuth) return;
  }
  viewport.setCamera(camera, false);
}

}  // namespace hapticell::app
