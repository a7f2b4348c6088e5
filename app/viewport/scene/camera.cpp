// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/scene/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace hapticell::app {
namespace {

// 240 pixels are 103 degrees; our choice. Half, twice: more or less of the table for a turn.
constexpr double kRadiansPerPixel = 0.0075;
constexpr double kMaxElevation =
    0.5 * std::numbers::pi;  // Just short of the pole: azimuth keeps giving the screen's right.
// m to the middle: nearer the front plane cuts what is looked at. Half, twice: small parts can be seen larger or
// smaller.
constexpr double kMinDistance = 0.01;
// m: as far as parts may lie (kFarthest of command_checks.h). Half: a large cell cannot be seen whole; twice: parts are
// points.
constexpr double kMaxDistance = 2000.0;
// Of what is fitted: a rim of about 5 % on each side; our choice. Half, twice of the rest: tighter or looser.
constexpr double kFitMargin = 1.12;

void appendCorners(const geometry::Bounds& box, std::vector<dvec3>& corners) {
  for (int i = 0; i < 8; ++i)
    corners.emplace_back((i & 1) ? box.max.x : box.min.x, (i & 2) ? box.max.y : box.min.y,
                         (i & 4) ? box.max.z : box.min.z);
}

double wrapped(double angle) {
  return std::remainder(angle, 2.0 * std::numbers::pi);
}

}  // namespace

dvec3 Camera::forward_W() const {
  const double c = std::cos(elevation);
  return {-std::sin(azimuth) * c, std::cos(azimuth) * c, -std::sin(elevation)};
}

dvec3 Camera::right_W() const {
  return {std::cos(azimuth), std::sin(azimuth), 0.0};
}
dvec3 Camera::up_W() const {
  return glm::cross(right_W(), forward_W());
}
dvec3 Camera::eye_W() const {
  return target_W - distance * forward_W();
}

glm::dmat4 Camera::viewMatrix() const {
  const dvec3 r = right_W();
  const dvec3 u = up_W();
  const dvec3 f = forward_W();
  const dvec3 e = eye_W();
  return glm::dmat4(glm::dvec4(r.x, u.x, -f.x, 0.0), glm::dvec4(r.y, u.y, -f.y, 0.0), glm::dvec4(r.z, u.z, -f.z, 0.0),
                    glm::dvec4(-glm::dot(r, e), -glm::dot(u, e), glm::dot(f, e), 1.0));
}

glm::dmat4 Camera::projectionMatrix(const ViewSize& size, const geometry::Bounds& scene_W) const {
  const double aspect = size.width / size.height;
  const double reach = scene_W.isEmpty() ? 10.0 : scene_W.radius();
  const double depth = scene_W.isEmpty() ? distance : glm::dot(scene_W.center() - eye_W(), forward_W());
  const double far_plane = std::max(depth + 1.05 * reach, 0.1 * distance);
  if (!perspective) {
    const double half = distance * std::tan(0.5 * field_of_view);
    const double near_plane = std::min(depth - 1.05 * reach, 0.0);
    return glm::ortho(-half * aspect, half * aspect, -half, half, near_plane, far_plane);
  }
  const double near_plane = std::max(depth - 1.05 * reach, far_plane * 5e-4);
  return glm::perspective(field_of_view, aspect, near_plane, far_plane);
}

std::optional<glm::dvec2> Camera::project(const dvec3& p_WQ, const ViewSize& size) const {
  const dvec3 offset = p_WQ - eye_W();
  const double depth = glm::dot(offset, forward_W());
  if (perspective && depth < 1e-6) return std::nullopt;
  const double per_metre = 0.5 * size.height / ((perspective ? depth : distance) * std::tan(0.5 * field_of_view));
  return glm::dvec2(0.5 * size.width + per_metre * glm::dot(offset, right_W()),
                    0.5 * size.height - per_metre * glm::dot(offset, up_W()));
}

Ray Camera::rayThrough(const glm::dvec2& pixel, const ViewSize& size) const {
  const double half = std::tan(0.5 * field_of_view);
  const double x = (2.0 * pixel.x - size.width) / size.height * half;
  const double y = (size.height - 2.0 * pixel.y) / size.height * half;
  if (perspective) return {eye_W(), glm::normalize(forward_W() + x * right_W() + y * up_W())};
  return {eye_W() + distance * (x * right_W() + y * up_W()), forward_W()};
}

double Camera::metresPerPixel(const dvec3& p_WQ, const ViewSize& size) const {
  const double depth = perspective ? std::max(glm::dot(p_WQ - eye_W(), forward_W()), kMinDistance) : distance;
  return 2.0 * depth * std::tan(0.5 * field_of_view) / size.height;
}

