#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Keeps SECURITY.md's rule on programs that are started: by absolute path and argument list, never through a shell.

usage: started_programs.py PROJECT_ROOT | --self-test
"""
import pathlib
import re
import sys

from source_folders import SOURCES

# What starts a program through a shell, or looks for it in PATH as PATH happens to be.
FORBIDDEN = re.compile(r"(?<![\w.>:])(?<!DualSystem )(?:std::|::)?(?:system|popen|execlp|execvp|execvpe|posix_spawnp|wordexp)\s*\("
                       r"|\bQDesktopServices\b|\bstartCommand\s*\(|\bQProcess::execute\b|\bfindExecutable\b"
                       r"|\b(?:start|startDetached|setProgram)\s*\(\s*(?:QStringLiteral\(|QLatin1String\()?\"(?!/)")
# Who may start one at all; what each starts. A new place belongs here once its path is absolute.
MAY_START = {
    "workcell/scenes/import_process.cpp": "the importer beside the program",
    "app/kit/system_open.cpp": "xdg-open, by config::systemProgram()",
    "app/kit/video_writer.cpp": "ffmpeg, by config::systemProgram()",
    "app/virtual_desktop/devices/server_process.cpp": "the haptic server beside the program",
    "app/virtual_desktop/devices/device_listing.cpp": "hapticell-cli beside the program",
    "app/console/console_link.cpp": "Python, by an absolute path or config::systemProgram()",
    "cli/device/device_list.cpp": "itself, to ask a driver apart",
    "studies/cluster/program_call.cpp": "Slurm's commands, by config::systemProgram()",
    "cli/ros2/bridge_call.cpp": "hapticell-ros2 beside the program",
    "app/ros2/ros2_process.cpp": "hapticell-ros2 beside the program",
    "cli/device/program_answer.cpp": "the window beside the program, for doctor",
}
STARTS = re.compile(r"\bQProcess\b|\bposix_spawn\s*\(|\bexecv[e]?\s*\(|(?<![\w.>:])fork\s*\(")
COMMENT = re.compile(r"//[^\n]*")


def offences(name, text):
    text = COMMENT.sub("", text)
    for number, line in enumerate(text.splitlines(), 1):
        if FORBIDDEN.search(line):
            yield f"{name}:{number}: {line.strip()}: starts a program through a shell or by PATH"
        if STARTS.search(line) and re.sub(r"\.h$", ".cpp", name) not in MAY_START:
            yield f"{name}:{number}: {line.strip()}: starts a program; see SECURITY.md and this test's list"


def self_test():
    for bad in ('std::system("ls");', 'FILE* f = ::popen(x, "r");', "execvp(a, b);", "posix_spawnp(&id, a);",
                'process.start("ffmpeg", arguments);', 'QProcess::startDetached(QStringLiteral("xdg-open"), {});',
                "QDesktopServices::openUrl(url);", 'p.startCommand("a b");', 'QStandardPaths::findExecutable("x")'):
        assert list(offences("app/kit/video_writer.cpp", bad)), bad
    for good in ("process.start(program, arguments);", "QLocale::system().language()", "timer_.start(20);", "thread.start();",
                 "clock.system(1)", "motion.start(x);", "// system(x)"):
        assert not list(offences("app/kit/video_writer.cpp", good)), good
    assert list(offences("app/new.cpp", "QProcess process;"))


if sys.argv[1] == "--self-test":
    self_test()
    sys.exit(0)
root = pathlib.Path(sys.argv[1])
found = [offence for folder in SOURCES for file in sorted((root / folder).rglob("*")) if file.suffix in (".cpp", ".h")
         for offence in offences(file.relative_to(root).as_posix(), file.read_text(errors="replace"))]
print("\n".join(found))
gone = [name for name in MAY_START if not (root / name).is_file()]
assert not gone, f"no longer there: {gone}"
sys.exit(1 if found else 0)
