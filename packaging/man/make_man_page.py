#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes a program's man page from what it prints for --help and --version, those of its commands included.

usage: make_man_page.py PROGRAM OUTPUT [RELATED_PROGRAM...]
       HAPTICELL_EMULATOR in the environment runs PROGRAM, where it is one for another processor
"""
import os
import pathlib
import re
import subprocess
import sys

ENTRY = re.compile(r"^ {2,}(\S.*?)(?:\s{2,}(\S.*))?$")
# No line that is broken to the width of a terminal, no words of another language.
ENVIRONMENT = {**os.environ, "LC_ALL": "C", "COLUMNS": "4000"}


EMULATOR = os.environ.get("HAPTICELL_EMULATOR", "").split()


def said(program, *words):
    return subprocess.run([*EMULATOR, program, *words], capture_output=True, text=True, check=True, timeout=60, env=ENVIRONMENT).stdout


def quoted(text):
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\\&" + text if text[:1] in ".'" else text


def sections(text):
    """[(heading or "", lines)]: a heading is a line that ends with a colon and is not indented."""
    found = [("", [])]
    for line in text.splitlines():
        heading = re.match(r"^([A-Z][A-Za-z ]*):\s*$", line)
        usage = re.match(r"^(?:Usage|usage): (.*)", line)
        if heading:
            found.append((heading.group(1), []))
        elif usage:
            found += [("Usage", [usage.group(1)]), ("", [])]
        else:
            found[-1][1].append(line)
    return found


def entries(lines):
    """[(names, meaning)] of a list of options or commands; a line without names goes on with the one before."""
    found, column = [], None
    for line in lines:
        if not line.strip():
            continue
        match, indent = ENTRY.match(line), len(line) - len(line.lstrip())
        goes_on = found and indent > 6
        if match and not goes_on:
            found.append([match.group(1), match.group(2) or ""])
        elif found:
            found[-1][1] += " " + line.strip()
    return [(names, meaning.strip()) for names, meaning in found]


def listed(lines):
    page = []
    for names, meaning in entries(lines):
        page += [".TP", f".B {quoted(names)}", quoted(meaning) or "\\&"]
    return page


def paragraphs(lines):
    page = []
    for block in "\n".join(lines).strip().split("\n\n"):
        text = " ".join(block.split())
        if text:
            page += [".PP", quoted(text)]
    return page


def is_list(lines):
    filled = [line for line in lines if line.strip()]
    return bool(filled) and filled[0].startswith("  ")


def command_pages(program, words, help_text):
    """The commands below, each with its own help, as sub-sections."""
    page = []
    for heading, lines in sections(help_text):
        if heading != "Subcommands":
            continue
        for name, _ in entries(lines):
            below = said(program, *words, name, "--help")
            page.append(f".SS {quoted(' '.join([*words, name]))}")
            for title, part in sections(below):
                if title == "Usage":
                    page += [".PP", f".B {quoted(part[0])}"]
                elif title != "Subcommands":
                    kept = [line for line in part if not re.match(r"^\s+-h,--help\s", line)]
                    page += listed(kept) if is_list(kept) else paragraphs(kept)
            page += command_pages(program, [*words, name], below)
    return page


def main(program, output, related):
    name = pathlib.Path(program).name
    version = said(program, "--version").splitlines()
    number = version[0].split()[-1]
    text = said(program, "--help")
    parts = sections(text)
    words = " ".join(" ".join(lines) for heading, lines in parts if heading == "" and not is_list(lines)).strip()
    summary = re.split(r"(?<=[a-z)])[.:;] |\.$|, which", words)[0]
    # .ad l: long words, such as lists of choices, leave gaps in lines that are stretched.
    page = [f'.TH {name.upper()} 1 "" "HaptiCell {number}" "User Commands"', ".ad l", ".SH NAME",
            f"{quoted(name)} \\- {quoted(summary)}", ".SH SYNOPSIS"]
    for heading, lines in parts:
        if heading == "Usage":
            usage = re.sub(r"^\S*" + re.escape(name), name, lines[0])
            page += [f".B {quoted(usage)}"]
    page += [".SH DESCRIPTION", *paragraphs([line for heading, lines in parts if heading == "" and not is_list(lines)
                                             for line in lines])]
    for heading, lines in parts:
        if heading not in ("", "Usage", "Subcommands") or (heading == "" and is_list(lines)):
            page += [f".SH {quoted((heading or 'Options').upper())}"]
            closing = [k for k, line in enumerate(lines) if line and not line.startswith(" ")]
            end = closing[0] if closing else len(lines)
            page += listed(lines[:end]) + paragraphs(lines[end:])
    commands = command_pages(program, [], text)
    if commands:
        page += [".SH COMMANDS", *commands]
    others = ", ".join(f".BR {quoted(other)} (1)" for other in sorted(related) if other != name).split(", ")
    page += [".SH SEE ALSO", *[line + (" ," if k + 1 < len(others) else "") for k, line in enumerate(others)]] if related else []
    pathlib.Path(output).parent.mkdir(parents=True, exist_ok=True)
    pathlib.Path(output).write_text("\n".join(page) + "\n")


main(sys.argv[1], sys.argv[2], sys.argv[3:])
