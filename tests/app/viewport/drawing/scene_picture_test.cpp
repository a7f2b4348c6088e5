// SPDX-License-Identifier: Apache-2.0
// What the renderer draws, by how many calls, and whether it looks as it should. Needs a display (xvfb-run).
#include <gtest/gtest.h>

#include <QFileInfo>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <cmath>
#include <map>
#include <numbers>

#include "app/style/theme.h"
#include "app/viewport/drawing/frame_colors.h"
#include "app/viewport/drawing/item_batches.h"
#include "app/viewport/drawing/scene_renderer.h"
#include "app/viewport/meshes/posed_mesh.h"
#include "geometry/shapes/shapes.h"
#include "tests/app/pages/picture_compare.h"
#include "tests/support/test_data.h"

namespace hapticell::app {
namespace {

using Mesh = std::shared_ptr<const geometry::TriangleMesh>;

Mesh shared(geometry::TriangleMesh mesh) {
  return std::make_shared<const geometry::TriangleMesh>(std::move(mesh));
}

/// The place of the i-th of things that lie in rows along x, `step` m from each other.
dvec3 inRows(int i, int in_a_row, double step, const dvec3& first) {
  const int row = i / in_a_row, column = i % in_a_row;
  return first + step * dvec3(column, row, 0.0);
}

class ScenePicture : public testing::Test {
 protected:
  void SetUp() override {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    context_.setFormat(format);
    surface_.setFormat(format);
    surface_.create();
    ASSERT_TRUE(context_.create() && context_.makeCurrent(&surface_) && gl_.initializeOpenGLFunctions());
    renderer_ = std::make_unique<SceneRenderer>(gl_, [] {});
    frame_.width = 320;
    frame_.height = 200;
    frame_.colors = frameColors(darkTheme());
    frame_.refine = true;
  }
  void TearDown() override {
    renderer_.reset();
    context_.doneCurrent();
  }

  void add(const Mesh& mesh, const dvec3& p_W, std::array<float, 3> color = {0.6f, 0.62f, 0.65f}) {
    RenderItem item;
    item.mesh = mesh;
    item.bounds_M = mesh->bounds();
    item.X_WM = Pose::translation(p_W);
    item.color = color;
    item.entity = frame_.items.size() + 1;
    const geometry::Bounds bounds = geometry::transformed(item.X_WM, item.bounds_M);
    frame_.bounds_W.add(bounds.min);
    frame_.bounds_W.add(bounds.max);
    frame_.items.push_back(item);
  }

  QImage draw(int samples) {
    QOpenGLFramebufferObject target(frame_.width, frame_.height);
    frame_.sample = 0;
    renderer_->draw(frame_);
    renderer_->waitForParts();
    for (frame_.sample = 0; frame_.sample < samples; ++frame_.sample) renderer_->render(frame_, target.handle());
    return target.toImage().convertToFormat(QImage::Format_RGB32);
  }

