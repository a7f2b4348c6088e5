// SPDX-License-Identifier: Apache-2.0
#include "feel/mesh_scenes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <utility>

#include "collision/contacts/contact_finder.h"
#include "collision/surfaces/surface_model.h"
#include "geometry/system/assertion.h"
#include "geometry/shapes/shapes.h"
#include "manipulation/holding/constraint_builder.h"
#include "manipulation/manipulators/solid_manipulator.h"

namespace hapticell::feel {

namespace {

using geometry::TriangleMesh;
using Pieces = std::shared_ptr<const collision::ConvexPieces>;

// m, radius of the held peg; its length is 40 mm. Our choice. Half: a hole of half the facets; twice: of a flatter
// wall.
constexpr double kPeg = 0.01;
// m between a chord and its arc, and rad between two of its ends, at most: as CAD importers make them. Half: smoother,
// easier meshes; twice: coarser than an importer gives.
constexpr double kChord = 1e-4;
constexpr double kTurn = 0.3;  // and rad between two of its ends.
// m of what is long: twice the workspace and more, so that no end is met. Half: an end is still 90 mm away, beyond the
// zone; twice: the same figures.
constexpr double kLength = 0.4;
// Queries for one set: each works for 15 ms at most (Contacts), so 0.75 s, for places that are new. Half: some sets
// would be incomplete; twice: the same.
constexpr int kMostQueries = 50;
// Times the way since the last set, as a session computes it (kLeastAhead of set_scheduler.cpp). Half: the hand meets
// the edge of its zone; twice: wider zones, in which fewer surfaces fit.
constexpr double kLooksAhead = 2.0;
// Of what the hand went in earlier sets: forgotten to a third in ten. Half: a turning hand meets the edge of its zone;
// nearer to 1: wide zones are asked for long after.
constexpr double kKept = 0.9;
// rad that a set is good for: the box turns by 1 rad/s at most, a tenth between two sets at 10 Hz. Half: the edge of
// the zone holds its turn; twice: more entries for one set.
constexpr double kTurnAhead = 0.1;
const Pose kAlongY = Pose::rotation(quaternionFromRotationVector({0.5 * std::numbers::pi, 0.0, 0.0}));

int segments(double radius) {
  const double step = std::min(kTurn, 2.0 * std::acos(1.0 - kChord / std::max(radius, 2.0 * kChord)));
  return static_cast<int>(std::ceil(2.0 * std::numbers::pi / step));
}

struct Placed {
  TriangleMesh mesh;
  Pose X_W;
};

class MeshScene final : public FeelScene {
 public:
  MeshScene(std::string name, const TriangleMesh& body, std::vector<Placed> environment)
      : name_(std::move(name)), robot_(Pose::identity(), {Pose::identity()}) {
    body_ = collision::ConvexPieces::build(body);
    models_.push_back(collision::SurfaceModel::build(body));
    surfaces_ = {models_.back().get()};
    for (Placed& placed : environment) {
      pieces_.push_back(collision::ConvexPieces::build(placed.mesh));
      models_.push_back(collision::SurfaceModel::build(placed.mesh));
      obstacles_.push_back({pieces_.back().get(), placed.X_W, pieces_.size(), 0.0, models_.back().get()});
      pairs_.push_back({0, static_cast<std::uint32_t>(pairs_.size()), true});
    }
    feel_.resize(pairs_.size());
    parts_ = {body_.get()};
    mapping_.anchor(Pose::identity(), Pose::identity());
  }
  std::string name() const override { return name_; }
  ConstraintSet setAt(const Pose& X_DP, double) const override {
    const manipulation::EntityConfiguration here{X_DP, {}};
    manipulation::ConstraintInputs inputs{robot_,     here,   mapping_,   X_DP,   haptic::kWantedZoneRadius,
                                          kTurnAhead, parts_, obstacles_, pairs_, feel_};
    inputs.finder = &finder_;
    inputs.surfaces = surfaces_;
    manipulation::ConstraintDraft draft = manipulation::draftConstraints(inputs);
    draft.options.pair_mask = draft.mask;
    draft.options.needed_radius = neededRadius(X_DP);
    const auto find = [&] { return finder_.find(draft.moving, obstacles_, draft.options); };
    // What is worked out for the first time takes several queries; until then a client holds the set that it has.
    collision::ZoneContacts found = find();
    for (int more = 0; found.pending && more < kMostQueries; ++more) found = find();
    return manipulation::completed(draft, found).set;
  }
  double penetration(const Pose&, double) const override { return 0.0; }
  dvec3 handAt(double, double) const override { return dvec3(0.0); }

