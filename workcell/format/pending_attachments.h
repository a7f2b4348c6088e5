// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "workcell/document/document_state.h"

namespace hapticell::workcell {

/// What hangs on what in a document that is being read: a carrier may stand further down in the file than what hangs on
/// it, so entities are read unattached first.
class PendingAttachments {
 public:
  /// Places among the entities of a state, by name.
  using Index = std::unordered_map<std::string, std::size_t>;

  /// The entity at `index` of the state hangs so. `is_placed`: its place on the carrier is written.
  void add(std::size_t index, Attachment attachment, bool is_placed);

  /// Attaches all in `state` and puts each where its carrier holds it; warns in `diagnostics` where the entity's own
  /// placement says otherwise. Errors: a carrier or link that does not exist, a circle, a chain that is too long; the
  /// state is then of no use. Carriers that were kept without their shape may have any link.
  Expected<void> attachAll(DocumentState& state, const Index& index, Diagnostics& diagnostics) const;

 private:
  struct Hanging {
    std::size_t index;  ///< Among the entities.
    Attachment attachment;
    bool is_placed;
  };
  Expected<void> checkChains(const DocumentState& state) const;
  std::vector<const Hanging*> carriersFirst(const DocumentState& state) const;

  std::vector<Hanging> all_;
};

}  // namespace hapticell::workcell
