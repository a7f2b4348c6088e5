// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "workcell/document/document_state.h"
#include "workcell/text/field_reader.h"

namespace hapticell::workcell {

/// The entities of a state that a text was made from a moment ago (LoadOptions::known): what the text says of them
/// need not be read from their files again.
class KnownShapes {
 public:
  /// `state` must outlive this; null: nothing is known. `folder` as that of the text.
  KnownShapes(const DocumentState* state, const std::filesystem::path& folder);

  /// The entity with exactly this text; null: none.
  const Entity* same(const Json& entity) const;
  /// An entity whose shape comes from the same source, with what comes of it only: the rest is in the text.
  std::optional<Entity> withSameShape(const Json& entity) const;

 private:
  std::map<Json, const Entity*> by_text_;
  std::map<std::string, const Entity*> by_source_;  // By sourceKey().
};

}  // namespace hapticell::workcell
