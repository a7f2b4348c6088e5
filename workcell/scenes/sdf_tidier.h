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

/// The name of the link that is added to a model without links, which the library would reject.
constexpr const char* kNoLink = "hapticell_no_link";

/// Makes the text of an SDF file that libsdformat gets: see SdfSource. Included models are written to files in
/// `folder`, which must exist until the library has read them. Mesh URIs become indices of meshes().
class SdfTidier {
 public:
  explicit SdfTidier(std::filesystem::path folder) : folder_(std::move(folder)), report_("SDF") {}

  /// Errors: see parseSdf(); more than 200 000 elements, counting included models once per use.
  Expected<std::string> tidy(const std::filesystem::path& file);

  std::vector<SdfMeshFile>& meshes() { return meshes_; }
  /// What was left out or assumed.
  std::vector<Text> warnings() const;

 private:
  /// Names that are used among siblings of one kind.
  struct Siblings {
    std::set<std::string> names;
    std::map<std::string, int> last;  // Number that was appended to a name.
    /// The name, or if it is used already, the name with the next number.
    std::string own(const std::string& wanted);
  };
  using Names = std::map<std::string, Siblings>;  // By kind, for one parent.

  struct Place {
    std::filesystem::path file;
    int depth = 0;         // Depth of nested files.
    bool lenient = false;  // A version whose elements the table does not list.
  };
  /// A file that is named but does not exist.
  struct Missing {
    Text shown;
    int times = 0;
  };
  struct Taken {
    std::filesystem::path file;  // Empty: not available.
    std::string name;
    Text why;
    std::shared_ptr<TiXmlElement> model;  // Set if it means the same in any version: replaces the include.
    std::size_t elements = 0;             // Including those of the models that it includes.
  };

  std::filesystem::path folder_;
  ContentReport report_;
  std::vector<SdfMeshFile> meshes_;
  std::map<std::string, int> mesh_numbers_;
  std::map<std::string, Taken> taken_;
  std::set<std::string> open_;
  std::vector<Text> told_;
  std::size_t elements_ = 0;  // Of the cleaned file, including all models that it includes.
  std::optional<Error> refused_;
  std::map<std::string, Missing> missing_models_, missing_meshes_;
  std::set<std::filesystem::path> taken_packages_;  ///< Reported as guessed.

  /// False once there are more elements than the library may get.
  bool count(std::size_t elements, const Place& place);
  /// Number of references to files that do not exist, and a list of these.
  static std::pair<int, std::vector<Text>> listed(const std::map<std::string, Missing>& missing);
  Place placeOf(TiXmlElement& root, const Place& place);
  void arrangeTop(TiXmlElement& root, const Place& place);
  void tidyChildren(TiXmlElement& parent, const Place& place);
  bool keep(TiXmlElement& parent, TiXmlElement& child, Names& names, const Place& place);
  bool keepByKind(TiXmlElement& parent, TiXmlElement& child, const Place& place);
  void giveName(TiXmlElement& element, Names& names, const Place& place);
  bool keepInclude(TiXmlElement& parent, TiXmlElement& include, Names& names, const Place& place);
  bool keepMesh(TiXmlElement& mesh, const Place& place);
  void settle(TiXmlElement& world, TiXmlElement& population, Names& names, const Place& place);
  const Taken& take(const std::filesystem::path& file, const Place& place);
  void tell(const TiXmlElement& of, const Place& place, Text what);
};

}  // namespace hapticell::workcell
