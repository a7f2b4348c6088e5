#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Texts are ids with arguments, translated in one place: no language is asked for by `kFrench ? ... : ...`, no source that
has to do with geometry/system/text.h looks at sentences with a pattern, and translations have the places of their texts.

usage: library_texts.py PROJECT | --self-test
"""
import pathlib
import re
import sys
import xml.etree.ElementTree as ET

FOLDERS = ("agents", "app", "cli", "collision", "config", "feel", "geometry", "haptic", "importer", "kinematics", "manipulation",
           "mannequin", "studies", "trajectory", "workcell", "xacro")
LANGUAGE = re.compile(r"\bk(French|English)\s*\?")
TEXTS = re.compile(r'#include "(geometry/system/text|app/style/library_text)\.h"')
PATTERN = re.compile(r"\bQRegularExpression\b|\bstd::regex\b")
PLACE = re.compile(r"%[1-9]")


def offences(source):
    found = [(match, "a language is asked for: take a translated text (mannequin/ergonomics/scores/score_words.h)")
             for match in LANGUAGE.finditer(source)]
    if TEXTS.search(source):
        found += [(match, "a pattern beside texts of libraries: compare Text::id(), or take its arguments")
                  for match in PATTERN.finditer(source)]
    return [(source.count("\n", 0, match.start()) + 1, why) for match, why in found]


def unlike_places(catalogue):
    """Texts whose translation lacks a place, or has one too many."""
    found = []
    for message in ET.fromstring(catalogue).iter("message"):
        translation = message.find("translation")
        if translation.get("type") == "unfinished" or message.get("numerus") == "yes":
            continue
        text = message.findtext("source")
        if set(PLACE.findall(text)) != set(PLACE.findall(translation.text or "")):
            found.append(text)
    return found


def self_test():
    assert [line for line, _ in offences("\nreturn language == Language::kFrench ? a : b;")] == [2]
    assert offences('#include "app/style/library_text.h"\nQRegularExpression x;')
    assert not offences("QRegularExpression x;") and not offences("case Language::kFrench: return a;")
    entry = "<TS><message><source>%1 of %2</source><translation>{}</translation></message></TS>"
    assert unlike_places(entry.format("%2 : %1")) == [] and unlike_places(entry.format("%1")) == ["%1 of %2"]


if sys.argv[1] == "--self-test":
    self_test()
    sys.exit(0)
project, looked_at, wrong = pathlib.Path(sys.argv[1]), 0, []
for folder in FOLDERS:
    for path in sorted((project / folder).rglob("*")):
        if path.suffix in (".h", ".cpp"):
            looked_at += 1
            wrong += [f"{path.relative_to(project)}:{line}: {why}"
                      for line, why in offences(path.read_text(encoding="utf-8", errors="replace"))]
for path in sorted((project / "app" / "translations").glob("*.ts")):
    wrong += [f"{path.relative_to(project)}: other places than in {text!r}"
              for text in unlike_places(path.read_text(encoding="utf-8"))]
print("\n".join(wrong))
assert looked_at > 500, f"only {looked_at} sources were found"
sys.exit(1 if wrong else 0)
