// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/session/session_commands.h"
#include "feel/benchmark.h"
#include "workcell/meshes/mesh_reader.h"

namespace hapticell::cli {

namespace {

using nlohmann::ordered_json;

constexpr double kMillimetre = 1e-3;

ordered_json numberOrNull(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json figureJson(const feel::Figure& figure) {
  return {{"id", figure.id},
          {"scene", figure.scene},
          {"rate", figure.rate},
          {"value", numberOrNull(figure.value)},
          {"limit", figure.limit ? numberOrNull(*figure.limit) : ordered_json(nullptr)},
          {"pass", figure.pass()},
          {"classic", figure.classic ? numberOrNull(*figure.classic) : ordered_json(nullptr)},
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
  options.progress = [](const std::string& what) { std::fprintf(stderr, "feel: %s\n", what.c_str()); };
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
  Subcommand command = app.add("feel", "Measure the feel in virtual time, beside the classic way");
  command.option("--only", options->only, "One figure (M4) or part of a scene's name");
  command.flag("--full", options->full, "The full counts (minutes)");
  command.flag("--timing", options->timing, "Also M7 and M11, by the clock on the wall");
  auto parts = std::make_shared<std::vector<std::string>>();
  command.option("--part", *parts, "A mesh (STL, OBJ, PLY; millimetres) to be felt with a ball besides (M13)")
      .takes(ValueKind::kMesh);
  command.onChosen([options, parts, &chosen] {
    chosen = [options, parts](ResultWriter& writer) { return runFeel(*options, *parts, writer); };
  });
}

}  // namespace hapticell::cli
