// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <cstddef>
#include <deque>
#include <string>

#include "workcell/document/document_state.h"

namespace hapticell::app {

class DocumentModel;

/// Keeps what the last steps of undo changed, and writes them as a script. Undone steps do not count. GUI thread.
class ActionRecorder : public QObject {
  Q_OBJECT
 public:
  /// Steps that are kept; each holds two states, which share their entities. Half: shorter scripts; twice: the same.
  static constexpr std::size_t kKept = 1000;

  explicit ActionRecorder(DocumentModel& model, QObject* parent = nullptr);
  /// A mark for scriptSince(): all steps from now on.
  std::size_t mark() const { return first_ + steps_.size(); }
  /// The steps since the mark that still stand.
  std::size_t countSince(std::size_t mark) const;
  /// How many steps are kept.
  std::size_t count() const { return steps_.size(); }
  /// Those steps as Python that does the same to `cell`; each is one step of undo.
  std::string scriptSince(std::size_t mark) const;

 signals:
  void changed();

 private:
  struct Step {
    std::string text;
    workcell::DocumentState before, after;
  };
  void look();
  void restart();

  DocumentModel& model_;
  workcell::DocumentState state_;  ///< As it was last seen.
  std::size_t depth_ = 0;          ///< Steps of undo as last seen.
  std::deque<Step> steps_;         ///< Those that stand, newest last.
  std::size_t first_ = 0;          ///< How many steps came before the first kept one.
};

}  // namespace hapticell::app
