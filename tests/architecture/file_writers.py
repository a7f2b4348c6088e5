#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every file is written by the one writer (geometry/system/atomic_file.h): nothing in the programs opens a file for writing, renames one
or hands a name to a library that writes, but what is listed here with its reason.

usage: file_writers.py PROJECT_ROOT | --self-test
"""
import pathlib
import re
import sys

# What writes into a file by its name, or gives a file its name.
WRITERS = re.compile(
    r"\bo?fstream\b(?<!ifstream)|\bofstream\b|\bfopen\b|\bfreopen\b|\btmpfile\b|\bmkd?o?stemps?\b|\bmkostemps?\b|\bmkdtemp\b|\bcreat\s*\("
    r"|\bO_WRONLY\b|\bO_RDWR\b|\bO_CREAT\b|\bO_TMPFILE\b|\bQSaveFile\b|\bQTemporary(?:File|Dir)\b|\bQSettings\b"
    r"|(?<!buffer\.open\()\bQIODevice(?:Base)?::(?:Write|ReadWrite|Append|Truncate)|\bQFile::(?:rename|copy|remove|open|write|resize)\b"
    r"|(?:\bfs|\bfilesystem)::(?:rename|copy|copy_file|resize_file)\b|(?<![\w:.>])::rename\s*\("
    r"|\b(?:rename|link)at2?\s*\(|(?<![\w:.>])\bstd::rename\b"
    r"|\bcairo_(?:pdf|ps|svg)_surface_create\s*\(|\bcairo_surface_write_to_png\s*\("
    r"|\barchive_write_open_file(?:name)?\w*\b|\bQ(?:PdfWriter|ImageWriter|Printer)\s+\w+\s*\(|\bsetOutputFileName\b"
    r"|\.save\((?!\)|&|device|buffer|writer)[^)]*\"(?:PNG|JPG|BMP)\"|(?:picture|image|pixmap|frame)\w*(?:\(\))?\.save\((?!&)"
    r"|\b(?:basic|rotating|daily)_(?:file_sink|logger)\w*|\bsqlite3_open\b|\.Write\(\s*file", re.IGNORECASE)

# File: why it may.
ALLOWED = {
    "geometry/system/atomic_file.cpp": "the writer",
    "geometry/system/scratch_folder.cpp": "the writer, of folders",
    "workcell/files/document_lock.cpp": "a lock is no content: it is made where none is, and goes with its owner",
    "workcell/files/autosave.cpp": "the lock of a run's folder; whole copies are handed from a dead run to a living one",
    "workcell/files/pack.cpp": "copies into a folder that has no name yet, read back before it gets one",
    "workcell/scenes/import_process.cpp": "/dev/null, for the importer's output",
    "cli/device/program_answer.cpp": "/dev/null, for what else the asked program says",
    "importer/step_writer.cpp": "writes under the unfinished name that its caller gives it",
    "config/program_log.cpp": "a log grows by lines; its lock keeps other processes of the program from its file",
    "app/shell/crash_guard.cpp": "a signal handler may not allocate; the note goes into the run's own folder",
    "app/shell/crash_report.cpp": "the same, in the folder of reports",
    "app/host/user_settings.cpp": "QSettings writes aside, flushes and renames by itself, and merges what two windows change",
    "app/host/user_settings.h": "the same",
    "app/kit/written_file.cpp": "Qt draws into memory here",
    "haptic/devices/drivers/cyberglove/serial_port.cpp": "a device",
}
# Ports of devices and cables to them are opened for reading and writing.
DEVICES = "haptic/devices/"
DEVICE_WORDS = {"o_rdwr", "o_wronly"}
FOLDERS = ("agents", "app", "cli", "collision", "config", "feel", "geometry", "haptic", "importer", "kinematics", "manipulation",
           "mannequin", "studies", "trajectory", "workcell", "xacro")


def without_comments(text):
    text = re.sub(r"/\*.*?\*/", lambda match: "\n" * match.group().count("\n"), text, flags=re.DOTALL)
    return re.sub(r"//[^\n]*", "", text)


def offences(name, text):
    """Yields a sentence for each line of the file `name` that writes past the writer."""
    if name in ALLOWED:
        return
    for number, line in enumerate(without_comments(text).splitlines(), 1):
        if line.lstrip().startswith("#include"):
            continue
        found = WRITERS.search(line)
        if not found or (name.startswith(DEVICES) and found.group().lower() in DEVICE_WORDS):
            continue
        yield f"{name}:{number}: {found.group()} writes past geometry/system/atomic_file.h: {line.strip()}"


def self_test():
    def found(line):
        return list(offences("cli/a.cpp", line + "\n"))

    for line in ("std::ofstream out(path);", 'FILE* f = fopen(name, "w");', "QSaveFile file(path);", "QTemporaryDir folder;",
                 "file.open(QIODevice::WriteOnly)", "std::filesystem::rename(a, b);", "fs::copy_file(a, b);",
                 "const int f = ::open(p, O_WRONLY | O_CREAT);", "if (::rename(a, b) != 0)", "::mkdtemp(name.data())",
                 "cairo_pdf_surface_create(file.c_str(), w, h)", "archive_write_open_filename(out, p)", "QPdfWriter writer(aside);",
                 'picture.save(file, "JPG", 85);', "window.picture().save(path)", "std::fstream both(path);", "QFile::rename(a, b)",
                 "std::make_shared<spdlog::sinks::rotating_file_sink_mt>(path, 1, 2)"):
        assert found(line), line
    for line in ("std::ifstream in(path);", "painter.save();", "// std::ofstream out;", "cairo_pdf_surface_create_for_stream(f, &b, w, h)",
                 "archive_write_open_fd(out, file)", "document_.save(path)", "file.open(QIODevice::ReadOnly)", "list.rename(a, b);",
                 "#include <QPdfWriter>", "picture.save(&buffer, format)", "void rename(const std::string& name);"):
        assert not found(line), line


def main():
    if sys.argv[1] == "--self-test":
        self_test()
        print("1 passed, 0 failed")
        return 0
    root = pathlib.Path(sys.argv[1])
    bad, read = [], 0
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in (".h", ".cpp"):
                read += 1
                bad += offences(path.relative_to(root).as_posix(), path.read_text(encoding="utf-8"))
    bad += [f"tests/architecture/file_writers.py: there is no {name} any more" for name in ALLOWED if not (root / name).is_file()]
    print("\n".join(bad) if bad else f"{read} files write by the one writer")
    return 1 if bad or read == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