  QOffscreenSurface surface_;
  QOpenGLContext context_;
  Gl gl_;
  std::unique_ptr<SceneRenderer> renderer_;
  Frame frame_;
};

TEST_F(ScenePicture, PartsOfOneMeshAreOneCallAndLookAsIfDrawnOneByOne) {
  const geometry::TriangleMesh bolt = geometry::makeCylinder(0.04, 0.2, 24);
  const Mesh one = shared(bolt);
  frame_.edges = false;
  for (int i = 0; i < 300; ++i) add(one, inRows(i, 20, 0.12, {-1.2, -0.9, 0.1}));
  frame_.camera = frame_.camera.fitted(frame_.bounds_W, {320, 200});
  const QImage together = draw(2);
  EXPECT_EQ(renderer_->lastCount().calls, 2u) << "the shadows and the faces";
  EXPECT_EQ(renderer_->lastCount().instances, 600u);
  for (RenderItem& item : frame_.items) item.mesh = shared(bolt);
  const QImage apart = draw(2);
  EXPECT_EQ(renderer_->lastCount().calls, 600u);
  EXPECT_LT(test::meanSquareError(together, apart), 1e-6);
}

/// However few triangles a frame may have: no part is off by more than the most, boxes are smaller than 6 pixels, and
/// what is held or near it has the triangles of the picture at rest.
TEST_F(ScenePicture, ShedTrianglesKeepShapesAndBoxesAreSmall) {
  const Mesh ball = shared(geometry::makeSphere(0.1, 60));
  const Mesh small = shared(geometry::makeSphere(0.004, 40));
  for (int i = 0; i < 40; ++i) add(ball, inRows(i, 8, 0.3, {-1.2, -0.6, 0.1}));
  for (int i = 0; i < 40; ++i) add(small, inRows(i, 8, 0.3, {-1.05, -0.45, 0.1}));
  for (const std::size_t held : {std::size_t{3}, std::size_t{17}, std::size_t{50}})
    frame_.items[held].keeps_shape = true;
  frame_.camera = frame_.camera.fitted(frame_.bounds_W, {320, 200});
  GpuMeshCache meshes(gl_, [] {});
  const ViewSize size{320.0, 200.0};
  const glm::dmat4 clip_from_world = frame_.camera.projectionMatrix(size, frame_.bounds_W) * frame_.camera.viewMatrix();
  const auto batches = [&](DetailLevel level, std::size_t most) {
    frame_.detail = level;
    frame_.most_triangles = most;
    return batchesOf(frame_, clip_from_world, ItemKind::kPlain, meshes);
  };
  batches(DetailLevel::kFull, 1);
  meshes.wait();
  std::map<std::uint32_t, std::size_t> at_rest;
  for (const ItemBatch& batch : batches(DetailLevel::kFull, ~std::size_t{0}))
    for (const std::uint32_t item : batch.items) at_rest[item] = batch.step;
  std::size_t boxes = 0, coarser = 0;
  for (const DetailLevel level : {DetailLevel::kFull, DetailLevel::kNoEdges, DetailLevel::kCoarse}) {
    for (const ItemBatch& batch : batches(level, 1)) {
      for (const std::uint32_t index : batch.items) {
        const RenderItem& item = frame_.items[index];
        const dvec3 middle = item.X_WM.p;
        const double pixel = frame_.camera.metresPerPixel(middle, size);
        if (item.keeps_shape) {
          EXPECT_FALSE(batch.box);
          EXPECT_EQ(batch.step, at_rest[index]);
        } else if (batch.box) {
          ++boxes;
          EXPECT_LT(item.bounds_M.size().x / pixel, kBoxPixels);
        } else {
          coarser += batch.step > at_rest[index] ? 1 : 0;
          EXPECT_LE(batch.mesh->steps()[batch.step].error / pixel, kMostPixels);
        }
      }
    }
    EXPECT_LE(meshes.counted().pixels_off, kMostPixels);
  }
  EXPECT_GT(boxes, 60u);
  EXPECT_GT(coarser, 60u);
}

TEST_F(ScenePicture, OcclusionLeavesNoLinesOverASmoothSurface) {
  frame_.width = 1600;
  frame_.height = 900;
  frame_.edges = false;
  const auto sphere = std::make_shared<PosedMesh>();
  static_cast<geometry::TriangleMesh&>(*sphere) = geometry::makeSphere(1.0, 120);
  for (const auto& vertex : sphere->vertices) sphere->normals.emplace_back(glm::normalize(dvec3(vertex)));
  PosedMesh::Step whole;
  for (const auto& triangle : sphere->triangles)
    whole.indices.insert(whole.indices.end(), {triangle[0], triangle[1], triangle[2]});
  sphere->steps = std::make_shared<const std::vector<PosedMesh::Step>>(1, whole);
  add(sphere, {0.0, 0.0, 1.0});
  frame_.items.front().smooth = true;
  frame_.items.front().casts_shadow = false;
  frame_.camera = frame_.camera.fitted(frame_.bounds_W, {1600, 900});
  const QImage picture = draw(4);
  const auto meanOfRow = [&](int y) {
    double sum = 0.0;
    for (int x = 780; x < 880; ++x) sum += qGray(picture.pixel(x, y));
    return sum / 100.0;
  };
  for (int y = 130; y < 300; ++y)  // The sphere's upper side, where only light falls.
    EXPECT_NEAR(meanOfRow(y), 0.5 * (meanOfRow(y - 2) + meanOfRow(y + 2)), 0.7) << y;
}

TEST_F(ScenePicture, DrawnInPiecesItIsTheSame) {
  const Mesh bolt = shared(geometry::makeCylinder(0.04, 0.3, 48));
  for (int i = 0; i < 40; ++i) add(bolt, inRows(i, 8, 0.15, {-0.5, -0.3, 0.3}));
  add(shared(geometry::makeSphere(0.3, 60)), {0, 0, 0.8});
  frame_.items[7].state = kContact;
  frame_.items[9].state = kSelected;
  frame_.camera = frame_.camera.fitted(frame_.bounds_W, {320, 200});
  const QImage whole = draw(3);
  const auto below = renderer_->pick(160, 100);
  QOpenGLFramebufferObject target(frame_.width, frame_.height);
  int pieces = 0;
  const auto refine = [&](bool shadows) {
    // No time at all: each piece is one call.
    do {
      ASSERT_LT(++pieces, 10000);
    } while (!renderer_->drawPiece(frame_, shadows, 0.0).whole);
  };
  frame_.bands = 3;
  // A round that does not count, so that occlusion finds neighbours beyond the band; then three samples.
  for (int round = -1; round < 3; ++round) {
    frame_.sample = std::max(round, 0);
    if (round != 0) refine(true);
    for (frame_.band = 0; frame_.band < frame_.bands; ++frame_.band) refine(false);
  }
  EXPECT_GT(pieces, 100);
  renderer_->present(frame_.width, frame_.height, target.handle());
  const QImage in_pieces = target.toImage().convertToFormat(QImage::Format_RGB32);
  EXPECT_LT(test::meanSquareError(whole, in_pieces), 1e-5);
  const auto picked = renderer_->pick(160, 100);
  ASSERT_TRUE(below && picked);
  EXPECT_EQ(picked->entity, below->entity);
  EXPECT_NEAR(glm::distance(picked->p_WQ, below->p_WQ), 0.0, 1e-3);
  // What was begun and then overtaken leaves no trace, and what is picked is always a whole picture.
  frame_.sample = frame_.band = 0;
  frame_.bands = 1;
  renderer_->drawPiece(frame_, false, 0.0);
  EXPECT_EQ(renderer_->pick(160, 100)->entity, below->entity);
  EXPECT_LT(test::meanSquareError(whole, draw(3)), 1e-9);
}

TEST_F(ScenePicture, TooManyTrianglesMakeTheSmallestPartsBoxes) {
  frame_.edges = false;
  frame_.refine = false;
  frame_.detail = DetailLevel::kCoarse;
  for (int i = 0; i < 40; ++i) add(shared(geometry::makeSphere(0.008, 40)), inRows(i, 8, 0.1, {-0.4, 0.0, 0.1}));
  add(shared(geometry::makeSphere(0.4, 60)), {0, 0, 0.8}, {0.9f, 0.3f, 0.1f});
  frame_.camera = frame_.camera.fitted(frame_.bounds_W, {320, 200});
  const QImage whole = draw(1);
  const std::size_t all = renderer_->lastCount().triangles;
  frame_.most_triangles = all / 3;
  const QImage fewer = draw(1);
  EXPECT_LE(renderer_->lastCount().triangles, all / 3);
  EXPECT_EQ(renderer_->lastCount().instances, 41u) << "none is left out";
  EXPECT_LT(test::meanSquareError(whole, fewer), 2e-3);
  frame_.most_triangles = 1;
  draw(1);
  EXPECT_LT(renderer_->lastCount().triangles, all / 4);
  EXPECT_EQ(renderer_->lastCount().instances, 41u);
  EXPECT_EQ(renderer_->lastCount().calls, 2u) << "all boxes at once; the large one keeps its shape";
  const auto picked = renderer_->pick(160, 100);
  EXPECT_TRUE(picked) << "a box is picked as its part is";
}

TEST_F(ScenePicture, FarPartsHaveFewTrianglesAndLookTheSame) {
  frame_.edges = false;
  add(shared(geometry::makeSphere(0.5, 300)), {0, 0, 0.5});
  frame_.camera.target_W = {0, 0, 0.5};
  frame_.camera.distance = 8.0;
  const QImage picture = draw(4);
  const std::size_t whole = frame_.items[0].mesh->triangles.size();
  EXPECT_LT(renderer_->lastCount().triangles, whole / 2) << "faces and shadow";
  const auto few = shared(geometry::makeSphere(0.5, 64));
  frame_.items[0].mesh = few;
  EXPECT_LT(test::meanSquareError(picture, draw(4)), 1e-4);
}

TEST_F(ScenePicture, ShedDetailStillShowsWhatStandsBehindAFence) {
  geometry::TriangleMesh fence;
  for (int i = 0; i < 600; ++i) {
    const geometry::TriangleMesh bar = geometry::makeBox({0.002, 0.002, 2.0});
    const auto first = static_cast<std::uint32_t>(fence.vertices.size());
    for (const dvec3& p : bar.vertices) fence.vertices.push_back(p + dvec3(0.01 * i - 3.0, -1.0, 1.0));
    for (const auto& t : bar.triangles) fence.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  add(shared(geometry::makeSphere(0.5, 40)), {0, 0, 1.0}, {0.9f, 0.3f, 0.1f});
  add(shared(fence), {0, 0, 0});
  frame_.camera.azimuth = 0.0;
  frame_.camera.elevation = 0.1;
  frame_.camera.target_W = {0, 0, 1};
  frame_.camera.distance = 3.0;
  frame_.refine = false;
  frame_.detail = DetailLevel::kCoarse;
  const QImage picture = draw(1);
  int orange = 0;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 320; ++x) orange += qRed(picture.pixel(x, y)) > 2 * qBlue(picture.pixel(x, y)) ? 1 : 0;
  EXPECT_GT(orange, 1500) << "a box in its place would hide the ball";
}

TEST_F(ScenePicture, AFenceAboutTheEyeNeverHidesTheCellHoweverFewTrianglesAreLeft) {
  geometry::TriangleMesh fence;
  for (int i = 0; i < 40; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 40;
    geometry::TriangleMesh post = geometry::makeCylinder(0.01, 2.0, 8);
    const auto first = static_cast<std::uint32_t>(fence.vertices.size());
    for (const dvec3& p : post.vertices)
      fence.vertices.push_back(p + dvec3(3.0 * std::cos(angle), 3.0 * std::sin(angle), 0.5));
    for (auto triangle : post.triangles) {
      for (auto& corner : triangle) corner += first;
      fence.triangles.push_back(triangle);
    }
  }
  add(shared(geometry::makeBox(dvec3(0.5))), {0.0, 0.0, 0.25}, {0.1f, 0.9f, 0.1f});
  frame_.camera = frame_.camera.fitted(frame_.bounds_W, {320, 200});
  add(shared(fence), {0.0, 0.0, 0.0}, {0.5f, 0.5f, 0.5f});
  ASSERT_LT(glm::length(frame_.camera.eye_W()), 3.0) << "the eye stands within the fence";
  frame_.detail = DetailLevel::kPlain;
  frame_.edges = false;
  frame_.most_triangles = 1;
  const QColor middle = draw(1).pixelColor(160, 100);
  EXPECT_GT(middle.green(), middle.red() + 30) << "the box in the middle is seen";
}

TEST_F(ScenePicture, FacesThatTheLightGrazesHaveNoStripes) {
  frame_.edges = false;
  frame_.floor = false;
  const dvec3 light = keyLightDirection_W();
  // A wall whose face turns a few degrees towards the light, looked at along its normal from a little above.
  for (const double turn : {0.04, 0.1, 0.2}) {
    frame_.items.clear();
    add(shared(geometry::makeBox({2.0, 0.1, 2.0})), {0, 0, 1.0});
    const double along = std::atan2(light.y, light.x) + 0.5 * std::numbers::pi - turn;  // Of the face's normal.
    frame_.items[0].X_WM.q = glm::angleAxis(along + 0.5 * std::numbers::pi, dvec3(0, 0, 1));
    frame_.camera.azimuth = along + 0.5 * std::numbers::pi;
    frame_.camera.elevation = 0.2;
    frame_.camera.target_W = {0, 0, 1};
    frame_.camera.distance = 5.0;
    const QImage picture = draw(8);
    double low = 255.0, high = 0.0;
    for (int y = 70; y < 130; ++y)
      for (int x = 120; x < 200; ++x) {
        low = std::min<double>(low, qGray(picture.pixel(x, y)));
        high = std::max<double>(high, qGray(picture.pixel(x, y)));
      }
    EXPECT_LT(high - low, 6.0) << turn;
  }
}

TEST_F(ScenePicture, LooksAsItDid) {
  add(shared(geometry::makeBox({0.6, 0.4, 0.3})), {0, 0, 0.15});
  add(shared(geometry::makeCylinder(0.15, 0.6, 48)), {0.6, 0.1, 0.3}, {0.55f, 0.6f, 0.7f});
  add(shared(geometry::makeSphere(0.2, 32)), {-0.5, -0.2, 0.2}, {0.7f, 0.6f, 0.55f});
  frame_.camera.azimuth = 0.5;
  frame_.camera = frame_.camera.fitted(frame_.bounds_W, {320, 200});
  const auto name = [](const char* stem) {
    return hapticell::test::sourceFile(std::string("tests/app/pictures/") + stem + ".png").string();
  };
  test::expectPicture(draw(SceneRenderer::kSamples), name("parts-dark"));
  frame_.items[0].state = kSelected;
  frame_.items[1].state = kContact;
  frame_.items[2].state = kNearMiss;
  test::expectPicture(draw(SceneRenderer::kSamples), name("states-dark"));
  frame_.colors = frameColors(lightTheme());
  test::expectPicture(draw(SceneRenderer::kSamples), name("states-light"));
  for (RenderItem& item : frame_.items) item.state = kPlain;
  frame_.section = SectionPlane{dvec3(0, -1, 0), 0.05};
  test::expectPicture(draw(SceneRenderer::kSamples), name("section-light"));
}

}  // namespace
}  // namespace hapticell::app