void Camera::orbit(const glm::dvec2& pixels, const dvec3& pivot_W) {
  const dvec3 offset = target_W - pivot_W;
  const dvec3 seen(glm::dot(offset, right_W()), glm::dot(offset, up_W()), glm::dot(offset, forward_W()));
  azimuth = wrapped(azimuth - pixels.x * kRadiansPerPixel);
  elevation = std::clamp(elevation + pixels.y * kRadiansPerPixel, -kMaxElevation, kMaxElevation);
  target_W = pivot_W + seen.x * right_W() + seen.y * up_W() + seen.z * forward_W();
}

void Camera::pan(const glm::dvec2& pixels, const dvec3& p_WQ, const ViewSize& size) {
  const double scale = metresPerPixel(p_WQ, size);
  target_W += scale * (pixels.y * up_W() - pixels.x * right_W());
}

void Camera::zoom(double factor, const dvec3& p_WQ) {
  const double wanted = std::clamp(distance * factor, kMinDistance, kMaxDistance);
  const double share = wanted / distance;
  target_W = p_WQ + share * (target_W - p_WQ);
  distance = wanted;
}

Camera Camera::fitted(const geometry::Bounds& bounds_W, const ViewSize& size) const {
  std::vector<dvec3> corners;
  if (!bounds_W.isEmpty()) appendCorners(bounds_W, corners);
  return fitted(corners, size);
}

Camera Camera::fitted(const std::vector<dvec3>& points_W, const ViewSize& size) const {
  Camera result = *this;
  if (points_W.empty()) return result;
  const double tangent_y = std::tan(0.5 * field_of_view) / kFitMargin;
  const double tangent_x = tangent_y * size.width / size.height;
  geometry::Bounds seen;              // Along right, up and backwards.
  glm::dvec2 high(-1e30), low(1e30);  // Where the sides of a view that holds the points meet depth 0.
  for (const dvec3& p_W : points_W) {
    const dvec3 p(glm::dot(p_W, right_W()), glm::dot(p_W, up_W()), -glm::dot(p_W, forward_W()));
    seen.add(p);
    const glm::dvec2 slant = (perspective ? p.z : 0.0) * glm::dvec2(tangent_x, tangent_y);
    high = glm::max(high, glm::dvec2(p) + slant);
    low = glm::min(low, glm::dvec2(p) - slant);
  }
  // The eye stands as near as the wider of the two pairs of sides allows, in the middle of both.
  const glm::dvec2 middle = 0.5 * (high + low), half = 0.5 * (high - low);
  const double back = std::max(half.x / tangent_x, half.y / tangent_y);
  const double middle_depth = seen.center().z;
  const double needed = perspective ? back - middle_depth : back;
  result.target_W = middle.x * right_W() + middle.y * up_W() - middle_depth * forward_W();
  result.distance = std::clamp(std::max(needed, 0.2 * seen.radius()), kMinDistance, kMaxDistance);
  return result;
}

Camera Camera::looking(const dvec3& p_WEye, const dvec3& p_WTarget) const {
  const double length = glm::length(p_WTarget - p_WEye);
  if (!(length > 0.0)) return *this;
  Camera result = turnedTo(p_WTarget - p_WEye);
  result.target_W = p_WTarget;
  result.distance = length;
  return result;
}

Camera Camera::turnedTo(StandardView view) const {
  switch (view) {
    case StandardView::kFront:
      return turnedTo(dvec3(0, 1, 0));
    case StandardView::kBack:
      return turnedTo(dvec3(0, -1, 0));
    case StandardView::kRight:
      return turnedTo(dvec3(-1, 0, 0));
    case StandardView::kLeft:
      return turnedTo(dvec3(1, 0, 0));
    case StandardView::kTop:
      return turnedTo(dvec3(0, 0, -1));
    case StandardView::kBottom:
      return turnedTo(dvec3(0, 0, 1));
    case StandardView::kIsometric:
      return turnedTo(dvec3(-1, 1, -1));
  }
  return *this;
}

Camera Camera::turnedTo(const dvec3& direction_W) const {
  Camera result = *this;
  const dvec3 d = glm::normalize(direction_W);
  result.elevation = std::clamp(std::asin(std::clamp(-d.z, -1.0, 1.0)), -kMaxElevation, kMaxElevation);
  // Straight up or down: north stays up.
  result.azimuth = std::hypot(d.x, d.y) > 1e-9 ? std::atan2(-d.x, d.y) : 0.0;
  return result;
}

Camera interpolate(const Camera& from, const Camera& to, double s) {
  Camera result = to;
  result.target_W = from.target_W + s * (to.target_W - from.target_W);
  result.azimuth = wrapped(from.azimuth + s * wrapped(to.azimuth - from.azimuth));
  result.elevation = from.elevation + s * (to.elevation - from.elevation);
  result.distance = std::exp(std::log(from.distance) + s * (std::log(to.distance) - std::log(from.distance)));
  return result;
}

double eased(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

}  // namespace hapticell::app
