// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/overlay/view_cube.h"

#include <QtGlobal>
#include <cmath>
#include <tuple>
#include <utility>

namespace hapticell::app {
namespace {

struct FaceDefinition {
  StandardView view;
  const char* name;
  dvec3 normal;
  dvec3 right;  // Of the name, as read.
  dvec3 up;
};

const std::array<FaceDefinition, 6>& faceDefinitions() {
  static const std::array<FaceDefinition, 6> faces{{
      {StandardView::kFront, QT_TRANSLATE_NOOP("ViewCube", "FRONT"), {0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
      {StandardView::kBack, QT_TRANSLATE_NOOP("ViewCube", "BACK"), {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}},
      {StandardView::kRight, QT_TRANSLATE_NOOP("ViewCube", "RIGHT"), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
      {StandardView::kLeft, QT_TRANSLATE_NOOP("ViewCube", "LEFT"), {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
      {StandardView::kTop, QT_TRANSLATE_NOOP("ViewCube", "TOP"), {0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
      {StandardView::kBottom, QT_TRANSLATE_NOOP("ViewCube", "BOTTOM"), {0, 0, -1}, {1, 0, 0}, {0, -1, 0}},
  }};
  return faces;
}

constexpr double kEye = 5.5;         // Of the cube's own little perspective, in half edges.
constexpr double kEdgeShare = 0.68;  // Beyond this share of a face lies its edge.

/// From where to where a spot reaches along an axis of a face, at whose edge it is where `side` is not zero.
std::pair<double, double> patchRange(double side) {
  if (side > 0.0) return {kEdgeShare, 1.0};
  if (side < 0.0) return {-1.0, -kEdgeShare};
  return {-kEdgeShare, kEdgeShare};
}

}  // namespace

glm::dvec2 ViewCube::project(const dvec3& point, const Camera& camera) const {
  const double depth = kEye + glm::dot(point, camera.forward_W());
  const double scale = camera.perspective ? half_edge_ * kEye / depth : half_edge_;
  return center_ + scale * glm::dvec2(glm::dot(point, camera.right_W()), -glm::dot(point, camera.up_W()));
}

std::vector<ViewCubeFace> ViewCube::visibleFaces(const Camera& camera) const {
  const dvec3 eye = -kEye * camera.forward_W();
  std::vector<ViewCubeFace> result;
  for (const FaceDefinition& face : faceDefinitions()) {
    const dvec3 to_eye = camera.perspective ? glm::normalize(eye - face.normal) : -camera.forward_W();
    const double facing = glm::dot(face.normal, to_eye);
    if (facing <= 1e-3) continue;
    ViewCubeFace seen{face.view, face.name, face.normal, {}, facing};
    seen.corners = {
        project(face.normal - face.right + face.up, camera), project(face.normal + face.right + face.up, camera),
        project(face.normal + face.right - face.up, camera), project(face.normal - face.right - face.up, camera)};
    result.push_back(seen);
  }
  return result;
}

std::vector<std::array<glm::dvec2, 4>> ViewCube::patches(const ViewCubeSpot& spot, const Camera& camera) const {
  std::vector<std::array<glm::dvec2, 4>> result;
  for (const ViewCubeFace& face : visibleFaces(camera)) {
    if (glm::dot(spot, face.normal_W) < 0.5) continue;
    dvec3 low = face.normal_W;
    dvec3 high = face.normal_W;
    int first = -1, second = -1;
    for (int axis = 0; axis < 3; ++axis) {
      if (face.normal_W[axis] != 0.0) continue;
      (first < 0 ? first : second) = axis;
      std::tie(low[axis], high[axis]) = patchRange(spot[axis]);
    }
    dvec3 corner = low;
    std::array<glm::dvec2, 4> patch;
    patch[0] = project(corner, camera);
    corner[first] = high[first];
    patch[1] = project(corner, camera);
    patch[2] = project(high, camera);
    corner[first] = low[first];
    corner[second] = high[second];
    patch[3] = project(corner, camera);
    result.push_back(patch);
  }
  return result;
}

std::optional<ViewCubeSpot> ViewCube::pick(const glm::dvec2& pixel, const Camera& camera) const {
  const glm::dvec2 offset = (pixel - center_) / half_edge_;
  dvec3 origin;
  dvec3 direction;
  if (camera.perspective) {
    origin = -kEye * camera.forward_W();
    direction = glm::normalize(kEye * camera.forward_W() + offset.x * camera.right_W() - offset.y * camera.up_W());
  } else {
    origin = -kEye * camera.forward_W() + offset.x * camera.right_W() - offset.y * camera.up_W();
    direction = camera.forward_W();
  }
  // Slab test against the cube [-1, 1]^3 (Kay and Kajiya 1986).
  double enter = -1e30;
  double leave = 1e30;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(direction[axis]) < 1e-12) {
      if (std::abs(origin[axis]) > 1.0) return std::nullopt;
      continue;
    }
    const double a = (-1.0 - origin[axis]) / direction[axis];
    const double b = (1.0 - origin[axis]) / direction[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  if (enter > leave) return std::nullopt;
  const dvec3 hit = origin + enter * direction;
  ViewCubeSpot spot(0.0);
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(hit[axis]) > kEdgeShare) spot[axis] = hit[axis] > 0.0 ? 1.0 : -1.0;
  return spot;
}

}  // namespace hapticell::app
