// SPDX-License-Identifier: Apache-2.0
#include "mannequin/motion/marker_set.h"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <initializer_list>
#include <optional>
#include <utility>

#include "geometry/system/listed.h"
#include "geometry/system/nesting_limit.h"
#include "geometry/system/regular_file.h"

namespace hapticell::mannequin {

namespace {

/// A landmark with the names that it has in a set; '@' is L or R. The first that is there counts.
struct KnownLandmark {
  const char* landmark;  ///< Without its side.
  bool sided;
  std::initializer_list<const char*> names;
};

const KnownLandmark kPlugInGait[] = {{"head_front", true, {"@FHD"}},
                                     {"head_back", true, {"@BHD"}},
                                     {"c7", false, {"C7"}},
                                     {"t10", false, {"T10"}},
                                     {"clavicle", false, {"CLAV"}},
                                     {"sternum", false, {"STRN"}},
                                     {"sacrum", false, {"SACR"}},
                                     {"asis", true, {"@ASI", "@FWT"}},
                                     {"psis", true, {"@PSI", "@BWT"}},
                                     {"shoulder", true, {"@SHO"}},
                                     {"elbow", true, {"@ELB"}},
                                     {"wrist_thumb_side", true, {"@WRA"}},
                                     {"wrist_little_finger_side", true, {"@WRB"}},
                                     {"finger", true, {"@FIN"}},
                                     {"thigh", true, {"@THI"}},
                                     {"shank", true, {"@TIB"}},
                                     {"knee", true, {"@KNE"}},
                                     {"knee_inside", true, {"@KNEIN", "@KNEM", "@KNM", "@MKNE"}},
                                     {"ankle", true, {"@ANK"}},
                                     {"ankle_inside", true, {"@ANKIN", "@ANKM", "@MED", "@MANK"}},
                                     {"heel", true, {"@HEE", "@HEL"}},
                                     {"toe", true, {"@TOE"}}};

const KnownLandmark kHelenHayes[] = {{"head_front", false, {"FRONTHEAD", "FHEAD"}},
                                     {"head_back", false, {"REARHEAD", "RHEAD", "BACKHEAD"}},
                                     {"head_top", false, {"TOPHEAD", "THEAD"}},
                                     {"c7", false, {"C7"}},
                                     {"sacrum", false, {"VSACRAL", "VSAC", "SACRAL", "SACR", "SACRUM"}},
                                     {"asis", true, {"@ASIS", "@ASI"}},
                                     {"psis", true, {"@PSIS", "@PSI"}},
                                     {"shoulder", true, {"@SHOULDER", "@SHO", "@SHOULD", "@ACROMION"}},
                                     {"elbow", true, {"@ELBOW", "@ELB"}},
                                     {"elbow_inside", true, {"@ELBOWMEDIAL", "@MELBOW"}},
                                     {"wrist", true, {"@WRIST", "@WRI"}},
                                     {"finger", true, {"@HAND", "@FIN"}},
                                     {"knee", true, {"@KNEE", "@KNE", "@KNEE1"}},
                                     {"knee_inside", true, {"@KNEEMEDIAL", "@MKNEE", "@KNEEM"}},
                                     {"ankle", true, {"@ANKLE", "@ANK", "@MALL"}},
                                     {"ankle_inside", true, {"@ANKLEMEDIAL", "@MANKLE", "@ANKLEM"}},
                                     {"heel", true, {"@HEEL", "@HEE"}},
                                     {"toe", true, {"@TOE", "@MET"}}};

/// Without its namespace, capital letters and digits only.
std::string bare(const std::string& name) {
  const std::size_t mark = name.find_last_of(":|");
  std::string word;
  for (const char c : mark == std::string::npos ? name : name.substr(mark + 1)) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      word += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return word;
}

template <std::size_t N>
MarkerSet found(const char* name, const KnownLandmark (&known)[N], const MarkerClip& clip) {
  std::map<std::string, std::size_t> at;
  for (std::size_t m = clip.names.size(); m-- > 0;) at[bare(clip.names[m])] = m;  // Of two alike the first.
  MarkerSet set{name, {}};
  const auto look = [&](const std::string& landmark, const KnownLandmark& each, const char* side) {
    for (std::string word : each.names) {
      if (const std::size_t mark = word.find('@'); mark != std::string::npos) word.replace(mark, 1, side);
      if (const auto marker = at.find(word); marker != at.end()) {
        set.markers[landmark] = {marker->second};
        return;
      }
    }
  };
  for (const KnownLandmark& each : known) {
    if (!each.sided) {
      look(each.landmark, each, "");
      continue;
    }
    look(std::string("left_") + each.landmark, each, "L");
    look(std::string("right_") + each.landmark, each, "R");
  }
  return set;
}

std::string namesOf(const MarkerClip& clip) {
  std::string text;
  for (const std::string& name : clip.names) {
    if (text.size() > 200) return text + ", ...";
    text += (text.empty() ? "" : ", ") + name.substr(0, 40);
  }
  return text;
}

/// The known set of which more is there.
MarkerSet likeliest(const MarkerClip& clip) {
  MarkerSet gait = found("Plug-in Gait", kPlugInGait, clip), hayes = found("Helen Hayes", kHelenHayes, clip);
  // CMU's waist (LFWT) comes with thigh markers that are put anywhere.
  for (const char* side : {"left_", "right_"}) {
    const auto waist = gait.markers.find(std::string(side) + "asis");
    if (waist == gait.markers.end() || bare(clip.names[waist->second.front()]).ends_with("ASI")) continue;
    gait.markers.erase(std::string(side) + "thigh");
    gait.markers.erase(std::string(side) + "shank");
  }
  const std::size_t a = missingLandmarks(gait).size(), b = missingLandmarks(hayes).size();
  return a <= b ? gait : hayes;
}

}  // namespace

std::vector<std::string> missingLandmarks(const MarkerSet& set) {
  std::vector<std::string> missing;
  for (const std::string side : {"left_", "right_"}) {
    const auto any = [&](std::initializer_list<const char*> landmarks) {
      return std::any_of(landmarks.begin(), landmarks.end(), [&](const char* each) { return set.has(side + each); });
    };
    if (!any({"asis", "hip_joint"})) missing.push_back(side + "asis");
    if (!any({"psis", "hip_joint"}) && !set.has("sacrum")) missing.push_back(side + "psis (or sacrum)");
    for (const char* each : {"knee", "ankle", "shoulder", "elbow"}) {
      if (!set.has(side + each) && !set.has(side + each + "_joint")) missing.push_back(side + each);
    }
    if (!any({"wrist", "wrist_thumb_side", "wrist_little_finger_side", "wrist_joint"}))
      missing.push_back(side + "wrist");
  }
  return missing;
}

const std::vector<std::string>& landmarkNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all{"head_front", "head_back", "head_top", "c7", "t10", "clavicle", "sternum", "sacrum"};
    for (const char* side : {"left_", "right_"}) {
      for (const char* each : {"head_front",
                               "head_back",
                               "asis",
                               "psis",
                               "shoulder",
                               "elbow",
                               "elbow_inside",
                               "wrist",
                               "wrist_thumb_side",
                               "wrist_little_finger_side",
                               "finger",
                               "knee",
                               "knee_inside",
                               "ankle",
                               "ankle_inside",
                               "heel",
                               "toe",
                               "hip_joint",
                               "knee_joint",
                               "ankle_joint",
                               "shoulder_joint",
                               "elbow_joint",
                               "wrist_joint"})
        all.push_back(std::string(side) + each);
    }
    return all;
  }();
  return names;
}

