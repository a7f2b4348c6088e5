// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/kit/command_listener.h"
#include "cli/kit/result_writer.h"
#include "cli/session/session_commands.h"
#include "feel/benchmark.h"
#include "workcell/meshes/mesh_reader.h"

namespace hapticell::cli {

namespace {

using nlohmann::ordered_json;

constexpr double kMillimetre = 1e-3;

ordered_json figureJson(const feel::Figure& figure) {
  return {{"id", figure.id},
          {"scene", figure.scene},
          {"rate", figure.rate},
          {"value", finiteOrNull(figure.value)},
          {"limit", figure.limit ? finiteOrNull(*figure.limit) : ordered_json(nullptr)},
          {"pass", figure.pass()},
          {"classic", figure.classic ? finiteOrNull(*figure.classic) : ordered_json(nullptr)},
          {"unit", figure.unit},
          {"comparison", figure.at_least ? "at least" : "at most"}};
}

Expected<void> readParts(const std::vector<std::string>& files, feel::BenchmarkOptions& options) {
  for (const std::string& file : files) {
    Diagnostics diagnostics;
    workcell::MeshReadOptions how;
    how.scale = kMillimetre;
    auto mesh = workcell::readMesh(file, how, diagnostics);
    HAPTICELL_TRY(mesh);
    options.parts.push_back({std::filesystem::path(file).filename().string(), std::move(*mesh)});
  }
  return {};
}

ExitStatus runFeel(feel::BenchmarkOptions options, const std::vector<std::string>& files, ResultWriter& writer) {
  if (const auto read = readParts(files, options); !read) {
    report(read.error());
    return ExitStatus::kBadInput;
  }
  CommandListener* const listener = commandListener();  // Of this thread; others tell the progress.
  if (listener != nullptr) options.stop = &listener->stopAsked();
  options.progress = [listener](const std::string& what) {
    if (listener != nullptr) return listener->hearProgress(-1.0, what);
    std::fprintf(stderr, "feel: %s\n", what.c_str());
  };
  const auto figures = feel::runBenchmark(options);
  if (!figures) {
    report(figures.error());
    return ExitStatus::kBadInput;
  }
  ordered_json lines = ordered_json::array();
  std::size_t passed = 0;
  for (const feel::Figure& figure : *figures) {
    lines.push_back(figureJson(figure));
    passed += figure.pass() ? 1 : 0;
  }
  const ordered_json result{
      {"full", options.full}, {"passed", passed}, {"failed", figures->size() - passed}, {"figures", lines}};
  if (const auto written = writer.write(result); !written) {
    report(written.error());
    return ExitStatus::kBadInput;
  }
  return ExitStatus::kDone;
}

}  // namespace

void addFeelCommand(Subcommand app, Action& chosen) {
  auto options = std::make_shared<feel::BenchmarkOptions>();
  Subcommand command = app.add("feel", "Measure the feel in virtual time, compared with the classic method");
  command.option("--only", options->only, "One measurement (M4) or part of a scene name");
  command.flag("--full", options->full, "Run the full counts (takes minutes)");
  command.flag("--timing", options->timing, "Also measure M7 and M11, in real time");
  auto parts = std::make_shared<std::vector<std::string>>();
  command.option("--part", *parts, "Mesh (STL, OBJ, PLY; millimetres) to feel with a ball as well (M13)")
      .takes(ValueKind::kMesh);
  command.onChosen([options, parts, &chosen] {
    chosen = [options, parts](ResultWriter& writer) { return runFeel(*options, *parts, writer); };
  });
}

}  // namespace hapticell::cli
