// SPDX-License-Identifier: Apache-2.0
#include "studies/document/study_document.h"

#include <algorithm>
#include <set>
#include <utility>

#include "geometry/system/nesting_limit.h"
#include "geometry/system/regular_file.h"
#include "studies/document/study_section.h"

namespace hapticell::studies {

namespace fs = std::filesystem;

struct StudyDocument::Tree {
  toml::table root;
};

StudyDocument::StudyDocument() = default;
StudyDocument::StudyDocument(const StudyDocument&) = default;
StudyDocument::StudyDocument(StudyDocument&&) noexcept = default;
StudyDocument& StudyDocument::operator=(const StudyDocument&) = default;
StudyDocument& StudyDocument::operator=(StudyDocument&&) noexcept = default;
StudyDocument::~StudyDocument() = default;

namespace {

/// Bytes; a document is written by hand or by the window. Half: still ten thousand lines; twice: more to read in vain.
constexpr std::uintmax_t kLargestStudy = 1'000'000;
/// Variants of one study, samples, and evaluations of a search: what a results file of some gigabytes holds. Half: some
/// full grids must be coarser; twice: results of tens of gigabytes.
constexpr double kMostSamples = 1e7;

bool isName(const std::string& name) {
  const auto good = [](char c) { return (std::isalnum(static_cast<unsigned char>(c)) != 0) || c == '_' || c == '-'; };
  return !name.empty() && name.size() <= 60 && std::all_of(name.begin(), name.end(), good);
}

}  // namespace

/// Fills a document from its tables.
class StudyReader {
 public:
  explicit StudyReader(StudyDocument& study) : study_(study) {}

  Expected<void> read(const toml::table& root) {
    SectionReader reader(root, "", study_.file);
    workcell::TomlFields& fields = reader.fields();
    fields.read("name", study_.name);
    fields.read("note", study_.note);
    std::string cell;
    fields.require("cell");
    fields.read("cell", cell);
    double seed = static_cast<double>(study_.seed);
    fields.read("seed", seed, 1.0, 0.0, 4294967295.0);
    study_.seed = static_cast<std::uint64_t>(seed);
    if (!cell.empty()) study_.cell = (study_.file.parent_path() / cell).lexically_normal();
    const toml::table* sampling = fields.table("sampling");
    const toml::table* search = fields.table("search");
    const toml::array* vary = fields.tables("vary");
    const toml::array* ask = fields.tables("ask");
    const toml::array* require = fields.tables("require");
    const toml::array* objective = fields.tables("objective");
    HAPTICELL_TRY(reader.end());
    if (study_.name.empty()) study_.name = study_.file.stem().string();
    HAPTICELL_TRY(readSampling(sampling, search));
    HAPTICELL_TRY(readSections(vary, "vary", study_.variations));
    HAPTICELL_TRY(readSections(ask, "ask", study_.questions));
    HAPTICELL_TRY(readRequirements(require));
    HAPTICELL_TRY(readObjectives(objective));
    return checkWhole();
  }

 private:
  Expected<void> readSampling(const toml::table* sampling, const toml::table* search) {
    if (sampling != nullptr) {
      SectionReader reader(*sampling, "sampling", study_.file);
      int method = 0;
      double samples = 0.0;
      reader.fields().readWord("method", {"grid", "list", "halton", "sobol"}, method);
      reader.fields().read("samples", samples, 1.0, 1.0, kMostSamples);
      study_.sampling = static_cast<Sampling>(method);
      study_.samples = static_cast<std::size_t>(samples);
      const bool sampled = study_.sampling == Sampling::kHalton || study_.sampling == Sampling::kSobol;
      if (sampled) reader.fields().require("samples");
      if (!sampled && reader.fields().has("samples"))
        reader.fields().failKey("samples", Text("samples with a method that has none"),
                                Text("method = \"halton\" or \"sobol\""));
      HAPTICELL_TRY(reader.end());
    }
    if (search == nullptr) return {};
    SectionReader reader(*search, "search", study_.file);
    double evaluations = static_cast<double>(study_.search.evaluations), starts = 1.0;
    static const std::vector<std::string> kMethods{"nelder-mead", "sbplx", "cobyla", "bobyqa",
                                                   "crs2",        "isres", "direct", "esch"};
    int method = 0;
    reader.fields().readWord("method", kMethods, method);
    reader.fields().read("evaluations", evaluations, 1.0, 2.0, 1e6);
    reader.fields().read("starts", starts, 1.0, 1.0, 1e4);
    reader.fields().read("tolerance", study_.search.tolerance, 1.0, 1e-12, 0.5);
    if (sampling != nullptr)
      reader.fields().fail(search, Text("both [sampling] and [search]"), Text("one of them"));
    HAPTICELL_TRY(reader.end());
    study_.sampling = Sampling::kSearch;
    study_.search.method = kMethods[static_cast<std::size_t>(method)];
    study_.search.evaluations = static_cast<std::size_t>(evaluations);
    study_.search.starts = static_cast<std::size_t>(starts);
    return {};
  }

