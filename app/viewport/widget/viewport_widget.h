// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QEvent>
#include <QImage>
#include <QOpenGLWidget>
#include <memory>
#include <optional>

#include "app/viewport/drawing/scene_renderer.h"
#include "app/viewport/overlay/overlay_painter.h"
#include "app/viewport/scene/scene_model.h"
#include "app/viewport/tools/feature_picker.h"
#include "app/viewport/tools/navigation.h"
#include "app/viewport/tools/pick_request.h"
#include "app/viewport/tools/tool_chain.h"
#include "app/viewport/widget/touch_meter.h"
#include "app/viewport/widget/turning_camera.h"

namespace hapticell::app {

class ScenePicks;
class ViewOverlay;
class ViewPicture;
class ViewPointer;

/// The scene in the window. How the mouse moves the camera is a Navigation; what it leaves free picks: a click one
/// entity, a drag all in a box. Tools (ToolChain) come before these. Its parts: ViewPicture draws, ViewOverlay paints
/// over it, ViewPointer serves the mouse, ScenePicks finds what lies under it. GUI thread only.
class ViewportWidget : public QOpenGLWidget {
  Q_OBJECT
 public:
  explicit ViewportWidget(QWidget* parent = nullptr);
  ~ViewportWidget() override;

  SceneModel& scene() { return scene_; }
  const Camera& camera() const { return camera_.now; }
  /// Turns to it within 250 ms, or at once.
  void setCamera(const Camera& camera, bool animated = true);
  void fit(const geometry::Bounds& bounds_W, bool animated = true);
  void fitAll(bool animated = true);
  void setStandardView(StandardView view);
  void setPerspective(bool on);
  void setEdges(bool on);
  /// Nothing: the picture is whole. While there is one, its handle can be dragged.
  void setSection(const std::optional<SectionPlane>& plane);
  const std::optional<SectionPlane>& section() const { return section_; }
  bool edges() const { return edges_; }
  void setMotion(bool on) { motion_ = on; }
  bool motion() const { return motion_; }
  void setNavigation(const Navigation& navigation);
  const Navigation& navigation() const;
  /// Null: no tool. The tool must outlive its being set.
  void setPointerTool(PointerTool* tool, ToolChain::Place place = ToolChain::kModule);
  /// The next click picks a face, an edge or a corner; see PickRequest. A pick that is still open is answered with
  /// nothing first.
  void startPick(PickRequest request);
  /// Ends an open pick without a result.
  void cancelPick();
  bool isPicking() const;
  /// The face, edge or corner at a place of the widget (pixels at 100 %), at once; nothing beside parts.
  std::optional<PickedFeature> featureAt(const QPointF& position, const FeatureFilter& filter = {});
  /// The nearest face, edge or corner at a place, looking through the entities of `without`: what a part that is
  /// dragged may snap to.
  std::optional<PickedFeature> featureNear(const QPointF& position, const std::vector<workcell::EntityId>& without,
                                           const FeatureFilter& filter = {});
  /// Entities in a box of the widget (pixels at 100 %): wholly inside, or, `touching`, those too that reach into it.
  std::vector<workcell::EntityId> entitiesIn(const QRectF& box, bool touching);
  /// Lines over the scene, kept by `owner` until it gives others (none: takes them away). Others are drawn without
  /// refresh().
  void setCurves(const std::string& owner, std::vector<SceneCurve> curves);
  /// All of them that are drawn, the section plane's and those of an open pick too.
  std::vector<SceneCurve> allCurves() const;
  /// Labels beside those of the snapshot, kept by `owner` until it gives others. Their keys must be their own: from
  /// 100.
  void setLabels(const std::string& owner, std::vector<OverlayLabel> labels);
  /// Another document follows: picks, curves, labels, strips and all of the scene that was made of this one are
  /// dropped. The section is the view's: its action ends it.
  void forgetCell();
  void setStrip(const StripContext& context);
  /// The text on a mannequin's task, in place of the stylus's strip; above it while forces are on. Empty: none.
  void setFigureStrip(std::vector<StripCell> cells);
  const std::vector<StripCell>& figureStrip() const;
  /// All labels that are to be seen, those of the snapshot first.
  std::vector<OverlayLabel> allLabels() const;
  /// Where labels, the force's number and the texts of curves were drawn last.
  const std::vector<PlacedLabel>& drawnLabels() const;
  void setViewStrip(std::vector<ViewStripCell> cells);
  const ViewStrip& viewStrip() const;
  /// What the pointer is over, as it is written beside it: "robot · link_3". Empty: nothing.
  const QString& hoverName() const;
  void setEmptyState(const std::optional<EmptyState>& state);
  /// The scene changed: says so where it did (sceneChanged()), and draws when Qt finds time.
  void refresh();
  /// The picture at rest is refined as far as it will be; from now on nothing is drawn until something changes. Sooner
  /// where a sample is dear (software rendering): a picture takes some seconds of work at the most.
  bool isFinished() const;
  /// The scene was drawn at this revision or a later one, and all its meshes are on the card.
  bool hasWhole(std::uint64_t revision) const;
  /// Redraws only if the strip or a label would change, so an idle cell costs nothing.
  void refreshNumbers();
  /// The scene as it is drawn now, so many pixels wide: for lists. Null where it is not shown.
  QImage smallPicture(int width);
  /// All samples of the picture, overlay included, as an image of the widget's size.
  QImage finishedPicture();
  /// Median seconds of `count` frames at each level of detail, every one waited for: what the machine can do.
  std::vector<double> measureFrames(int count);
  const FrameMeter& meter() const;
  double lastFrameSeconds() const { return meter().lastSeconds(); }
  DetailLevel detail() const;
  /// How long after they were felt the last contacts were on the screen.
  TouchMeter::Figures touchFigures() const;
  /// No graphics card: the picture is drawn by the processor.
  bool isSoftware() const;
  /// What moves is drawn with fewer pixels, or parts with visibly fewer triangles; the picture says so.
  bool isSimplified() const;

