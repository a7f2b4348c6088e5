// SPDX-License-Identifier: Apache-2.0
#include "importer/step_text.h"

#include <archive.h>
#include <archive_entry.h>
#include <iconv.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "geometry/system/regular_file.h"
#include "geometry/system/utf8.h"
#include "importer/archive_closer.h"
#include "workcell/text/file_content.h"

namespace hapticell::importer {

namespace {

constexpr std::string_view kMark = "\xEF\xBB\xBF";
// 4 GB: guards memory. Half, twice: other files are refused with a message.
constexpr std::size_t kMostUnpacked = std::size_t{4} << 30;

bool isHigh(char c) {
  return (static_cast<unsigned char>(c) & 0x80u) != 0;
}

unsigned byteAt(const std::string& text, std::size_t at) {
  return at < text.size() ? static_cast<unsigned char>(text[at]) : 0;
}

bool isShiftJis(const std::string& text) {
  for (std::size_t k = 0; k < text.size(); ++k) {
    const unsigned first = byteAt(text, k), second = byteAt(text, k + 1);
    if (first < 0x80 || (first >= 0xA1 && first <= 0xDF)) continue;
    const bool lead = (first >= 0x81 && first <= 0x9F) || (first >= 0xE0 && first <= 0xFC);
    const bool trail = (second >= 0x40 && second <= 0x7E) || (second >= 0x80 && second <= 0xFC);
    if (!lead || !trail) return false;
    ++k;
  }
  return true;
}

bool isGb18030(const std::string& text) {
  for (std::size_t k = 0; k < text.size(); ++k) {
    const unsigned first = byteAt(text, k), second = byteAt(text, k + 1);
    if (first < 0x80) continue;
    if (first < 0x81 || first > 0xFE) return false;
    const bool four = second >= 0x30 && second <= 0x39 && byteAt(text, k + 2) >= 0x81 && byteAt(text, k + 3) >= 0x30 &&
                      byteAt(text, k + 3) <= 0x39;
    const bool two = (second >= 0x40 && second <= 0x7E) || (second >= 0x80 && second <= 0xFE);
    if (!two && !four) return false;
    k += four ? 3 : 1;
  }
  return true;
}

std::string converted(const std::string& text, const char* encoding) {
  const iconv_t converter = ::iconv_open("UTF-8", encoding);
  if (converter == reinterpret_cast<iconv_t>(-1)) return text;
  std::string result;
  std::vector<char> block(std::size_t{1} << 16);
  std::string copy = text;
  char* in = copy.data();
  std::size_t left = copy.size();
  while (left > 0) {
    char* out = block.data();
    std::size_t room = block.size();
    const std::size_t done = ::iconv(converter, &in, &left, &out, &room);
    result.append(block.data(), block.size() - room);
    if (done != static_cast<std::size_t>(-1) || errno == E2BIG) continue;
    result += '?';  // A byte that is invalid in that encoding.
    ++in;
    --left;
  }
  ::iconv_close(converter);
  return result;
}

/// What guessEncoding() says, for iconv (with what Windows adds to it) and for people.
struct EncodingWords {
  const char* guessed;
  const char* for_iconv;
  const char* for_people;  ///< A Text's id.
};
constexpr EncodingWords kEncodings[] = {{"ISO-8859-1", "CP1252", HAPTICELL_TRANSLATED("Latin-1 (Western Europe)")},
                                        {"SHIFT_JIS", "CP932", HAPTICELL_TRANSLATED("Shift-JIS (Japanese)")},
                                        {"GB18030", "GB18030", HAPTICELL_TRANSLATED("GB 18030 (Chinese)")}};

const EncodingWords& wordsOf(const std::string& encoding) {
  for (const EncodingWords& words : kEncodings)
    if (encoding == words.guessed) return words;
  return kEncodings[2];
}

/// The file with its raw names in UTF-8; `encoding` is set to what they were taken for.
std::string withNamesConverted(const std::string& content, const StepOutline& outline, std::string& encoding) {
  // Names from which the encoding is guessed: more do not change the guess. Half, twice: time.
  constexpr std::size_t kMostTexts = 4000;
  std::vector<std::string> raw;
  for (const auto& [begin, length] : outline.raw) {
    if (raw.size() < kMostTexts) raw.push_back(content.substr(begin, length));
  }
  encoding = guessEncoding(raw);
  std::string result;
  result.reserve(content.size() + content.size() / 64);
  std::size_t done = 0;
  for (const auto& [begin, length] : outline.raw) {
    result.append(content, done, begin - done);
    result += converted(content.substr(begin, length), wordsOf(encoding).for_iconv);
    done = begin + length;
  }
  return result.append(content, done);
}

/// OpenCASCADE opens the files that a text names by itself: none of them, nor of those that they name, may be a pipe or
/// a device. Which of the texts are names it decides; so all are looked at where there are any references.
Expected<void> checkReferences(const std::string& content, const std::filesystem::path& folder) {
  // Guards time: texts that may be names of files. Half, twice: no effect on real assemblies.
  constexpr std::size_t kLongestName = 255, kMostNames = 100'000;
  std::set<std::string> known;
  std::vector<std::string> open;
  const auto look = [&](std::string_view text) -> Expected<void> {
    if (text.find("DOCUMENT_FILE") == text.npos && text.find("EXTERNAL_IDENTIFICATION") == text.npos) return {};
    for (std::size_t at = text.find('\''); at < text.size() && known.size() < kMostNames;) {
      const std::size_t end = std::min(text.find('\'', at + 1), text.size());
      const std::string name(text.substr(at + 1, end - at - 1));
      at = text.find('\'', end + 1);
      if (name.empty() || name.size() > kLongestName || name.find('\n') != name.npos || !known.insert(name).second)
        continue;
      const std::filesystem::path path = folder / name;
      std::error_code fault;
      const auto status = std::filesystem::status(path, fault);
      if (fault || !std::filesystem::exists(status) || std::filesystem::is_directory(status)) continue;
      if (auto regular = geometry::checkRegularFile(path); !regular) {
        return makeError({.place = Text("reference to '%1'", name),
                          .found = regular.error().found,
                          .expected = "a file in the same folder"});
      }
      if (beginsAsStep(geometry::headOfFile(path, 65536))) open.push_back(path.string());
    }
    return {};
  };
  if (auto looked = look(content); !looked) return looked;
  while (!open.empty()) {
    const auto below = geometry::readRegularFile(open.back());
    open.pop_back();
    if (!below) continue;
    if (auto looked = look(*below); !looked) return looked;
  }
  return {};
}

/// The first STEP file in a ZIP archive, or what is packed by gzip and the like.
Expected<std::string> unpacked(const std::filesystem::path& file) {
  const std::unique_ptr<archive, ArchiveCloser> in(archive_read_new());
  archive_read_support_filter_all(in.get());
  archive_read_support_format_zip(in.get());
  archive_read_support_format_raw(in.get());
  archive_entry* entry = nullptr;
  const auto refused = [] {
    return makeError(Error{.found = "an unknown compression",
                           .expected = "a STEP file, plain or compressed with gzip or ZIP",
                           .fix = "Unpack it, or export it as .step."});
  };
  if (archive_read_open_filename(in.get(), file.c_str(), 65536) != ARCHIVE_OK) return refused();
  // As kHarmless and kMostFold of model_package.cpp.
  constexpr std::uintmax_t kHarmlessStep = std::uintmax_t{64} << 20, kStepFold = 200;
  std::error_code ignored;
  const std::uintmax_t most = std::min<std::uintmax_t>(
      kMostUnpacked, std::max(kHarmlessStep, kStepFold * std::filesystem::file_size(file, ignored)));
  std::vector<char> block(std::size_t{1} << 20);
  while (archive_read_next_header(in.get(), &entry) == ARCHIVE_OK) {
    std::string content;
    la_ssize_t count = 0;
    while ((count = archive_read_data(in.get(), block.data(), block.size())) > 0) {
      content.append(block.data(), static_cast<std::size_t>(count));
      if (content.size() > most) {
        return makeError({.found = Text("more than %1 MB once unpacked", most >> 20),
                          .expected = "at most 4 GB and 200 times the packed size",
                          .fix = "Unpack it, or export it again."});
      }
    }
    if (count == 0 && beginsAsStep(std::string_view(content).substr(0, 65536))) return content;
  }
  return refused();
}

/// Walks through the text from entity to entity.
class StepScanner {
 public:
  explicit StepScanner(std::string_view text) : text_(text) {}

