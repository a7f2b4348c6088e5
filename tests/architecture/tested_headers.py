#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that each header of the libraries is used by a test of its own folder: geometry/shapes/pose.h by a source below
tests/geometry/shapes. A test uses a header if it includes it, or if it names a type, a function or a constant that the header
declares at namespace level (the test then gets the header through another one). What is bound for Python is tested from
Python: a header of python/engine by tests/python/NAME_test.py of a source NAME.cpp that includes it.

Folders of ALLOWED may have that many headers without a test; the number must be lowered with each header that gets one.

usage: tested_headers.py PROJECT_ROOT [--list] | --self-test
"""
import collections
import pathlib
import re
import sys

from source_folders import SOURCES

TESTED = tuple(folder for folder in SOURCES if folder != "app")
# By the top folder: headers without a test, from before this check. They become fewer, never more.
ALLOWED = {
    "cli": 8,
    "haptic": 7,
    "manipulation": 3,
    "mannequin": 11,
    "workcell": 7,
}
INCLUDE = re.compile(r'^\s*#\s*include\s*["<]([^">]+)[">]', re.MULTILINE)
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
STRING = re.compile(r'"(?:[^"\\\n]|\\.)*"')
TYPE = re.compile(r"\b(?:class|struct|enum(?:\s+class)?|union)\s+(?:\[\[\w+\]\]\s*)?(\w+)[^;{(]*$")
ALIAS = re.compile(r"\busing\s+(\w+)\s*=")
CONSTANT = re.compile(r"\bconst(?:expr|init)?\b[^=({]*?\b(k[A-Z]\w*)\s*(?:\[[^\]]*\]\s*)?(?:=|$)")
FUNCTION = re.compile(r"(\w+)\s*\(")
MACRO = re.compile(r"^\s*#\s*define\s+(\w+)", re.MULTILINE)
NOT_FUNCTIONS = {"alignas", "decltype", "defined", "explicit", "noexcept", "operator", "requires", "sizeof", "static_assert"}


def statements(text):
    """The declarations of `text` at namespace level, without what stands between their braces; a definition ends in {."""
    depth, begin, found = [], 0, []
    for at, letter in enumerate(text):
        if letter == "{":
            head = text[begin:at]
            is_namespace = re.search(r"\bnamespace\b[\w\s:]*$", head) or re.search(r"\bextern\s*$", head)
            if "body" not in depth and not is_namespace:
                found.append(head + "{")
            depth.append("namespace" if is_namespace else "body")
            begin = at + 1
        elif letter == "}":
            if depth:
                depth.pop()
            if "body" not in depth:
                begin = at + 1
        elif letter == ";" and "body" not in depth:
            found.append(text[begin:at])
            begin = at + 1
    return found


def declared_names(text):
    """The names that a header declares at namespace level, and its macros."""
    text = STRING.sub("", COMMENT.sub("", text))
    names = set(MACRO.findall(text))
    for statement in statements(re.sub(r"^\s*#(?:[^\n]*\\\n)*[^\n]*", "", text, flags=re.MULTILINE)):
        is_definition = statement.endswith("{")
        statement = statement.removesuffix("{").strip()
        is_forward_declaration = re.fullmatch(r"(?:class|struct|enum(?: class)?)\s+\w+", statement)
        if (is_forward_declaration and not is_definition) or statement.startswith("friend"):
            continue
        if alias := ALIAS.search(statement):
            names.add(alias[1])
        elif declared := TYPE.search(statement):
            names.add(declared[1])
        elif constant := CONSTANT.search(statement):
            names.add(constant[1])
        else:
            names |= {name for name in FUNCTION.findall(statement)[:1] if name not in NOT_FUNCTIONS}
    return names


def untested(headers, tests):
    """The headers, of {path: text}, that no test of {path: text} below tests/<their folder> uses."""
    found = []
    for path, text in sorted(headers.items()):
        folder = f"tests/{pathlib.PurePosixPath(path).parent}/"
        near = [test for name, test in tests.items() if name.startswith(folder)]
        if any(path in INCLUDE.findall(test) for test in near):
            continue
        names = declared_names(text)
        used = re.compile(r"\b(?:" + "|".join(map(re.escape, sorted(names))) + r")\b") if names else None
        if not any(used and used.search(STRING.sub("", COMMENT.sub("", test))) for test in near):
            found.append(path)
    return found


def offences(found, allowed):
    """What is wrong with the headers that were found without a test, in sentences."""
    counts = collections.Counter(pathlib.PurePosixPath(path).parts[0] for path in found)
    sentences = []
    for folder in sorted(counts.keys() | allowed.keys()):
        count, most = counts[folder], allowed.get(folder, 0)
        if count > most:
            sentences += [f"{path}: no test below tests/{pathlib.PurePosixPath(path).parent} uses it"
                          for path in found if path.startswith(folder + "/")]
            if most:
                sentences.append(f"{folder}: {count} headers without a test, and only {most} are from before the check")
        elif count < most:
            sentences.append(f'{folder}: {count} headers without a test; in tests/architecture/tested_headers.py, set ALLOWED of it to {count}')
    return sentences


def tested_from_python(headers, sources, tests):
    """The headers of python/engine that a source includes which tests/python has a test of by its name."""
    tested = {pathlib.PurePosixPath(name).name.removesuffix("_test.py") for name in tests if name.startswith("tests/python/")}
    used = {path for name, source in sources.items() if pathlib.PurePosixPath(name).stem in tested
            for path in INCLUDE.findall(source)}
    return {path for path in headers if path.startswith("python/engine/") and path in used}


def self_test():
    header = """#pragma once
#include "a/other.h"
#define A_MACRO(x) x
namespace hapticell::a {
class Elsewhere;
/// using Commented = int;
struct Box final : Base { int inside(int x); };
struct Plain { int x = 0; };
enum class Kind : unsigned { kOne, kTwo };
using Row = int;
inline constexpr double kLargest_m = 3.0;
[[nodiscard]] Expected<Box> boxOf(const Box& box, std::function<int(int)> f = {});
template <class T> T twice(T t) { helper(t); return t; }
}
"""
    assert declared_names(header) == {"A_MACRO", "Box", "Plain", "Kind", "Row", "kLargest_m", "boxOf", "twice"}, declared_names(header)
    headers = {"a/b/box.h": header}
    assert untested(headers, {}) == ["a/b/box.h"]
    assert untested(headers, {"tests/a/c/box_test.cpp": '#include "a/b/box.h"'}) == ["a/b/box.h"]
    assert untested(headers, {"tests/a/b/t.cpp": '// Box\nf("Box"); Boxes b; inside(3); helper(1); Elsewhere e;'}) == ["a/b/box.h"]
    assert not untested(headers, {"tests/a/b/box_test.cpp": '#include "a/b/box.h"'})
    assert not untested(headers, {"tests/a/b/c/t.cpp": "auto x = boxOf(y);"})
    assert not offences(["a/b/x.h", "a/y.h"], {"a": 2})
    assert offences(["a/b/x.h", "c/y.h"], {"a": 1}) == ["c/y.h: no test below tests/c uses it"]
    assert len(offences(["a/b/x.h", "a/y.h"], {"a": 1})) == 3
    assert "to 1" in offences(["a/b/x.h"], {"a": 2})[0] and "to 0" in offences([], {"a": 1})[0]
    engine = {"python/engine/a.h": "", "python/engine/b.h": "", "cli/c.h": ""}
    sources = {"python/engine/meshes.cpp": '#include "python/engine/a.h"\n#include "cli/c.h"',
               "python/engine/other.cpp": '#include "python/engine/b.h"'}
    assert tested_from_python(engine, sources, {"tests/python/meshes_test.py": ""}) == {"python/engine/a.h"}
    assert not tested_from_python(engine, sources, {"tests/other/meshes_test.py": ""})


def main():
    if sys.argv[1] == "--self-test":
        self_test()
        return 0
    root = pathlib.Path(sys.argv[1])

    def texts(top, endings):
        return {path.relative_to(root).as_posix(): path.read_text(encoding="utf-8", errors="replace")
                for path in sorted((root / top).rglob("*")) if path.suffix in endings}

    headers = {path: text for top in TESTED for path, text in texts(top, {".h"}).items()}
    tests = texts("tests", {".cpp", ".h", ".py"})
    from_python = tested_from_python(headers, texts("python/engine", {".cpp"}), tests)
    found = untested({path: text for path, text in headers.items() if path not in from_python}, tests)
    if "--list" in sys.argv[2:]:
        print("\n".join(found))
        return 0
    wrong = offences(found, ALLOWED)
    print("\n".join(wrong) or f"{len(headers)} headers are used by tests of their folders, but for {len(found)} from before the check")
    return 1 if wrong or not headers else 0


if __name__ == "__main__":
    sys.exit(main())
