"""The package: a crate with straps (package.glb), and its parachute (parachute.glb), with their textures.

Body axes: up +y, metres. The crate's origin is its centre; the parachute's is where its lines meet, HARNESS
above the crate's centre, so that a canopy that fills is the open one scaled about its origin.
"""

import argparse
import pathlib

import numpy as np

import glb
import paint
from glb import MeshBuilder, Node, Surface

SEED = 20260103  # grain and stains of the wood

SIZE = np.array([.80, .80, .80])
HARNESS = .58
GORES = 16
CANOPY_RADIUS, CANOPY_HEIGHT, LINE_LENGTH = 2.6, 1.7, 4.4

CRATE_TEXTURE = 512  # square: side planks above, lid and straps below
CANOPY_TEXTURE = (512, 256)


def uv_rectangle(x0, y0, x1, y1):
    return np.array([[x0, y1], [x1, y1], [x1, y0], [x0, y0]])


SIDE, LID = uv_rectangle(.005, .005, .495, .495), uv_rectangle(.505, .005, .995, .495)
EDGE, STRAP, BUCKLE = np.array([.25, .60]), np.array([.25, .85]), np.array([.75, .85])
ROPE = np.array([.75, .60])


def bevelled_box(half, bevel, faces, edge_uv):
    """A box whose edges are cut off by bevel; faces: texture corners of the sides and of top and bottom."""
    mesh = MeshBuilder()
    half = np.asarray(half, float)
    corners = {}  # (sign of each axis, axis of the face) -> point on that face
    for signs in np.ndindex(2, 2, 2):
        s = np.array(signs) * 2 - 1
        for axis in range(3):
            point = (half - bevel) * s
            point[axis] = half[axis] * s[axis]
            corners[tuple(s), axis] = point
    for axis in range(3):
        for sign in (-1, 1):
            u, v = [(2, 1), (0, 2), (0, 1)][axis]  # across and up the face
            right = -sign if axis == 0 else sign  # so that writing is read from outside
            quad = []
            for a, b in [(-right, -1), (right, -1), (right, 1), (-right, 1)]:
                s = [0, 0, 0]
                s[axis], s[u], s[v] = sign, a, b
                quad.append(corners[tuple(s), axis])
            add_quad(mesh, quad, faces[1] if axis == 1 else faces[0], sign * np.eye(3)[axis])
    for axis in range(3):  # twelve bevels along the axes
        a, b = [k for k in range(3) if k != axis]
        for sa in (-1, 1):
            for sb in (-1, 1):
                def corner(along, face):
                    s = [0, 0, 0]
                    s[axis], s[a], s[b] = along, sa, sb
                    return corners[tuple(s), face]
                outwards = np.zeros(3)
                outwards[a], outwards[b] = sa, sb
                add_quad(mesh, [corner(-1, a), corner(1, a), corner(1, b), corner(-1, b)], edge_uv, outwards)
    for signs in np.ndindex(2, 2, 2):
        s = np.array(signs) * 2 - 1
        triangle = [corners[tuple(s), k] for k in range(3)]
        add_polygon(mesh, triangle, np.broadcast_to(edge_uv, (3, 2)), s)
    return mesh


def add_polygon(mesh, points, uv, outwards):
    points, uv = np.asarray(points, float), np.asarray(uv, float)
    if np.cross(points[1] - points[0], points[2] - points[0]) @ outwards < 0:
        points, uv = points[::-1], uv[::-1]
    for k in range(1, len(points) - 1):
        mesh.add_triangles(points[[0, k, k + 1]], uv[[0, k, k + 1]][None])


def add_quad(mesh, points, uv, outwards):
    add_polygon(mesh, points, np.broadcast_to(uv, (4, 2)), outwards)


def band(inner, outer, width, axis, at, uv):
    """A closed strap around the crate in the plane across `axis`, between two half sizes."""
    mesh = MeshBuilder()
    a, b = [k for k in range(3) if k != axis]
    loop = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    for k in range(4):
        def point(i, half, side):
            p = np.zeros(3)
            p[a], p[b] = loop[i % 4][0] * half[a], loop[i % 4][1] * half[b]
            p[axis] = at + side * width / 2
            return p
        middle = (np.array(loop[k]) + np.array(loop[(k + 1) % 4])) / 2
        outwards = np.zeros(3)
        outwards[a], outwards[b] = middle
        along = np.eye(3)[axis]
        add_quad(mesh, [point(k, outer, -1), point(k + 1, outer, -1), point(k + 1, outer, 1), point(k, outer, 1)],
                 uv, outwards)
        add_quad(mesh, [point(k, inner, -1), point(k + 1, inner, -1), point(k + 1, inner, 1), point(k, inner, 1)],
                 uv, -outwards)
        for side in (-1, 1):
            add_quad(mesh, [point(k, inner, side), point(k + 1, inner, side), point(k + 1, outer, side),
                            point(k, outer, side)], uv, side * along)
    return mesh


