// SPDX-License-Identifier: Apache-2.0
// How long a frame takes against the number of triangles, at each level of detail: frame_bench [WIDTHxHEIGHT]
//
// The cell is a grid of different parts (bumpy spheres of 20 000 triangles each), all of it in the picture. Of each
// level the median of five frames with a turning eye, every one waited for; then what the governor chooses for a budget
// of 55 ms and how long its frames take; and the longest piece of a picture at rest, of its second sample.
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

#include "app/style/theme.h"
#include "app/viewport/drawing/detail_level.h"
#include "app/viewport/drawing/frame_colors.h"
#include "app/viewport/widget/rest_picture.h"
#include "app/viewport/drawing/scene_renderer.h"
#include "geometry/shapes/shapes.h"

namespace {

using namespace hapticell;
using namespace hapticell::app;
using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// A sphere of about 20 000 triangles, another one for each number.
std::shared_ptr<const geometry::TriangleMesh> bumpy(int number) {
  geometry::TriangleMesh mesh = geometry::makeSphere(0.1, 142);
  for (dvec3& p : mesh.vertices)
    p *= 1.0 + 0.05 * std::sin(30.0 * p.x + number) * std::cos(35.0 * p.y) * std::sin(25.0 * p.z + 0.3 * number);
  return std::make_shared<const geometry::TriangleMesh>(std::move(mesh));
}

void addParts(Frame& frame, std::size_t triangles) {
  std::size_t there = 0;
  const int side = std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(triangles) / 20000.0))));
  for (int number = 0; there < triangles; ++number) {
    RenderItem item;
    item.mesh = bumpy(number);
    item.bounds_M = item.mesh->bounds();
    const int column = number % side;
    const int row = number / side;
    item.X_WM = Pose::translation({0.25 * column, 0.25 * row, 0.1});
    item.color = {0.6f, 0.62f, 0.65f};
    item.entity = frame.items.size() + 1;
    const geometry::Bounds bounds = geometry::transformed(item.X_WM, item.bounds_M);
    frame.bounds_W.add(bounds.min);
    frame.bounds_W.add(bounds.max);
    there += item.mesh->triangles.size();
    frame.items.push_back(std::move(item));
  }
}

class Bench {
 public:
  Bench(Gl& gl, int width, int height) : gl_(gl), renderer_(gl, [] {}), target_(width, height) {
    frame_.width = width;
    frame_.height = height;
    frame_.colors = frameColors(darkTheme());
  }
  void run(std::size_t triangles) {
    frame_.items.clear();
    frame_.most_triangles = static_cast<std::size_t>(-1);
    frame_.bounds_W = {};
    addParts(frame_, triangles);
    frame_.camera = Camera().turnedTo(StandardView::kIsometric);
    frame_.camera = frame_.camera.fitted(frame_.bounds_W, {double(frame_.width), double(frame_.height)});
    frame_.detail = DetailLevel::kFull;
    renderer_.draw(frame_);
    renderer_.waitForParts();
    std::printf("%9zu", triangles);
    for (int level = 0; level <= static_cast<int>(DetailLevel::kCoarse); ++level) {
      frame_.detail = static_cast<DetailLevel>(level);
      std::printf(" %8.1f", median(5));
    }
    DetailGovernor governor(0.055, DetailLevel::kHalfSize);
    double took = 0.0;
    for (int i = 0; i < 24; ++i) {
      frame_.detail = governor.level();
      frame_.most_triangles = governor.mostTriangles();
      took = once();
      governor.frameTook(0.001 * took, renderer_.lastCount().triangles);
    }
    frame_.detail = governor.level();
    frame_.most_triangles = governor.mostTriangles();
    std::printf("   %d %8.1f %9zu", static_cast<int>(governor.level()), median(5), renderer_.lastCount().triangles);
    std::printf(" %8.1f\n", piece());
    std::fflush(stdout);
  }

 private:
  double once() {
    frame_.camera.azimuth += 0.01;
    const auto start = Clock::now();
    renderer_.render(frame_, target_.handle());
    gl_.glFinish();
    return since(start);
  }
  double median(int count) {
    once();
    std::vector<double> times;
    for (int i = 0; i < count; ++i) times.push_back(once());
    std::nth_element(times.begin(), times.begin() + count / 2, times.end());
    return times[static_cast<std::size_t>(count / 2)];
  }
  /// The longest piece of one sample of the picture at rest, as the window draws it.
  double piece() {
    Frame frame = frame_;
    frame.detail = DetailLevel::kFull;
    frame.most_triangles = static_cast<std::size_t>(-1);
    frame.refine = true;
    RestPicture rest(2, 0.03);
    rest.begin();
    double longest = 0.0;
    while (!rest.isFinished()) {
      const RestPicture::Piece piece = rest.next();
      frame.sample = piece.sample;
      frame.band = piece.band;
      frame.bands = piece.bands;
      const auto start = Clock::now();
      const auto done = renderer_.drawPiece(frame, piece.shadows, 0.015);
      gl_.glFinish();
      const double took = since(start);
      // The first round finds out what a call may hold.
      if (piece.sample > 0) longest = std::max(longest, took);
      rest.took({0.001 * took, done.whole, done.longest_least});
    }
    return longest;
  }
  Gl& gl_;
  SceneRenderer renderer_;
  QOpenGLFramebufferObject target_;
  Frame frame_;
};

}  // namespace

int main(int argc, char** argv) {
  QGuiApplication application(argc, argv);
  int width = 1600, height = 900;
  if (argc > 1 && std::sscanf(argv[1], "%dx%d", &width, &height) != 2) {
    std::fprintf(stderr, "frame_bench [WIDTHxHEIGHT]\n");
    return 2;
  }
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  QOffscreenSurface surface;
  surface.setFormat(format);
  surface.create();
  QOpenGLContext context;
  context.setFormat(format);
  Gl gl;
  if (!context.create() || !context.makeCurrent(&surface) || !gl.initializeOpenGLFunctions()) {
    std::fprintf(stderr, "No OpenGL 3.3 here; run it under xvfb-run.\n");
    return 2;
  }
  std::printf("%s, %d x %d, ms a frame\n", reinterpret_cast<const char*>(gl.glGetString(GL_RENDERER)), width, height);
  std::printf("triangles     full no occl.    plain no edges     half   coarse level  it takes   of them    piece\n");
  {
    Bench bench(gl, width, height);
    for (const std::size_t triangles : {20000u, 100000u, 500000u, 2000000u, 5000000u}) bench.run(triangles);
  }
  context.doneCurrent();
  return 0;
}
