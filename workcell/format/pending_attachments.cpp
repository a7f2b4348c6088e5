// SPDX-License-Identifier: Apache-2.0
#include "workcell/format/pending_attachments.h"

#include <memory>
#include <set>
#include <utility>

#include "workcell/document/perform_command.h"
#include "workcell/format/name_levels.h"

namespace hapticell::workcell {

namespace {

// Entities that hang on each other in a row: guards time of a motion. Half, twice: other documents are refused with a
// message.
constexpr int kMostCarriers = 200;
/// m and rad: what is written with all digits and read again is nearer than this. Half: documents of other programs
/// with seven digits warn; twice: 2 um off is not noted.
constexpr double kSamePlace = 1e-6;

const Entity* entityNamed(const DocumentState& state, const PendingAttachments::Index& index, const std::string& name) {
  const auto found = index.find(name);
  return found == index.end() || found->second >= state.entities.size() ? nullptr : state.entities[found->second].get();
}

/// Whether `entity` may hang there; its own attachment is not set yet.
Expected<void> checkCarrier(const DocumentState& state, const PendingAttachments::Index& index, const Entity& entity,
                            const Attachment& attachment) {
  const Text place("entity '%1'", entity.name);
  const Entity* carrier = entityNamed(state, index, attachment.to);
  for (const Entity* at = carrier; at != nullptr;
       at = at->attachment.to.empty() ? nullptr : entityNamed(state, index, at->attachment.to)) {
    if (at->name == entity.name)
      return makeError({.place = place,
                        .found = Text("it is attached to itself through '%1'", attachment.to),
                        .expected = "another entity"});
  }
  const bool link_there =
      carrier != nullptr && (carrier->unloaded || attachment.link.empty() ||
                             (carrier->robot() && carrier->robot()->findLink(attachment.link) >= 0));
  if (link_there) return {};
  return makeError({.place = place,
                    .found = carrier ? Text("it is attached to '%1', link '%2', which does not exist", attachment.to,
                                            attachment.link)
                                     : Text("it is attached to '%1', which does not exist", attachment.to),
                    .expected = "an existing entity or link"});
}

/// Where it hangs counts: an entity whose own placement says otherwise is put there, and that is told.
void placeOnCarrier(DocumentState& state, const PendingAttachments::Index& index, std::size_t at, bool is_placed,
                    Diagnostics& diagnostics) {
  auto entity = std::make_shared<Entity>(*state.entities[at]);
  const Entity* carrier = entityNamed(state, index, entity->attachment.to);
  if (carrier == nullptr || carrier->unloaded) return;
  const Pose X_WL = carrierPose(*carrier, entity->attachment.link);
  if (!is_placed) {
    entity->attachment.X_LE = X_WL.inverse() * entity->X_WE;
  } else {
    const Pose X_WE = X_WL * entity->attachment.X_LE;
    const Twist off = difference(X_WE, entity->X_WE);
    if (glm::length(off.linear) < kSamePlace && glm::length(off.angular) < kSamePlace) return;
    entity->X_WE = X_WE;
    diagnostics.warn(
        Text("entity '%1': its \"placement\" does not match its attachment to '%2'; the attachment is used",
             entity->name, carrier->name));
  }
  state.entities[at] = std::move(entity);
}

}  // namespace

void PendingAttachments::add(std::size_t index, Attachment attachment, bool is_placed) {
  all_.push_back({index, std::move(attachment), is_placed});
}

Expected<void> PendingAttachments::attachAll(DocumentState& state, const Index& index, Diagnostics& diagnostics) const {
  HAPTICELL_TRY(checkChains(state));
  for (const Hanging& hanging : all_) {
    auto entity = std::make_shared<Entity>(*state.entities[hanging.index]);
    HAPTICELL_TRY(checkCarrier(state, index, *entity, hanging.attachment));
    entity->attachment = hanging.attachment;
    state.entities[hanging.index] = std::move(entity);
  }
  for (const Hanging* hanging : carriersFirst(state))
    placeOnCarrier(state, index, hanging->index, hanging->is_placed, diagnostics);
  return {};
}

Expected<void> PendingAttachments::checkChains(const DocumentState& state) const {
  std::unordered_map<std::string, std::string> carriers;
  for (const Hanging& hanging : all_) carriers.emplace(state.entities[hanging.index]->name, hanging.attachment.to);
  const Levels levels = levelsOf(carriers, kMostCarriers);
  if (levels.too_deep.empty()) return {};
  return makeError({.place = Text("entity '%1'", levels.too_deep),
                    .found = Text("it is attached through a chain of more than %1 entities", kMostCarriers),
                    .expected = "fewer",
                    .fix = "Correct \"attached\" in the document."});
}

/// Carriers come first; a chain of them may be as long as the file.
std::vector<const PendingAttachments::Hanging*> PendingAttachments::carriersFirst(const DocumentState& state) const {
  std::map<std::string, const Hanging*> by_name;
  for (const Hanging& hanging : all_) by_name[state.entities[hanging.index]->name] = &hanging;
  std::set<const Hanging*> done;
  std::vector<const Hanging*> sorted;
  for (const Hanging& hanging : all_) {
    std::vector<const Hanging*> chain;
    for (const Hanging* at = &hanging; at != nullptr && done.insert(at).second;) {
      chain.push_back(at);
      const auto below = by_name.find(state.entities[at->index]->attachment.to);
      at = below == by_name.end() ? nullptr : below->second;
    }
    sorted.insert(sorted.end(), chain.rbegin(), chain.rend());
  }
  return sorted;
}

}  // namespace hapticell::workcell
