// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <list>
#include <memory>
#include <optional>
#include <vector>

#include "app/viewport/scene/camera.h"
#include "app/viewport/scene/render_item.h"
#include "app/viewport/scene/section_plane.h"
#include "app/viewport/tools/picked_feature.h"
#include "collision/trees/ray.h"

namespace hapticell::app {

struct EdgeChain;

/// Finds the face, edge or corner of a part at a pixel.
///
/// Dialogs use it by ViewportWidget::startPick() (see PickRequest there). This class has the computation: no OpenGL, no
/// widgets. The id buffer gives the visible part; a ray finds its triangle; a flood fill collects the smooth
/// surroundings of that triangle (at most kFloodLimit triangles, so that a part of millions costs no more than one of
/// thousands); their surfaces are recognised (collision/surfaces/surface_recognition.h), and the face's borders are its
/// edges. Lines and circles are fitted to chains of border edges. The last results are kept, so hovering is cheap. One
/// thread.
class FeaturePicker {
 public:
  /// Triangles around the pointer, for quick hovers. Half: only the middle of large faces is known; twice: it lags.
  static constexpr std::size_t kFloodLimit = 4000;
  /// Distance at which a corner is picked, for aiming by mouse. Half: hard to hit; twice: edges at it cannot be picked.
  static constexpr double kVertexPixels = 10.0;
  /// The same for an edge; less than for a corner on it. Half: hard to hit; twice: small faces cannot be picked.
  static constexpr double kEdgePixels = 7.0;

  /// The query: the items of one entity and link (from the id buffer), and the pixel.
  struct Question {
    const std::vector<RenderItem>* items = nullptr;
    workcell::EntityId entity = 0;
    int link = -1;
    Camera camera;
    ViewSize size;
    glm::dvec2 pixel{0.0};
    FeatureFilter filter;
    std::optional<SectionPlane> section = {};  ///< What it cuts away cannot be picked.
  };
  FeaturePicker();
  ~FeaturePicker();

  /// Empty if the ray meets no triangle of those items or the filter leaves nothing.
  std::optional<PickedFeature> pick(const Question& question);

 private:
  struct Incidence;
  struct Patch;
  struct Hit {
    const RenderItem* item = nullptr;
    std::uint32_t triangle = 0;
    double along = 0.0;
  };
  struct Snap {
    const EdgeChain* chain = nullptr;
    dvec3 p_WEdge{0.0}, p_WCorner{0.0};
    double edge_pixels = 1e300, corner_pixels = 1e300;
  };
  static std::optional<Hit> hitOrNear(Question& question, Ray& ray_W);
  static Snap snap(const Patch& patch, const Pose& X_WM, const Question& question);
  static std::optional<Hit> meet(const Question& question, const Ray& ray_W);
  std::shared_ptr<const Incidence> incidenceOf(const std::shared_ptr<const geometry::TriangleMesh>& mesh);
  const Patch& patchAbout(const Hit& hit, const collision::Ray& ray_M);

  std::list<std::shared_ptr<const Incidence>> incidences_;  // Of the last picked meshes, newest first.
  std::unique_ptr<Patch> patch_;
};

}  // namespace hapticell::app
