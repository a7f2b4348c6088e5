// SPDX-License-Identifier: Apache-2.0
#include "tests/collision/contacts/zone_scenes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <random>

#include "geometry/shapes/shapes.h"

namespace hapticell::test {
namespace {

using geometry::makeBox;
using geometry::makeCylinder;
using geometry::makePipe;
using geometry::makePrism;
using geometry::makeSphere;
using geometry::TriangleMesh;

TriangleMesh bracket(double leg, double thick, double height) {
  const std::vector<glm::dvec2> outline{{0, 0}, {leg, 0}, {leg, thick}, {thick, thick}, {thick, leg}, {0, leg}};
  return makePrism(outline, height);
}

TriangleMesh channel(double wide, double deep, double wall, double length) {
  const std::vector<glm::dvec2> outline{{0, 0},
                                        {wide + 2 * wall, 0},
                                        {wide + 2 * wall, deep + wall},
                                        {wide + wall, deep + wall},
                                        {wide + wall, wall},
                                        {wall, wall},
                                        {wall, deep + wall},
                                        {0, deep + wall}};
  return makePrism(outline, length);
}

TriangleMesh posts() {
  TriangleMesh whole = makeBox(dvec3(0.3, 0.3, 0.02));
  geometry::append(whole, makeCylinder(0.015, 0.12, 24), at(0.05, 0, 0.07));
  geometry::append(whole, makeCylinder(0.015, 0.12, 24), at(-0.05, 0, 0.07));
  geometry::append(whole, makeCylinder(0.015, 0.12, 24), at(0, 0.08, 0.07));
  return whole;
}

}  // namespace

std::vector<ZoneScene> simpleZoneScenes() {
  const dvec3 tilt(0.2, 0.1, 0.3);
  std::vector<ZoneScene> scenes;
  scenes.push_back({"box over plate",
                    makeBox(dvec3(0.04)),
                    makeBox(dvec3(0.4, 0.4, 0.02)),
                    {at(0, 0, 0.031), at(0, 0, 0.03), at(0.01, 0.02, 0.045, tilt), at(0.195, 0.03, 0.0305)}});
  scenes.push_back({"box corner at box edge",
                    makeBox(dvec3(0.05)),
                    makeBox(dvec3(0.1)),
                    {at(0.08, 0, 0.08, dvec3(0.5, 0.6, 0.1)), at(0.076, 0.01, 0.04, tilt),
                     at(0.08, 0.085, 0.085, dvec3(0.4, 0.1, 0.9))}});
  scenes.push_back({"crossing beams",
                    makeBox(dvec3(0.3, 0.02, 0.02)),
                    makeBox(dvec3(0.02, 0.3, 0.02)),
                    {at(0, 0, 0.0295, dvec3(0.785398, 0, 0)), at(0.02, 0.05, 0.04, dvec3(0.7, 0.05, 0.4)),
                     at(0.1, 0.145, 0.03, tilt)}});
  scenes.push_back(
      {"box in bracket",
       makeBox(dvec3(0.02)),
       bracket(0.1, 0.01, 0.08),
       {at(0.021, 0.021, 0.04), at(0.03, 0.025, 0.05, tilt), at(0.105, 0.025, 0.04), at(-0.011, -0.011, 0.04)}});
  scenes.push_back({"bracket on beam",
                    bracket(0.1, 0.01, 0.03),
                    makeBox(dvec3(0.03, 0.03, 0.3)),
                    {at(-0.027, -0.027, 0), at(-0.03, -0.03, 0.01, dvec3(0.02, 0.05, 0.1))}});
  scenes.push_back({"box in channel",
                    makeBox(dvec3(0.039, 0.03, 0.05)),
                    channel(0.04, 0.05, 0.01, 0.2),
                    {at(0.03, 0.0255, 0.1), at(0.03, 0.06, 0.1), at(0.03, 0.08, 0.1), at(0.0299, 0.026, 0.21),
                     at(0.03, 0.1, 0.1, tilt)}});
  scenes.push_back({"cylinder in bore",
                    makeCylinder(0.0195, 0.06, 24),
                    makePipe(0.04, 0.02, 0.05, 24),
                    {at(0, 0, 0), at(0, 0, 0.035), at(0.0001, 0.0001, 0.056), at(0.01, 0.03, 0.0565)}});
  scenes.push_back({"sphere on box",
                    makeSphere(0.02, 24),
                    makeBox(dvec3(0.1)),
                    {at(0, 0, 0.0705), at(0.066, 0.01, 0.064), at(0.064, 0.064, 0.064)}});
  scenes.push_back({"thin plates",
                    makeBox(dvec3(0.1, 0.1, 0.001)),
                    makeBox(dvec3(0.1, 0.1, 0.001)),
                    {at(0, 0, 0.002), at(0.02, 0.01, 0.03, dvec3(0.4, 0.3, 0)), at(0.1005, 0, 0)}});
  scenes.push_back({"box among posts",
                    makeBox(dvec3(0.03)),
                    posts(),
                    {at(0, 0, 0.04), at(0, 0, 0.06, tilt), at(0.05, 0, 0.146), at(0, 0.049, 0.0255)}});
  return scenes;
}

namespace {

std::shared_ptr<const collision::ConvexPieces> piecesOf(const geometry::TriangleMesh& mesh,
                                                        ZoneBench::Cutting cutting) {
  return cutting == ZoneBench::Cutting::kWhole
             ? collision::ConvexPieces::build(mesh)
             : collision::ConvexPieces::onDemand(collision::MeshCollider::build(mesh));
}

}  // namespace

ZoneBench::ZoneBench(ZoneScene scene, Ways ways, Cutting cutting)
    : scene_(std::move(scene)),
      moving_(piecesOf(scene_.moving, cutting)),
      environment_(piecesOf(scene_.environment, cutting)),
      proximity_(collision::MeshCollider::build(scene_.moving), collision::MeshCollider::build(scene_.environment)),
      contacts_(ways) {
  if (ways == Ways::kFacets) return;
  moving_model_ = collision::SurfaceModel::build(scene_.moving);
  environment_model_ = collision::SurfaceModel::build(scene_.environment);
  margin_ += moving_model_->surface().greatestSagitta() + environment_model_->surface().greatestSagitta();
}

collision::ZoneContacts ZoneBench::query(const Pose& X_WM) {
  if (moving_model_) {
    const collision::ZonePart moving{moving_.get(), X_WM, 1, 0.0, moving_model_.get()};
    const collision::ZonePart environment{environment_.get(), Pose::identity(), 2, 0.0, environment_model_.get()};
    collision::ZoneOptions options;
    options.radius = scene_.radius;
    return contacts_.find({&moving, 1}, {&environment, 1}, options);
  }
  const collision::ZonePart moving{moving_.get(), X_WM, 1, 0.0};
  const collision::ZonePart environment{environment_.get(), Pose::identity(), 2, 0.0};
  collision::ZoneOptions options;
  options.radius = scene_.radius;
  return collision::zoneContacts({&moving, 1}, {&environment, 1}, options);
}

collision::DistanceResult ZoneBench::exact(const Pose& X_WM) {
  return proximity_.distance(X_WM, Pose::identity());
}

double claimedClearance(const collision::ZoneContacts& set, const Pose& X_WM, const Twist& motion_W) {
  std::vector<double> best(set.groups, -1e9);
  const dquat turn = quaternionFromRotationVector(motion_W.angular);
  const auto moved = [&](const dvec3& p) { return X_WM.p + motion_W.linear + turn * (p - X_WM.p); };
  for (const auto& c : set.contacts) {
    // From the foot on the surface to the point that meets it, as whoever carries the surface sees it.
    const dvec3 e =
        c.normal_moves ? glm::inverse(turn) * (moved(c.q_W) - c.p_W) : c.gap * c.nhat_W + moved(c.p_W) - c.p_W;
    double value = glm::dot(c.nhat_W, e) + 0.5 * glm::dot(e, c.M_W * e);
    if (c.has_trim) value = std::min(value, c.trim_gap + glm::dot(c.trim_nhat_W, moved(c.p_W) - c.p_W));
    best[c.group] = std::max(best[c.group], value);
  }
  return best.empty() ? 1e9 : *std::min_element(best.begin(), best.end());
}

ZoneReport ZoneBench::compare(int count, double rotation) {
  const double kMargin = margin_;
  ZoneReport report;
  report.name = scene_.name;
  report.pieces_moving = moving_->pieces().size();
  report.pieces_environment = environment_->pieces().size();
  std::mt19937_64 random(20261121);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::normal_distribution<double> normal;
  std::vector<double> times;
  double extent = 0.0;
  for (const dvec3& p : scene_.moving.vertices) extent = std::max(extent, glm::length(p));
  for (const Pose& X_WM : scene_.places) {
    const std::clock_t start = std::clock();
    const auto set = query(X_WM);
    times.push_back(1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    char place[80];
    std::snprintf(place, sizeof place, " %zu/%u/%.1f/%.1f", set.contacts.size(), set.groups, 1e3 * set.radius,
                  times.back());
    report.places += place;
    report.entries = std::max(report.entries, set.contacts.size());
    report.groups = std::max(report.groups, set.groups);
    report.least_radius = std::min(report.least_radius, set.radius);
    report.complete = report.complete && set.complete;
    for (int i = 0; i < 2 * count; ++i) {
      const double length = set.radius * std::pow(10.0, -3.0 * uniform(random));
      Twist motion;
      motion.linear = length * glm::normalize(dvec3(normal(random), normal(random), normal(random)));
      const bool turned = i >= count;
      if (turned) {
        // No point of the body moves farther than the kept radius.
        const double angle =
            std::min(rotation * length / scene_.radius, (set.radius - length) / extent) * uniform(random);
        motion.angular = angle * glm::normalize(dvec3(normal(random), normal(random), normal(random)));
      }
      const Pose X_WN{X_WM.p + motion.linear, glm::normalize(quaternionFromRotationVector(motion.angular) * X_WM.q)};
      const auto truth = exact(X_WN);
      const double claimed = claimedClearance(set, X_WM, motion);
      bool hole = truth.colliding && claimed > kMargin;
      bool wall = !truth.colliding && truth.distance > kMargin && claimed < -kMargin;
      // Points behind something thin are free for themselves; what counts is that no way leads there.
      for (int k = 1; moving_model_ && k < 40; ++k) {
        const double share = k / 40.0;
        const Twist part{share * motion.linear, share * motion.angular};
        if (hole && claimedClearance(set, X_WM, part) < -kMargin) hole = false;
        if (wall && exact({X_WM.p + part.linear, quaternionFromRotationVector(part.angular) * X_WM.q}).colliding)
          wall = false;
      }
      if (turned) {
        ++report.turned;
        report.turned_holes += hole ? 1 : 0;
        report.turned_walls += wall ? 1 : 0;
        if (hole) report.turned_hole_depth = std::max(report.turned_hole_depth, claimed);
        continue;
      }
      ++(truth.colliding ? report.blocked : report.free);
      report.holes += hole ? 1 : 0;
      report.false_walls += wall ? 1 : 0;
      if (hole) report.hole_depth = std::max(report.hole_depth, claimed);
      if (wall) report.wall_depth = std::max(report.wall_depth, -claimed);
    }
  }
  std::sort(times.begin(), times.end());
  report.cold_ms = times.back();
  report.median_ms = times[times.size() / 2];
  return report;
}

std::string line(const ZoneReport& r) {
  char text[400];
  std::snprintf(
      text, sizeof text,
      "%-24s pieces %zu/%zu entries %zu groups %u radius %.2f mm%s time %.2f/%.2f ms | free %d blocked %d holes %d "
      "(%.4f mm) walls %d (%.3f mm) | turned %d holes %d (%.3f mm) walls %d",
      r.name.c_str(), r.pieces_moving, r.pieces_environment, r.entries, r.groups, 1e3 * r.least_radius,
      r.complete ? "" : " INCOMPLETE", r.median_ms, r.cold_ms, r.free, r.blocked, r.holes, 1e3 * r.hole_depth,
      r.false_walls, 1e3 * r.wall_depth, r.turned, r.turned_holes, 1e3 * r.turned_hole_depth, r.turned_walls);
  return text + (" | places" + r.places);
}

}  // namespace hapticell::test