  /// Only what all kinds have; the kind reads the rest.
  Expected<void> readSections(const toml::array* tables, const std::string& list, std::vector<StudySection>& sections) {
    std::set<std::string> names;
    for (std::size_t i = 0; tables != nullptr && i < tables->size(); ++i) {
      const toml::table& table = *tables->get(i)->as_table();
      SectionReader reader(table, list, study_.file);
      StudySection section{&table, {}, {}, study_.file, list};
      reader.fields().require("what");
      reader.fields().read("what", section.kind);
      section.name = section.kind;
      reader.fields().read("name", section.name);
      if (!isName(section.name))
        reader.fields().failKey("name", Text("the name '%1'", section.name),
                                Text("1 to 60 letters, digits, '_' and '-'"));
      if (!names.insert(section.name).second)
        reader.fields().fail(&table, Text("a second one called '%1'", section.name), Text("a name of its own"));
      HAPTICELL_TRY(reader.check());
      sections.push_back(std::move(section));
    }
    return {};
  }

  Expected<void> readRequirements(const toml::array* tables) {
    for (std::size_t i = 0; tables != nullptr && i < tables->size(); ++i) {
      const toml::table& table = *tables->get(i)->as_table();
      SectionReader reader(table, "require", study_.file);
      Requirement one;
      double least = 0.0, most = 0.0;
      reader.fields().require("value");
      reader.fields().read("value", one.value);
      reader.fields().read("at_least", least, 1.0, -1e12, 1e12);
      reader.fields().read("at_most", most, 1.0, -1e12, 1e12);
      if (reader.fields().has("at_least")) one.at_least = least;
      if (reader.fields().has("at_most")) one.at_most = most;
      if (!one.at_least && !one.at_most)
        reader.fields().fail(&table, Text("a value without a bound"), Text("at_least or at_most"));
      HAPTICELL_TRY(reader.end());
      study_.requirements.push_back(std::move(one));
    }
    return {};
  }

  Expected<void> readObjectives(const toml::array* tables) {
    for (std::size_t i = 0; tables != nullptr && i < tables->size(); ++i) {
      SectionReader reader(*tables->get(i)->as_table(), "objective", study_.file);
      Objective one;
      int goal = 0;
      reader.fields().require("value");
      reader.fields().read("value", one.value);
      reader.fields().readWord("goal", {"least", "greatest"}, goal);
      reader.fields().read("weight", one.weight, 1.0, 1e-9, 1e9);
      HAPTICELL_TRY(reader.end());
      one.is_greatest = goal == 1;
      study_.objectives.push_back(std::move(one));
    }
    return {};
  }

  Expected<void> checkWhole() const {
    const auto lacking = [&](Text found, Text expected) {
      return makeError({.file = study_.file.string(), .found = std::move(found), .expected = std::move(expected)});
    };
    if (study_.variations.empty()) return lacking("nothing varies", "at least one table [[vary]]");
    if (study_.questions.empty()) return lacking("nothing is asked", "at least one table [[ask]]");
    if (study_.sampling == Sampling::kSearch && study_.objectives.empty())
      return lacking("a search without an objective", "at least one table [[objective]]");
    return {};
  }

  StudyDocument& study_;
};

Expected<StudyDocument> StudyDocument::read(const fs::path& file) {
  auto text = geometry::readRegularFile(file, kLargestStudy);
  HAPTICELL_TRY(text);
  return parse(std::move(*text), file);
}

Expected<StudyDocument> StudyDocument::parse(std::string text, const fs::path& file) {
  StudyDocument study;
  study.file = fs::absolute(file).lexically_normal();
  study.text = std::move(text);
  HAPTICELL_TRY(geometry::checkNesting(study.text, geometry::NestedText::kToml, file.string()));
  auto tree = std::make_shared<Tree>();
  try {
    tree->root = toml::parse(study.text);
  } catch (const toml::parse_error& problem) {
    return makeError({.file = file.string(),
                      .place = Text("line %1", problem.source().begin.line),
                      .found = Text("text that is not TOML (%1)", problem.description()),
                      .expected = "a study (.hstudy)"});
  }
  study.tree_ = tree;
  HAPTICELL_TRY(StudyReader(study).read(tree->root));
  return study;
}

}  // namespace hapticell::studies
