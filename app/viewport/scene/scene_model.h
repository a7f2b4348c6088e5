// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/viewport/scene/posed_skin.h"
#include "app/viewport/scene/render_item.h"
#include "app/viewport/scene/stylus_mesh.h"
#include "manipulation/engine/scene_snapshot.h"

namespace hapticell::app {

/// An entity shown at a possible pose.
struct GhostPose {
  workcell::EntityId entity = 0;
  Pose X_WE;
  std::vector<double> joints;  ///< For robots: one per variable.
  bool touches = false;        ///< It would collide there.
  bool operator==(const GhostPose& other) const;
};

/// What to draw: the document's entities at the poses of the newest snapshot, with their marks.
class SceneModel {
 public:
  SceneModel();
  /// Sets the entities of the document.
  void setEntities(std::vector<workcell::Entity> entities);
  /// Empty: shows the cell as in the document.
  void setSnapshot(const std::optional<manipulation::SceneSnapshot>& snapshot);
  /// Sets the pair sets of the document: those with own colours colour the marks of their pairs.
  void setPairSets(std::vector<workcell::PairSet> sets);
  /// The sets with own colours, in the order of FrameColors::set_colors from 1; more sets have the theme's colours.
  const std::vector<workcell::PairSet>& colouredSets() const { return coloured_sets_; }
  void setSelected(std::vector<workcell::EntityId> entities);
  void setHovered(workcell::EntityId entity);
  bool isSelected(workcell::EntityId entity) const;
  workcell::EntityId hovered() const { return hovered_; }  ///< 0: nothing.
  /// Sets ghosts of entities, drawn in addition to the entities; `owner` keeps them until it sets others (empty:
  /// removes them).
  void setGhosts(const std::string& owner, std::vector<GhostPose> ghosts);
  std::vector<GhostPose> ghosts() const;
  /// Sets the links of an entity, by index, that are not drawn in their own colour. Empty: all are.
  void setLinkLooks(workcell::EntityId entity, std::map<int, LinkLook> looks);
  /// Sets shapes in addition to the document's; `owner` keeps them until it sets others (empty: removes them): zones,
  /// volumes, bodies of other sizes. They cannot be picked; their meshes' bounds are computed here.
  void setExtras(const std::string& owner, std::vector<RenderItem> extras);
  /// Empty if all links have their own colour.
  std::map<int, LinkLook> linkLooks(workcell::EntityId entity) const;
  /// Sets one smooth skin in place of a mannequin's links, at rest, held and played; null removes it. A mannequin whose
  /// size has changed since shows its links until it has a new skin.
  void setSkin(const workcell::Entity& entity, std::shared_ptr<const mannequin::FigureSkin> skin);
  /// Whether an entity's skin is drawn now.
  bool hasSkin(const workcell::Entity& entity) const { return skinOf(entity) != nullptr; }
  /// Drops ghosts, looks, extras, skins and what is played, because another document follows.
  void forgetCell();
  /// Sets entities that are shown at other poses than in the document: a motion that is played. Empty ends it.
  void setPlayed(std::vector<GhostPose> played);

  const std::optional<manipulation::SceneSnapshot>& snapshot() const { return snapshot_; }
  const std::vector<workcell::Entity>& entities() const { return entities_; }
  const workcell::Entity* find(workcell::EntityId id) const;
  /// Changes whenever a picture of the scene would change.
  std::uint64_t revision() const { return revision_; }
  bool empty() const { return entities_.empty(); }

  /// Parts nearer than this to what is held keep their shape in motion (RenderItem::keeps_shape), m; our choice. Half:
  /// clearances near the hand are shown with coarse shapes; twice: more triangles in motion.
  static constexpr double kNearHeld = 0.3;
  /// Everything visible; `stylus_length` in metres of the cell (0: no stylus), colours of body and band in sRGB.
  struct StylusLook {
    double length = 0.0;
    std::array<float, 3> body{1, 1, 1}, band{0.2f, 0.6f, 1};
  };
  std::vector<RenderItem> items(const StylusLook& stylus) const;

  geometry::Bounds bounds_W() const;
  /// Corners of the boxes of all visible parts: a tighter bound for a fitted view than the box of all.
  std::vector<dvec3> corners_W() const;
  geometry::Bounds boundsOf_W(workcell::EntityId entity) const;
  /// The present pose of an entity, including the snapshot.
  Pose placement_W(const workcell::Entity& entity) const;
  std::vector<double> joints(const workcell::Entity& entity) const;
  /// "Gripper G2" or "robot, link 5".
  std::string nameOf(workcell::EntityId entity, const std::string& part) const;

 private:
  const GhostPose* playedOf(workcell::EntityId id) const;
  const manipulation::EntityState* stateOf(workcell::EntityId id) const;
  std::uint32_t marks(const workcell::Entity& entity, const std::string& part) const;
  std::uint32_t setColorOf(const manipulation::PairState& pair) const;
  geometry::Bounds boundsOf_M(const std::shared_ptr<const geometry::TriangleMesh>& mesh) const;
  void appendItems(const workcell::Entity& entity, std::vector<RenderItem>& items) const;
  struct Skin {
    std::shared_ptr<const mannequin::Figure> figure;
    std::vector<int> bodies;          ///< For each link of the model; -1: none.
    std::shared_ptr<PosedSkin> skin;  ///< Keeps what was drawn last.
  };
  /// The skin to be drawn now; null: the links.
  const Skin* skinOf(const workcell::Entity& entity) const;
  void appendSkin(const workcell::Entity& entity, const Skin& skin, std::vector<RenderItem>& items) const;
  /// Appends the shapes for this placement and these joints, without marks.
  void appendShapes(const workcell::Entity& entity, const Pose& X_WE, std::vector<double> joints,
                    std::vector<RenderItem>& items) const;
  void appendGhost(const GhostPose& ghost, std::vector<RenderItem>& items) const;
  void markKept(std::vector<RenderItem>& items) const;
  std::vector<workcell::EntityId> held() const;
  void appendStylus(const StylusLook& look, const Pose& X_WS, std::vector<RenderItem>& items) const;
  std::vector<workcell::Entity> entities_;
  std::vector<workcell::PairSet> pair_sets_, coloured_sets_;
  std::optional<manipulation::SceneSnapshot> snapshot_, shown_;
  std::vector<workcell::EntityId> selected_;
  workcell::EntityId hovered_ = 0;
  std::map<std::string, std::vector<GhostPose>> ghosts_;
  std::vector<GhostPose> played_;
  std::map<workcell::EntityId, std::map<int, LinkLook>> looks_;
  std::map<std::string, std::vector<RenderItem>> extras_;
  std::map<workcell::EntityId, Skin> skins_;
  StylusMesh stylus_;
  std::map<std::shared_ptr<const geometry::TriangleMesh>, geometry::Bounds>
      mesh_bounds_;  // Millions of vertices: computed once.
  std::uint64_t revision_ = 1;
};

}  // namespace hapticell::app