  // For its parts.
  ViewSize viewSize() const;
  QSize devicePixels() const;  ///< At least one each way.
  /// The scene as it is to be drawn now.
  Frame makeFrame() const;
  /// The camera turns, or labels glide.
  bool isUnderWay() const;
  /// The scene was drawn last at this revision.
  bool shows(std::uint64_t revision) const;
  /// Parts that are still being made ready for drawing.
  std::size_t missingParts() const;
  /// Of the clock of the view's pictures.
  double seconds() const;
  ViewCube viewCube() const;
  const ScenePicks& picks() const { return *picks_; }
  const ViewPointer& pointer() const { return *pointer_; }

 signals:
  /// A click on an entity, or on nothing (0).
  void picked(hapticell::workcell::EntityId entity, Qt::KeyboardModifiers modifiers);
  /// A drag over free space: what lies in the box.
  void boxed(const std::vector<hapticell::workcell::EntityId>& entities, Qt::KeyboardModifiers modifiers);
  void hovered(hapticell::workcell::EntityId entity);
  void contextMenuWanted(hapticell::workcell::EntityId entity, QPoint global);
  /// Where a point of the scene lies in the widget: another camera, or another size of the widget.
  void cameraChanged();
  /// Entities were added, moved, held, played or marked. If you provide curves or labels at an entity, provide them
  /// again here, so that they are in the same picture.
  void sceneChanged();
  /// By its handle.
  void sectionMoved();

 protected:
  void initializeGL() override;
  void paintGL() override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void advanceAnimation();

  SceneModel scene_;
  TurningCamera camera_;
  std::optional<SectionPlane> section_;
  bool edges_ = true, motion_ = true;
  std::uint64_t told_revision_ = 0;
  std::unique_ptr<ViewPicture> picture_;
  std::unique_ptr<ViewOverlay> overlay_;
  std::unique_ptr<ScenePicks> picks_;
  std::unique_ptr<ViewPointer> pointer_;
};

}  // namespace hapticell::app