def rod(start, end, radius, uv, sides=4):
    start, end = np.asarray(start, float), np.asarray(end, float)
    axis = (end - start) / np.linalg.norm(end - start)
    side = np.cross(axis, [1.0, 0, 0] if abs(axis[0]) < .8 else [0, 1.0, 0])
    side /= np.linalg.norm(side)
    other = np.cross(axis, side)
    angles = np.linspace(0, 2 * np.pi, sides + 1)
    circle = radius * (np.cos(angles)[:, None] * side + np.sin(angles)[:, None] * other)
    circle[-1] = circle[0]
    points = np.stack([start + circle, end + circle]).transpose(1, 0, 2)
    mesh = MeshBuilder()
    mesh.add_surface(Surface(points, np.broadcast_to(uv, points.shape[:2] + (2,))))
    mesh.add_fan(points[:, 0], uv, reverse=True)
    mesh.add_fan(points[:, 1], uv)
    return mesh


def crate():
    return bevelled_box(SIZE / 2, .018, (SIDE, LID), EDGE)


def straps():
    mesh = MeshBuilder()
    half = SIZE / 2
    for axis in (0, 2):
        for at in (-.20, .20):
            thick = .010 if axis == 0 else .016
            mesh.add(band(half - .004, half + thick, .055, axis, at, STRAP))
    for x in (-.20, .20):
        for z in (-.20, .20):
            plate = bevelled_box([.045, .010, .045], .003, (np.broadcast_to(BUCKLE, (4, 2)),) * 2, BUCKLE)
            mesh.add(plate, glb.translation_matrix([x, half[1] + .018, z]))
            mesh.add(rod([x, half[1] + .02, z], [0, HARNESS, 0], .014, ROPE))
    return mesh


def canopy_point(around, down, thickness):
    """around: gores, 0..GORES; down: 0 at the vent, 1 at the rim. Between the seams the cloth bulges outwards and
    its hem hangs in arcs."""
    seam = np.abs(np.sin(np.pi * around))  # 0 at a seam, 1 in the middle of a gore
    bulge = seam ** .8
    vent = .07
    polar = np.radians(4) + down * np.radians(92)
    flare = 1 - .06 * np.clip(down - .8, 0, 1) / .2  # the rim draws in a little
    radius = (np.maximum(vent, np.sin(polar)) * CANOPY_RADIUS * flare) * (1 + .050 * bulge * down)
    height = np.cos(polar) * CANOPY_HEIGHT + .16 * bulge * down ** 6
    radius = radius - thickness * np.sin(polar)
    height = height - thickness * np.cos(polar)
    angle = 2 * np.pi * around / GORES
    return np.stack([radius * np.cos(angle), height + LINE_LENGTH, -radius * np.sin(angle)], -1)


def fallen_point(around, down, thickness):
    """The canopy spread on level ground (y = 0) with what air is left in it: folds run to the rim, which lies in arcs
    and reaches farther to one side."""
    angle = 2 * np.pi * around / GORES
    reach = CANOPY_RADIUS * (.92 + .13 * np.sin(angle * 2 + .6) + .07 * np.sin(angle * 5 + 2.1))
    radius = reach * (.07 + .93 * down) * (1 + .05 * np.abs(np.sin(np.pi * around)) ** .8 * down)
    folds = np.abs(np.sin(angle * 9 + 2.0 * down)) * .13 + np.abs(np.sin(angle * 4 + 1.0 - 3.0 * down)) * .17
    air = .26 * (.5 + .5 * np.sin(angle + .8)) * np.sin(np.pi * np.clip(down * 1.02, 0, 1))
    height = .07 + (folds * np.sin(np.pi * np.clip(down, .12, .97)) + air)
    return np.stack([radius * np.cos(angle), height - thickness * (height + .10) / .03 * .9, -radius * np.sin(angle)], -1)


def canopy(shape=canopy_point):
    mesh = MeshBuilder()
    per_gore, rows = 6, 14
    around, down = np.meshgrid(np.linspace(0, GORES, GORES * per_gore + 1), np.linspace(0, 1, rows + 1), indexing="ij")
    uv = np.stack([around / GORES, .02 + .96 * down], -1)
    outside, inside = (shape(around, down, t) for t in (0, .03))
    for points in (outside, inside):
        points[-1] = points[0]
    mesh.add_surface(Surface(outside[:, ::-1], uv[:, ::-1]))
    mesh.add_surface(Surface(inside, uv))
    for row, flip in ((-1, False), (0, True)):
        rim = np.stack([outside[:, row], inside[:, row]], axis=1)
        rim_uv = np.stack([uv[:, row], uv[:, row]], axis=1)
        mesh.add_surface(Surface(rim[::-1] if not flip else rim, rim_uv[::-1] if not flip else rim_uv))
    return mesh


def lines():
    mesh = MeshBuilder()
    for k in range(GORES):
        mesh.add(rod([0, 0, 0], canopy_point(np.float64(k), np.float64(1.0), 0.0), .016, np.array([.5, .995]), 3))
    return mesh


