#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the typed stubs of the package from the module itself: _engine.pyi from what pybind11 says of each function, and
__init__.pyi with the commands of the program's grammar. So they never differ from what is there.

usage: write_stubs.py FOLDER_OF_THE_PACKAGE
"""
import inspect
import pathlib
import re
import sys

sys.path[0] = str(pathlib.Path(sys.argv[1]).parent)  # Not the sources beside this file: they have no module.
import hapticell  # noqa: E402
from hapticell import _commands, _engine  # noqa: E402

HEAD = "# Written by python/write_stubs.py.\nfrom __future__ import annotations\n"
#: Arguments that are object for pybind11, by name.
ARGUMENTS = {
    "pose": "PoseLike", "pose_a": "PoseLike", "pose_b": "PoseLike", "other_pose": "PoseLike", "reference": "PoseLike",
    "poses": "ArrayLike", "joints": "ArrayLike | None", "start": "ArrayLike | None", "times": "ArrayLike", "vertices": "ArrayLike",
    "triangles": "ArrayLike", "point": "ArrayLike", "normal": "ArrayLike", "direction": "ArrayLike", "gaps": "ArrayLike",
    "gradients": "ArrayLike", "velocity": "ArrayLike | None", "acceleration": "ArrayLike | float | None",
    "jerk": "ArrayLike | None", "file": "str | os.PathLike[str]", "what": "str | os.PathLike[str]",
    "progress": "Progress | None", "hand": "ArrayLike | Callable[[float, Felt], Any]",
}
#: Results that pybind11 calls object, by name.
RESULTS = {"trace": "NDArray[Any]", "device": "Result", "state": "Felt", "session": "Result", "scores": "Result", "ik_batch": "Result",
           "distances": "Any", "free_ik": "list[NDArray[np.float64]]"}


def python_type(text):
    """pybind11's word for a type, as Python writes it."""
    text = re.sub(r"hapticell\._engine\.", "", text)
    text = re.sub(r"numpy\.ndarray(\[numpy\.(\w+)\])?", lambda m: f"NDArray[{'np.' + m.group(2) if m.group(2) else 'Any'}]", text)
    for old, new in (("List[", "list["), ("Tuple[", "tuple["), ("Dict[", "dict["), ("handle", "object"), ("numpy.dtype", "Any")):
        text = text.replace(old, new)
    text = re.sub(r"Optional\[((?:[^\[\]]|\[[^\]]*\])*)\]", r"\1 | None", text)
    text = re.sub(r"(\w+)\[\d+\]", r"\1", text)
    text = re.sub(r"numpy\.ndarray\[bool\]|NDArray\[Any\]\[bool\]", "NDArray[np.bool_]", text)
    return re.sub(r"Annotated\[(.*?), .*?\]", r"\1", text)


def split_arguments(text):
    """At commas outside of brackets."""
    parts, depth, at = [], 0, 0
    for i, c in enumerate(text):
        depth += (c in "[(") - (c in "])")
        if c == "," and depth == 0:
            parts.append(text[at:i].strip())
            at = i + 1
    last = text[at:].strip()
    return parts + [last] if last else parts


def signature_of(name, documentation):
    """(arguments, result) of pybind11's first line."""
    first = documentation.splitlines()[0]
    match = re.match(r"\w+\((.*)\) -> (.*)$", first)
    if not match:
        raise SystemExit(f"{name}: no signature in {first!r}")
    arguments = []
    for argument in split_arguments(match.group(1)):
        if argument.startswith("*") or ":" not in argument:
            arguments.append(argument.split(":")[0])
            continue
        word, kind = argument.split(":", 1)
        kind, _, default = kind.partition("=")
        kind = python_type(kind.strip())
        if word == "self" or re.fullmatch(r"arg\d+", word):
            arguments.append("self" if not arguments else f"{word}: {kind}")
            continue
        kind = ARGUMENTS.get(word, kind) if kind == "object" else kind
        arguments.append(f"{word}: {kind}" + (" = ..." if default else ""))
    result = python_type(match.group(2))
    return arguments, RESULTS.get(name, "Any") if result == "object" else result


def text_of(documentation, indent):
    lines = [line for line in (documentation or "").strip().splitlines()]
    if lines and re.match(r"\w+\(.*\) -> ", lines[0]):
        lines = lines[1:]
    text = "\n".join(lines).strip().replace("\\", "\\\\")
    return [f'{indent}"""{text}"""'] if text else []


def stub_of_method(name, member):
    static = isinstance(member, staticmethod)
    function = member.__func__ if static else member
    arguments, result = signature_of(name, function.__doc__)
    if not static and (not arguments or arguments[0] != "self"):
        arguments = ["self", *arguments[1:]]
    lines = ["    @staticmethod"] if static else []
    lines.append(f"    def {name}({', '.join(arguments)}) -> {result}:")
    return [*lines, *text_of(function.__doc__, " " * 8), "        ..."]


