// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "studies/questions/question.h"
#include "studies/store/result_row.h"
#include "studies/variants/variant_space.h"

namespace hapticell::manipulation {
class SceneService;
}

namespace hapticell::studies {

/// A study with everything that it needs, read, checked and ready to run. Immutable after load(); any thread.
class Study {
 public:
  /// Reads the document and all files that it names, and prepares all meshes: this takes seconds. `version` is that of
  /// the program, for its rows. Errors name file, line and key.
  static Expected<std::unique_ptr<const Study>> load(const std::filesystem::path& file, std::string version);
  /// The same from the text of a document that stood in `file`.
  static Expected<std::unique_ptr<const Study>> load(std::string text, const std::filesystem::path& file,
                                                     std::string version);
  /// A cell that stands in memory, such as one with unsaved changes.
  struct CellInMemory {
    workcell::Document document;
    manipulation::SceneService* scenes = nullptr;  ///< Who prepares its meshes; null: only for this study.
  };
  /// The same for a cell in memory: it stands for the one that the text names, which is not read.
  static Expected<std::unique_ptr<const Study>> load(std::string text, const std::filesystem::path& file,
                                                     CellInMemory cell, std::string version);

  const StudyDocument& document() const { return inputs_.document; }
  /// The cell that it names, with what touches in it left out from checks.
  const workcell::Document& cell() const { return inputs_.cell; }
  const VariantSpace& space() const { return space_; }
  const ResultHead& head() const { return head_; }
  /// What readers noticed, and pairs that are not checked because they touch in the given cell.
  const std::vector<Text>& notes() const { return inputs_.notes; }

  /// Everything about one variant. The same values give the same bits, whatever else was evaluated before.
  ResultRow evaluate(std::int64_t number, const std::vector<Value>& values) const;
  /// The rows of one unit: of a variant, or of a whole search. A search that is cancelled gives no rows.
  std::vector<ResultRow> runUnit(std::size_t unit, const std::atomic<bool>& cancelled) const;
  /// The cell as it stood for these values. Errors: the cell cannot be so.
  Expected<workcell::Document> cellOf(const std::vector<Value>& values) const;

 private:
  Study() = default;
  Expected<void> readCell();
  Expected<void> prepare(std::string version, manipulation::SceneService& scenes);
  Expected<void> makeParts();
  Expected<void> prepareScene(manipulation::SceneService& scenes);
  Expected<void> makeHead(std::string version);
  Expected<void> checkNames() const;
  Expected<void> change(const std::vector<Value>& values, VariantCell& cell) const;
  void judge(ResultRow& row) const;
  std::size_t answerNamed(const std::string& name) const;
  std::vector<ResultRow> search(std::size_t unit, const std::atomic<bool>& cancelled) const;

  StudyInputs inputs_;
  std::string cell_text_;  ///< Of a cell in memory, for the digest.
  std::vector<std::unique_ptr<Variation>> variations_;
  std::vector<std::unique_ptr<Question>> questions_;
  VariantSpace space_;
  ResultHead head_;
};

}  // namespace hapticell::studies
