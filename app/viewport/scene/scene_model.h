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

/// An entity shown where it might stand.
struct GhostPose {
  workcell::EntityId entity = 0;
  Pose X_WE;
  std::vector<double> joints;  ///< Robots: one a variable.
  bool touches = false;        ///< It would stand in something there.
  bool operator==(const GhostPose& other) const;
};

/// What is to be drawn: the document's entities, moved to where the newest snapshot has them, with their marks.
class SceneModel {
 public:
  SceneModel();
  /// The entities as the document has them now.
  void setEntities(std::vector<workcell::Entity> entities);
  /// Nothing: the cell as the document has it.
  void setSnapshot(const std::optional<manipulation::SceneSnapshot>& snapshot);
  /// Pair sets of the document: those with colours of their own colour the marks of their pairs.
  void setPairSets(std::vector<workcell::PairSet> sets);
  /// The sets with colours, in the order of FrameColors::set_colors from 1 on; those beyond its end have the theme's.
  const std::vector<workcell::PairSet>& colouredSets() const { return coloured_sets_; }
  void setSelected(std::vector<workcell::EntityId> entities);
  void setHovered(workcell::EntityId entity);
  bool isSelected(workcell::EntityId entity) const;
  workcell::EntityId hovered() const { return hovered_; }  ///< 0: nothing.
  /// Ghosts of entities, drawn beside the entities themselves, kept by `owner` until it gives others (none: takes them
  /// away).
  void setGhosts(const std::string& owner, std::vector<GhostPose> ghosts);
  std::vector<GhostPose> ghosts() const;
  /// Links of an entity, by index, that are not drawn in their own colour. Empty: all are.
  void setLinkLooks(workcell::EntityId entity, std::map<int, LinkLook> looks);
  /// Shapes beside the document's, kept by `owner` until it gives others (none: takes them away): zones, volumes,
  /// bodies of other sizes. They are not picked; their meshes' bounds are found here.
  void setExtras(const std::string& owner, std::vector<RenderItem> extras);
  /// Empty where all links have their own colour.
  std::map<int, LinkLook> linkLooks(workcell::EntityId entity) const;
  /// One smooth skin in place of a figure's links, at rest, held and played; null takes it away. Whose figure has
  /// another size by now has its links until it has a skin of its own.
  void setSkin(const workcell::Entity& entity, std::shared_ptr<const mannequin::FigureSkin> skin);
  /// Whether an entity's skin is drawn now.
  bool hasSkin(const workcell::Entity& entity) const { return skinOf(entity) != nullptr; }
  /// Another document follows: ghosts, looks, extras, skins and what is played are dropped.
  void forgetCell();
  /// Entities that are shown elsewhere than they stand: a motion that is played. Empty ends it.
  void setPlayed(std::vector<GhostPose> played);

  const std::optional<manipulation::SceneSnapshot>& snapshot() const { return snapshot_; }
  const std::vector<workcell::Entity>& entities() const { return entities_; }
  const workcell::Entity* find(workcell::EntityId id) const;
  /// Changes whenever a picture of the scene would.
  std::uint64_t revision() const { return revision_; }
  bool empty() const { return entities_.empty(); }

  /// How near a part must be to what is held so that it keeps its shape in motion (RenderItem::keeps_shape), m; our
  /// choice. Half: gaps near the hand are of coarse shapes; twice: more triangles in motion.
  static constexpr double kNearHeld = 0.3;
  /// Everything visible; `stylus_length` in metres of the cell (0: none is drawn), colours of body and band sRGB.
  struct StylusLook {
    double length = 0.0;
    std::array<float, 3> body{1, 1, 1}, band{0.2f, 0.6f, 1};
  };
  std::vector<RenderItem> items(const StylusLook& stylus) const;

  geometry::Bounds bounds_W() const;
  /// Corners of the boxes of all visible parts: what a fitted view must show, nearer than the box of all.
  std::vector<dvec3> corners_W() const;
  geometry::Bounds boundsOf_W(workcell::EntityId entity) const;
  /// Where an entity stands now, snapshot included.
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
    std::vector<int> bodies;          ///< Of each link of the model; -1: none.
    std::shared_ptr<PosedSkin> skin;  ///< Keeps what was drawn last.
  };
  /// The skin that is to be drawn now; null: the links.
  const Skin* skinOf(const workcell::Entity& entity) const;
  void appendSkin(const workcell::Entity& entity, const Skin& skin, std::vector<RenderItem>& items) const;
  /// Shapes where they stand for this placement and these joints, without marks.
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
      mesh_bounds_;  // Millions of vertices: once.
  std::uint64_t revision_ = 1;
};

}  // namespace hapticell::app
