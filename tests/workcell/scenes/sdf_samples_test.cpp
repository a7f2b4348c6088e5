// SPDX-License-Identifier: Apache-2.0
// The library's own sample files, read by us and by the library alone: every visual stands where its semantic graph has
// it, as a body of a cell and as a link of a robot. HAPTICELL_SDF_SAMPLES names the folder (test/sdf of libsdformat's
// source); without it the test is skipped.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <optional>
#include <sdf/sdf.hh>

#include "kinematics/model/robot_model.h"
#include "tests/support/test_data.h"
#include "workcell/scenes/sdf_cell_reader.h"
#include "workcell/scenes/sdf_reader.h"

namespace hapticell::workcell {
namespace {

namespace fs = std::filesystem;
using Places = std::multimap<std::string, Pose>;

Pose toPose(const ignition::math::Pose3d& X) {
  return {{X.Pos().X(), X.Pos().Y(), X.Pos().Z()},
          glm::normalize(dquat(X.Rot().W(), X.Rot().X(), X.Rot().Y(), X.Rot().Z()))};
}

/// Nothing where the sample is one of those whose frames are wrong.
std::optional<Pose> resolved(const sdf::SemanticPose& pose, const std::string& to) {
  ignition::math::Pose3d X;
  return pose.Resolve(X, to).empty() ? std::optional(toPose(X)) : std::nullopt;
}

/// Visuals (and links of robots) by name, where the library has them.
void addPlaces(const sdf::Model& model, const Pose& X_WP, const std::string& scope, Places& visuals, Places& links) {
  const auto X_PM = resolved(model.SemanticPose(), scope.empty() ? "" : "__model__");
  if (!X_PM) return;
  const Pose X_WM = X_WP * *X_PM;
  for (std::uint64_t k = 0; k < model.LinkCount(); ++k) {
    const sdf::Link& link = *model.LinkByIndex(k);
    const auto X_ML = resolved(link.SemanticPose(), "__model__");
    if (!X_ML) continue;
    links.emplace(scope + link.Name(), X_WM * *X_ML);
    for (std::uint64_t i = 0; i < link.VisualCount(); ++i) {
      const sdf::Visual& visual = *link.VisualByIndex(i);
      const auto* shape = visual.Geom();
      const auto X_LV = resolved(visual.SemanticPose(), link.Name());
      if (X_LV && shape && (shape->BoxShape() || shape->SphereShape() || shape->CylinderShape() || shape->CapsuleShape()))
        visuals.emplace(visual.Name(), X_WM * *X_ML * *X_LV);
    }
  }
  for (std::uint64_t k = 0; k < model.ModelCount(); ++k) {
    const sdf::Model& inside = *model.ModelByIndex(k);
    addPlaces(inside, X_WM, scope + inside.Name() + "::", visuals, links);
  }
}

bool isAt(const Places& places, const std::string& name, const Pose& X_W) {
  const auto [begin, end] = places.equal_range(name);
  return std::any_of(begin, end, [&](const auto& one) {
    const Pose off = one.second.inverse() * X_W;
    return glm::length(off.p) < 1e-9 && glm::length(rotationVector(off.q)) < 1e-7;
  });
}

TEST(SdfSamples, StandWhereTheLibraryPutsThem) {
  const char* folder = std::getenv("HAPTICELL_SDF_SAMPLES");
  if (!folder) GTEST_SKIP() << "HAPTICELL_SDF_SAMPLES does not name libsdformat's samples";
  int files = 0, robots = 0;
  std::size_t shapes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".sdf" && entry.path().extension() != ".world") continue;
    sdf::Root root;
    root.Load(entry.path().string());  // What it complains of may be of no matter here.
    std::vector<const sdf::Model*> models;
    if (root.Model()) models.push_back(root.Model());
    const sdf::World* world = root.WorldCount() > 0 ? root.WorldByIndex(0) : nullptr;
    for (std::uint64_t k = 0; world && k < world->ModelCount(); ++k) models.push_back(world->ModelByIndex(k));
    if (models.empty()) continue;
    Places visuals, links;
    for (const sdf::Model* model : models) addPlaces(*model, Pose(), "", visuals, links);
    const auto scene = readSdfCell(entry.path(), nullptr, false);
    if (!scene) {
      ADD_FAILURE() << scene.error().message();
      continue;
    }
    ++files;
    Places ours;
    const std::vector<Pose> X_F = nodePoses(*scene);
    for (std::size_t k = 0; k < X_F.size(); ++k) ours.emplace(scene->nodes[k].name, X_F[k]);
    for (const auto& [name, X_W] : visuals) {
      ++shapes;
      EXPECT_TRUE(isAt(ours, name, X_W)) << entry.path() << ": " << name << " at " << X_W.p.x << " " << X_W.p.y << " "
                                         << X_W.p.z;
    }
    Diagnostics notes;
    const auto robot = isSdfCell(entry.path()) ? Expected<SdfRobot>(tl::unexpected(Error{})) : readSdf(entry.path(), notes);
    if (!robot || robot->model.closure) continue;
    ++robots;
    std::vector<Pose> X_BL;
    kinematics::forwardKinematics(robot->model, std::vector<double>(robot->model.dof(), 0.0), X_BL);
    for (std::size_t k = 0; k < X_BL.size(); ++k) {
      const std::string& name = robot->model.links[k].name;
      EXPECT_TRUE(links.count(name) == 0 || isAt(links, name, robot->X_FB * X_BL[k]))
          << entry.path() << ": link " << name;
    }
  }
  std::cout << files << " files, " << shapes << " shapes, " << robots << " robots\n";
  EXPECT_GT(files, 100);
  EXPECT_GT(robots, 5);
}

}  // namespace
}  // namespace hapticell::workcell
