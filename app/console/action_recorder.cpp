// SPDX-License-Identifier: Apache-2.0
#include "app/console/action_recorder.h"

#include <algorithm>

#include "app/console/python_call.h"
#include "app/console/state_commands.h"
#include "app/host/document_model.h"

namespace hapticell::app {

ActionRecorder::ActionRecorder(DocumentModel& model, QObject* parent) : QObject(parent), model_(model) {
  restart();
  connect(&model, &DocumentModel::changed, this, &ActionRecorder::look);
  connect(&model, &DocumentModel::opened, this, &ActionRecorder::restart);
}

void ActionRecorder::restart() {
  first_ += steps_.size();
  steps_.clear();
  state_ = model_.document().state();
  depth_ = model_.document().undoTexts().size();
  emit changed();
}

void ActionRecorder::look() {
  const workcell::Document& document = model_.document();
  if (document.inCompound()) return;  // A drag, or a trial: one step, or none, at its end.
  const std::size_t depth = document.undoTexts().size();
  if (depth > depth_) {
    steps_.push_back({document.undoText(), state_, document.state()});
  } else if (depth < depth_) {
    for (std::size_t i = depth; i < depth_ && !steps_.empty(); ++i) steps_.pop_back();
  } else {
    return;  // Saved.
  }
  if (steps_.size() > kKept) {
    steps_.pop_front();
    ++first_;
  }
  state_ = document.state();
  depth_ = depth;
  emit changed();
}

std::size_t ActionRecorder::countSince(std::size_t mark) const {
  return std::min(steps_.size(), first_ + steps_.size() - std::min(mark, first_ + steps_.size()));
}

std::string ActionRecorder::scriptSince(std::size_t mark) const {
  std::string script = "# Recorded actions: run it from the Python console, where `cell` is the open cell.\n";
  for (std::size_t i = steps_.size() - countSince(mark); i < steps_.size(); ++i) {
    const Step& step = steps_[i];
    script += "\nwith cell.step(" + pythonText(step.text) + "):\n";
    const auto commands = commandsBetween(step.before, step.after);
    std::string lines;
    workcell::DocumentState state = step.before;
    workcell::EntityId next = 1;
    for (const auto& entity : step.before.entities) next = std::max(next, entity->id + 1);
    if (commands) {
      for (const workcell::Command& command : *commands) {
        lines += pythonCall(command, state);
        (void)workcell::apply(command, state, next);  // Was tried by commandsBetween(), which numbers in the same way.
        if (std::holds_alternative<workcell::AddEntity>(command)) ++next;
      }
    } else {
      lines = "# Not written, because Python has no method for it: " + step.text + "\n";
    }
    std::size_t at = 0;
    bool any = false;
    for (std::size_t end = lines.find('\n'); end != std::string::npos; at = end + 1, end = lines.find('\n', at)) {
      script += "    " + lines.substr(at, end - at) + "\n";
      any = any || lines[at] != '#';
    }
    if (!any) script += "    pass\n";
  }
  return script;
}

}  // namespace hapticell::app
