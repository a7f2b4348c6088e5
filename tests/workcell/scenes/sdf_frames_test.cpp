// SPDX-License-Identifier: Apache-2.0
// Cells drawn at random with frames, models inside models, relative_to, placement_frame and all ways to write a
// rotation: every shape must stand where poses composed here, without the library, put it.
#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <numbers>
#include <random>

#include "tests/support/test_data.h"
#include "tests/support/wanted_cases.h"
#include "workcell/scenes/sdf_cell_reader.h"

namespace hapticell::workcell {
namespace {

/// A placement as a matrix of its own, so that nothing of what is tested takes part.
struct Place {
  double R[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  double p[3] = {0, 0, 0};

  Place operator*(const Place& b) const {
    Place c;
    for (int i = 0; i < 3; ++i) {
      c.p[i] = p[i];
      for (int j = 0; j < 3; ++j) {
        c.p[i] += R[i][j] * b.p[j];
        c.R[i][j] = 0;
        for (int k = 0; k < 3; ++k) c.R[i][j] += R[i][k] * b.R[k][j];
      }
    }
    return c;
  }
  Place inverse() const {
    Place c;
    for (int i = 0; i < 3; ++i) {
      c.p[i] = 0;
      for (int j = 0; j < 3; ++j) {
        c.R[i][j] = R[j][i];
        c.p[i] -= R[j][i] * p[j];
      }
    }
    return c;
  }
};

class DrawnCell {
 public:
  explicit DrawnCell(unsigned seed) : random_(seed) {}

  std::string write() {
    std::map<std::string, Place> world;
    std::string text = "<sdf version='1.9'><world name='w'>";
    // Each cell is a start of the importer; much larger ones take libsdformat longer than that.
    for (int k = 0; k < 4; ++k) text += frame(world);
    for (int k = 0; k < 6; ++k) text += model(world, Place(), 0);
    return text + "</world></sdf>";
  }

  std::map<std::string, Place> expected;  ///< In the world, by the names of the shapes.

 private:
  using Scope = std::map<std::string, Place>;  // Names that a pose may refer to, in the scope's frame.

  std::mt19937 random_;
  int number_ = 0;

