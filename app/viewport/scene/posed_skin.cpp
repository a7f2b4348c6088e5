// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/scene/posed_skin.h"

#include "app/viewport/scene/part_colors.h"

namespace hapticell::app {
namespace {

bool samePosture(const mannequin::Posture& a, const mannequin::Posture& b) {
  return a.angles == b.angles && a.gaze.yaw == b.gaze.yaw && a.gaze.pitch == b.gaze.pitch;
}

}  // namespace

void PosedSkin::gather(const std::vector<BodyLook>& bodies) {
  bodies_ = bodies;
  full_colors_ = fullColorsNow();
  groups_.clear();
  std::map<Look, std::size_t> known;
  for (std::size_t p = 0; p < skin_->patches().size(); ++p) {
    const auto& patch = skin_->patches()[p];
    const BodyLook& body = bodies[patch.body];
    const bool own = body.own && !patch.face;
    const Look look{patch.face, own ? body.own->color : partColor(patch.color), own ? body.own->pattern : std::uint8_t{0},
                    body.state};
    const auto [place, is_new] = known.try_emplace(look, groups_.size());
    if (is_new) groups_.push_back({look, {}, {}, {}});
    groups_[place->second].patches.push_back(p);
  }
  for (Group& group : groups_) {
    auto steps = std::make_shared<std::vector<PosedMesh::Step>>();
    for (std::size_t i = 0; i < skin_->stepErrors().size(); ++i) {
      PosedMesh::Step& step = steps->emplace_back();
      step.error = i == 0 ? 0.0 : skin_->stepErrors()[i];
      std::uint32_t first = 0;
      for (const std::size_t p : group.patches) {
        const auto& patch = skin_->patches()[p];
        for (const auto& triangle : patch.steps[i])
          for (const std::uint32_t v : triangle) step.indices.push_back(first + v);
        first += static_cast<std::uint32_t>(patch.count);
      }
    }
    const auto& whole = steps->front().indices;
    for (std::size_t i = 0; i < whole.size(); i += 3) group.triangles.push_back({whole[i], whole[i + 1], whole[i + 2]});
    group.steps = std::move(steps);
  }
}

const std::vector<RenderItem>& PosedSkin::items(const mannequin::Posture& posture,
                                                const std::vector<BodyLook>& bodies) {
  const bool same_looks = bodies == bodies_ && full_colors_ == fullColorsNow();
  if (same_looks && posture_ && samePosture(*posture_, posture)) return items_;
  if (!same_looks) gather(bodies);
  if (!posture_ || !samePosture(*posture_, posture)) skin_->pose(posture, places_, normals_);
  posture_ = posture;
  items_.clear();
  for (const Group& group : groups_) {
    auto mesh = std::make_shared<PosedMesh>();
    for (const std::size_t p : group.patches) {
      const auto& patch = skin_->patches()[p];
      for (std::size_t v = patch.first; v < patch.first + patch.count; ++v) mesh->vertices.emplace_back(places_[v]);
      const auto from = normals_.begin() + static_cast<std::ptrdiff_t>(patch.first);
      mesh->normals.insert(mesh->normals.end(), from, from + static_cast<std::ptrdiff_t>(patch.count));
    }
    mesh->triangles = group.triangles;
    mesh->steps = group.steps;
    RenderItem& item = items_.emplace_back();
    std::tie(std::ignore, item.color, item.pattern, item.state) = group.look;
    item.bounds_M = mesh->bounds();
    item.mesh = std::move(mesh);
    item.smooth = true;
    item.borderless = items_.size() > 1;  // Clothes and marks have edges enough of their own.
  }
  return items_;
}

}  // namespace hapticell::app
