// SPDX-License-Identifier: Apache-2.0
#include "app/mannequin/figure_skins.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "app/host/host.h"
#include "app/mannequin/beside.h"
#include "app/viewport/viewport_widget.h"
#include "mannequin/body_skin.h"
#include "mannequin/figure_model.h"

namespace hapticell::app {
namespace {

constexpr int kRestMilliseconds = 500;                                  // Then it is dressed.
constexpr double kCell = 0.010, kHandCell = 0.004, kHeadCell = 0.0045;  // m

}  // namespace

SceneModel::Skin makeSkin(const workcell::Entity& entity, const std::vector<double>& joints) {
  SceneModel::Skin skin;
  skin.robot = entity.robot;
  skin.joints = joints;
  const mannequin::Posture posture = mannequin::toPosture(*entity.figure, {Pose::identity(), joints});
  // What has one colour is one part: between two of them a line would be seen.
  std::vector<mannequin::SkinPart> parts;
  const auto add = [&](std::vector<mannequin::SkinPart> more) {
    for (mannequin::SkinPart& part : more) {
      const auto known = std::find_if(parts.begin(), parts.end(), [&](const auto& p) { return p.color == part.color; });
      if (known == parts.end())
        parts.push_back(std::move(part));
      else
        geometry::append(known->mesh, part.mesh, Pose::identity());
    }
  };
  using Region = mannequin::SkinRegion;
  for (const auto& [cell, region] :
       {std::pair{kCell, Region::kBody}, {kHandCell, Region::kHands}, {kHeadCell, Region::kHead}})
    add(mannequin::skinParts(*entity.figure, posture, cell, region));
  add(mannequin::faceParts(*entity.figure, posture));
  for (mannequin::SkinPart& part : parts) {
    RenderItem item;
    item.mesh = std::make_shared<const geometry::TriangleMesh>(std::move(part.mesh));
    item.color = part.color;
    item.smooth = true;
    skin.parts.push_back(std::move(item));
  }
  return skin;
}

FigureSkins::FigureSkins(Host& host, QObject* parent) : QObject(parent), host_(host) {}

void FigureSkins::look() {
  SceneModel& scene = host_.viewport().scene();
  for (const workcell::Entity& entity : scene.entities()) {
    if (!entity.figure || !entity.robot) continue;
    Dressed& dressed = dressed_[entity.id];
    std::vector<double> joints = scene.joints(entity);
    joints.resize(entity.robot->dof(), 0.0);
    if (joints != dressed.joints || entity.figure.get() != dressed.figure) {
      dressed.joints = std::move(joints);
      dressed.figure = entity.figure.get();
      dressed.state = Dressed::State::kMoves;
      dressed.since.start();
    } else if (dressed.state == Dressed::State::kMoves && dressed.since.elapsed() > kRestMilliseconds) {
      ask(entity, dressed);
    } else if (dressed.state == Dressed::State::kReady && host_.viewport().isFinished()) {
      dressed.state = Dressed::State::kAlone;
      scene.showSkinAlone(entity.id);
      host_.viewport().refresh();
    }
  }
}

void FigureSkins::ask(const workcell::Entity& entity, Dressed& dressed) {
  if (asking_) return;
  asking_ = true;
  dressed.state = Dressed::State::kAsked;
  runBeside(
      this, [copy = entity, joints = dressed.joints] { return makeSkin(copy, joints); },
      [this, id = entity.id, figure = dressed.figure](SceneModel::Skin skin) {
        asking_ = false;
        const auto found = dressed_.find(id);
        if (found == dressed_.end() || found->second.joints != skin.joints || found->second.figure != figure) return;
        found->second.state = Dressed::State::kReady;
        host_.viewport().scene().setSkin(id, std::move(skin));
        host_.viewport().refresh();
      });
}

}  // namespace hapticell::app
