// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QEvent>
#include <QImage>
#include <QOpenGLWidget>
#include <QTimer>
#include <map>
#include <memory>
#include <optional>

#include "app/viewport/tools/feature_picker.h"
#include "app/viewport/tools/navigation.h"
#include "app/viewport/overlay/overlay_painter.h"
#include "app/viewport/tools/pick_request.h"
#include "app/viewport/widget/rest_picture.h"
#include "app/viewport/scene/scene_model.h"
#include "app/viewport/drawing/scene_renderer.h"
#include "app/viewport/tools/tool_chain.h"
#include "app/viewport/widget/touch_meter.h"

namespace hapticell::app {

/// The scene in the window. How the mouse moves the camera is a Navigation; what it leaves free picks: a click one
/// entity, a drag all in a box. Tools (ToolChain) come before these. GUI thread only.
class ViewportWidget : public QOpenGLWidget {
  Q_OBJECT
 public:
  explicit ViewportWidget(QWidget* parent = nullptr);
  ~ViewportWidget() override;

  SceneModel& scene() { return scene_; }
  const Camera& camera() const { return camera_; }
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
  void setNavigation(const Navigation& navigation) { navigation_ = navigation; }
  const Navigation& navigation() const { return navigation_; }
  /// Null: no tool. The tool must outlive its being set.
  void setPointerTool(PointerTool* tool, ToolChain::Place place = ToolChain::kModule);
  /// The next click picks a face, an edge or a corner; see PickRequest. A pick that is still open is answered with
  /// nothing first.
  void startPick(PickRequest request);
  /// Answers the open pick with nothing; nothing where there is none.
  void cancelPick();
  bool isPicking() const { return pick_.has_value(); }
  /// The face, edge or corner at a place of the widget (pixels at 100 %), at once; nothing beside parts.
  std::optional<PickedFeature> featureAt(const QPointF& position, const FeatureFilter& filter = {});
  /// The nearest face, edge or corner at a place, looking through the entities of `without`: what a part that is
  /// dragged may snap to.
  std::optional<PickedFeature> featureBeside(const QPointF& position, const std::vector<workcell::EntityId>& without,
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
  void setStrip(const StripContext& context) { strip_ = context; }
  /// What a figure's work is told by, in place of the stylus's strip; above it while forces are on. Empty: none.
  void setFigureStrip(std::vector<StripCell> cells);
  const std::vector<StripCell>& figureStrip() const { return figure_strip_; }
  /// All labels that are to be seen, those of the snapshot first.
  std::vector<OverlayLabel> allLabels() const;
  /// Where labels, the force's number and the texts of curves were drawn last.
  const std::vector<PlacedLabel>& drawnLabels() const { return drawn_labels_; }
  void setViewStrip(std::vector<ViewStripCell> cells);
  const ViewStrip& viewStrip() const { return view_strip_; }
  /// What the pointer is over, as it is written beside it: "robot · link_3". Empty: nothing.
  const QString& hoverName() const { return hover_name_; }
  void setEmptyState(const std::optional<EmptyState>& state) { empty_ = state; }
  /// The scene changed: says so where it did (sceneChanged()), and draws when Qt finds time.
  void refresh();
  /// The picture at rest is refined as far as it will be; from now on nothing is drawn until something changes. Sooner
  /// where a sample is dear (software rendering): a picture takes some seconds of work at the most.
  bool isFinished() const;
  /// The scene was drawn at this revision or a later one, and all its meshes are on the card.
  bool hasWhole(std::uint64_t revision) const;
  /// Draws anew only where the strip or a label would say something else than is drawn: a cell at rest costs nothing.
  void refreshNumbers();
  /// The scene as it is drawn now, so many pixels wide: for lists. Null where it is not shown.
  QImage smallPicture(int width);
  /// All samples of the picture, overlay included, as an image of the widget's size.
  QImage finishedPicture();
  /// Median seconds of `count` frames at each level of detail, every one waited for: what the machine can do.
  std::vector<double> measureFrames(int count);
  const FrameMeter& meter() const { return meter_; }
  double lastFrameSeconds() const { return meter_.lastSeconds(); }
  DetailLevel detail() const { return governor_.level(); }
  /// How long after they were felt the last contacts were on the screen.
  TouchMeter::Figures touchFigures() const { return touch_.figures(); }
  /// No graphics card: the picture is drawn by the processor.
  bool isSoftware() const { return software_; }
  /// What moves is drawn with fewer pixels, or parts with visibly fewer triangles; the picture says so.
  bool isSimplified() const { return simplified_; }

 signals:
  /// A click on an entity, or on nothing (0).
  void picked(hapticell::workcell::EntityId entity, Qt::KeyboardModifiers modifiers);
  /// A drag over free space: what lies in the box.
  void boxed(const std::vector<hapticell::workcell::EntityId>& entities, Qt::KeyboardModifiers modifiers);
  void hovered(hapticell::workcell::EntityId entity);
  void contextMenuWanted(hapticell::workcell::EntityId entity, QPoint global);
  /// Where a point of the scene lies in the widget: another camera, or another size of the widget.
  void cameraChanged();
  /// Entities were added, moved, held, played or marked. Who gives curves or labels that lie at an entity gives them
  /// anew, so that they are in the same picture.
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
  ViewSize viewSize() const;
  QSize devicePixels() const;  ///< At least one each way.
  Frame makeFrame() const;
  void drawFrame();
  void drawMoving(double now);
  bool hasMoved() const;
  void showNewPart();
  bool touchMatters() const;
  void refineStep();
  bool refine(double now);  ///< One piece of the picture at rest; true at the end of a sample.
  void paintOverlayImage();
  KeptFree keptFree(const Overlay& overlay) const;
  std::vector<PlacedLabel> placeLabels(const Overlay& overlay, const KeptFree& kept);
  Overlay makeOverlay();
  /// What the strip and the labels say of the snapshot, to be compared with what is drawn.
  std::vector<StripCell> spokenNumbers() const;
  PointerEvent eventFrom(const QMouseEvent& event) const;
  std::optional<PickedPoint> pickAt(const QPointF& position);
  dvec3 pointUnder(const QPointF& position);
  void advanceAnimation();
  void hover(const QPointF& position);
  void answerPick(const std::optional<PickedFeature>& feature);
  bool pressWhilePicking(const QMouseEvent& event);
  void pressFree(const QMouseEvent& event, bool over_cube);
  void setMotionFor(Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers, bool after_release);
  void moveCamera(const glm::dvec2& step);
  void releaseClick(const QMouseEvent& event, bool over_cube);
  bool wheelOfTouchpad(const QWheelEvent& event);
  bool isMovingCamera() const { return drag_ == Drag::kOrbit || drag_ == Drag::kPan || drag_ == Drag::kZoom; }
  Strips strips() const;
  bool pressViewStrip(const QMouseEvent& event);
  ViewCube viewCube() const;
  workcell::EntityId entityAt(const QPointF& position);

  Gl gl_;
  std::unique_ptr<SceneRenderer> renderer_;
  SceneModel scene_;
  Camera camera_;
  struct Turn {
    Camera from, to;
    QElapsedTimer clock;
    bool active = false;
  } turn_;
  /// What a frame may take: for the window's 10 Hz; and while contacts can be felt, so that they are seen within 50 ms:
  /// one frame may be on its way when it comes, the next one shows it, and the window puts each together.
  static constexpr double kFrameSeconds = 0.055, kTouchFrameSeconds = 0.018;
  DetailGovernor governor_{kFrameSeconds, DetailLevel::kHalfSize};  ///< The first picture must not wait either.
  static constexpr double kPieceSeconds = 0.03;                     ///< Of a picture at rest.
  RestPicture rest_{SceneRenderer::kSamples, kPieceSeconds};
  FrameMeter meter_;
  TouchMeter touch_;
  bool software_ = false, simplified_ = false;
  QElapsedTimer clock_;
  LabelLayout label_layout_;
  QImage overlay_image_;  ///< What is painted over the scene; only its pieces of now are valid.
  double last_overlay_s_ = 0.0;
  std::uint64_t drawn_revision_ = 0, told_revision_ = 0;
  Camera drawn_camera_;
  std::vector<StripCell> drawn_numbers_;
  std::vector<PlacedLabel> drawn_labels_;
  QSize drawn_pixels_;
  bool dirty_ = true;  ///< Theme or what is shown of the scene changed, or a part came.
  double last_motion_s_ = 0.0;
  QTimer refine_;
  ToolChain tools_;
  bool tool_active_ = false;
  StripContext strip_;
  FeaturePicker picker_;
  std::optional<PickRequest> pick_;
  std::optional<PickedFeature> pick_hover_;
  std::map<std::string, std::vector<SceneCurve>> curves_;
  std::map<std::string, std::vector<OverlayLabel>> labels_;
  std::vector<StripCell> figure_strip_;
  std::optional<EmptyState> empty_;
  bool edges_ = true, motion_ = true;
  std::optional<SectionPlane> section_;
  std::optional<ViewCubeSpot> cube_hover_;
  ViewStrip view_strip_;
  int view_strip_hover_ = -1;
  QString hover_name_;
  QPointF hover_place_;
  QPointF press_place_, last_place_;
  dvec3 pivot_W_{0.0};
  enum class Drag { kNone, kOrbit, kPan, kZoom, kClick, kBox, kMenu, kCube, kPick, kSection } drag_ = Drag::kNone;
  Qt::MouseButton press_button_ = Qt::NoButton;
  Navigation navigation_ = navigationPreset({});
};

}  // namespace hapticell::app
