// SPDX-License-Identifier: Apache-2.0
#include "workcell/meshes/unit_statement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/shapes/shapes.h"
#include "tests/workcell/meshes/mesh_text.h"
#include "workcell/meshes/mesh_reader.h"
#include "workcell/meshes/mesh_writer.h"

namespace hapticell::workcell {
namespace {

TEST(UnitStatement, KnowsWhatProgramsWrite) {
  const std::pair<const char*, double> stated[] = {
      {"# units: m", 1.0},
      {"# Units: mm", 0.001},
      {"comment units mm", 0.001},
      {"comment units millimetres; maximum extent exactly 200.0 mm", 0.001},
      {"comment units meters; XR local space", 1.0},
      {"# File units = inches", 0.0254},
      {"# File units = meters", 1.0},
      {"# File units = feet", 0.3048},
      {"# This file uses centimeters as units for non-parametric coordinates.", 0.01},
      {"exported from X, UNITS=mm", 0.001},
      {"UNITS= in", 0.0254},
      {"# units in mm", 0.001},
      {"# units are in (inches)", 0.0254},
      {"# 1 unit = 1 mm", 0.001},
      {"# Unit: Microns", 1e-6},
      {"# all dimensions are in millimeters.", 0.001},
      {"# coordinates in m", 1.0},
  };
  for (const auto& [comment, metres] : stated) {
    const auto unit = statedUnit(comment);
    ASSERT_TRUE(unit.has_value()) << comment;
    EXPECT_DOUBLE_EQ(*unit, metres) << comment;
  }
}

TEST(UnitStatement, ReadsNothingIntoOtherComments) {
  for (const char* comment :
       {"", "# Blender v3.2.0 OBJ File: ''", "# units", "# units:", "# units: lj", "# units: m/s", "# Unit: mm^2",
        "# 12 units", "# a unit sphere in 3 m", "# 1 unit = 25.4 mm", "# File units = u.photon/u.s", "# vertices 12 m",
        "# metres", "# Measurements in mm", "# Alias OBJ Model File", "SketchUp STL 10A", "# units: m_per_s"}) {
    EXPECT_FALSE(statedUnit(comment).has_value()) << comment;
  }
  EXPECT_FALSE(statedUnit(std::string(300, 'x') + " units: mm").has_value());
}

double sizeOf(const std::string& content, const char* name, MeshReadOptions options, std::size_t warnings) {
  Diagnostics notes;
  const auto file = parseMeshFile(content, name, options, notes);
  EXPECT_TRUE(file.has_value()) << (file ? "" : file.error().message());
  EXPECT_EQ(notes.warnings.size(), warnings) << name;
  return file ? file->mesh.bounds().size().x : 0.0;
}

TEST(UnitStatement, WhatIsWrittenIsReadInItsSize) {
  const std::vector<NamedMesh> meshes = {{"box", geometry::makeBox(dvec3(12.0)), {}}};
  for (const double unit : {1.0, 0.001, 0.0254}) {
    EXPECT_NEAR(sizeOf(stlBytes(meshes, unit), "a.stl", {}, 0), 12.0, 1e-5) << unit;
    EXPECT_NEAR(sizeOf(objText(meshes, unit, ""), "a.obj", {}, 0), 12.0, 1e-12) << unit;
    EXPECT_NEAR(sizeOf(plyBytes(meshes, unit), "a.ply", {}, 0), 12.0, 1e-5) << unit;
    EXPECT_NEAR(sizeOf(offText(meshes, unit), "a.off", {}, 0), 12.0, 1e-12) << unit;
    EXPECT_NEAR(sizeOf(objText(meshes, unit, ""), "a.obj", {.scale = 0.5}, 0), 6.0 / unit, 1e-6) << unit;
  }
}

TEST(UnitStatement, OnlyStandsAtTheHead) {
  const std::string box = test::objText(geometry::makeBox(dvec3(2.0)));
  EXPECT_NEAR(sizeOf("# units: in\n" + box, "a.obj", {}, 0), 2.0 * 0.0254, 1e-12);
  EXPECT_NEAR(sizeOf(box + "# units: in\n", "a.obj", {}, 1), 2.0, 1e-12)
      << "2 units may be metres or millimetres: said";
  EXPECT_NEAR(sizeOf("# units: mm\n# units: in\n" + box, "a.obj", {}, 0), 0.002, 1e-12);
}

}  // namespace
}  // namespace hapticell::workcell
