// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <unordered_set>

#include "workcell/format/format_context.h"
#include "workcell/format/known_shapes.h"
#include "workcell/format/pending_attachments.h"
#include "workcell/format/source_format.h"
#include "workcell/text/field_reader.h"

namespace hapticell::workcell {

/// Reads the JSON of one document into a state, in the order in which its parts need each other: entities, what they
/// hang on, pair sets and rules, guides, tasks. Used once.
class StateReader {
 public:
  /// All arguments must outlive this; `folder` is absolute.
  StateReader(const std::filesystem::path& folder, Diagnostics& diagnostics, const LoadOptions& options);

  /// As stateFromJson().
  Expected<DocumentState> read(const Json& json);

 private:
  void readHead(FieldReader& fields);
  void checkParents(const Json& entities);
  void refuseCancelled();
  void reportEntity(std::size_t index, std::size_t count);
  void readEntity(const Json& json, std::size_t index);
  void keepUnloaded(const Json& json, FieldReader& fields, const Text& place, Entity entity, const Error& cause);
  bool add(const Text& place, Entity entity);
  const Entity* named(const std::string& name) const;
  void addEntity(FieldReader& fields, const Text& place, Entity entity);
  void addHanging(FieldReader& fields, const Text& place, Entity entity);
  void attachAll();
  void readPairSet(const Json& json, std::size_t index);
  void readPairRule(const Json& json, std::size_t index);
  void readGuide(const Json& json, std::size_t index);
  void readWorkTask(const Json& json, std::size_t index);
  void readView(FieldReader& fields);
  void readTrajectories(FieldReader& fields);

  const std::filesystem::path& folder_;
  EntityLoader loader_;
  Diagnostics& diagnostics_;
  const LoadOptions& options_;
  std::optional<Error> error_;
  FormatContext context_{folder_, loader_, diagnostics_, options_, error_};
  SourceReader sources_{context_};
  DocumentState state_;
  PendingAttachments attachments_;
  PendingAttachments::Index index_;
  std::unordered_set<std::string> in_circle_;  // One of each circle of parents.
  KnownShapes known_;
};

}  // namespace hapticell::workcell