  StepOutline run() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '\'') {
        string();
      } else if (c == '/' && at_ + 1 < text_.size() && text_[at_ + 1] == '*') {
        const std::size_t end = text_.find("*/", at_ + 2);
        at_ = end == std::string_view::npos ? text_.size() : end + 2;
      } else if (c >= 'A' && c <= 'Z') {
        keyword();
      } else {
        ++at_;
      }
    }
    return std::move(outline_);
  }

 private:
  void string() {
    const std::size_t begin = ++at_;
    bool high = false;
    while (at_ < text_.size() && text_[at_] != '\'') high = isHigh(text_[at_++]) || high;
    if (high && !isUtf8(std::string(text_.substr(begin, at_ - begin)))) outline_.raw.emplace_back(begin, at_ - begin);
    ++at_;
  }

  void keyword() {
    const std::size_t begin = at_;
    const auto part_of_word = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; };
    while (at_ < text_.size() && part_of_word(text_[at_])) ++at_;
    const std::string_view word = text_.substr(begin, at_ - begin);
    if (word == "ADVANCED_FACE" || word == "FACE_SURFACE") ++outline_.exact_faces;
    if (word == "KINEMATIC_JOINT" || word == "RIGID_LINK_REPRESENTATION") ++outline_.joints;
    static constexpr std::array<std::string_view, 4> kTessellated = {
        "TESSELLATED_SOLID", "TESSELLATED_SHELL", "TRIANGULATED_SURFACE_SET", "COMPLEX_TRIANGULATED_SURFACE_SET"};
    if (std::find(kTessellated.begin(), kTessellated.end(), word) == kTessellated.end()) return;
    const std::size_t end = text_.find(';', at_);
    const std::string_view arguments = text_.substr(at_, end == std::string_view::npos ? end : end - at_);
    const std::size_t last = arguments.rfind(',');
    const bool solid = word.starts_with("TESSELLATED");
    const bool exact_behind =
        solid && last != std::string_view::npos && arguments.find('#', last) != std::string_view::npos;
    outline_.tessellated += exact_behind ? 0 : 1;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  StepOutline outline_;
};

}  // namespace

