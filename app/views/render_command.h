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

/// The options of `hapticell --render`.
struct RenderCommand {
  QString input;         ///< A workcell, or anything else that can be imported.
  QString output;        ///< A picture (png, jpg, bmp ...), or a video of a turn around the cell (mp4, webm, mkv, gif).
  QString view = "iso";  ///< See viewNamed(); "saved" is the view stored in the workcell.
  QSize size{1920, 1080};
  bool light = false;  ///< Theme: light, else dark.
  bool floor = true;
  double seconds = 8.0;  ///< Duration of a video: one full turn.
};

/// "front", "back", "right", "left", "top", "bottom", "iso"; empty for other words.
std::optional<StandardView> viewNamed(const QString& name);

/// Draws the picture and writes it completely or not at all. `diagnostics` lists what could not be shown. Errors:
/// unreadable files, unknown views, formats that cannot be written, a display without OpenGL 3.3.
Expected<void> render(const RenderCommand& command, Diagnostics& diagnostics);

/// A video of one turn around a scene, frame by frame, so that a window stays responsive in between.
class TurnVideo {
 public:
  static Expected<std::unique_ptr<TurnVideo>> begin(const RenderCommand& command, const SceneModel& scene,
                                                    const Camera& camera);
  ~TurnVideo();
  /// Draws the next frame; after the last one, isDone() is true and the file is complete.
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

/// Writes the picture or video of an existing scene, as `camera` sees it.
Expected<void> renderScene(const RenderCommand& command, const SceneModel& scene, const Camera& camera);

}  // namespace hapticell::app
