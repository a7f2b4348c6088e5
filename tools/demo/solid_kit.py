# SPDX-License-Identifier: Apache-2.0
"""Small kit of watertight solids: prisms with chamfers, turned parts, placed and joined. Metres, Z up, outward CCW."""
import math
import struct


class Solid:
    """A triangle soup: a list of triangles, each three (x, y, z)."""

    def __init__(self, triangles=None):
        self.triangles = triangles or []

    def __add__(self, other):
        return Solid(self.triangles + other.triangles)

    def map(self, function, flip=False):
        turned = []
        for a, b, c in self.triangles:
            a, b, c = function(a), function(b), function(c)
            turned.append((a, c, b) if flip else (a, b, c))
        return Solid(turned)

    def moved(self, x=0.0, y=0.0, z=0.0):
        return self.map(lambda p: (p[0] + x, p[1] + y, p[2] + z))

    def turned(self, axis, degrees):
        c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        if axis == "x":
            return self.map(lambda p: (p[0], c * p[1] - s * p[2], s * p[1] + c * p[2]))
        if axis == "y":
            return self.map(lambda p: (c * p[0] + s * p[2], p[1], -s * p[0] + c * p[2]))
        return self.map(lambda p: (c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]))

    def mirrored_y(self):
        return self.map(lambda p: (p[0], -p[1], p[2]), flip=True)

    def write_stl(self, path):
        with open(path, "wb") as file:
            file.write(b"HaptiCell demonstration workcell, metres".ljust(80, b" "))
            file.write(struct.pack("<I", len(self.triangles)))
            for a, b, c in self.triangles:
                u = [b[i] - a[i] for i in range(3)]
                v = [c[i] - a[i] for i in range(3)]
                n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
                length = math.sqrt(sum(k * k for k in n)) or 1.0
                file.write(struct.pack("<12fH", *(k / length for k in n), *a, *b, *c, 0))


def _area(profile):
    return 0.5 * sum(x0 * y1 - x1 * y0 for (x0, y0), (x1, y1) in zip(profile, profile[1:] + profile[:1]))


def _inset(profile, distance):
    """Moves every edge of a counter-clockwise profile inwards; small against its features."""
    result = []
    n = len(profile)
    for i in range(n):
        (xa, ya), (xb, yb), (xc, yc) = profile[i - 1], profile[i], profile[(i + 1) % n]
        e0, e1 = (xb - xa, yb - ya), (xc - xb, yc - yb)
        l0, l1 = math.hypot(*e0), math.hypot(*e1)
        n0, n1 = (-e0[1] / l0, e0[0] / l0), (-e1[1] / l1, e1[0] / l1)
        bisector = (n0[0] + n1[0], n0[1] + n1[1])
        scale = 2.0 * distance / max(0.2, bisector[0] ** 2 + bisector[1] ** 2)
        result.append((xb + bisector[0] * scale, yb + bisector[1] * scale))
    return result


def _ears(profile):
    """Triangles of a simple counter-clockwise polygon, as index triples."""
    index = list(range(len(profile)))

    def cross(o, a, b):
        return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])

    result = []
    while len(index) > 3:
        best = None
        for k in range(len(index)):
            i, j, m = index[k - 1], index[k], index[(k + 1) % len(index)]
            a, b, c = profile[i], profile[j], profile[m]
            if cross(a, b, c) <= 1e-15:
                continue
            inside = any(cross(a, b, profile[q]) > -1e-15 and cross(b, c, profile[q]) > -1e-15 and
                         cross(c, a, profile[q]) > -1e-15 for q in index if q not in (i, j, m))
            if not inside:
                quality = math.dist(a, c)
                if best is None or quality < best[0]:
                    best = (quality, k, (i, j, m))
        if best is None:
            break
        result.append(best[2])
        index.pop(best[1])
    if len(index) == 3:
        result.append(tuple(index))
    return result