bool beginsAsStep(std::string_view head) {
  if (head.starts_with(kMark)) head.remove_prefix(kMark.size());
  for (;;) {
    const std::size_t first = head.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return false;
    head.remove_prefix(first);
    if (!head.starts_with("/*")) return head.starts_with("ISO-10303-21");
    const std::size_t end = head.find("*/");
    if (end == std::string_view::npos) return false;
    head.remove_prefix(end + 2);
  }
}

StepOutline outlineOfStep(std::string_view content) {
  return StepScanner(content).run();
}

std::string guessEncoding(const std::vector<std::string>& raw) {
  const auto all = [&](auto is) { return std::all_of(raw.begin(), raw.end(), is); };
  if (all(isUtf8)) return "UTF-8";
  bool low_controls = false;  // Bytes that are controls in Latin-1 and common in Shift-JIS.
  std::size_t runs = 0, odd_runs = 0, high = 0, letters = 0;
  for (const std::string& text : raw) {
    for (std::size_t k = 0; k < text.size(); ++k) {
      if (!isHigh(text[k])) continue;
      const std::size_t begin = k;
      for (; k < text.size() && isHigh(text[k]); ++k) {
        ++high;
        letters += byteAt(text, k) >= 0xC0 ? 1 : 0;
        low_controls = low_controls || byteAt(text, k) < 0xA0;
      }
      ++runs;
      odd_runs += (k - begin) % 2;
    }
  }
  if (low_controls && all(isShiftJis)) return "SHIFT_JIS";
  if (low_controls && all(isGb18030)) return "GB18030";
  // Chinese characters are pairs of bytes, half of the second ones below the letters of Latin-1, and seldom stand
  // alone.
  const bool pairs = odd_runs == 0 && all(isGb18030);
  if (pairs && (letters < high || high >= 4 * runs)) return "GB18030";
  return "ISO-8859-1";
}

Expected<StepText> StepText::open(const std::filesystem::path& file) {
  auto content = workcell::readFileContent(file);
  HAPTICELL_TRY(content);
  HAPTICELL_TRY(checkReferences(*content, file.parent_path()));
  StepText result;
  result.name_ = file.filename().string();
  bool changed = false;
  if (!beginsAsStep(*content) && (content->starts_with("\x1F\x8B") || content->starts_with("PK"))) {
    content = unpacked(file);
    HAPTICELL_TRY(content);
    changed = true;
  }
  const StepOutline outline = outlineOfStep(*content);
  if (outline.tessellated > 0 && outline.exact_faces == 0) {
    return makeError(
        {.found = Text("it contains only tessellated shapes (%1, triangles as in AP242), which are not supported",
                       outline.tessellated),
         .expected = "solids or surfaces with exact faces",
         .fix = "Export it with exact shapes (B-rep), or its triangles as STL, OBJ or 3MF."});
  }
  if (outline.tessellated > 0) {
    result.warnings_.push_back(
        Text("%1 tessellated shapes (triangles as in AP242) are left out; exact shapes are read", outline.tessellated));
  }
  if (outline.joints > 0) result.warnings_.push_back(Text("joints are left out; all parts are read as rigid bodies"));
  if (!outline.raw.empty()) {
    std::string encoding;
    *content = withNamesConverted(*content, outline, encoding);
    result.warnings_.push_back(Text("%1 texts, which can include part names, have no stated encoding; %2 is assumed",
                                    outline.raw.size(), Text(wordsOf(encoding).for_people)));
    changed = true;
  }
  std::string_view text = *content;
  if (text.starts_with(kMark)) {
    text.remove_prefix(kMark.size());
    changed = true;
  }
  if (!changed) return result;
  result.descriptor_ = ::memfd_create("step", MFD_CLOEXEC);
  for (std::size_t done = 0; result.descriptor_ >= 0 && done < text.size();) {
    const ssize_t count = ::write(result.descriptor_, text.data() + done, text.size() - done);
    if (count <= 0) return makeError({.found = "not enough memory for the text of the file"});
    done += static_cast<std::size_t>(count);
  }
  result.name_ = "/proc/self/fd/" + std::to_string(result.descriptor_);
  return result;
}

StepText::StepText(StepText&& other) noexcept
    : name_(std::move(other.name_)), descriptor_(other.descriptor_), warnings_(std::move(other.warnings_)) {
  other.descriptor_ = -1;
}

StepText::~StepText() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace hapticell::importer
