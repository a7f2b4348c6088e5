// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "geometry/system/text.h"
#include "workcell/scenes/sdf_source.h"
#include "workcell/scenes/sdf_xml.h"
#include "workcell/text/content_rules.h"

namespace hapticell::workcell {

/// The link that a model without any is given, since the library refuses it otherwise.
constexpr const char* kNoLink = "hapticell_no_link";

/// Makes the text that libsdformat is given of an SDF file: see SdfSource. Models that are taken in are tidied into
/// files of `folder`, which must stay until the library has read them. Mesh URIs become numbers of meshes().
class SdfTidier {
 public:
  explicit SdfTidier(std::filesystem::path folder) : folder_(std::move(folder)), report_("SDF") {}

  /// Errors: see parseSdf(); more than 200 000 elements, all that is taken in counted as often as it is.
  Expected<std::string> tidy(const std::filesystem::path& file);

  std::vector<SdfMeshFile>& meshes() { return meshes_; }
  /// All that was left out or assumed.
  std::vector<Text> warnings() const;

 private:
  /// Names that are in use among siblings of one kind.
  struct Siblings {
    std::set<std::string> names;
    std::map<std::string, int> last;  // Number that was put behind a name.
    /// The name, or where it is in use already the name with the next number.
    std::string own(const std::string& wanted);
  };
  using Names = std::map<std::string, Siblings>;  // By kind, of one parent.

  struct Place {
    std::filesystem::path file;
    int depth = 0;         // How many files deep.
    bool lenient = false;  // A version whose elements the table does not list.
  };
  /// A file that is named but not there.
  struct Missing {
    Text shown;
    int times = 0;
  };
  struct Taken {
    std::filesystem::path file;  // Empty: not to be had.
    std::string name;
    Text why;
    std::shared_ptr<TiXmlElement> model;  // Where it means the same in any version: it is put in place of the include.
    std::size_t elements = 0;             // With all that it takes in itself.
  };

  std::filesystem::path folder_;
  ContentReport report_;
  std::vector<SdfMeshFile> meshes_;
  std::map<std::string, int> mesh_numbers_;
  std::map<std::string, Taken> taken_;
  std::set<std::string> open_;
  std::vector<Text> told_;
  std::size_t elements_ = 0;  // Of the file that is tidied, with all that it takes in.
  std::optional<Error> refused_;
  std::map<std::string, Missing> missing_models_, missing_meshes_;
  std::set<std::filesystem::path> taken_packages_;  ///< That were reported as guessed.

  /// False from where there are more elements than a library should be given.
  bool count(std::size_t elements, const Place& place);
  /// How many times files are named that are not there, and which.
  static std::pair<int, std::vector<Text>> listed(const std::map<std::string, Missing>& missing);
  Place placeOf(TiXmlElement& root, const Place& place);
  void arrangeTop(TiXmlElement& root, const Place& place);
  void tidyChildren(TiXmlElement& parent, const Place& place);
  bool keep(TiXmlElement& parent, TiXmlElement& child, Names& names, const Place& place);
  bool keepByKind(TiXmlElement& parent, TiXmlElement& child, const Place& place);
  void giveName(TiXmlElement& element, Names& names, const Place& place);
  bool keepPose(TiXmlElement& pose, const TiXmlElement& of, const Place& place);
  bool keepNumbers(TiXmlElement& element, const TiXmlElement& of, const Place& place);
  bool keepWord(TiXmlElement& element);
  bool keepInclude(TiXmlElement& parent, TiXmlElement& include, Names& names, const Place& place);
  bool keepMesh(TiXmlElement& mesh, const Place& place);
  bool keepShape(TiXmlElement& geometry, const TiXmlElement& of, const Place& place);
  void settle(TiXmlElement& world, TiXmlElement& population, Names& names, const Place& place);
  const Taken& take(const std::filesystem::path& file, const Place& place);
  void tell(const TiXmlElement& of, const Place& place, Text what);
};

}  // namespace hapticell::workcell
