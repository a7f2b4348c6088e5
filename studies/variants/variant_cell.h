// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <any>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "studies/variants/study_inputs.h"

namespace hapticell::studies {

/// The cell of one variant while it is changed and asked. One thread.
class VariantCell {
 public:
  explicit VariantCell(const StudyInputs& inputs) : document(inputs.cell), inputs_(inputs) {}

  workcell::Document document;
  std::map<std::string, std::shared_ptr<const trajectory::Trajectory>> motions;  ///< By the name of what varies.

  /// How mannequins do their work, by name, where it is not as in the given cell: "seated".
  std::map<std::string, std::string> stances;

  const StudyInputs& inputs() const { return inputs_; }
  /// The scene of the present document, prepared when it is first asked for; the document must not change after that.
  const std::shared_ptr<const manipulation::PreparedScene>& scene();
  /// The same of another document of this variant (with another body).
  std::shared_ptr<const manipulation::PreparedScene> sceneOf(const workcell::Document& other) const;
  /// What several questions need: made by the first one that asks under this key.
  std::any& kept(const std::string& key) { return kept_[key]; }

 private:
  const StudyInputs& inputs_;
  std::shared_ptr<const manipulation::PreparedScene> scene_;
  std::map<std::string, std::any> kept_;
};

}  // namespace hapticell::studies
