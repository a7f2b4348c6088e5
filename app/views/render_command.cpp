// SPDX-License-Identifier: Apache-2.0
#include "app/views/render_command.h"

#include <QFileInfo>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <numbers>

#include "app/kit/video_writer.h"
#include "app/kit/written_file.h"
#include "app/mannequin/figure_skins.h"
#include "app/viewport/drawing/picture_renderer.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"

namespace hapticell::app {
namespace {

// As European television has, as play_video.cpp.
constexpr int kFramesASecond = 25;
// Samples of a picture. Half: edges flicker; twice: twice the time.
constexpr int kVideoSamples = 6;

struct NamedView {
  const char* name;
  StandardView view;
};
constexpr std::array<NamedView, 7> kViews{{{"front", StandardView::kFront},
                                           {"back", StandardView::kBack},
                                           {"right", StandardView::kRight},
                                           {"left", StandardView::kLeft},
                                           {"top", StandardView::kTop},
                                           {"bottom", StandardView::kBottom},
                                           {"iso", StandardView::kIsometric}}};

QString knownViews() {
  QStringList names;
  for (const NamedView& known : kViews) names << known.name;
  return names.join(", ") + " or saved";
}

Expected<workcell::Document> readScene(const QString& input, Diagnostics& diagnostics) {
  if (input.endsWith(".hcell", Qt::CaseInsensitive)) {
    workcell::LoadOptions options;
    options.keep_unloaded = true;
    return workcell::loadDocument(input.toStdString(), diagnostics, options);
  }
  workcell::EntityLoader loader(".");
  auto read = loader.loadTree(input.toStdString(), {}, diagnostics);
  HAPTICELL_TRY(read);
  workcell::Document document;
  for (workcell::Entity& entity : read->entities) {
    auto added = document.execute(workcell::AddEntity{std::move(entity)});
    HAPTICELL_TRY(added);
  }
  return document;
}

Expected<Camera> cameraFor(const RenderCommand& command, const workcell::Document& document, const SceneModel& scene) {
  const ViewSize size{static_cast<double>(command.size.width()), static_cast<double>(command.size.height())};
  const Camera camera;
  if (command.view == "saved") {
    if (const auto& saved = document.state().view) return camera.looking(saved->p_WEye, saved->p_WTarget);
    return camera.turnedTo(StandardView::kIsometric).fitted(scene.corners_W(), size);
  }
  const auto view = viewNamed(command.view);
  if (!view) {
    return makeError(
        {.place = "--view", .found = "'" + command.view.toStdString() + "'", .expected = knownViews().toStdString()});
  }
  return camera.turnedTo(*view).fitted(scene.corners_W(), size);
}

}  // namespace

TurnVideo::TurnVideo(RenderCommand command, SceneModel scene, Camera camera, PictureRenderer renderer)
    : command_(std::move(command)),
      scene_(std::move(scene)),
      camera_(std::move(camera)),
      renderer_(std::move(renderer)),
      // Most formats of video want even sides.
      size_(command_.size.width() & ~1, command_.size.height() & ~1),
      count_(std::max(1, static_cast<int>(std::lround(command_.seconds * kFramesASecond)))) {}

TurnVideo::~TurnVideo() = default;

Expected<std::unique_ptr<TurnVideo>> TurnVideo::begin(const RenderCommand& command, const SceneModel& scene,
                                                      const Camera& camera) {
  auto renderer = PictureRenderer::make();
  HAPTICELL_TRY(renderer);
  std::unique_ptr<TurnVideo> video(new TurnVideo(command, scene, camera, std::move(*renderer)));
  auto writer = VideoWriter::open(command.output, video->size_, kFramesASecond);
  HAPTICELL_TRY(writer);
  video->writer_ = std::move(*writer);
  return video;
}

Expected<void> TurnVideo::step() {
  if (isDone()) return {};
  Camera turned = camera_;
  turned.azimuth += 2.0 * std::numbers::pi * done_ / count_;
  PictureRenderer::Look look;
  look.floor = command_.floor;
  look.samples = kVideoSamples;
  const auto added =
      writer_->add(renderer_.draw(scene_, turned, size_, command_.light ? lightTheme() : darkTheme(), look));
  if (!added) return added;
  return ++done_ < count_ ? Expected<void>() : writer_->finish();
}

Expected<void> renderScene(const RenderCommand& command, const SceneModel& scene, const Camera& camera) {
  if (VideoWriter::isVideo(command.output)) {
    auto video = TurnVideo::begin(command, scene, camera);
    HAPTICELL_TRY(video);
    while (!(*video)->isDone())
      if (auto stepped = (*video)->step(); !stepped) return stepped;
    return {};
  }
  auto renderer = PictureRenderer::make();
  HAPTICELL_TRY(renderer);
  PictureRenderer::Look look;
  look.floor = command.floor;
  return writePicture(renderer->draw(scene, camera, command.size, command.light ? lightTheme() : darkTheme(), look),
                      command.output);
}

std::optional<StandardView> viewNamed(const QString& name) {
  for (const NamedView& known : kViews)
    if (name == known.name) return known.view;
  return std::nullopt;
}

Expected<void> render(const RenderCommand& command, Diagnostics& diagnostics) {
  const auto document = readScene(command.input, diagnostics);
  HAPTICELL_TRY(document);
  SceneModel scene;
  scene.setEntities(document->snapshotEntities());
  for (const workcell::Entity& entity : scene.entities()) {
    if (!entity.figure() || !entity.visible) continue;
    scene.setSkin(entity, figureSkin(*entity.figure()));
  }
  const auto camera = cameraFor(command, *document, scene);
  HAPTICELL_TRY(camera);
  return renderScene(command, scene, *camera);
}

}  // namespace hapticell::app
