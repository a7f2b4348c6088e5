// SPDX-License-Identifier: Apache-2.0
#include "collision/surfaces/surface_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hapticell::collision {
namespace {

constexpr int kMostParameters = 7;
// Of damped least squares, which halve the error at least or end. Half: coarse starts do not arrive; twice: hardly
// used.
constexpr int kIterations = 12;
// Of the tolerance's square, six times it: a fit that creeps so far off will not arrive. Half: some good ones are given
// up; twice: longer until bad ones are.
constexpr double kFarOff = 36.0;
// Of the extent that a start may be off: farther is another shape. Half: starts from noisy normals are refused; twice:
// least squares that do not arrive.
constexpr double kWorstStart = 0.1;
// Extents: flatter than that is no curved surface (a sagitta of 1/1600 of the extent, 0.06 mm on 100 mm). Half: flat
// domes are facets; twice: planes with noise may become cylinders.
constexpr double kLargestRadius = 200.0;

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;

Vector eigen(const dvec3& v) {
  return {v.x, v.y, v.z};
}

dvec3 vec(const Vector& v) {
  return {v.x(), v.y(), v.z()};
}

struct Frame {
  dvec3 e1, e2;
};

Frame frameOf(const dvec3& n) {
  const dvec3 other = std::abs(n.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
  const dvec3 e1 = glm::normalize(glm::cross(n, other));
  return {e1, glm::cross(n, e1)};
}

dvec3 middleOfPoints(std::span<const dvec3> points) {
  dvec3 sum(0.0);
  for (const dvec3& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

double extentOf(std::span<const dvec3> points, const dvec3& middle) {
  double greatest = 0.0;
  for (const dvec3& p : points) greatest = std::max(greatest, glm::length(p - middle));
  return greatest;
}

int parameterCount(SurfaceType type) {
  switch (type) {
    case SurfaceType::kSphere:
      return 4;
    case SurfaceType::kCylinder:
      return 5;
    case SurfaceType::kCone:
      return 6;
    default:
      return 7;
  }
}

/// Moves along the free parameters: positions in metres, the axis by tilting it, angles in radians.
SurfaceShape moved(const SurfaceShape& shape, const Frame& frame, const double* x) {
  SurfaceShape s = shape;
  int i = 0;
  s.p_M += x[i] * frame.e1 + x[i + 1] * frame.e2;
  i += 2;
  if (s.type != SurfaceType::kCylinder) s.p_M += x[i++] * shape.axis_M;
  if (s.type == SurfaceType::kSphere) {
    s.radius += x[i];
    return s;
  }
  s.axis_M = glm::normalize(shape.axis_M + x[i] * frame.e1 + x[i + 1] * frame.e2);
  i += 2;
  if (s.type == SurfaceType::kCone) {
    s.half_angle += x[i];
  } else {
    s.radius += x[i++];
    if (s.type == SurfaceType::kTorus) s.major_radius += x[i];
  }
  return s;
}

bool isSound(const SurfaceShape& s, double extent) {
  if (s.type == SurfaceType::kCone) return s.half_angle > 0.005 && s.half_angle < 0.5 * std::numbers::pi - 0.005;
  if (!(s.radius > 1e-4 * extent && s.radius < kLargestRadius * extent)) return false;
  return s.type != SurfaceType::kTorus ||
         (s.major_radius > 1e-3 * s.radius && s.major_radius < kLargestRadius * extent);
}

struct Normal {
  Eigen::Matrix<double, kMostParameters, kMostParameters> A;
  Eigen::Matrix<double, kMostParameters, 1> b;
  double sum = 0.0;
};

double sumOfSquares(const SurfaceShape& shape, std::span<const dvec3> points) {
  double sum = 0.0;
  for (const dvec3& p : points) {
    const double f = signedDistance(shape, p);
    sum += f * f;
  }
  return sum;
}

Normal normalEquations(const SurfaceShape& shape, std::span<const dvec3> points, double extent) {
  const int n = parameterCount(shape.type);
  const Frame frame = frameOf(shape.axis_M);
  const double step = 1e-6;
  std::array<SurfaceShape, kMostParameters> shifted;
  std::array<double, kMostParameters> scale{};
  for (int k = 0; k < n; ++k) {
    double x[kMostParameters] = {};
    const bool angle =
        shape.type != SurfaceType::kSphere &&
        ((shape.type == SurfaceType::kCylinder && (k == 2 || k == 3)) || (shape.type == SurfaceType::kCone && k >= 3) ||
         (shape.type == SurfaceType::kTorus && (k == 3 || k == 4)));
    scale[static_cast<std::size_t>(k)] = angle ? step : step * extent;
    x[k] = scale[static_cast<std::size_t>(k)];
    shifted[static_cast<std::size_t>(k)] = moved(shape, frame, x);
  }
  Normal normal;
  normal.A.setZero();
  normal.b.setZero();
  for (const dvec3& p : points) {
    const double f = signedDistance(shape, p);
    double J[kMostParameters];
    for (int k = 0; k < n; ++k) {
      const auto i = static_cast<std::size_t>(k);
      J[k] = (signedDistance(shifted[i], p) - f) / scale[i];
    }
    for (int i = 0; i < n; ++i) {
      normal.b(i) -= J[i] * f;
      for (int j = i; j < n; ++j) normal.A(i, j) += J[i] * J[j];
    }
    normal.sum += f * f;
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < i; ++j) normal.A(i, j) = normal.A(j, i);
  }
  return normal;
}

/// Circle through 2-D points: linear least squares of x^2 + y^2 = 2 c . p + d.
bool fitCircle(std::span<const glm::dvec2> points, glm::dvec2& center, double& radius) {
  Matrix A = Matrix::Zero();
  Vector b = Vector::Zero();
  glm::dvec2 middle(0.0);
  for (const auto& p : points) middle += p;
  middle /= static_cast<double>(points.size());
  for (const auto& q : points) {
    const glm::dvec2 p = q - middle;
    const Vector row(p.x, p.y, 1.0);
    A += row * row.transpose();
    b += row * glm::dot(p, p);
  }
  const Eigen::FullPivLU<Matrix> lu(A);
  if (!lu.isInvertible()) return false;
  const Vector x = lu.solve(b);
  center = middle + 0.5 * glm::dvec2(x(0), x(1));
  const double square = x(2) + 0.25 * (x(0) * x(0) + x(1) * x(1));
  if (!(square > 0.0)) return false;
  radius = std::sqrt(square);
  return true;
}

struct Context {
  const FitSample& sample;
  dvec3 middle;
  double extent;
};

std::optional<SurfaceShape> startSphere(const Context& c) {
  Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
  Eigen::Vector4d b = Eigen::Vector4d::Zero();
  for (const dvec3& q : c.sample.points) {
    const dvec3 p = (q - c.middle) / c.extent;
    const Eigen::Vector4d row(p.x, p.y, p.z, 1.0);
    A += row * row.transpose();
    b += row * glm::dot(p, p);
  }
  const Eigen::FullPivLU<Eigen::Matrix4d> lu(A);
  if (!lu.isInvertible()) return std::nullopt;
  const Eigen::Vector4d x = lu.solve(b);
  const dvec3 center = 0.5 * dvec3(x(0), x(1), x(2));
  const double square = x(3) + glm::dot(center, center);
  if (!(square > 0.0)) return std::nullopt;
  SurfaceShape s;
  s.type = SurfaceType::kSphere;
  s.p_M = c.middle + c.extent * center;
  s.radius = c.extent * std::sqrt(square);
  return s;
}

std::optional<SurfaceShape> startCylinder(const Context& c) {
  Matrix N = Matrix::Zero();
  for (const dvec3& n : c.sample.facet_normals) N += eigen(n) * eigen(n).transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(N);
  const double all = static_cast<double>(c.sample.facet_normals.size());
  if (solver.eigenvalues()(0) > 0.02 * all || solver.eigenvalues()(1) < 1e-5 * all) return std::nullopt;
  SurfaceShape s;
  s.type = SurfaceType::kCylinder;
  s.axis_M = glm::normalize(vec(solver.eigenvectors().col(0)));
  const Frame frame = frameOf(s.axis_M);
  std::vector<glm::dvec2> flat;
  flat.reserve(c.sample.points.size());
  for (const dvec3& p : c.sample.points)
    flat.emplace_back(glm::dot(p - c.middle, frame.e1), glm::dot(p - c.middle, frame.e2));
  glm::dvec2 center;
  if (!fitCircle(flat, center, s.radius)) return std::nullopt;
  s.p_M = c.middle + center.x * frame.e1 + center.y * frame.e2;
  return s;
}

std::optional<SurfaceShape> startCone(const Context& c) {
  Matrix A = Matrix::Zero();
  Vector b = Vector::Zero();
  for (std::size_t i = 0; i < c.sample.facet_normals.size(); ++i) {
    const Vector n = eigen(c.sample.facet_normals[i]);
    A += n * n.transpose();
    b += n * glm::dot(c.sample.facet_normals[i], c.sample.facet_points[i] - c.middle);
  }
  const Eigen::SelfAdjointEigenSolver<Matrix> planes(A);
  if (planes.eigenvalues()(0) < 1e-9 * planes.eigenvalues()(2)) return std::nullopt;
  SurfaceShape s;
  s.type = SurfaceType::kCone;
  s.p_M = c.middle + vec(A.ldlt().solve(b));
  if (glm::length(s.p_M - c.middle) > kLargestRadius * c.extent) return std::nullopt;
  std::vector<dvec3> ways;
  dvec3 mean(0.0);
  for (const dvec3& p : c.sample.points) {
    const dvec3 way = p - s.p_M;
    if (glm::length(way) < 1e-3 * c.extent) continue;
    ways.push_back(glm::normalize(way));
    mean += ways.back();
  }
  if (ways.size() < 4) return std::nullopt;
  mean /= static_cast<double>(ways.size());
  Matrix spread = Matrix::Zero();
  for (const dvec3& way : ways) spread += eigen(way - mean) * eigen(way - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(spread);
  s.axis_M = glm::normalize(vec(solver.eigenvectors().col(0)));
  if (glm::dot(s.axis_M, mean) < 0.0) s.axis_M = -s.axis_M;
  s.half_angle = std::acos(std::clamp(glm::dot(s.axis_M, mean), -1.0, 1.0));
  return s;
}

/// With the axis known: the circle of the section.
std::optional<SurfaceShape> torusAbout(const Context& c, const dvec3& p, const dvec3& axis) {
  std::vector<glm::dvec2> flat;
  flat.reserve(c.sample.points.size());
  for (const dvec3& q : c.sample.points) {
    const dvec3 v = q - p;
    const double h = glm::dot(v, axis);
    flat.emplace_back(glm::length(v - h * axis), h);
  }
  glm::dvec2 center;
  SurfaceShape s;
  s.type = SurfaceType::kTorus;
  s.axis_M = axis;
  if (!fitCircle(flat, center, s.radius)) return std::nullopt;
  s.major_radius = center.x;
  s.p_M = p + center.y * axis;
  return s;
}

/// The axis is met by every normal's line: two lines do so nearly for a small patch (the axis and a tangent of the
/// tube's middle line); both are tried. Pottmann, Wallner, "Computational line geometry" (2001).
std::optional<SurfaceShape> startTorus(const Context& c) {
  Eigen::Matrix<double, 6, 6> A = Eigen::Matrix<double, 6, 6>::Zero();
  for (std::size_t i = 0; i < c.sample.facet_normals.size(); ++i) {
    const dvec3& n = c.sample.facet_normals[i];
    const dvec3 m = glm::cross((c.sample.facet_points[i] - c.middle) / c.extent, n);
    Eigen::Matrix<double, 6, 1> row;
    row << m.x, m.y, m.z, n.x, n.y, n.z;
    A += row * row.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(A);
  const Eigen::Matrix<double, 6, 1> u = solver.eigenvectors().col(0), v = solver.eigenvectors().col(1);
  const auto product = [](const auto& x, const auto& y) {
    return 0.5 * (x.template head<3>().dot(y.template tail<3>()) + y.template head<3>().dot(x.template tail<3>()));
  };
  const double uu = product(u, u), uv = product(u, v), vv = product(v, v);
  std::vector<Eigen::Matrix<double, 6, 1>> lines{u};
  const double root = uv * uv - uu * vv;
  if (root >= 0.0 && std::abs(uu) > 1e-12) {
    for (const double sign : {-1.0, 1.0}) lines.push_back((-uv + sign * std::sqrt(root)) / uu * u + v);
  } else if (std::abs(uu) <= 1e-12) {
    lines.push_back(v);
  }
  std::optional<SurfaceShape> best;
  double least = 1e300;
  for (const auto& line : lines) {
    const Vector a = line.head<3>(), moment = line.tail<3>();
    if (a.norm() < 1e-4 * line.norm()) continue;
    const Vector axis = a.normalized();
    const Vector p = axis.cross(moment / a.norm());
    const auto shape = torusAbout(c, c.middle + c.extent * vec(p), glm::normalize(vec(axis)));
    if (!shape || !isSound(*shape, c.extent)) continue;
    const double sum = sumOfSquares(*shape, c.sample.points);
    if (sum < least) {
      least = sum;
      best = shape;
    }
  }
  return best;
}

std::optional<SurfaceShape> startOf(SurfaceType type, const Context& context) {
  switch (type) {
    case SurfaceType::kSphere:
      return startSphere(context);
    case SurfaceType::kCylinder:
      return startCylinder(context);
    case SurfaceType::kCone:
      return startCone(context);
    case SurfaceType::kTorus:
      return startTorus(context);
    default:
      return std::nullopt;
  }
}

double sideOf(const SurfaceShape& shape, const FitSample& sample) {
  double sum = 0.0;
  for (std::size_t i = 0; i < sample.facet_points.size(); ++i)
    sum += glm::dot(viewFrom(shape, sample.facet_points[i]).nhat_M, sample.facet_normals[i]);
  return sum < 0.0 ? -1.0 : 1.0;
}

}  // namespace

double greatestDistance(const SurfaceShape& shape, std::span<const dvec3> points) {
  double greatest = 0.0;
  for (const dvec3& p : points) greatest = std::max(greatest, std::abs(signedDistance(shape, p)));
  return greatest;
}

double refineSurface(SurfaceShape& shape, std::span<const dvec3> points, double tolerance) {
  const double extent = std::max(1e-12, extentOf(points, middleOfPoints(points)));
  const int n = parameterCount(shape.type);
  double damping = 1e-9;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    Normal normal = normalEquations(shape, points, extent);
    bool better = false;
    double gain = 0.0;
    for (int attempt = 0; attempt < 4 && !better; ++attempt) {
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostParameters, kMostParameters> A =
          normal.A.topLeftCorner(n, n);
      for (int i = 0; i < n; ++i) A(i, i) += damping * std::max(A(i, i), 1e-12);
      const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostParameters, 1> x = A.ldlt().solve(normal.b.head(n));
      if (!x.allFinite()) break;
      const SurfaceShape next = moved(shape, frameOf(shape.axis_M), x.data());
      const double sum = isSound(next, extent) ? sumOfSquares(next, points) : 1e300;
      better = sum < normal.sum;
      if (better) {
        gain = normal.sum - sum;
        shape = next;
        damping = std::max(1e-12, 0.1 * damping);
      } else {
        damping = std::max(1e-6, 100.0 * damping);
      }
    }
    const double goal = 1e-4 * tolerance * tolerance * static_cast<double>(points.size());
    if (!better || gain < 1e-3 * normal.sum || normal.sum - gain < goal) break;
    // A fit that creeps far from the tolerance will not arrive.
    if (iteration >= 1 && normal.sum - gain > kFarOff * tolerance * tolerance * static_cast<double>(points.size()) &&
        gain < 0.7 * normal.sum)
      break;
  }
  return greatestDistance(shape, points);
}

std::optional<SurfaceShape> fitSurface(SurfaceType type, const FitSample& sample, double tolerance) {
  if (sample.points.size() < 6 || sample.facet_normals.size() < 3) return std::nullopt;
  Context context{sample, middleOfPoints(sample.points), 0.0};
  context.extent = extentOf(sample.points, context.middle);
  if (!(context.extent > 0.0)) return std::nullopt;
  auto shape = startOf(type, context);
  if (!shape || !isSound(*shape, context.extent)) return std::nullopt;
  shape->side = 1.0;
  double worst = greatestDistance(*shape, sample.points);
  if (!(worst <= kWorstStart * context.extent)) return std::nullopt;
  if (worst > 0.05 * tolerance && type != SurfaceType::kSphere) worst = refineSurface(*shape, sample.points, tolerance);
  if (!(worst <= tolerance) || !isSound(*shape, context.extent)) return std::nullopt;
  shape->side = sideOf(*shape, sample);
  return shape;
}

}  // namespace hapticell::collision
