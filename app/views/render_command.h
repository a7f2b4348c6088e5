// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSize>
#include <QString>
#include <memory>
#include <optional>

#include "app/viewport/scene/camera.h"
#include "app/viewport/drawing/picture_renderer.h"
#include "app/viewport/scene/scene_model.h"
#include "geometry/system/error.h"

namespace hapticell::app {

class VideoWriter;

/// What `hapticell --render` was asked for.
struct RenderCommand {
  QString input;         ///< A workcell, or anything else that can be imported.
  QString output;        ///< A picture (png, jpg, bmp ...), or a video of a turn round the cell (mp4, webm, mkv, gif).
  QString view = "iso";  ///< See viewNamed(); "saved" is the view that the workcell keeps.
  QSize size{1920, 1080};
  bool light = false;  ///< Theme.
  bool floor = true;
  double seconds = 8.0;  ///< Of a video: one whole turn.
};

/// "front", "back", "right", "left", "top", "bottom", "iso"; nothing for other words.
std::optional<StandardView> viewNamed(const QString& name);

/// Draws the picture and writes it whole or not at all. `diagnostics` lists what could not be shown. Refused:
/// files that cannot be read, views that are not known, formats that cannot be written, a display without OpenGL 3.3.
Expected<void> render(const RenderCommand& command, Diagnostics& diagnostics);

/// A video of one turn round a scene, picture by picture, so that a window goes on between them.
class TurnVideo {
 public:
  static Expected<std::unique_ptr<TurnVideo>> begin(const RenderCommand& command, const SceneModel& scene,
                                                    const Camera& camera);
  ~TurnVideo();
  /// The next picture; after the last one isDone(), and the file is there.
  Expected<void> step();
  bool isDone() const { return done_ >= count_; }
  double share() const { return static_cast<double>(done_) / count_; }

 private:
  TurnVideo(RenderCommand command, SceneModel scene, Camera camera, PictureRenderer renderer);
  RenderCommand command_;
  SceneModel scene_;
  Camera camera_;
  PictureRenderer renderer_;
  std::unique_ptr<VideoWriter> writer_;
  QSize size_;
  int count_ = 1, done_ = 0;
};

/// The picture or video of a scene that is there already, as `camera` sees it.
Expected<void> renderScene(const RenderCommand& command, const SceneModel& scene, const Camera& camera);

}  // namespace hapticell::app
