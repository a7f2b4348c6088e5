// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/nesting_limit.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace hapticell::geometry {

namespace {

/// Where a text nests too deeply, and what is too much there.
struct TooMuch {
  std::size_t place;
  Text found, expected;
};

TooMuch tooDeep(std::size_t place, Text found, int most) {
  return {place, std::move(found), Text("at most %1 levels", most)};
}

/// Behind the string that begins with the quote at `i`.
std::size_t behindString(std::string_view text, std::size_t i) {
  const char quote = text[i];
  for (++i; i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"') {
      ++i;
    } else if (text[i] == quote) {
      return i + 1;
    }
  }
  return text.size();
}

std::optional<TooMuch> lookAtJson(std::string_view text, bool ordered) {
  std::vector<std::size_t> members;  // Of each list and object that is open.
  for (std::size_t i = text.find_first_of("\"[]{}:"); i < text.size(); i = text.find_first_of("\"[]{}:", i)) {
    const char c = text[i];
    if (c == '"') {
      i = behindString(text, i);
      continue;
    }
    if (c == '[' || c == '{') {
      members.push_back(0);
      if (members.size() > static_cast<std::size_t>(kDeepestNesting))
        return tooDeep(i, Text("lists and objects nested deeper than %1", kDeepestNesting), kDeepestNesting);
    } else if (c == ':') {
      if (ordered && !members.empty() && ++members.back() > kMostMembers)
        return TooMuch{i, Text("an object of more than %1 members", kMostMembers), Text("at most %1", kMostMembers)};
    } else if (!members.empty()) {
      members.pop_back();
    }
    ++i;
  }
  return std::nullopt;
}

/// Behind what begins at `i` and ends with `end`; the text's end where it does not.
std::size_t behind(std::string_view text, std::size_t i, std::string_view end) {
  const std::size_t found = text.find(end, i);
  return found == std::string_view::npos ? text.size() : found + end.size();
}

struct Tag {
  std::size_t end;      ///< Behind it.
  bool closed = false;  ///< It is an element by itself.
  std::size_t attributes = 0;
};

/// The tag that begins at `i`; '>' in its values counts for nothing.
Tag tagAt(std::string_view text, std::size_t i) {
  Tag tag{text.size()};
  char mark = '\0';
  for (std::size_t at = i; at < text.size(); ++at) {
    const char c = text[at];
    if (mark != '\0') {
      if (c == mark) mark = '\0';
    } else if (c == '"' || c == '\'') {
      mark = c;
    } else if (c == '=') {
      ++tag.attributes;
    } else if (c == '>') {
      tag.closed = text[at - 1] == '/';
      tag.end = at + 1;
      break;
    }
  }
  return tag;
}

std::optional<TooMuch> lookAtXml(std::string_view text) {
  int depth = 0;
  for (std::size_t i = text.find('<'); i < text.size(); i = text.find('<', i)) {
    if (text.compare(i, 4, "<!--") == 0) {
      i = behind(text, i, "-->");
    } else if (text.compare(i, 9, "<![CDATA[") == 0) {
      i = behind(text, i, "]]>");
    } else if (text.compare(i, 2, "</") == 0) {
      depth = std::max(0, depth - 1);
      ++i;
    } else if (text.compare(i, 2, "<!") == 0 || text.compare(i, 2, "<?") == 0) {
      ++i;
    } else {
      const Tag tag = tagAt(text, i);
      if (depth + 1 > kDeepestNesting)
        return tooDeep(i, Text("elements nested deeper than %1", kDeepestNesting), kDeepestNesting);
      if (tag.attributes > kMostAttributes)
        return TooMuch{i, Text("an element with more than %1 attributes", kMostAttributes),
                       Text("at most %1", kMostAttributes)};
      i = tag.end;
      if (!tag.closed) ++depth;
    }
  }
  return std::nullopt;
}

/// Behind a string of TOML, which may have three quotes and then go over lines.
std::size_t behindTomlString(std::string_view text, std::size_t i) {
  const std::string three(3, text[i]);
  if (text.compare(i, 3, three) != 0) {
    const char quote = text[i];
    for (++i; i < text.size() && text[i] != '\n'; ++i) {
      if (text[i] == '\\' && quote == '"') {
        ++i;
      } else if (text[i] == quote) {
        return i + 1;
      }
    }
    return i;
  }
  for (i += 3; i < text.size(); ++i) {
    if (text[i] == '\\' && three[0] == '"') {
      ++i;
    } else if (text.compare(i, 3, three) == 0) {
      i += 3;
      while (i < text.size() && text[i] == three[0]) ++i;  // Up to two more belong to the text.
      return i;
    }
  }
  return text.size();
}

std::optional<TooMuch> lookAtToml(std::string_view text) {
  int depth = 0, dots = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      i = behindTomlString(text, i);
      continue;
    }
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') depth = std::max(0, depth - 1);
    if (c == '.') ++dots;
    if (c == '\n' || c == ',' || c == '=' || c == '[' || c == '{') dots = 0;
    if (depth > kDeepestToml || dots >= kDeepestToml)
      return tooDeep(i, Text("tables and lists nested deeper than %1", kDeepestToml), kDeepestToml);
    ++i;
  }
  return std::nullopt;
}

std::optional<TooMuch> look(std::string_view text, NestedText kind) {
  switch (kind) {
    case NestedText::kXml: {
      if (text.find('\0') == std::string_view::npos) return lookAtXml(text);
      std::string narrow(text);  // UTF-16, perhaps: its tags stand between zeros.
      std::erase(narrow, '\0');
      return lookAtXml(narrow);
    }
    case NestedText::kToml:
      return lookAtToml(text);
    case NestedText::kJson:
    case NestedText::kOrderedJson:
      break;
  }
  return lookAtJson(text, kind == NestedText::kOrderedJson);
}

}  // namespace

Expected<void> checkNesting(std::string_view text, NestedText kind, const std::string& file) {
  const auto found = look(text, kind);
  if (!found) return {};
  const std::string_view before = text.substr(0, std::min(found->place, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  return makeError({.file = file, .place = Text("line %1", line), .found = found->found, .expected = found->expected});
}

}  // namespace hapticell::geometry