  double draw(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  bool chance(double share) { return draw(0, 1) < share; }
  std::string name(const char* kind) { return kind + std::to_string(++number_); }

  static Place rolled(const double (&n)[6]) {
    const double cr = std::cos(n[3]), sr = std::sin(n[3]), cp = std::cos(n[4]), sp = std::sin(n[4]),
                 cy = std::cos(n[5]), sy = std::sin(n[5]);
    return {{{cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr},
             {sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr},
             {-sp, cp * sr, cp * cr}},
            {n[0], n[1], n[2]}};
  }

  /// A <pose> with perhaps a frame of the scope that it refers to, and where that is in the scope.
  std::string pose(const Scope& scope, Place& placed, const Place& otherwise = Place()) {
    Place reference = otherwise;
    std::string attributes;
    if (!scope.empty() && chance(0.6)) {
      auto chosen = scope.begin();
      std::advance(chosen, std::uniform_int_distribution<std::size_t>(0, scope.size() - 1)(random_));
      attributes = " relative_to='" + chosen->first + "'";
      reference = chosen->second;
    }
    const double n[6] = {draw(-2, 2), draw(-2, 2), draw(-2, 2), draw(-3, 3), draw(-1.5, 1.5), draw(-3, 3)};
    placed = reference * rolled(n);
    char text[400];
    const double kind = draw(0, 1);
    if (kind < 0.3) {
      const double d = 180.0 / std::numbers::pi;
      attributes += " degrees='true'";
      std::snprintf(text, sizeof text, "%.17g %.17g %.17g %.17g %.17g %.17g", n[0], n[1], n[2], n[3] * d, n[4] * d,
                    n[5] * d);
    } else if (kind < 0.6) {
      const double cr = std::cos(n[3] / 2), sr = std::sin(n[3] / 2), cp = std::cos(n[4] / 2), sp = std::sin(n[4] / 2),
                   cy = std::cos(n[5] / 2), sy = std::sin(n[5] / 2);
      attributes += " rotation_format='quat_xyzw'";
      std::snprintf(text, sizeof text, "%.17g %.17g %.17g  %.17g %.17g %.17g %.17g", n[0], n[1], n[2],
                    sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy, cr * cp * sy - sr * sp * cy,
                    cr * cp * cy + sr * sp * sy);
    } else {
      std::snprintf(text, sizeof text, "%.17g %.17g %.17g %.17g %.17g %.17g", n[0], n[1], n[2], n[3], n[4], n[5]);
    }
    return "<pose" + attributes + ">" + text + "</pose>";
  }

  std::string frame(Scope& scope) {
    const std::string own = name("frame");
    Place placed;
    const std::string text = "<frame name='" + own + "'>" + pose(scope, placed) + "</frame>";
    scope[own] = placed;
    return text;
  }

  std::string link(Scope& scope, std::map<std::string, Place>& shapes) {
    const std::string own = name("link");
    Place placed;
    std::string text = "<link name='" + own + "'>" + pose(scope, placed);
    scope[own] = placed;
    const int count = std::uniform_int_distribution<int>(1, 2)(random_);
    for (int k = 0; k < count; ++k) {
      const std::string shape = name("shape");
      text += "<visual name='" + shape + "'>" + pose(scope, shapes[shape], placed) +
              "<geometry><box><size>0.1 0.2 0.3</size></box></geometry></visual>";
    }
    return text + "</link>";
  }

  /// `X_WS` places the scope in the world.
  std::string model(Scope& scope, const Place& X_WS, int depth) {
    const std::string own = name("model");
    Scope inside;
    std::map<std::string, Place> shapes;  // In the model.
    std::map<std::string, Place> deeper = std::exchange(expected, {});
    std::string body = link(inside, shapes);
    for (int k = 0; k < 4; ++k) {
      const double kind = draw(0, 1);
      if (kind < 0.35)
        body += frame(inside);
      else
        body += kind < 0.75 || depth > 1 ? link(inside, shapes) : model(inside, {}, depth + 1);
    }
    Place placed;
    std::string placement;
    std::string where = pose(scope, placed);
    if (chance(0.4)) {  // The pose is that of one of its own frames.
      auto chosen = inside.begin();
      std::advance(chosen, std::uniform_int_distribution<std::size_t>(0, inside.size() - 1)(random_));
      if (chosen->first.find("::") == std::string::npos) {
        placement = " placement_frame='" + chosen->first + "'";
        placed = placed * chosen->second.inverse();
      }
    }
    for (const auto& [shape, X] : expected) deeper[shape] = X_WS * placed * X;  // Of models inside.
    for (const auto& [shape, X] : shapes) deeper[shape] = X_WS * placed * X;
    expected = std::move(deeper);
    scope[own] = placed;
    for (const auto& [frame_name, X] : inside) {
      if (frame_name.find("::") == std::string::npos) scope[own + "::" + frame_name] = placed * X;
    }
    return "<model name='" + own + "'" + placement + ">" + where + body + "</model>";
  }
};

TEST(SdfFrames, DrawnCellsStandWhereComposedPosesPutThem) {
  test::TemporaryFolder folder;
  std::size_t compared = 0;
  const unsigned cells = test::allCasesAreWanted() ? 10 : 4;
  for (unsigned seed = 1; seed <= cells; ++seed) {
    DrawnCell cell(seed);
    const auto file = folder.write("cell.sdf", cell.write());
    const auto scene = readSdfCell(file, nullptr);
    ASSERT_TRUE(scene) << scene.error().message();
    EXPECT_TRUE(scene->warnings.empty()) << seed << ": " << english(scene->warnings);
    const std::vector<Pose> X_W = nodePoses(*scene);
    std::size_t found = 0;
    for (std::size_t k = 0; k < scene->nodes.size(); ++k) {
      const auto expected = cell.expected.find(scene->nodes[k].name);
      if (expected == cell.expected.end()) continue;
      ++found;
      const dmat3 R = X_W[k].R();
      for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(X_W[k].p[i], expected->second.p[i], 1e-9) << seed << " " << expected->first;
        for (int j = 0; j < 3; ++j)
          EXPECT_NEAR(R[j][i], expected->second.R[i][j], 1e-9) << seed << " " << expected->first;
      }
    }
    EXPECT_EQ(found, cell.expected.size());
    compared += found;
  }
  EXPECT_GT(compared, 30u * cells);
}

}  // namespace
}  // namespace hapticell::workcell
