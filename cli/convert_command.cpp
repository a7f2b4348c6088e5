// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <memory>
#include <string>

#include "cli/commands.h"
#include "cli/import_arguments.h"
#include "workcell/length_unit.h"
#include "workcell/scene_export.h"

namespace hapticell::cli {

namespace {

struct ConvertOptions {
  std::string file;
  std::string output;
  std::string unit;         ///< Of the read file; empty: as it says, else metres.
  std::string output_unit;  ///< Of a written mesh file; empty: metres.
  std::string up;
  workcell::Tessellation tessellation;
};

Expected<workcell::ImportOptions> importOptions(const ConvertOptions& options) {
  workcell::ImportOptions reading;
  reading.tessellation = options.tessellation;
  reading.weld = false;
  if (!options.unit.empty()) {
    const auto unit = workcell::parseLengthUnit(options.unit);
    if (!unit) return makeError(unit.error());
    reading.metres_per_unit = workcell::metresPer(*unit);
  }
  if (!options.up.empty()) {
    const auto axis = workcell::parseAxis(options.up);
    if (!axis) return makeError(axis.error());
    reading.up_axis = *axis;
  }
  return reading;
}

Expected<nlohmann::ordered_json> convert(const ConvertOptions& options, Diagnostics& notes) {
  const auto reading = importOptions(options);
  if (!reading) return tl::unexpected(reading.error());
  workcell::ExportOptions writing;
  if (!options.output_unit.empty()) {
    const auto unit = workcell::parseLengthUnit(options.output_unit);
    if (!unit) return tl::unexpected(unit.error());
    writing.metres_per_unit = workcell::metresPer(*unit);
  }
  const auto scene = workcell::sceneOfFile(options.file, *reading, notes);
  if (!scene) return tl::unexpected(scene.error());
  const auto written = workcell::exportScene(*scene, options.output, writing, notes);
  if (!written) return tl::unexpected(written.error());
  std::size_t parts = 0, triangles = 0;
  for (const workcell::SceneNode& node : scene->nodes) {
    if (node.mesh < 0) continue;
    ++parts;
    triangles += scene->meshes[static_cast<std::size_t>(node.mesh)].triangles.size();
  }
  return nlohmann::ordered_json{
      {"output", options.output}, {"parts", parts}, {"triangles", triangles}, {"warnings", notes.warnings}};
}

ExitStatus runConvert(const ConvertOptions& options, const ResultWriter& writer) {
  Diagnostics notes;
  const auto result = convert(options, notes);
  for (const std::string& note : notes.warnings) warn(note);
  const auto written = result ? writer.write(*result) : tl::unexpected(result.error());
  if (written) return ExitStatus::kDone;
  report(written.error());
  return ExitStatus::kBadInput;
}

}  // namespace

void addConvertCommand(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("convert", "From any readable format to any writable one, by the extension");
  const auto options = std::make_shared<ConvertOptions>();
  command->add_option("file", options->file, "A mesh, CAD, robot or workcell file")->required();
  command->add_option("-o,--output", options->output, "STEP, GLB, glTF, STL, OBJ, PLY or OFF")->required();
  command->add_option("--unit", options->unit, "What one unit of the read file is: m, mm or in");
  command->add_option("--output-unit", options->output_unit,
                      "What one unit of a written STL, OBJ, PLY or OFF shall be: m, mm or in (m)");
  command->add_option("--up", options->up, "The axis of the read file that points up: x, y or z");
  addTessellationOptions(*command, options->tessellation);
  command->callback(
      [options, &chosen] { chosen = [options](ResultWriter& writer) { return runConvert(*options, writer); }; });
}

}  // namespace hapticell::cli
