# SPDX-License-Identifier: Apache-2.0
"""The top folders of the program's sources, bottom to top, from folders.txt: the one list of them."""
import pathlib

ORDER = [line.split("#")[0].strip() for line in (pathlib.Path(__file__).parent / "folders.txt").read_text().splitlines()
         if line.split("#")[0].strip()]
SOURCES = tuple(dict.fromkeys(folder.split("/")[0] for folder in ORDER))
# Programs: nothing else may include what they hold.
PROGRAMS = ("importer", "bridge", "cli", "app", "python")
LIBRARIES = tuple(folder for folder in SOURCES if folder not in PROGRAMS)
