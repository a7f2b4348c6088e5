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

/// The scene in the window. A Navigation defines how the mouse moves the camera; buttons that it does not use select: a
/// click one entity, a drag all in a box. Tools (ToolChain) have priority. Its parts: ViewPicture draws, ViewOverlay
/// paints over it, ViewPointer serves the mouse, ScenePicks finds what is under it. GUI thread only.
class ViewportWidget : public QOpenGLWidget {
  Q_OBJECT
 public:
  explicit ViewportWidget(QWidget* parent = nullptr);
  ~ViewportWidget() override;

  SceneModel& scene() { return scene_; }
  const Camera& camera() const { return camera_.now; }
  /// Turns to this camera within 250 ms, or at once.
  void setCamera(const Camera& camera, bool animated = true);
  void fit(const geometry::Bounds& bounds_W, bool animated = true);
  void fitAll(bool animated = true);
  void setStandardView(StandardView view);
  void setPerspective(bool on);
  void setEdges(bool on);
  /// Empty: the picture is not cut. While there is a plane, its handle can be dragged.
  void setSection(const std::optional<SectionPlane>& plane);
  const std::optional<SectionPlane>& section() const { return section_; }
  bool edges() const { return edges_; }
  void setMotion(bool on) { motion_ = on; }
  bool motion() const { return motion_; }
  void setNavigation(const Navigation& navigation);
  const Navigation& navigation() const;
  /// Null: no tool. The tool must outlive the time it is set.
  void setPointerTool(PointerTool* tool, ToolChain::Place place = ToolChain::kModule);
  /// Lets the next click pick a face, an edge or a corner; see PickRequest. An open pick is first answered with an
  /// empty result.
  void startPick(PickRequest request);
  /// Ends an open pick without a result.
  void cancelPick();
  bool isPicking() const;
  /// The face, edge or corner at a position of the widget (pixels at 100 %), at once; empty outside of parts.
  std::optional<PickedFeature> featureAt(const QPointF& position, const FeatureFilter& filter = {});
  /// The nearest face, edge or corner at a position, looking through the entities of `without`: what a dragged part may
  /// snap to.
  std::optional<PickedFeature> featureNear(const QPointF& position, const std::vector<workcell::EntityId>& without,
                                           const FeatureFilter& filter = {});
  /// Entities in a box of the widget (pixels at 100 %): completely inside, or, with `touching`, also partly inside.
  std::vector<workcell::EntityId> entitiesIn(const QRectF& box, bool touching);
  /// Sets lines over the scene; `owner` keeps them until it sets others (empty: removes them). Changed lines are drawn
  /// without refresh().
  void setCurves(const std::string& owner, std::vector<SceneCurve> curves);
  /// All drawn lines, including those of the section plane and of an open pick.
  std::vector<SceneCurve> allCurves() const;
  /// Sets labels in addition to those of the snapshot; `owner` keeps them until it sets others. Their keys must be
  /// unique, from 100 on.
  void setLabels(const std::string& owner, std::vector<OverlayLabel> labels);
  /// Another document follows: drops picks, curves, labels, strips and everything in the scene that was made for this
  /// one. The section plane belongs to the view and stays until its action ends it.
  void forgetCell();
  void setStrip(const StripContext& context);
  /// Sets the text on a mannequin's task, in place of the stylus's strip; above it while forces are on. Empty: none.
  void setFigureStrip(std::vector<StripCell> cells);
  const std::vector<StripCell>& figureStrip() const;
  /// All labels to be shown, those of the snapshot first.
  std::vector<OverlayLabel> allLabels() const;
  /// Last drawn positions of labels, the force's number and the texts of curves.
  const std::vector<PlacedLabel>& drawnLabels() const;
  void setViewStrip(std::vector<ViewStripCell> cells);
  const ViewStrip& viewStrip() const;
  /// Name of what the pointer is over, as shown next to it: "robot · link_3". Empty: nothing.
  const QString& hoverName() const;
  void setEmptyState(const std::optional<EmptyState>& state);
  /// Checks whether the scene changed; if so, emits sceneChanged() and draws when Qt is ready.
  void refresh();
  /// True if the picture at rest is completely refined; nothing is drawn any more until something changes. With slow
  /// rendering (software) this is the case sooner: a picture takes at most some seconds of work.
  bool isFinished() const;
  /// True if the scene was drawn at this revision or a later one, with all its meshes uploaded.
  bool hasWhole(std::uint64_t revision) const;
  /// Redraws only if the strip or a label would change, so a cell at rest costs nothing.
  void refreshNumbers();
  /// The scene as drawn now, at a width in pixels: for lists. Null if it is not shown.
  QImage smallPicture(int width);
  /// All samples of the picture, overlay included, as an image of the widget's size.
  QImage finishedPicture();
  /// Median time of `count` frames at each level of detail, in seconds, each waited for: the speed of the machine.
  std::vector<double> measureFrames(int count);
  const FrameMeter& meter() const;
  double lastFrameSeconds() const { return meter().lastSeconds(); }
  DetailLevel detail() const;
  /// Delays from feeling to showing the last contacts.
  TouchMeter::Figures touchFigures() const;
  /// True without a graphics card: the processor draws the picture.
  bool isSoftware() const;
  /// True if the scene in motion has fewer pixels, or parts visibly fewer triangles; the picture says so.
  bool isSimplified() const;

  // For its parts.
  ViewSize viewSize() const;
  QSize devicePixels() const;  ///< At least one in each direction.
  /// The scene to be drawn now.
  Frame makeFrame() const;
  /// True while the camera turns, or labels move.
  bool isUnderWay() const;
  /// True if the last drawn scene has this revision.
  bool shows(std::uint64_t revision) const;
  /// Number of parts that are still being prepared for drawing.
  std::size_t missingParts() const;
  /// Present time of the clock of the view's pictures.
  double seconds() const;
  ViewCube viewCube() const;
  const ScenePicks& picks() const { return *picks_; }
  const ViewPointer& pointer() const { return *pointer_; }

 signals:
  /// A click on an entity, or on nothing (0).
  void picked(hapticell::workcell::EntityId entity, Qt::KeyboardModifiers modifiers);
  /// A drag over free space selected what is in the box.
  void boxed(const std::vector<hapticell::workcell::EntityId>& entities, Qt::KeyboardModifiers modifiers);
  void hovered(hapticell::workcell::EntityId entity);
  void contextMenuWanted(hapticell::workcell::EntityId entity, QPoint global);
  /// The mapping from scene to widget changed: another camera, or another size of the widget.
  void cameraChanged();
  /// Entities were added, moved, held, played or marked. If you provide curves or labels at an entity, provide them
  /// again here, so that they are in the same picture.
  void sceneChanged();
  /// Moved by its handle.
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