def stub_of_class(name, cls):
    lines = [f"class {name}:", *text_of(cls.__doc__, "    ")]
    for member_name, member in vars(cls).items():
        if member_name.startswith("__") and member_name not in ("__init__", "__len__", "__getitem__", "__setitem__", "__contains__",
                                                                "__float__", "__bool__", "__enter__", "__exit__"):
            continue
        if member_name in ("_repr_png_", "step", "render") or inspect.isfunction(member):
            continue
        if isinstance(member, property):
            told = member.fget.__doc__ or ""
            result = signature_of(member_name, f"{member_name}{told}")[1] if told.startswith("(") else "Any"
            lines += ["    @property", f"    def {member_name}(self) -> {result}:", *text_of(member.__doc__, " " * 8), "        ..."]
            if member.fset is not None:
                lines += [f"    @{member_name}.setter", f"    def {member_name}(self, value: Any) -> None: ..."]
        elif member_name == "__init__" and "-> None" not in (member.__doc__ or ""):
            continue  # Made by the engine alone.
        elif callable(member) or isinstance(member, staticmethod):
            lines += stub_of_method(member_name, member)
    if name == "Workcell":
        lines += ["    def step(self, text: str) -> contextlib.AbstractContextManager[Workcell]: ...",
                  "    def render(self, file: str | os.PathLike[str] | None = None, *, size: tuple[int, int] = ..., view: str = ...,",
                  "               theme: str = ...) -> bytes: ...", "    def __iter__(self) -> Iterator[str]: ...",
                  "    def _repr_png_(self) -> bytes | None: ..."]
    return lines + ["    ..."] if len(lines) == 1 else lines


def engine_stub():
    lines = [HEAD, '"""HaptiCell\'s engine. Use it as `import hapticell`."""', "import contextlib", "import os",
             "from collections.abc import Callable, Iterator", "from typing import Any", "", "import numpy as np",
             "from numpy.typing import ArrayLike, NDArray", "", "from ._results import Records, Result", "",
             "#: None (identity), x, y, z, qw, qx, qy, qz, or a 4 x 4 matrix.", "PoseLike = ArrayLike | None",
             "Progress = Callable[[float, str], object]", "__version__: str", ""]
    for name, value in vars(_engine).items():
        if inspect.isclass(value):
            lines += [*stub_of_class(name, value), ""]
        elif inspect.isbuiltin(value):
            arguments, result = signature_of(name, value.__doc__)
            lines += [f"def {name}({', '.join(arguments)}) -> {result}:", *text_of(value.__doc__, "    "), "    ...", ""]
    return "\n".join(lines)


def command_type(option):
    if option["flag"]:
        return "bool"
    many = option["repeated"] or option["values"][1] != 1
    return "Value | Sequence[Value] | Mapping[str, object]" if many else "Value"


def stub_of_command(command, indent=""):
    """A class with __call__ and the commands below, and the object of it."""
    name = "_" + command.__qualname__.replace(".", "_")
    lines = [f"class {name}:"]
    if command._runs:
        kinds = {_commands.python_name(option["name"]): command_type(option) for option in command._options}
        words, named = ["self"], False
        for parameter in command.__signature__.parameters.values():
            if parameter.kind == parameter.KEYWORD_ONLY and not named:
                words.append("*")
                named = True
            kind = kinds.get(parameter.name, "Progress | None")
            optional = parameter.default is not parameter.empty
            words.append(f"{parameter.name}: {kind}{' | None' if optional and kind != 'bool' and 'None' not in kind else ''}"
                         f"{' = ...' if optional else ''}")
        lines += [f"    def __call__({', '.join(words)}) -> Any:", *text_of(command.__doc__, " " * 8), "        ..."]
    below = []
    for short, one in command._commands.items():
        below += stub_of_command(one)
        lines.append(f"    {short}: _{one.__qualname__.replace('.', '_')}")
    return [*below, *(lines if len(lines) > 1 else [*lines, "    ..."]), ""]


def package_stub():
    classes = [name for name in hapticell.__all__ if hasattr(_engine, name)]
    lines = [HEAD, '"""HaptiCell: see help(hapticell)."""', "import os", "from collections.abc import Mapping, Sequence", "from typing import Any", "",
             "from numpy.typing import ArrayLike", "", "from ._engine import Progress, __version__ as __version__",
             *(f"from ._engine import {name} as {name}" for name in classes), "from ._errors import Error as Error, Notice as Notice",
             "from ._results import Records as Records, Result as Result", "",
             "#: What an option takes: text, a number, a file, what stands for one, or an array.",
             "Value = str | float | os.PathLike[str] | Workcell | Trajectory | Mesh | Mapping[str, object] | ArrayLike", "",
             "class ForceLoop:", "    def __init__(self, *args: object, **kwargs: object) -> None: ...", ""]
    for command in hapticell._functions.values():
        lines += stub_of_command(command)
        lines += [f"{command.__name__}: _{command.__qualname__}", ""]
    return "\n".join(lines)


def main():
    folder = pathlib.Path(sys.argv[1])
    for name, text in (("_engine.pyi", engine_stub()), ("__init__.pyi", package_stub())):
        compile(text, name, "exec")  # It must at least be Python.
        (folder / name).write_text(text, encoding="utf-8")


main()
