#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""No conditional operator stands within another one (a ? b : c ? d : e): a function, if/else or a table is easier to read.

usage: conditional_operators.py PROJECT | --self-test
"""
import pathlib
import re
import sys

FOLDERS = ("agents", "app", "bench", "cli", "collision", "config", "examples", "feel", "geometry", "haptic", "importer",
           "kinematics", "manipulation", "mannequin", "studies", "tests", "tools", "trajectory", "workcell", "xacro")
# What holds no code: comments, strings, characters, the preprocessor's lines.
BLANK = re.compile(r'//[^\n]*|/\*.*?\*/|R"([^\s()\\]*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])+\''
                   r"|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.DOTALL | re.MULTILINE)
MARK = re.compile(r"::|[][(){};,?:]")


def offences(text):
    """The lines on which a conditional operator begins that lies within another."""
    plain = BLANK.sub(lambda blank: "\n" * blank.group().count("\n"), text)
    # For each open bracket: how many conditional operators began in the expression read last, how many reached their colon.
    levels, lines = [[0, 0]], []
    for mark in MARK.finditer(plain):
        sign, level = mark.group(), levels[-1]
        if sign in "([{":
            levels.append([0, 0])
        elif sign in ")]}":
            if len(levels) > 1:
                levels.pop()
            if sign == "}" and levels[-1][0] == levels[-1][1]:
                levels[-1] = [0, 0]
        elif sign == ";" or sign == "," and level[0] == level[1]:
            levels[-1] = [0, 0]
        elif sign == ":":
            level[1] = min(level[1] + 1, level[0])
        elif sign == "?":
            if any(begun for begun, _ in levels):
                lines.append(plain.count("\n", 0, mark.start()) + 1)
            level[0] += 1
    return lines


def self_test():
    assert offences("x = a ? b : c ? d : e;") == [1] and offences("x = a ? b\n  : (c ? d : e);") == [2]
    assert offences("x = a ? b ? c : d : e;") and offences("x = a ? std::pair<int, int>(1, 2) : c ? d : e;")
    assert offences("x = a ? P{b ? 1 : 2} : c;") and offences("x = a ? f(1, b ? 1 : 2) : c;")
    assert not offences("f(a ? b : c, d ? e : g); x = (a ? b : c) + (d ? e : g);\ny = a ? b : c; // ? :")
    assert not offences('s = "a ? b : c ? d : e"; c = a ? \'?\' : \':\'; n = 1\'000 + (a ? 1 : 2); m = a ? 1 : 2\'000;')
    assert not offences("F() : a_(x ? 1 : 2), b_{y ? 1 : 2} {}\nif (a ? b : c) { z = d ? e : f; }\n#define M(a) a ? 1 : a ? 2 : 3\n")


if sys.argv[1] == "--self-test":
    self_test()
    sys.exit(0)
project, looked_at, found = pathlib.Path(sys.argv[1]), 0, []
for folder in FOLDERS:
    for source in sorted((project / folder).rglob("*")):
        if source.suffix in (".h", ".cpp"):
            looked_at += 1
            found += [f"{source.relative_to(project)}:{line}: a conditional operator within another"
                      for line in offences(source.read_text(errors="replace"))]
print("\n".join(found))
assert looked_at > 500, f"only {looked_at} sources were found"
sys.exit(1 if found else 0)
