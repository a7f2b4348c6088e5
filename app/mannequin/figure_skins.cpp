// SPDX-License-Identifier: Apache-2.0
#include "app/mannequin/figure_skins.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>

#include "app/host/host.h"
#include "app/mannequin/beside.h"
#include "app/viewport/viewport_widget.h"
#include "mannequin/body_skin.h"
#include "mannequin/figure_model.h"

namespace hapticell::app {
namespace {

constexpr int kDressMilliseconds = 500;                                 // Then it is dressed.
constexpr double kCell = 0.010, kHandCell = 0.003, kHeadCell = 0.0045;  // m

/// The look of each body; none where its link has none.
std::vector<std::optional<LinkLook>> looksOfBodies(const kinematics::RobotModel& model,
                                                   const std::map<int, LinkLook>& looks) {
  std::vector<std::optional<LinkLook>> of_bodies(mannequin::kBodies);
  for (const auto& [link, look] : looks) {
    if (const int body = mannequin::bodyOfLink(model, link); body >= 0)
      of_bodies[static_cast<std::size_t>(body)] = look;
  }
  return of_bodies;
}

/// Colours of the bodies as they are looked: scores keep theirs, the others are quietened later.
std::vector<std::array<float, 3>> colorsOf(const mannequin::Figure& figure,
                                           const std::vector<std::optional<LinkLook>>& looks) {
  const auto flesh = mannequin::fleshOf(figure);
  std::vector<std::array<float, 3>> colors;
  for (std::size_t i = 0; i < flesh.size(); ++i) colors.push_back(looks[i] ? looks[i]->color : flesh[i].color);
  return colors;
}

}  // namespace

SceneModel::Skin makeSkin(const workcell::Entity& entity, const std::vector<double>& joints,
                          const std::map<int, LinkLook>& looks) {
  SceneModel::Skin skin;
  skin.robot = entity.robot;
  skin.joints = joints;
  skin.looks = looks;
  const auto of_bodies = looksOfBodies(*entity.robot, looks);
  const auto colors = colorsOf(*entity.figure, of_bodies);
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
    add(mannequin::skinParts(*entity.figure, posture, cell, region, colors));
  // What belongs to the face follows the part that the face is, and has no border with it.
  const auto& of_head = colors[mannequin::indexOf(mannequin::Segment::kHead)];
  std::stable_partition(parts.begin(), parts.end(), [&](const auto& part) { return part.color != of_head; });
  const std::size_t of_body = parts.size();
  add(mannequin::faceParts(*entity.figure, posture));
  for (mannequin::SkinPart& part : parts) {
    RenderItem item;
    item.mesh = std::make_shared<const geometry::TriangleMesh>(std::move(part.mesh));
    const auto scored = std::find_if(of_bodies.begin(), of_bodies.end(),
                                     [&](const auto& look) { return look && look->color == part.color; });
    item.color = scored == of_bodies.end() ? quietened(part.color) : part.color;
    item.pattern = scored == of_bodies.end() ? std::uint8_t{0} : (*scored)->pattern;
    item.smooth = true;
    item.borderless = skin.parts.size() >= of_body;
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
    auto looks = scene.linkLooks(entity.id);
    if (joints != dressed.joints || entity.figure.get() != dressed.figure || looks != dressed.looks) {
      dressed.joints = std::move(joints);
      dressed.figure = entity.figure.get();
      dressed.looks = std::move(looks);
      dressed.state = Dressed::State::kMoves;
      dressed.since.start();
    } else if (dressed.state == Dressed::State::kMoves && dressed.since.elapsed() > kDressMilliseconds) {
      ask(entity, dressed);
    } else if (dressed.state == Dressed::State::kReady && host_.viewport().hasWhole(dressed.set_at)) {
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
      this, [copy = entity, joints = dressed.joints, looks = dressed.looks] { return makeSkin(copy, joints, looks); },
      [this, id = entity.id, figure = dressed.figure](SceneModel::Skin skin) {
        asking_ = false;
        const auto found = dressed_.find(id);
        if (found == dressed_.end() || found->second.joints != skin.joints || found->second.looks != skin.looks ||
            found->second.figure != figure)
          return;
        found->second.state = Dressed::State::kReady;
        host_.viewport().scene().setSkin(id, std::move(skin));
        found->second.set_at = host_.viewport().scene().revision();
        host_.viewport().refresh();
      });
}

}  // namespace hapticell::app
