#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the command-line examples of the documents and compares what they print.

An example is a fenced block marked `console`. Lines that begin with "$ " are commands; a backslash at the end, an open
quote or an open here-document continues a command on the next line. The lines below are the expected output (standard
output and standard error together). "..." stands for what the document leaves out: alone on a line for any lines,
within a line for any text. All blocks of a page run in one scratch folder that holds a copy of config/.

usage: documented_commands_test.py FOLDER_OF_PROGRAMS PROJECT_ROOT [PAGE.md ...]
"""
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

FENCE = re.compile(r"^( *)```console\s*$")
HERE_DOCUMENT = re.compile(r"<<-?\s*'?(\w+)'?")


def blocks_of(page: pathlib.Path):
    """The console blocks of a page: (number of the first line, its lines)."""
    first, indent, block = 0, "", None
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        if block is None:
            fence = FENCE.match(line)
            if fence:
                first, indent, block = number + 1, fence.group(1), []
        elif line.strip() == "```":
            yield first, block
            block = None
        else:
            block.append(line[len(indent):] if line.startswith(indent) else line)
    if block is not None:
        raise SystemExit(f"{page}:{first}: the block has no end")


def is_complete(command: str) -> bool:
    """Whether a shell would not wait for another line."""
    if command.endswith("\\"):
        return False
    here = HERE_DOCUMENT.search(command)
    if here:
        return command.splitlines()[-1] == here.group(1)
    return command.count("'") % 2 == 0


def examples_of(page: pathlib.Path):
    """(line, command, expected lines) of each example of a page, in order."""
    for first, lines in blocks_of(page):
        at = 0
        if lines and not lines[0].startswith("$ "):
            raise SystemExit(f"{page}:{first}: a console block begins with a command, '$ ...'")
        while at < len(lines):
            start, command = at, lines[at][2:]
            at += 1
            while not is_complete(command):
                if at == len(lines):
                    raise SystemExit(f"{page}:{first + start}: the command does not end")
                command += "\n" + lines[at]
                at += 1
            expected = []
            while at < len(lines) and not lines[at].startswith("$ "):
                expected.append(lines[at])
                at += 1
            yield first + start, command, expected


def matches_line(expected: str, line: str) -> bool:
    return re.fullmatch(".*".join(re.escape(part) for part in expected.rstrip().split("...")), line.rstrip()) is not None


def difference(expected, printed):
    """What is wrong, or None. Lines between two '...' are searched for as a run, first place first."""
    runs, run = [], []
    for line in expected:
        if line.strip() == "...":
            runs.append(run)
            run = []
        else:
            run.append(line)
    runs.append(run)
    at = 0
    for index, wanted in enumerate(runs):
        is_first, is_last = index == 0, index == len(runs) - 1
        if is_last and not is_first:
            places = [len(printed) - len(wanted)] if len(printed) - len(wanted) >= at else []
        elif is_first:
            places = [0]
        else:
            places = range(at, len(printed) - len(wanted) + 1)
        for place in places:
            if len(printed) >= place + len(wanted) and all(map(matches_line, wanted, printed[place:])):
                at = place + len(wanted)
                break
        else:
            return "expected, but not found:\n" + "\n".join("  " + line for line in wanted)
    if len(runs) == 1 and at != len(printed):
        return "more is printed than expected, from:\n  " + printed[at]
    return None


def check_page(page: pathlib.Path, programs: pathlib.Path, root: pathlib.Path):
    examples = list(examples_of(page))
    failures = []
    if not examples:
        return page, 0, failures
    with tempfile.TemporaryDirectory(prefix="hapticell-docs-") as scratch:
        shutil.copytree(root / "config", pathlib.Path(scratch) / "config")
        environment = dict(os.environ, PATH=f"{programs}:{os.environ['PATH']}", HOME=scratch, LC_ALL="C.UTF-8",
                           XDG_CONFIG_HOME=f"{scratch}/.config", XDG_STATE_HOME=f"{scratch}/.state",
                           XDG_CACHE_HOME=f"{scratch}/.cache", XDG_DATA_HOME=f"{scratch}/.data")
        status = 0
        for line, command, expected in examples:
            run = subprocess.run(["bash", "-c", f"(exit {status})\n{command}"], cwd=scratch, env=environment, text=True,
                                 stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=60)
            status = run.returncode
            wrong = difference(expected, run.stdout.splitlines())
            if wrong:
                failures.append(f"{page.relative_to(root)}:{line}: $ {command}\n{wrong}\nprinted:\n"
                                + "\n".join("  " + text for text in run.stdout.splitlines()[:60]))
    return page, len(examples), failures


def main() -> int:
    programs, root = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    pages = [pathlib.Path(page).resolve() for page in sys.argv[3:]] or sorted((root / "docs").rglob("*.md"))
    count, failures = 0, []
    with concurrent.futures.ThreadPoolExecutor(max_workers=max(2, os.cpu_count() or 1)) as pool:
        for _, examples, wrong in pool.map(lambda page: check_page(page, programs, root), pages):
            count += examples
            failures += wrong
    for failure in failures:
        print(failure, "\n")
    print(f"{count} examples, {len(failures)} differ from what the documents show")
    return 1 if failures or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
