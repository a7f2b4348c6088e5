// SPDX-License-Identifier: Apache-2.0
#include "mannequin/motion/glove_file.h"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "geometry/system/atomic_file.h"
#include "geometry/system/nesting_limit.h"
#include "geometry/system/regular_file.h"

namespace hapticell::mannequin {

namespace {

using nlohmann::json;

bool take(const json& document, const char* key, GloveReadings& values) {
  const auto found = document.find(key);
  if (found == document.end() || !found->is_array() || found->size() != kGloveSensors) return false;
  for (std::size_t i = 0; i < kGloveSensors; ++i) {
    if (!(*found)[i].is_number()) return false;
    values[i] = (*found)[i].get<double>();
    if (!std::isfinite(values[i])) return false;
  }
  return true;
}

}  // namespace

Expected<GloveCalibration> readGloveCalibration(const std::filesystem::path& file) {
  const auto refuse = [&](Text found) {
    return makeError({.file = file.string(),
                      .found = std::move(found),
                      .expected = "a glove's calibration",
                      .fix = "Calibrate the glove again."});
  };
  // Guards memory: a calibration is some numbers of 22 sensors. Half, twice: no effect.
  constexpr std::uintmax_t kMostGloveBytes = 1'000'000;
  const auto text = geometry::readRegularFile(file, kMostGloveBytes);
  if (!text) return refuse(text.error().found);
  auto flat = geometry::checkNesting(*text, geometry::NestedText::kJson, file.string());
  HAPTICELL_TRY(flat);
  const json document = json::parse(*text, nullptr, false);
  if (!document.is_object() || document.value("format", json()) != "hapticell-glove")
    return refuse(Text("another format"));
  if (document.value("version", json()) != 1) return refuse(Text("another version"));
  GloveCalibration calibration;
  if (!take(document, "gain", calibration.gain) || !take(document, "offset", calibration.offset)) {
    return refuse(Text("not 22 numbers each for gain and offset"));
  }
  return calibration;
}

Expected<void> writeGloveCalibration(const GloveCalibration& calibration, const std::filesystem::path& file) {
  const json document{
      {"format", "hapticell-glove"}, {"version", 1}, {"gain", calibration.gain}, {"offset", calibration.offset}};
  std::error_code problem;
  std::filesystem::create_directories(file.parent_path(), problem);
  return writeFileAtomically(file, document.dump(1) + '\n');
}

GloveCalibration roughGloveCalibration() {
  GloveCalibrationPoses poses;
  poses.flat.fill(60.0);
  poses.fist.fill(200.0);
  poses.spread.fill(120.0);
  poses.thumb_under.fill(160.0);
  return calibrateGlove(poses).value_or(GloveCalibration{});
}

}  // namespace hapticell::mannequin
