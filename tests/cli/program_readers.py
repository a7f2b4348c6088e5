# SPDX-License-Identifier: Apache-2.0
"""Small readers of robot programs for tests: regular expressions and matrices by hand, nothing of what wrote them.

Each gives a list of (p, R): metres, and the rotation as three rows.
"""
import math
import re
from xml.etree import ElementTree

NUMBER = r"[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?"


def product(A, B):
    return [[sum(A[i][k] * B[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def about(axis, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return {"x": [[1, 0, 0], [0, c, -s], [0, s, c]], "y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
            "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]]}[axis]


def of_quaternion(w, x, y, z):
    n = math.sqrt(w * w + x * x + y * y + z * z)
    w, x, y, z = w / n, x / n, y / n, z / n
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]


def of_vector(x, y, z):
    angle = math.sqrt(x * x + y * y + z * z)
    if angle < 1e-15:
        return [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
    half = math.sin(angle / 2) / angle
    return of_quaternion(math.cos(angle / 2), x * half, y * half, z * half)


def angle_between(A, B):
    """Degrees; from the sine, which is exact where the cosine is not."""
    off = product([[A[j][i] for j in range(3)] for i in range(3)], B)
    sines = (off[2][1] - off[1][2], off[0][2] - off[2][0], off[1][0] - off[0][1])
    cosine = 0.5 * (off[0][0] + off[1][1] + off[2][2] - 1)
    return math.degrees(math.atan2(0.5 * math.sqrt(sum(s * s for s in sines)), cosine))


def numbers(text):
    return [float(n) for n in re.findall(NUMBER, text)]


def field(text, name):
    return float(re.search(r"\b%s\s*=?\s*(%s)" % (name, NUMBER), text).group(1))


def read_krl(folder, stem):
    points = {}
    for name, body in re.findall(r"DECL E6POS (XP\d+)=\{([^}]*)\}", (folder / (stem + ".dat")).read_text()):
        R = product(product(about("z", field(body, "A")), about("y", field(body, "B"))), about("x", field(body, "C")))
        points[name] = ([field(body, axis) / 1000 for axis in "XYZ"], R)
    order = ["XP1"] + re.findall(r"LIN (XP\d+)", (folder / (stem + ".src")).read_text())
    return [points[name] for name in order]


def read_rapid(folder, name):
    targets = []
    for p, q in re.findall(r"robtarget p\d+:=\[\[([^\]]*)\],\[([^\]]*)\]", (folder / name).read_text()):
        targets.append(([v / 1000 for v in numbers(p)], of_quaternion(*numbers(q))))
    return targets


def read_fanuc(folder, name):
    targets = []
    for body in re.findall(r"P\[\d+\]\{([^}]*)\}", (folder / name).read_text()):
        body = body[body.index("',"):]
        R = product(product(about("z", field(body, "R")), about("y", field(body, "P"))), about("x", field(body, "W")))
        targets.append(([field(body, axis) / 1000 for axis in "XYZ"], R))
    return targets


def read_urscript(folder, name):
    targets = []
    for body in re.findall(r"move[jl]\(p\[([^\]]*)\]", (folder / name).read_text()):
        n = numbers(body)
        targets.append((n[:3], of_vector(*n[3:])))
    return targets



def read_val3(folder):
    """By the order in which start.pgx moves to the points; also gives the joints (degrees) of the first move."""
    space = "{http://www.staubli.com/robotics/VAL3/Data/2}"
    data = ElementTree.parse(next(folder.glob("*.dtx"))).getroot()
    arrays = {d.get("name"): d.findall(space + "Value") for d in data.iter(space + "Data")}
    number = lambda value, names: [float(value.get(n)) for n in names.split()]
    code = ElementTree.parse(folder / "start.pgx").getroot().find(".//{*}Code").text
    start = number(arrays["jStart"][0], "j1 j2 j3 j4 j5 j6") if "jStart" in arrays else None
    targets = []
    for index in re.findall(r"movel\(pPoint\[(\d+)\]", code):
        value = arrays["pPoint"][int(index)]
        assert value.get("key") == index and value.get("fatherId") == "world[0]"
        rx, ry, rz = number(value, "rx ry rz")
        R = product(product(about("x", rx), about("y", ry)), about("z", rz))
        targets.append(([v / 1000 for v in number(value, "x y z")], R))
    assert code.rstrip().removesuffix("end").rstrip().endswith("waitEndMove()"), code[-60:]
    return targets, start
