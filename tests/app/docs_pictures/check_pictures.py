#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""docs_pictures takes pictures in their sizes, and refuses an empty one and an unknown name.

usage: check_pictures.py DOCS_PICTURES_PROGRAM
"""
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

WANTED = {"robot-library": (345, 980), "swept-volume": (1000, 625)}


def size(path):
    head = path.read_bytes()[:24]
    assert head[:8] == b"\x89PNG\r\n\x1a\n", f"{path} is no PNG"
    return struct.unpack(">II", head[16:24])


def write_empty(path, width, height):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = (b"\0" + b"\x20" * width) * height
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0))
                     + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def main(program):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        only = [word for picture in WANTED for word in ("--only", picture)]
        subprocess.run([program, folder, *only], check=True)
        for picture, pixels in WANTED.items():
            assert size(folder / f"{picture}.png") == pixels, picture
            assert 10_000 < (folder / f"{picture}.png").stat().st_size <= 400_000, picture
        write_empty(folder / "empty-source.png", 40, 30)
        empty = subprocess.run([program, folder, "--file", folder / "empty-source.png", "empty"], capture_output=True, text=True,
                               check=False)
        assert empty.returncode == 1 and "nothing is to be seen" in empty.stderr, empty.stderr
        assert not (folder / "empty.png").exists()
        unknown = subprocess.run([program, folder, "--only", "no-such"], capture_output=True, text=True, check=False)
        assert unknown.returncode == 2 and "no-such" in unknown.stderr, unknown.stderr


if __name__ == "__main__":
    main(sys.argv[1])
