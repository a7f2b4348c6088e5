// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/stylus_holder.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/system/overloaded.h"
#include "manipulation/holding/felt_load.h"

namespace hapticell::manipulation {

namespace {

constexpr std::uint32_t kGrabButton = 1, kClutchButton = 2;
/// m of hand space within which the tip touches something: a finger's breadth. Our choice. Half: the tip must be in the
/// part; twice: it takes the neighbour.
constexpr double kTipReach = 0.010;
/// m of hand from which a joint's limit is shown. Our choice. Half: shown when nearly met; twice: shown where it does
/// not matter.
constexpr double kLimitShown = 0.005;
/// m of hand at which it counts as holding, kContactIn. Half: it chatters with the skin (0.02 mm); twice: reported
/// before it is felt.
constexpr double kLimitHolds = 5e-5;

haptic::Vector6 vectorOf(const Twist& t) {
  return {t.linear.x, t.linear.y, t.linear.z, t.angular.x, t.angular.y, t.angular.z};
}

}  // namespace

StylusHolder::StylusHolder(haptic::HapticLink& link, CellState& cell)
    : cell_(cell),
      input_(link, cell.configuration()),
      grip_(cell, log_),
      guides_(cell),
      sets_(cell.configuration().manipulation.zone_radius),
      snapshots_(cell) {
  updateMapping();
}

void StylusHolder::apply(const Command& command) {
  const auto remap = [this](const auto& set) {
    set();
    updateMapping();
  };
  const auto take_anew = [this](const auto& set) {
    set();
    retake();
  };
  std::visit(
      Overloaded{[&](const command::SetGuides& c) {
                   guides_.set(c.guides);
                   sets_.want();
                 },
                 [&](const command::SetPlan& c) {
                   plan_.set(c.source, c.authority);
                   sets_.want();
                 },
                 [&](const command::ChooseEntity& c) { grip_.choose(c.entity); },
                 [&](const command::SetMovedBy& c) { take_anew([&] { grip_.setMovedBy(c.moved_by); }); },
                 [&](const command::SetOnContact& c) { take_anew([&] { grip_.setOnContact(c.on_contact); }); },
                 [&](const command::SetForceClass& c) { take_anew([&] { grip_.setForceClass(c.force_class); }); },
                 [&](const command::SetAxes& c) { remap([&] { hand_.setAxes(c.axes); }); },
                 [&](const command::SetScale& c) { remap([&] { hand_.setScale(c.scale); }); },
                 [&](const command::SetCamera& c) { remap([&] { hand_.setCamera(c); }); },
                 [&](const command::SetFilter& c) {
                   hand_.setFilter(c);
                   anchor();
                 },
                 [&](const command::SetForces& c) { input_.setForces(c.on); },
                 [&](const command::SetClutch& c) { hand_.setClutchCommand(c.on); },
                 [&](const command::SetHandTarget& c) { input_.link().sendHandTarget(c.target); },
                 [&](const command::Grab& c) { grab(c.entity); }, [&](const command::Release&) { release(); },
                 // Of the cell, not of one stylus.
                 [](const command::SetDocument&) {}, [](const command::PoseJoints&) {},
                 [](const command::StartRecording&) {}, [](const command::MarkFrame&) {},
                 [](const command::StopRecording&) {}},
      command);
}

void StylusHolder::takeScene() {
  if (cell_.find(grip_.chosen()) == nullptr) grip_.dropChosen();
  retake();
}

/// Where the frame stands that the axes name.
Pose StylusHolder::frameOfAxes() {
  const AxesChoice& axes = hand_.axes();
  if (axes.mode != AxesMode::kFrame || !cell_.scene()) return {};
  const PreparedScene::FoundFrame frame = cell_.scene()->findFrame(axes.frame);
  if (frame.entity != nullptr) return placement(frame.entity->id).X_WE * frame.X_EF;
  log_.notice(Text("There is no frame '%1' to move along; the cell's axes are used", axes.frame));
  return {};
}

void StylusHolder::updateMapping() {
  const bool changed = hand_.update(frameOfAxes(), input_.link().device(), cell_.configuration().scale);
  if (changed || !held()) anchor();
}

void StylusHolder::anchor() {
  plan_.anchored();
  sets_.want();
  if (held())
    hand_.anchor(input_.state() ? input_.state()->X_DP : Pose::identity(), held()->movedFrame());
  else
    hand_.anchorToView();
}

bool StylusHolder::hold(workcell::EntityId entity) {
  if (!grip_.take(entity)) return false;
  hurried_joint_ = -1;
  return true;
}

void StylusHolder::forgetFelt() {
  contacts_.clear();
  plan_.forget();
  snapshots_.forget();
  sets_.forget();
}

void StylusHolder::retake() {
  if (!held()) return;
  const workcell::EntityId id = held()->id();
  grip_.putDown();
  forgetFelt();
  hold(id);
  updateMapping();
  anchor();
}

void StylusHolder::grab(workcell::EntityId wanted) {
  if (held() || !cell_.scene()) return;
  workcell::EntityId entity = wanted != 0 ? wanted : grip_.chosen();
  if (entity == 0 && input_.state()) {
    const MotionMapping& mapping = hand_.mapping();
    entity = grip_.entityAt(mapping.toCell(input_.state()->X_DS), kTipReach * mapping.scale());
  }
  if (entity == 0) return;
  if (Text why = grip_.heldElsewhere(entity); !why.empty()) return log_.notice(std::move(why));
  if (!hold(entity)) return;
  stopped_ = false;
  updateMapping();
  anchor();
  log_.add(result::Grabbed{entity});
}

void StylusHolder::release() {
  if (!held()) return;
  log_.add(grip_.whereHeld());
  grip_.putDown();
  forgetFelt();
  grip_.setJointsMove(false);
  stopped_ = false;
  sets_.want();
}

bool StylusHolder::yieldJoints() {
  if (held()->manipulator().movesJoints()) return true;
  if (grip_.jointsMove()) return false;
  grip_.setJointsMove(true);
  retake();
  return held() && held()->manipulator().movesJoints();
}

bool StylusHolder::placeOther(workcell::EntityId id, const EntityConfiguration& at) {
  if (!grip_.placeOther(id, at)) return false;
  wantSetForOthers();
  return true;
}

void StylusHolder::letGoOfWhatOtherHolds() {
  if (!held()) return;
  const Text why = grip_.heldElsewhere(held()->id());
  if (why.empty()) return;
  log_.notice(why);
  release();
}

void StylusHolder::followOther(const EntityConfiguration& at) {
  if (areSame(held()->standing(), at) || !yieldJoints()) return;
  grip_.held()->goTo(at);
  wantSetForOthers();
}

void StylusHolder::takeState() {
  if (input_.watchLink()) {
    sets_.want();
    updateMapping();
  }
  input_.takeNewest();
}

void StylusHolder::watchButtons(TakeRecording& recording) {
  const StylusInput::Buttons buttons = input_.takeButtons();
  if ((buttons.pressed & kGrabButton) != 0) held() ? release() : grab(0);
  if ((buttons.let_go & kGrabButton) != 0 && cell_.configuration().manipulation.hold_to_move) release();
  const bool marks = recording.isMarkedByButton();
  if (marks && (buttons.pressed & kClutchButton) != 0) recording.mark();
  setClutched(hand_.isClutchedByCommand() || (!marks && (buttons.down & kClutchButton) != 0));
}

void StylusHolder::setClutched(bool clutched) {
  if (!hand_.setClutched(clutched)) return;
  sets_.want();
  contacts_.clear();
  if (!clutched && held()) anchor();
}

void StylusHolder::driftAtEdge() {
  const haptic::HapticState& state = *input_.state();
  const std::optional<haptic::DeviceDescription> device = input_.link().device();
  const bool drifts = held() && !hand_.isClutched() && device;
  const double fastest = cell_.configuration().manipulation.edge_drift;
  if (hand_.drift(drifts ? &*device : nullptr, state.X_DP.p, fastest, cell_.clock().now())) sets_.want();
  hand_.lookFrom(state.X_DP);
}

/// Tells the server what the hand carries now, where that has changed.
void StylusHolder::updateLoad() {
  haptic::LoadOptions load;
  const workcell::Entity* entity = held() ? cell_.find(held()->id()) : nullptr;
  if (entity != nullptr && !hand_.isClutched()) {
    const std::optional<haptic::DeviceDescription> device = input_.link().device();
    load = feltLoad(*entity, grip_.forceClassOf(*entity), cell_.configuration().manipulation, hand_.mapping(),
                    device ? device->continuous_force : 0.0);
    load.friction = std::max({load.friction, held()->jointFriction(), guides_.friction(*held())});
  }
  input_.setLoad(load);
}

/// Once for each two entities.
void StylusHolder::noticeSimplifiedContacts() {
  const std::vector<std::size_t>& touching = contacts_.contacts();
  if (!held() || touching.empty() || !held()->isPlain()) return;
  const HeldPair& pair = held()->pairs()[touching.front()];
  log_.noticeOnce(
      Text("%1 against %2: the meshes are too dense there to tell all contacts, so only the nearest point "
           "of each pair is felt",
           cell_.find(held()->id())->name, cell_.find(pair.other)->name));
}

void StylusHolder::follow(const ScriptedEntities& scripted) {
  const haptic::HapticState& state = *input_.state();
  const std::int64_t now = cell_.clock().now();
  HeldEntity* const moved = hand_.isClutched() ? nullptr : grip_.held();
  if (moved != nullptr) {
    if (plan_.step(*moved, hand_, state.X_DS, state.X_DP, cell_)) sets_.refresh();
    const Pose X_DWanted = guides_.onGuides(state.X_DP, *moved, hand_.mapping());
    const auto followed = moved->follow(X_DWanted, hand_.mapping(), &sets_.built(), cell_.clock().stepTime());
    hurried_joint_ = followed.hurried_joint;
    stopped_ = followed.stopped;
  }
  updateLoad();
  sets_.update({moved, hand_, state, guides_, plan_, scripted, now}, input_.link());
  if (moved != nullptr) contacts_.look(*moved, sets_.built(), state.X_DP, now, input_.stateTime(now));
  noticeSimplifiedContacts();
  for (const std::size_t i : contacts_.contacts())
    stopped_ = stopped_ || held()->pairs()[i].on_contact == workcell::OnContact::kStop;
}

std::vector<LimitState> StylusHolder::nearLimits() const {
  std::vector<LimitState> near;
  if (!held() || !input_.state()) return near;
  const BuiltConstraints& built = sets_.built();
  const Pose& X_DP = input_.state()->X_DP;
  const Pose X_DHere = hand_.mapping().toDevice(held()->movedFrame(), X_DP);
  const haptic::Vector6 here = vectorOf(difference(X_DHere, built.set.X_DR));
  const haptic::Vector6 proxy = vectorOf(difference(X_DP, built.set.X_DR));
  for (std::size_t i = 0; i < built.set.count && i < built.origins.size(); ++i) {
    if (built.origins[i].limit < 0) continue;
    const MotionLimit& limit = built.limits[static_cast<std::size_t>(built.origins[i].limit)];
    // As it is, not as it is felt while a plan carries the entity.
    haptic::Constraint row = built.set.constraints[i];
    if (row.gap > 0.0) row.gap *= built.eased;
    const double gap = haptic::evaluate(row, here);
    if (gap > kLimitShown) continue;
    const double least = std::min(gap, haptic::evaluate(row, proxy));
    near.push_back({limit.text, held()->ownJoint(limit.joint), limit.kind, std::max(0.0, gap) * hand_.mapping().scale(),
                    least < kLimitHolds});
  }
  if (hurried_joint_ >= 0) {
    const std::string& name = held()->jointName(hurried_joint_);
    near.push_back(
        {Text("%1 moves as fast as it can", name), held()->ownJoint(hurried_joint_), LimitKind::kSpeed, 0.0, true});
  }
  std::stable_sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.gap < b.gap; });
  return near;
}

TakeRecording::Hand StylusHolder::hand() const {
  const dvec3 force_W = input_.state() ? hand_.mapping().axes() * input_.state()->force_D : dvec3(0.0);
  return {grip_, force_W, contacts_.contacts()};
}

void StylusHolder::addTo(SceneSnapshot& snapshot) {
  snapshots_.addEntities(grip_, contacts_, snapshot);
  snapshot.limits = nearLimits();
  snapshot.plan = plan_.state();
  snapshot.clutched = hand_.isClutched();
  snapshot.stopped = stopped_;
  snapshot.felt_ns = contacts_.feltAt();
  SnapshotMaker::addStylus(input_, hand_.mapping(), snapshot);
}

}  // namespace hapticell::manipulation
