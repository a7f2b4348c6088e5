// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "app/viewport/meshes/posed_mesh.h"
#include "app/viewport/scene/render_item.h"
#include "mannequin/shape/figure_skin.h"

namespace hapticell::app {

/// The skin of a mannequin for drawing: all triangles with the same appearance are one item, in the mannequin's
/// frame. Appearances seldom change, so triangles are regrouped only then; each picture updates only positions and
/// normals.
class PosedSkin {
 public:
  explicit PosedSkin(std::shared_ptr<const mannequin::FigureSkin> skin) : skin_(std::move(skin)) {}

  /// How a body is drawn: marks, and its own colour, if any, in place of its clothes' colours.
  struct BodyLook {
    std::uint32_t state = kPlain;
    std::optional<LinkLook> own = {};
    bool operator==(const BodyLook&) const = default;
  };
  /// `bodies`: one entry for each, in the order of mannequin::fleshOf(). The items stay the same while nothing changes.
  const std::vector<RenderItem>& items(const mannequin::Posture& posture, const std::vector<BodyLook>& bodies);

 private:
  using Look = std::tuple<bool, std::array<float, 3>, std::uint8_t, std::uint32_t>;  ///< Face, colour, pattern, state.
  struct Group {
    Look look;
    std::vector<std::size_t> patches;
    std::vector<geometry::Triangle> triangles;
    std::shared_ptr<const std::vector<PosedMesh::Step>> steps;
  };
  void gather(const std::vector<BodyLook>& bodies);

  std::shared_ptr<const mannequin::FigureSkin> skin_;
  std::vector<BodyLook> bodies_;
  bool full_colors_ = false;
  std::optional<mannequin::Posture> posture_;
  std::vector<Group> groups_;
  std::vector<fvec3> places_, normals_;
  std::vector<RenderItem> items_;
};

}  // namespace hapticell::app
