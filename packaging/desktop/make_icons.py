#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the icons of the program and of its kinds of files, as a desktop looks for them: an SVG, and PNGs where rsvg-convert is.

usage: make_icons.py PICTURES OUTPUT [RSVG_CONVERT]
PICTURES: the folder of the window's own icons. OUTPUT becomes the folder hicolor.
"""
import pathlib
import re
import subprocess
import sys

SIZES = (16, 22, 24, 32, 48, 64, 128, 256, 512)
KINDS = {"workcell": "cell", "motion": "trajectory", "exercise": "hand", "training": "check",
         "study": "grid", "study-results": "filter"}


def inner(picture):
    text = re.sub(r"<!--.*?-->", "", picture.read_text(), flags=re.S)
    box = re.search(r'viewBox="([^"]+)"', text).group(1)
    outer = re.search(r"<svg([^>]*)>", text).group(1)
    style = " ".join(re.findall(r'(?:fill|stroke|stroke-[a-z]+)="[^"]*"', outer))
    return box, style, re.search(r"<svg[^>]*>(.*)</svg>", text, flags=re.S).group(1).strip()


def sheet(picture):
    """The picture on a sheet of paper with the program's mark: dark, as the window's own pictures are bright lines."""
    box, style, shapes = inner(picture)
    shapes = shapes.replace("currentColor", "#ffffff")
    return f"""<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 64 64" width="64" height="64">
<!-- SPDX-License-Identifier: Apache-2.0 -->
<path d="M12 3H42L54 15V61H12Z" fill="#f4f6f8" stroke="#7a8794" stroke-width="1.500" stroke-linejoin="round"/>
<path d="M42 3V15H54Z" fill="#c8d2dc" stroke="#7a8794" stroke-width="1.500" stroke-linejoin="round"/>
<rect x="16" y="21" width="34" height="34" rx="6" fill="#2c5f94"/>
<svg x="20" y="25" width="26" height="26" viewBox="{box}" color="#ffffff" {style.replace("currentColor", "#ffffff")}>{shapes}</svg>
</svg>
"""


def main(pictures, output, convert=""):
    made = {("apps", "hapticell"): (pictures / "hapticell.svg").read_text()}
    for kind, picture in KINDS.items():
        made["mimetypes", f"application-x-hapticell-{kind}"] = sheet(pictures / f"{picture}.svg")
    for (place, name), text in made.items():
        file = output / "scalable" / place / f"{name}.svg"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        for size in SIZES if convert else ():
            picture = output / f"{size}x{size}" / place / f"{name}.png"
            picture.parent.mkdir(parents=True, exist_ok=True)
            subprocess.run([convert, "-w", str(size), "-h", str(size), "-o", str(picture), str(file)], check=True)


main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), *sys.argv[3:4])