def prism(profile, z0, z1, chamfer=0.0, bottom_chamfer=None):
    """The profile (x, y), counter-clockwise, from z0 to z1, with chamfers at both ends."""
    if _area(profile) < 0:
        profile = profile[::-1]
    low = chamfer if bottom_chamfer is None else bottom_chamfer
    sections = []
    sections.append((_inset(profile, low) if low > 0 else profile, z0))
    if low > 0:
        sections.append((profile, z0 + low))
    if chamfer > 0:
        sections.append((profile, z1 - chamfer))
        sections.append((_inset(profile, chamfer), z1))
    else:
        sections.append((profile, z1))
    triangles = []
    n = len(profile)
    for (lower, za), (upper, zb) in zip(sections, sections[1:]):
        for i in range(n):
            j = (i + 1) % n
            a, b = (*lower[i], za), (*lower[j], za)
            c, d = (*upper[j], zb), (*upper[i], zb)
            triangles += [(a, b, c), (a, c, d)]
    for i, j, k in _ears(sections[0][0]):
        p, z = sections[0]
        triangles.append(((*p[i], z), (*p[k], z), (*p[j], z)))
    for i, j, k in _ears(sections[-1][0]):
        p, z = sections[-1]
        triangles.append(((*p[i], z), (*p[j], z), (*p[k], z)))
    return Solid(triangles)


def revolve(profile, segments=48):
    """Turns (radius, z) points, from the bottom axis point up the outside to the top axis point, about Z."""
    triangles = []
    ring = [(math.cos(2 * math.pi * i / segments), math.sin(2 * math.pi * i / segments)) for i in range(segments)]
    for (r0, z0), (r1, z1) in zip(profile, profile[1:]):
        for i in range(segments):
            (c0, s0), (c1, s1) = ring[i], ring[(i + 1) % segments]
            a, b = (r0 * c0, r0 * s0, z0), (r0 * c1, r0 * s1, z0)
            c, d = (r1 * c1, r1 * s1, z1), (r1 * c0, r1 * s0, z1)
            if r0 > 0:
                triangles.append((a, b, c))
            if r1 > 0:
                triangles.append((a, c, d) if r0 > 0 else (a, c, d))
    return Solid(triangles)


def cylinder(radius, z0, z1, chamfer=0.0, segments=48):
    if chamfer > 0:
        return revolve([(0, z0), (radius - chamfer, z0), (radius, z0 + chamfer), (radius, z1 - chamfer),
                        (radius - chamfer, z1), (0, z1)], segments)
    return revolve([(0, z0), (radius, z0), (radius, z1), (0, z1)], segments)


def rectangle(width, depth, radius=0.0, steps=6, center=(0.0, 0.0)):
    """A rectangle with rounded corners, counter-clockwise, about its centre."""
    x, y = width / 2, depth / 2
    if radius <= 0:
        corners = [(x, -y), (x, y), (-x, y), (-x, -y)]
        return [(px + center[0], py + center[1]) for px, py in corners]
    points = []
    for cx, cy, start in ((x - radius, y - radius, 0), (-x + radius, y - radius, 90),
                          (-x + radius, -y + radius, 180), (x - radius, -y + radius, 270)):
        for k in range(steps + 1):
            angle = math.radians(start + 90 * k / steps)
            points.append((cx + radius * math.cos(angle) + center[0], cy + radius * math.sin(angle) + center[1]))
    return points


def box(x0, x1, y0, y1, z0, z1, chamfer=0.0):
    return prism(rectangle(x1 - x0, y1 - y0, center=((x0 + x1) / 2, (y0 + y1) / 2)), z0, z1, chamfer)


def belt(p0, r0, p1, r1, steps=18):
    """Outline around two circles (a link arm's side view), counter-clockwise."""
    dx, dy = p1[0] - p0[0], p1[1] - p0[1]
    length = math.hypot(dx, dy)
    direction = math.atan2(dy, dx)
    lean = math.acos(max(-1.0, min(1.0, (r0 - r1) / length)))
    points = []
    start, end = direction - lean, direction + lean
    for k in range(steps + 1):
        angle = start + (end - start) * k / steps
        points.append((p1[0] + r1 * math.cos(angle), p1[1] + r1 * math.sin(angle)))
    start, end = direction + lean, direction - lean + 2 * math.pi
    for k in range(steps + 1):
        angle = start + (end - start) * k / steps
        points.append((p0[0] + r0 * math.cos(angle), p0[1] + r0 * math.sin(angle)))
    return points


def upright(solid):
    """Takes a prism made in (x, y) with height z to one standing in the X-Z plane with its thickness along Y."""
    return solid.map(lambda p: (p[0], -p[2], p[1]))
