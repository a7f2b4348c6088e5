// SPDX-License-Identifier: Apache-2.0
#include <pybind11/stl.h>

#include <mutex>
#include <optional>
#include <utility>

#include "cli/command_line.h"
#include "cli/device/program_answer.h"
#include "python/engine/bindings.h"
#include "python/engine/conversion.h"
#include "python/engine/long_work.h"

namespace hapticell::python {

namespace {

/// Keeps what a command says until Python takes it.
class Heard final : public cli::CommandListener {
 public:
  void hearResult(const nlohmann::ordered_json& result) override { results.push_back(result); }
  void hearText(const std::string& text) override { texts += text; }
  void hearError(const Error& error) override { errors.push_back(error); }
  void hearWarning(const Text& sentence) override { warnings.push_back(sentence); }
  void hearProgress(double share, const std::string& stage) override {
    const std::lock_guard lock(mutex_);
    progress_ = {share, stage};
  }
  /// Since the last call.
  std::optional<std::pair<double, std::string>> takeProgress() {
    const std::lock_guard lock(mutex_);
    return std::exchange(progress_, std::nullopt);
  }

  // Of the command's thread; Python reads them once it has ended.
  std::vector<nlohmann::ordered_json> results;
  std::string texts;
  std::vector<Error> errors;
  std::vector<Text> warnings;

 private:
  std::mutex mutex_;
  std::optional<std::pair<double, std::string>> progress_;
};

/// (exit status, results, text). Raises the error of a command that failed.
py::tuple run(const std::vector<std::string>& words, const py::object& progress) {
  Heard heard;
  int status = 0;
  runLong([&] { status = cli::runCommand(words, heard); }, [&] { heard.askToStop(); },
          [&] {
            const auto newest = heard.takeProgress();
            if (newest && !progress.is_none()) progress(newest->first, newest->second);
          });
  tellWarnings(heard.warnings);
  if (status == 2) {
    raise(heard.errors.empty()
              ? Error{.found = "the command failed without a sentence", .fix = "This is a bug. Please report it."}
              : heard.errors.back());
  }
  py::list results;
  for (const auto& result : heard.results) results.append(objectOf(result));
  return py::make_tuple(status, results, heard.texts);
}

}  // namespace

void bindCommands(py::module_& module) {
  module.def("run_command", &run, py::arg("words"), py::arg("progress") = py::none(),
             "Runs a command of hapticell-cli in this process: (exit status, results, printed text).");
  module.def(
      "command_grammar", [] { return cli::commandGrammar().dump(); }, "All commands and their options, as JSON.");
  module.def(
      "program_path", [](const std::string& name) { return cli::siblingProgram(name).string(); }, py::arg("name"),
      "Path of another program of HaptiCell; empty: not found.");
}

}  // namespace hapticell::python