 private:
  /// What the hand may go until the set after this one is felt, by what it went of late; as a session reckons it.
  double neededRadius(const Pose& X_DP) const {
    const double gone = looked_ ? glm::length(X_DP.p - looked_->p) : 0.0;
    looked_ = X_DP;
    needed_ = std::max(kLooksAhead * gone, kKept * needed_);
    return std::min(needed_, haptic::kWantedZoneRadius);
  }

  std::string name_;
  manipulation::SolidManipulator robot_;
  manipulation::MotionMapping mapping_;
  Pieces body_;
  std::vector<Pieces> pieces_;
  std::vector<const collision::ConvexPieces*> parts_;
  std::vector<collision::ZonePart> obstacles_;
  std::vector<manipulation::MotionPair> pairs_;
  std::vector<manipulation::PairFeel> feel_;
  std::vector<std::shared_ptr<const collision::SurfaceModel>> models_;
  std::vector<const collision::SurfaceModel*> surfaces_;
  // One session asks, in its own thread.
  mutable collision::ContactFinder finder_;
  mutable std::optional<Pose> looked_;
  mutable double needed_ = 0.0;
};

TriangleMesh block() {
  return geometry::makeBox(dvec3(kLength));
}
Placed floorAt(double height) {
  return {block(), Pose::translation({0.0, 0.0, height - 0.5 * kLength})};
}
Placed roundBar(double radius) {
  Pose X_W = kAlongY;
  X_W.p = {0.0, 0.0, -kBallRadius - radius};
  return {geometry::makeCylinder(radius, kLength, segments(radius)), X_W};
}

struct Recipe {
  const char* name;
  std::function<TriangleMesh()> body;
  std::function<std::vector<Placed>()> environment;
  std::function<std::unique_ptr<FeelScene>()> exact;
};

const std::vector<Recipe>& recipes() {
  static const std::vector<Recipe> all{
      {"mesh sphere on flat wall", heldBall, [] { return std::vector<Placed>{floorAt(-kBallRadius)}; }, planeScene},
      {"mesh sphere on cylinder R50", heldBall, [] { return std::vector<Placed>{roundBar(0.05)}; },
       [] { return cylinderScene(0.05 + kBallRadius); }},
      {"mesh sphere on cylinder R10", heldBall, [] { return std::vector<Placed>{roundBar(0.01)}; },
       [] { return cylinderScene(0.01 + kBallRadius); }},
      {"mesh sphere in bore R15", heldBall,
       [] {
         return std::vector<Placed>{{geometry::makePipe(0.03, 0.015, kLength, segments(0.015)), kAlongY}};
       },
       [] { return boreScene(0.015 - kBallRadius); }},
      {"mesh sphere in corner", heldBall,
       [] {
         const double off = -kBallRadius - 0.5 * kLength;
         return std::vector<Placed>{{block(), Pose::translation({off, 0, 0})},
                                    {block(), Pose::translation({0, off, 0})},
                                    {block(), Pose::translation({0, 0, off})}};
       },
       cornerScene},
      {"mesh box on flat wall",
       [] {
         TriangleMesh box = geometry::makeBox({0.06, 0.04, 0.02});
         for (dvec3& vertex : box.vertices) vertex.z -= 0.01;
         return box;
       },
       [] { return std::vector<Placed>{floorAt(0.0)}; }, boxScene},
      {"mesh peg in hole 0.05 mm",
       [] {
         TriangleMesh peg = geometry::makeCylinder(kPeg, 0.04, segments(kPeg));
         for (dvec3& vertex : peg.vertices) vertex.z -= 0.01;
         return peg;
       },
       [] {
         const double hole = kPeg + 0.05e-3;
         return std::vector<Placed>{
             {geometry::makePipe(3.0 * kPeg, hole, 0.03, segments(hole)), Pose::translation({0.0, 0.0, -0.025})},
             floorAt(-0.04)};
       },
       pegScene}};
  return all;
}

}  // namespace

TriangleMesh heldBall() {
  return geometry::makeSphere(kBallRadius, segments(kBallRadius));
}

std::vector<std::string> meshCaseNames() {
  std::vector<std::string> names;
  for (const Recipe& recipe : recipes()) names.push_back(recipe.name);
  return names;
}

MeshCase makeMeshCase(const std::string& name) {
  for (const Recipe& recipe : recipes()) {
    if (name != recipe.name) continue;
    return {name, std::make_unique<MeshScene>(name, recipe.body(), recipe.environment()), recipe.exact()};
  }
  HAPTICELL_DEMAND(false && "a name of meshCaseNames()");
  return {};
}

std::unique_ptr<FeelScene> ballAgainst(const std::string& name, const TriangleMesh& part, const Pose& X_WP) {
  return std::make_unique<MeshScene>(name, heldBall(), std::vector<Placed>{{part, X_WP}});
}

}  // namespace hapticell::feel
