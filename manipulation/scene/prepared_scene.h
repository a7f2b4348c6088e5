// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "collision/pieces/convex_pieces.h"
#include "collision/surfaces/surface_model.h"
#include "collision/trees/mesh_collider.h"
#include "workcell/entity/entity.h"
#include "workcell/entity/pair_policy.h"

namespace hapticell::manipulation {

/// A mesh prepared for both kinds of query, as it is felt (collision::feltMesh): material is behind every triangle,
/// whatever its direction in the file; open sheets are thin plates, so that both sides can be felt.
struct PreparedMesh {
  /// From the mesh with its hollows relieved (collision::relievedMesh).
  std::shared_ptr<const collision::MeshCollider> collider;
  std::shared_ptr<const collision::ConvexPieces> pieces;
  std::shared_ptr<const collision::SurfaceModel> surfaces;
  std::size_t bodies_turned = 0;  ///< Connected surfaces that face inward in the file.
};

/// One rigid body of the scene: a solid, or a link of a robot with all its collision shapes. Its frame P is the
/// entity's own or the link's.
struct ScenePart {
  workcell::EntityId entity = 0;
  int link = -1;       ///< Robots: index of the link; -1 for a solid.
  std::string name{};  ///< Robots: the link's name; empty for a solid.
  PreparedMesh mesh{};
  workcell::RigidBody body{};  ///< See workcell::rigidBodyOf().
};

class PreparedScene;

/// Progress of a preparation, for showing or cancelling it. Any thread may read, and cancel, at any time.
struct PreparationProgress {
  std::atomic<std::size_t> steps{0};  ///< In total (a triangle counts once for each thing that is made of it),
  std::atomic<std::size_t> done{0};   ///< and done so far.
  collision::BuildProgress build;     ///< Its `cancelled` ends the preparation.
  /// After a cancelled preparation: the meshes that were ready, for `previous` of the next one. Belongs to the
  /// preparing thread.
  std::shared_ptr<const PreparedScene> given_up;
};

/// The document prepared for the manipulation loop: its entities, their parts ready for queries, and the pairs to
/// check. Immutable; any thread.
class PreparedScene {
 public:
  /// Takes as long as the meshes need, on all the machine's cores; meshes that `previous` has are reused. Entities
  /// without a mesh have no parts. Null when cancelled (see PreparationProgress::given_up). Programs use SceneService
  /// instead, the only owner of scenes.
  static std::shared_ptr<const PreparedScene> prepare(std::vector<workcell::Entity> entities,
                                                      workcell::PairPolicy pairs,
                                                      const workcell::PairDefaults& defaults,
                                                      const PreparedScene* previous = nullptr,
                                                      PreparationProgress* progress = nullptr);
  /// The same, reusing the meshes of several others.
  static std::shared_ptr<const PreparedScene> prepare(std::vector<workcell::Entity> entities,
                                                      workcell::PairPolicy pairs,
                                                      const workcell::PairDefaults& defaults,
                                                      std::span<const std::shared_ptr<const PreparedScene>> previous,
                                                      PreparationProgress& progress);

  const std::vector<workcell::Entity>& entities() const { return entities_; }
  /// Null if it does not exist. Looked up in a table.
  const workcell::Entity* find(workcell::EntityId id) const;
  const workcell::Entity* find(const std::string& name) const;
  const std::vector<ScenePart>& parts() const { return parts_; }
  /// Those of one entity; none where it does not exist.
  std::span<const ScenePart> partsOf(workcell::EntityId id) const;
  const workcell::PairPolicy& pairs() const { return pairs_; }
  const workcell::PairDefaults& defaults() const { return defaults_; }

  /// Pose X_WP of an entity's part for the given placement and joints.
  static Pose partPose(const workcell::Entity& entity, const Pose& X_WE, const std::vector<double>& joints, int link);

  /// The pairs to check for the entity, with `on_contact` as its own contact mode.
  std::vector<workcell::EffectivePair> pairsOf(workcell::EntityId moved, workcell::OnContact on_contact) const;

  /// The user's rule for two of its parts; null without a rule.
  const workcell::PairRule* ruleFor(const ScenePart& a, const ScenePart& b) const;

  /// Whether these two are ever checked against each other: no rule of the user excludes them, and they can move
  /// relative to each other (an attached entity is one body with its link).
  bool isChecked(const ScenePart& a, const ScenePart& b) const;

  /// A frame by its name: a frame of an entity, or an entity's own. Null entity if it does not exist.
  struct FoundFrame {
    const workcell::Entity* entity = nullptr;
    Pose X_EF;
  };
  FoundFrame findFrame(const std::string& name) const;

 private:
  using MeshKey = std::pair<const void*, int>;  ///< Mesh, or robot model and link.
  PreparedScene() = default;
  struct Job;  ///< A mesh that is still to be prepared.
  struct Known {
    std::size_t entity = 0;                 ///< Its place in entities_,
    std::size_t first_part = 0, parts = 0;  ///< and of its parts in parts_.
  };
  void index();
  void addParts(const workcell::Entity& entity, std::vector<Job>& jobs);
  void addLinks(const workcell::Entity& entity, std::vector<Job>& jobs);
  void addPart(ScenePart part, const MeshKey& key, std::shared_ptr<const geometry::TriangleMesh> mesh,
               std::vector<Job>& jobs);
  void run(const std::vector<Job>& jobs, std::span<const std::shared_ptr<const PreparedScene>> previous,
           PreparationProgress& progress);
  void dropUnfinished();

  std::vector<workcell::Entity> entities_;
  workcell::PairPolicy pairs_;
  workcell::PairDefaults defaults_;
  std::vector<ScenePart> parts_;
  std::vector<MeshKey> keys_;  ///< For the parts' meshes.
  std::unordered_map<workcell::EntityId, Known> by_id_;
  std::unordered_map<std::string_view, std::size_t> by_name_;  ///< Places in entities_; names are those there.
  /// The rules that name an entity, in their order.
  std::unordered_map<std::string_view, std::vector<workcell::PairRule>> rules_of_;
  std::map<MeshKey, PreparedMesh> meshes_;
};

}  // namespace hapticell::manipulation