Expected<MarkerSet> recogniseMarkers(const MarkerClip& clip) {
  MarkerSet set = likeliest(clip);
  const std::vector<std::string> missing = missingLandmarks(set);
  if (missing.empty()) return set;
  return makeError(
      {.place = "markers",
       .found = Text("no marker on %1 by the names of %2 (the file has %3)", listed(missing), set.name, namesOf(clip)),
       .expected = "the markers of Plug-in Gait (full body) or Helen Hayes with shoulders, elbows and wrists",
       .fix = "Use --markers TABLE to assign the markers (docs/user/formats.md)."});
}

Expected<MarkerSet> parseMarkerTable(std::string_view text, const std::string& name, const MarkerClip& clip) {
  HAPTICELL_TRY(geometry::checkNesting(text, geometry::NestedText::kToml, name));
  toml::table table;
  try {
    table = toml::parse(text, name);
  } catch (const toml::parse_error& problem) {
    return makeError({.file = name,
                      .place = Text("line %1", problem.source().begin.line),
                      .found = std::string(problem.description()),
                      .expected = "a table in TOML"});
  }
  const auto fail = [&](const toml::node& node, Text seen, Text expected) {
    return makeError({.file = name,
                      .place = Text("line %1", node.source().begin.line),
                      .found = std::move(seen),
                      .expected = std::move(expected)});
  };
  const toml::table* markers = table["markers"].as_table();
  if (!markers)
    return makeError(
        {.file = name, .found = "[markers] is missing", .expected = "[markers] with landmarks and their markers"});
  const bool alone = table["base"].value_or(std::string("known")) == "none";
  MarkerSet set = alone ? MarkerSet{} : likeliest(clip);
  set.name = table["name"].value_or(std::filesystem::path(name).stem().string());
  for (const auto& [key, node] : *markers) {
    const std::string landmark(key.str());
    const auto& all = landmarkNames();
    if (std::find(all.begin(), all.end(), landmark) == all.end())
      return fail(node, Text("'%1'", landmark), Text("one of the landmarks %1", listed(all)));
    std::vector<std::string> names;
    if (const auto one = node.value<std::string>()) names.push_back(*one);
    if (const toml::array* list = node.as_array()) {
      for (const toml::node& each : *list) names.push_back(each.value_or(std::string()));
    }
    if (names.empty())
      return fail(node, Text("no marker for %1", landmark), Text("a marker's name, or a list of names"));
    std::vector<std::size_t>& indices = set.markers[landmark];
    indices.clear();
    for (const std::string& wanted : names) {
      const auto same = std::find_if(clip.names.begin(), clip.names.end(), [&](const std::string& each) {
        return each == wanted || bare(each) == bare(wanted);
      });
      if (same == clip.names.end() || wanted.empty())
        return fail(node, Text("the marker '%1', which is not in the recording", wanted),
                    Text("one of %1", namesOf(clip)));
      indices.push_back(static_cast<std::size_t>(same - clip.names.begin()));
    }
  }
  const std::vector<std::string> missing = missingLandmarks(set);
  if (missing.empty()) return set;
  return makeError({.file = name,
                    .place = "markers",
                    .found = Text("no marker for %1", listed(missing)),
                    .expected = "a marker for each of them"});
}

Expected<MarkerSet> readMarkerTable(const std::filesystem::path& file, const MarkerClip& clip) {
  // Guards memory: a table has a line a marker. Half, twice: no effect.
  constexpr std::uintmax_t kMostTable = 1u << 20;
  const auto text = geometry::readRegularFile(file, kMostTable);
  if (!text)
    return makeError({.file = file.string(),
                      .place = Text::plain("--markers"),
                      .found = text.error().found,
                      .expected = "a table in TOML of at most 1 MB"});
  return parseMarkerTable(*text, file.string(), clip);
}

}  // namespace hapticell::mannequin