# --- Textures -----------------------------------------------------------------------------------------------

def paint_crate():
    n = CRATE_TEXTURE
    v, u = np.mgrid[0:n, 0:n] / n + .5 / n
    x, y = (u % .5) * 2, (v % .5) * 2  # within a quarter, 0..1
    wood = paint.Coat(u.shape, (.62, .45, .27), .16, .30)
    plank = np.floor(y * 5)
    tone = np.random.RandomState(SEED).random_sample(64)
    wood.colour *= (.84 + .28 * tone[(plank + 8 * (u > .5)).astype(int)])[..., None]
    grain = paint.value_noise(x * 6 + 9 * plank, y * 90, SEED + 1) - .5
    wood.colour *= (1 + .22 * grain + .12 * (paint.value_noise(x * 3, y * 3, SEED + 2) - .5))[..., None]
    wood.darken(np.abs((y * 5 + .5) % 1 - .5) / 5 - .006, .65)
    frame = .5 - np.maximum(np.abs(x - .5), np.abs(y - .5))  # distance from the side's edge
    border = paint.Coat(u.shape, (.50, .35, .20), .16, .30)
    border.colour *= (1 + .25 * (paint.value_noise(x * 40, y * 9, SEED + 3) - .5))[..., None]
    wood.cover(frame - .105, border.colour, .16, .30)
    wood.darken(np.abs(frame - .105) - .004, .6)
    for cx in (.05, .95):
        for cy in (.05, .5, .95):
            wood.cover(paint.circle_distance(x, y, cx, cy, .014), (.25, .24, .23), .45, .5)
    # A stencilled arrow and name on the sides.
    side = (u < .5) & (v < .5)
    stencil = paint.text_distance(x - .5 + paint.text_width("DROP", .11) / 2, .57 - y, "DROP", .11, .024)
    arrow = np.minimum(paint.segment_distance(x, y, (.5, .78), (.5, .70)) - .016,
                       paint.polygon_distance(x, y, [(.445, .71), (.555, .71), (.5, .645)]))
    wood.cover(np.where(side, np.minimum(stencil, arrow), 1.0), (.12, .10, .09), .12, .2, opacity=.85)
    colours = [((u < .5) & (v >= .5) & (v < .75), (.42, .29, .17), .16, .30),   # bevels
               ((u < .5) & (v >= .75), (.84, .34, .06), .14, .25),              # straps
               ((u >= .5) & (v >= .5) & (v < .75), (.30, .28, .24), .10, .20),  # ropes
               ((u >= .5) & (v >= .75), (.55, .56, .58), .60, .65)]             # buckles
    for where, colour, specular, gloss in colours:
        wood.colour[where] = colour
        wood.surface[where] = (specular, gloss)
    weave = .9 + .1 * np.sin(v * n * np.pi * .5)
    wood.colour[(u < .5) & (v >= .75)] *= weave[(u < .5) & (v >= .75)][:, None]
    return wood.colour, wood.surface[..., [0, 0, 0, 1]]


def paint_canopy():
    width, height = CANOPY_TEXTURE
    v, u = np.mgrid[0:height, 0:width]
    u, v = (u + .5) / width, (v + .5) / height
    gore = np.floor(u * GORES).astype(int)
    orange, white = np.array([.93, .38, .07]), np.array([.94, .93, .90])
    coat = paint.Coat(u.shape, white, .12, .25)
    coat.colour[gore % 2 == 0] = orange
    metres = np.abs((u * GORES + .5) % 1 - .5) / GORES * 2 * np.pi * CANOPY_RADIUS * np.maximum(v, .1)
    coat.darken(metres - .025, .35, .04)
    for at in (.30, .62, .90):
        coat.darken(np.abs(v - at) * 4.5 - .02, .22, .04)
    coat.cover((.975 - v) * 4.5, (.20, .21, .23), .12, .25, .03)
    coat.colour *= (1 - .10 * paint.value_noise(u * 64, v * 14, SEED + 4))[..., None]
    return coat.colour


def build(folder):
    folder = pathlib.Path(folder)
    glb.write_glb(folder / "package.glb", "package", [Node("crate", crate(), "wood"), Node("straps", straps(), "wood")],
                  {"wood": ("package_diffuse.png", "package_specular.png")})
    colour, specular = paint_crate()
    glb.write_png(folder / "package_diffuse.png", colour)
    glb.write_png(folder / "package_specular.png", specular)
    glb.write_glb(folder / "parachute.glb", "parachute",
                  [Node("canopy", canopy(), "cloth", crease_degrees=50),
                   Node("fallen", canopy(fallen_point), "cloth", crease_degrees=60),
                   Node("lines", lines(), "cloth", crease_degrees=120)],
                  {"cloth": ("parachute_diffuse.png",)})
    glb.write_png(folder / "parachute_diffuse.png", paint_canopy())


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", nargs="?", default=pathlib.Path(__file__).parents[1] / "models")
    build(parser.parse_args().folder)
