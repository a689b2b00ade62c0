"""The aircraft's shape: fuselage, wings, tail, gear, propeller and cockpit, and their places in the livery.

Body axes: forward -z, right +x, up +y, metres, origin at the centre of mass.
"""

import numpy as np

import glb
from glb import MeshBuilder, Surface

ATLAS_WIDTH, ATLAS_HEIGHT = 2048, 1536
# Places in the livery, in texels: x, y, width, height.
WING_TOP = (0, 0, 2048, 304)
WING_BOTTOM = (0, 304, 2048, 304)
FUSELAGE = (0, 608, 2048, 512)
TAIL_TOP = (0, 1120, 768, 208)
TAIL_BOTTOM = (0, 1328, 768, 208)
FIN_LEFT = (768, 1120, 448, 416)
FIN_RIGHT = (1216, 1120, 448, 416)
PANEL = (1664, 1120, 384, 192)
SWATCHES = (1664, 1312, 384, 224)  # 6 x 3 fields of one material each

SWATCH_NAMES = ["black", "tyre", "metal", "red", "white", "navy", "spinner", "blade", "tip", "exhaust", "glare",
                "frame", "disc"]


# --- Detail ---------------------------------------------------------------------------------------------------

FINE, COARSE = 1.0, 0.4
detail = FINE  # share of the points along curves: the aircraft is made twice, to be seen from near and from far


def curve(count, least=3):
    """How many points a curve has that has `count` in the fine aircraft."""
    return max(least, round(count * detail))


# --- Curves -------------------------------------------------------------------------------------------------

def monotone(xs, ys, x):
    """Monotone cubic interpolation (Fritsch and Carlson 1980): smooth, and never beyond the given values."""
    xs, ys = np.asarray(xs, float), np.asarray(ys, float)
    h = np.diff(xs)
    d = np.diff(ys) / h
    m = np.zeros_like(ys)
    for i in range(1, len(xs) - 1):
        if d[i - 1] * d[i] > 0:
            w1, w2 = 2 * h[i] + h[i - 1], h[i] + 2 * h[i - 1]
            m[i] = (w1 + w2) / (w1 / d[i - 1] + w2 / d[i])
    m[0], m[-1] = d[0], d[-1]
    k = np.clip(np.searchsorted(xs, x, side="right") - 1, 0, len(h) - 1)
    t = (x - xs[k]) / h[k]
    return ((1 + 2 * t) * (1 - t) ** 2 * ys[k] + t * (1 - t) ** 2 * h[k] * m[k]
            + t * t * (3 - 2 * t) * ys[k + 1] + t * t * (t - 1) * h[k] * m[k + 1])


def aerofoil(thickness, camber=0.0, camber_at=0.4, count=20):
    """Four-digit NACA section (Jacobs, Ward, Pinkerton 1933), closed trailing edge: the lower side from the
    trailing to the leading edge and the upper side back, each count + 1 points (x, y) in chords."""
    x = 0.5 * (1 - np.cos(np.linspace(0, np.pi, curve(count, 4) + 1)))
    yt = 5 * thickness * (.2969 * np.sqrt(x) - .1260 * x - .3516 * x**2 + .2843 * x**3 - .1036 * x**4)
    yc = np.where(x < camber_at, camber / camber_at**2 * (2 * camber_at * x - x * x),
                  camber / (1 - camber_at) ** 2 * (1 - 2 * camber_at + 2 * camber_at * x - x * x))
    lower = np.stack([x, yc - yt], 1)[::-1]
    upper = np.stack([x, yc + yt], 1)
    return lower, upper


def cut_aerofoil(section, cut, keep):
    """The part of a section before ("front") or behind ("rear") the chord fraction cut. The rear part gets a
    round nose. Returns lower and upper side; both start and end where the other does."""
    lower, upper = section

    def at(side, x):
        order = np.argsort(side[:, 0], kind="stable")
        return np.array([x, np.interp(x, side[order, 0], side[order, 1])])

    if keep == "front":
        low = np.vstack([at(lower, cut), lower[lower[:, 0] < cut]])
        up = np.vstack([upper[upper[:, 0] < cut], at(upper, cut)])
        return low, up
    low_cut, up_cut = at(lower, cut), at(upper, cut)
    radius = (up_cut[1] - low_cut[1]) / 2
    middle = (low_cut + up_cut) / 2
    arc = [middle + radius * np.array([-.25 * np.cos(a), np.sin(a)]) for a in np.linspace(-np.pi / 2, np.pi / 2, 9)]
    low = np.vstack([lower[lower[:, 0] > cut], low_cut, arc[1:5]])
    up = np.vstack([arc[4:8], up_cut, upper[upper[:, 0] > cut]])
    return low, up


# --- Texture places -----------------------------------------------------------------------------------------

def place_uv(place, s, t, margin=4):
    """Texture coordinates of the fractions (s to the right, t downwards) of a place, margin left free."""
    x, y, width, height = place
    u = (x + margin + s * (width - 2 * margin)) / ATLAS_WIDTH
    v = (y + margin + t * (height - 2 * margin)) / ATLAS_HEIGHT
    return np.stack(np.broadcast_arrays(u, v), -1)


def place_fractions(place, margin=4):
    """The fractions (s, t) at the middle of each texel of a place; the margin lies outside 0..1."""
    _, _, width, height = place
    s = (np.arange(width) + .5 - margin) / (width - 2 * margin)
    t = (np.arange(height) + .5 - margin) / (height - 2 * margin)
    return np.meshgrid(s, t)


def swatch_uv(name):
    x, y, width, height = SWATCHES
    i = SWATCH_NAMES.index(name)
    return np.array([(x + (i % 6 + .5) * width / 6) / ATLAS_WIDTH, (y + (i // 6 + .5) * height / 3) / ATLAS_HEIGHT])


def planar(place, x_range, z_range):
    """A function from points to texture coordinates, seen along one axis: x_range across, z_range down."""
    def uv(across, down):
        s = (across - x_range[0]) / (x_range[1] - x_range[0])
        t = (down - z_range[0]) / (z_range[1] - z_range[0])
        return place_uv(place, s, t)
    return uv


WING_X, WING_Z = (-5.5, 5.5), (-.85, .95)
TAIL_X, TAIL_Z = (-1.75, 1.75), (3.75, 5.0)
FIN_Z, FIN_Y = (2.6, 5.1), (-.05, 1.9)


# --- Fuselage -----------------------------------------------------------------------------------------------

FUSELAGE_TABLE = np.array([
    # z     half width, top, bottom, height of the widest point, exponent of the section
    [-2.80, .25, .20, -.27, -.03, 2.2],
    [-2.79, .31, .26, -.33, -.03, 2.3],
    [-2.75, .375, .325, -.395, -.03, 2.4],
    [-2.66, .425, .375, -.45, -.03, 2.5],
    [-2.45, .470, .415, -.51, -.03, 2.6],
    [-2.00, .510, .455, -.56, -.02, 2.7],
    [-1.45, .540, .500, -.60, .02, 2.8],
    [-1.28, .548, .540, -.61, .06, 2.9],
    [-1.10, .556, .690, -.62, .10, 3.0],
    [-.85, .565, .910, -.63, .16, 3.1],
    [-.62, .570, 1.040, -.63, .18, 3.2],
    [-.30, .572, 1.075, -.63, .18, 3.2],
    [.70, .560, 1.060, -.61, .18, 3.1],
    [1.10, .530, .990, -.57, .18, 2.9],
    [1.70, .450, .830, -.46, .18, 2.6],
    [2.50, .335, .660, -.29, .18, 2.4],
    [3.40, .220, .520, -.08, .22, 2.2],
    [4.20, .125, .445, .09, .27, 2.1],
    [4.62, .075, .420, .17, .30, 2.0],
    [4.72, .045, .400, .21, .305, 2.0],
])
FUSELAGE_STATIONS = np.unique(np.concatenate([
    FUSELAGE_TABLE[:, 0], np.linspace(-2.66, -1.28, 9), np.linspace(-1.28, -.5, 15), np.linspace(.5, 4.62, 30)]))
RING_COUNT = 48


ARC_STEPS = 720


def section_angle(z, around):
    """The angle of the section's formula at a fraction of its circumference: equal fractions are equal lengths, so
    that no part of the livery is stretched."""
    shape = np.broadcast(z, around).shape
    z, around = np.broadcast_to(z, shape).ravel(), np.broadcast_to(around, shape).ravel()
    stations, station = np.unique(z, return_inverse=True)
    steps = np.linspace(0, 1, ARC_STEPS + 1)
    result = np.empty(len(z))
    for k, at in enumerate(stations):
        ring = section_point(at, 2 * np.pi * steps)
        length = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(ring, axis=0), axis=1))])
        here = station == k
        result[here] = 2 * np.pi * np.interp(around[here], length / length[-1], steps)
    return result.reshape(shape)


def section_point(z, angle):
    half, top, bottom, middle, power = (monotone(FUSELAGE_TABLE[:, 0], FUSELAGE_TABLE[:, k], z) for k in range(1, 6))
    s, c = np.sin(angle), -np.cos(angle)
    x = half * np.sign(s) * np.abs(s) ** (2 / power)
    y = np.sign(c) * np.abs(c) ** (2 / power)
    y = middle + np.where(y > 0, y * (top - middle), y * (middle - bottom))
    return np.stack(np.broadcast_arrays(x, y, z), -1)


def fuselage_point(z, around):
    """around: the way along the section, 0 at the keel, about 1/4 at the right, 1/2 on top, 3/4 at the left."""
    return section_point(z, section_angle(z, around))


def fuselage():
    mesh = MeshBuilder()
    stations = FUSELAGE_STATIONS if detail == FINE else FUSELAGE_TABLE[:, 0]
    z, around = np.meshgrid(stations, np.linspace(0, 1, curve(RING_COUNT) + 1), indexing="ij")
    skin = fuselage_point(z, around)
    skin[:, -1] = skin[:, 0]
    s = (z - FUSELAGE_STATIONS[0]) / (FUSELAGE_STATIONS[-1] - FUSELAGE_STATIONS[0])
    mesh.add_surface(Surface(skin[:, ::-1], place_uv(FUSELAGE, s, around)[:, ::-1]))
    mesh.add_fan(skin[0], swatch_uv("black"), reverse=True)
    mesh.add_fan(skin[-1], swatch_uv("white"))
    for side in (-1, 1):  # two air inlets beside the spinner and an exhaust pipe below
        inlet = rounded_slab(np.array([side * .225, .06, -2.815]), (.085, .065, .03), "glare")
        mesh.add(inlet)
        pipe = lathe([(.0, .0), (.035, .0), (.035, .34), (.027, .34), (.027, .30), (.0, .30)], 14, "exhaust")
        turn = glb.rotation_matrix([1, 0, 0], 2.75) @ glb.rotation_matrix([1, 0, 0], -np.pi / 2)
        mesh.add(pipe, glb.translation_matrix([side * .26, -.44, -1.75]) @ turn)
    return mesh


def rounded_slab(middle, half, swatch, count=20):
    """A flat pill facing forward: an ellipse extruded along z with a bevelled front."""
    mesh = MeshBuilder()
    count = curve(count)
    angles = np.linspace(0, 2 * np.pi, count + 1)
    rings = []
    for depth, scale in ((half[2], 1.0), (-.3 * half[2], 1.0), (-half[2], .86)):
        ring = np.stack([half[0] * scale * np.cos(angles), half[1] * scale * np.sin(angles),
                         np.full(count + 1, depth)], 1) + middle
        ring[-1] = ring[0]
        rings.append(ring)
    pill = np.stack(rings)
    uv = np.broadcast_to(swatch_uv(swatch), pill.shape[:2] + (2,))
    mesh.add_surface(Surface(pill, uv))
    mesh.add_fan(pill[0], swatch_uv(swatch))
    mesh.add_fan(pill[-1], swatch_uv(swatch), reverse=True)
    return mesh


def lathe(profile, count, swatch):
    """Turns a profile (radius, y) around the y axis; it must start and end on the axis. The profile runs so that
    its outside lies to the right of the way upwards."""
    mesh = MeshBuilder()
    swatches = swatch if isinstance(swatch, list) else [swatch] * (len(profile) - 1)
    count = curve(count, 6)
    angles = np.linspace(0, 2 * np.pi, count + 1)
    rings = []
    for radius, y in profile:
        ring = np.stack([radius * np.cos(angles), np.full(count + 1, y), -radius * np.sin(angles)], 1)
        ring[-1] = ring[0]
        rings.append(ring)
    for lower, upper, name in zip(rings[:-1], rings[1:], swatches):
        band = np.stack([lower, upper]).transpose(1, 0, 2)
        mesh.add_surface(Surface(band, np.broadcast_to(swatch_uv(name), band.shape[:2] + (2,))))
    return mesh


# --- Wings, tail, struts ------------------------------------------------------------------------------------

class WingStation:
    """Where a section stands: leading edge, chord, height scale of the section, angle of incidence."""

    def __init__(self, leading, chord, thickness=1.0, incidence=0.0):
        self.leading, self.chord = np.asarray(leading, float), chord
        self.thickness, self.incidence = thickness, incidence


def place_section(points, station, up):
    """Section points (x, y in chords) into body axes: chord along +z, height along up."""
    c, s = np.cos(station.incidence), np.sin(station.incidence)
    along = points[:, 0] * station.chord
    height = points[:, 1] * station.chord * station.thickness
    z = along * c + height * s
    y = height * c - along * s
    return station.leading + z[:, None] * np.array([0, 0, 1.0]) + y[:, None] * np.asarray(up, float)


def wing_part(sections, stations, uv_lower, uv_upper, up=(0, 1.0, 0), swatch="white"):
    """A closed body over the stations. Each section is (lower, upper); stations run towards +x (or towards +y
    with up = -x for a fin). uv_lower, uv_upper: functions from points (n, 3)."""
    mesh = MeshBuilder()
    lower = np.stack([place_section(s[0], st, up) for s, st in zip(sections, stations)])
    upper = np.stack([place_section(s[1], st, up) for s, st in zip(sections, stations)])
    lower, upper = lower.transpose(1, 0, 2), upper.transpose(1, 0, 2)  # points along the section, stations
    mesh.add_surface(Surface(lower, uv_lower(lower)))
    mesh.add_surface(Surface(upper, uv_upper(upper)))
    # The wall between the upper and the lower side behind a cut, and both ends.
    if not np.allclose(upper[-1], lower[0], atol=1e-9):
        wall = np.stack([upper[-1], lower[0]])
        mesh.add_surface(Surface(wall, np.broadcast_to(swatch_uv(swatch), wall.shape[:2] + (2,))))
    for k, reverse in ((0, True), (-1, False)):
        mesh.add_fan(np.vstack([lower[:, k], upper[1:, k]]), swatch_uv(swatch), reverse=reverse)
    return mesh


def wing_shape(x):
    """Station of the right wing at x: straight to 3 m, then tapered, with a rounded tip."""
    chord = np.interp(x, [0, 3.0, 5.2, 5.4], [1.60, 1.60, 1.22, 1.20])
    leading = -.75 + np.interp(x, [0, 3.0, 5.4], [0, 0, .14])
    round_off = np.sqrt(max(0.0, 1 - max(0.0, (x - 5.12) / .29) ** 2))
    narrow = 1 - .30 * (1 - round_off)
    y = 1.085 + x * np.tan(np.radians(1.8)) - .02 * (1 - round_off)
    return WingStation([x, y, leading + chord * (1 - narrow) * .45], chord * narrow, max(round_off, .12),
                       np.radians(1.5 - 2.0 * x / 5.4))


def wing_section():
    return aerofoil(.125, .022, .4, 22)


AILERON_X = (2.95, 4.95)
AILERON_CUT = .74
HINGE_CUT = .750


def wing_uvs():
    top, bottom = planar(WING_TOP, WING_X, WING_Z), planar(WING_BOTTOM, WING_X, WING_Z)
    return (lambda p: bottom(p[..., 0], p[..., 2])), (lambda p: top(p[..., 0], p[..., 2]))


def mirrored(mesh, remap):
    """The mesh on the other side, with the texture coordinates of its own side."""
    result = MeshBuilder()
    for positions, uvs in zip(mesh.positions, mesh.uvs):
        flipped = positions[:, ::-1] * np.array([-1.0, 1, 1])
        result.add_triangles(flipped, remap(uvs[:, ::-1]))
    return result


def mirror_planar(uvs, places):
    """Mirrors texture coordinates across the middle of the place they lie in."""
    result = np.array(uvs)
    for x, y, width, height in places:
        u0, u1 = x / ATLAS_WIDTH, (x + width) / ATLAS_WIDTH
        v0, v1 = y / ATLAS_HEIGHT, (y + height) / ATLAS_HEIGHT
        inside = (uvs[..., 0] >= u0) & (uvs[..., 0] <= u1) & (uvs[..., 1] >= v0) & (uvs[..., 1] <= v1)
        result[..., 0] = np.where(inside, u0 + u1 - uvs[..., 0], result[..., 0])
    return result


def mirror_wing(mesh):
    return mirrored(mesh, lambda uv: mirror_planar(uv, [WING_TOP, WING_BOTTOM, TAIL_TOP, TAIL_BOTTOM]))


def wing():
    lower_uv, upper_uv = wing_uvs()
    whole, front = wing_section(), cut_aerofoil(wing_section(), AILERON_CUT, "front")
    half = np.linspace(0, AILERON_X[0], curve(7))
    middle = [-x for x in half[::-1]] + list(half[1:])

    def at(x):
        station = wing_shape(abs(x))
        station.leading[0] = x
        return station

    mesh = wing_part([whole] * len(middle), [at(x) for x in middle], lower_uv, upper_uv)
    right = MeshBuilder()
    xs = np.linspace(*AILERON_X, curve(7))
    right.add(wing_part([front] * len(xs), [at(x) for x in xs], lower_uv, upper_uv))
    xs = np.concatenate([np.linspace(AILERON_X[1], 5.12, curve(4, 2)), 5.12 + .29 * np.sin(np.linspace(0, np.pi / 2, curve(9)))[1:]])
    right.add(wing_part([whole] * len(xs), [at(x) for x in xs], lower_uv, upper_uv, swatch="red"))
    mesh.add(right)
    mesh.add(mirror_wing(right))
    return mesh


def hinge_point(station, section, cut, up=(0, 1.0, 0)):
    lower, upper = section
    order = np.argsort(lower[:, 0], kind="stable")
    low = np.interp(cut, lower[order, 0], lower[order, 1])
    high = np.interp(cut, upper[:, 0], upper[:, 1])
    return place_section(np.array([[cut, (low + high) / 2]]), station, up)[0]


def aileron():
    lower_uv, upper_uv = wing_uvs()
    rear = cut_aerofoil(wing_section(), HINGE_CUT, "rear")
    xs = np.linspace(AILERON_X[0] + .012, AILERON_X[1] - .012, curve(7))
    mesh = wing_part([rear] * len(xs), [wing_shape(x) for x in xs], lower_uv, upper_uv)
    ends = [hinge_point(wing_shape(x), wing_section(), HINGE_CUT) for x in (xs[0], xs[-1])]
    return mesh, ends


def tail_section():
    return aerofoil(.09, count=14)


TAIL_CUT, TAIL_HINGE = .57, .585


def tail_shape(x):
    chord = np.interp(abs(x), [0, 1.55, 1.7], [1.02, .74, .70])
    leading = 3.90 + np.interp(abs(x), [0, 1.7], [0, .22])
    round_off = np.sqrt(max(0.0, 1 - max(0.0, (abs(x) - 1.52) / .20) ** 2))
    narrow = 1 - .35 * (1 - round_off)
    return WingStation([x, .37, leading + chord * (1 - narrow) * .5], chord * narrow, max(round_off, .15))


def tail_uvs():
    top, bottom = planar(TAIL_TOP, TAIL_X, TAIL_Z), planar(TAIL_BOTTOM, TAIL_X, TAIL_Z)
    return (lambda p: bottom(p[..., 0], p[..., 2])), (lambda p: top(p[..., 0], p[..., 2]))


def tail_ends():
    return np.concatenate([np.linspace(.12, 1.52, curve(6)),
                           1.52 + .20 * np.sin(np.linspace(0, np.pi / 2, curve(7)))[1:]])


def tailplane():
    front = cut_aerofoil(tail_section(), TAIL_CUT, "front")
    ends = tail_ends()
    xs = np.concatenate([-ends[::-1], ends])
    return wing_part([front] * len(xs), [tail_shape(x) for x in xs], *tail_uvs())


def elevator():
    rear = cut_aerofoil(tail_section(), TAIL_HINGE, "rear")
    ends = tail_ends()
    half = wing_part([rear] * len(ends), [tail_shape(x) for x in ends], *tail_uvs())
    mesh = MeshBuilder()
    mesh.add(half)
    mesh.add(mirror_wing(half))
    # The hinge is straight: it follows the chord fraction at the middle of the half span.
    return mesh, hinge_point(tail_shape(.8), tail_section(), TAIL_HINGE)


RUDDER_Z = ((.16, 4.56), (1.72, 4.80))  # hinge line: (y, z) at the bottom and at the top


def rudder_hinge_z(y):
    (y0, z0), (y1, z1) = RUDDER_Z
    return z0 + (y - y0) / (y1 - y0) * (z1 - z0)


def fin_station(y):
    """A section of the whole fin and rudder whose chord fraction .6 lies on the hinge line."""
    round_off = np.sqrt(max(0.0, 1 - max(0.0, (y - 1.55) / .20) ** 2))
    rear = np.interp(y, [.16, .45, 1.72], [.34, .46, .30]) * (1 - .45 * (1 - round_off))
    front = np.interp(y, [.16, .42, .62, .85, 1.72], [1.75, 1.60, .95, .80, .50]) * (1 - .35 * (1 - round_off))
    hinge = rudder_hinge_z(y)
    return hinge - front, hinge + rear, round_off


def fin_uvs():
    left, right = planar(FIN_LEFT, FIN_Z, FIN_Y[::-1]), planar(FIN_RIGHT, FIN_Z, FIN_Y[::-1])
    # A fin is a wing that grows upwards with its upper side to the left.
    return (lambda p: right(p[..., 2], p[..., 1])), (lambda p: left(p[..., 2], p[..., 1]))


def fin_heights(bottom):
    return np.concatenate([np.linspace(bottom, .85, curve(8, 6)), np.linspace(.85, 1.55, curve(5))[1:],
                           1.55 + .20 * np.sin(np.linspace(0, np.pi / 2, curve(7)))[1:]])


def fin_part(keep, heights):
    stations, sections = [], []
    for y in heights:
        front, rear, round_off = fin_station(y)
        chord, thickness = rear - front, max(round_off, .2)
        hinge = (rudder_hinge_z(y) - front) / chord
        # The thickness is that of the tail's root everywhere but at the tip: a long dorsal fillet stays slim.
        section = aerofoil(min(.085, .10 / chord), count=14)
        sections.append(cut_aerofoil(section, hinge + (.008 / chord if keep == "rear" else -.008 / chord), keep))
        stations.append(WingStation([0, y, front], chord, thickness))
    counts = {len(s[0]) for s in sections}
    if len(counts) > 1:  # where the cut crosses a point of the section the counts differ: resample all
        sections = [tuple(resample(side, curve(14, 8)) for side in s) for s in sections]
    return wing_part(sections, stations, *fin_uvs(), up=(-1.0, 0, 0), swatch="red")


def resample(side, count):
    steps = np.hypot(*np.diff(side, axis=0).T)
    at = np.concatenate([[0], np.cumsum(steps)])
    t = np.linspace(0, at[-1], count)
    return np.stack([np.interp(t, at, side[:, k]) for k in (0, 1)], 1)


def strut(start, end, chord, thickness, swatch="white"):
    """A streamlined rod between two points, chord along z."""
    lower, upper = aerofoil(thickness / chord, count=8)
    ring = np.vstack([lower, upper[1:-1]])
    start, end = np.asarray(start, float), np.asarray(end, float)
    direction = (end - start) / np.linalg.norm(end - start)
    up = np.cross([0, 0, 1.0], direction)
    up /= np.linalg.norm(up)
    mesh = MeshBuilder()
    rings = []
    for point in (start, end):
        points = point + (ring[:, :1] - .4) * chord * np.array([0, 0, 1.0]) + ring[:, 1:] * chord * up
        rings.append(np.vstack([points, points[:1]]))
    points = np.stack(rings, axis=1)
    mesh.add_surface(Surface(points, np.broadcast_to(swatch_uv(swatch), points.shape[:2] + (2,))))
    mesh.add_fan(points[:, 0], swatch_uv(swatch), reverse=True)
    mesh.add_fan(points[:, 1], swatch_uv(swatch))
    return mesh


def wheel(radius, width, hub):
    """A tyre and hub around the x axis."""
    half = width / 2
    tyre = [(0, -.30 * half), (hub * .55, -.42 * half), (hub, -.55 * half), (hub * 1.05, -.80 * half)]
    for angle in np.linspace(-70, 70, curve(9, 4)):
        a = np.radians(angle)
        tyre.append((hub * 1.05 + (radius - hub * 1.05) * np.cos(a) ** .6, half * np.sin(a) / np.sin(np.radians(75))))
    tyre += [(hub * 1.05, .80 * half), (hub, .55 * half), (hub * .55, .42 * half), (0, .30 * half)]
    names = ["metal", "metal", "tyre"] + ["tyre"] * (len(tyre) - 7) + ["tyre", "metal", "metal"]
    mesh = MeshBuilder()
    mesh.add(lathe(tyre, 28, names), glb.rotation_matrix([0, 0, 1], -np.pi / 2))
    return mesh


def gear():
    mesh = MeshBuilder()
    right = MeshBuilder()
    axle = np.array([1.18, -1.24, -.92])
    right.add(strut([.30, -.52, -.86], axle + [-.06, 0, .02], .20, .045))
    right.add(wheel(.31, .21, .13), glb.translation_matrix(axle))
    right.add(strut(axle + [-.10, 0, 0], axle + [.03, 0, 0], .07, .06, "metal"))
    mesh.add(right)
    mesh.add(right, glb.MIRROR_X)
    mesh.add(strut([0, .14, 4.28], [0, -.10, 4.52], .07, .035, "metal"))
    mesh.add(wheel(.11, .075, .05), glb.translation_matrix([0, -.13, 4.54]))
    return mesh


def struts():
    right = MeshBuilder()
    for z_low, z_high in ((-.42, -.42), (-.30, .25)):
        right.add(strut([.50, -.42, z_low], [2.62, 1.13, z_high], .12, .038))
    mesh = MeshBuilder()
    mesh.add(right)
    mesh.add(right, glb.MIRROR_X)
    return mesh


# --- Propeller ----------------------------------------------------------------------------------------------

PROPELLER_CENTRE = np.array([0, -.03, -2.90])
PROPELLER_RADIUS = 1.04


def blade():
    """One blade along +x from the spinner, turning clockwise seen from behind (towards -y at +x)."""
    radii = np.concatenate([np.linspace(.08, .96, 12), [1.0, 1.025, PROPELLER_RADIUS]])
    chords = np.interp(radii, [.08, .2, .55, .85, .96, 1.0, 1.025, 1.04], [.07, .11, .155, .135, .115, .10, .07, .03])
    twists = np.arctan2(.78, 2 * np.pi * radii * .55)
    thickness = np.interp(radii, [.08, .2, .6, 1.04], [.5, .26, .12, .09])
    rings, names = [], []
    for radius, chord, twist, thick in zip(radii, chords, twists, thickness):
        lower, upper = aerofoil(thick, .02, count=8)
        ring = np.vstack([lower, upper[1:]])
        along, height = (ring[:, 0] - .4) * chord, ring[:, 1] * chord
        # Chord lies in the plane of rotation turned by the twist; the leading edge goes first.
        y = along * np.cos(twist) + height * np.sin(twist)
        z = along * np.sin(twist) - height * np.cos(twist)
        rings.append(np.stack([np.full(len(ring), radius), y, z], 1))
        names.append("tip" if radius > .93 else "blade")
    mesh = MeshBuilder()
    points = np.stack(rings)
    for k in range(len(rings) - 1):
        strip = points[k:k + 2].transpose(1, 0, 2)
        mesh.add_surface(Surface(strip, np.broadcast_to(swatch_uv(names[k]), strip.shape[:2] + (2,))))
    mesh.add_fan(points[0], swatch_uv("blade"), reverse=True)
    mesh.add_fan(points[-1], swatch_uv("tip"))
    return mesh


def propeller():
    mesh = MeshBuilder()
    one = blade()
    for k in range(3):
        mesh.add(one, glb.translation_matrix(PROPELLER_CENTRE) @ glb.rotation_matrix([0, 0, 1], k * 2 * np.pi / 3))
    return mesh


def spinner():
    mesh = MeshBuilder()
    profile = [(0, -.10), (.235, -.10), (.25, -.06)]
    profile += [(.25 * np.cos(a) ** .75, -.02 + .34 * np.sin(a)) for a in np.linspace(0, np.pi / 2 - .12, curve(10, 5))]
    profile += [(0, .32)]
    mesh.add(lathe(profile, 32, ["metal", "spinner"] + ["spinner"] * (len(profile) - 3)),
             glb.translation_matrix(PROPELLER_CENTRE) @ glb.rotation_matrix([1, 0, 0], -np.pi / 2))
    return mesh


def propeller_disc():
    """A flat drum where the turning blades are seen as a veil: u is the distance from the axis in radii, v the
    angle in turns from the first blade."""
    mesh = MeshBuilder()
    angles = np.linspace(0, 2 * np.pi, 49)
    for side in (-1, 1):
        rings = []
        for radius in (.24, PROPELLER_RADIUS):
            ring = np.stack([radius * np.cos(angles), radius * np.sin(angles), np.full(49, side * .004)], 1)
            ring[-1] = ring[0]
            rings.append(ring + PROPELLER_CENTRE)
        points = np.stack(rings)
        uv = np.zeros(points.shape[:2] + (2,))
        uv[0, :, 0], uv[1, :, 0], uv[..., 1] = .24 / PROPELLER_RADIUS, 1.0, angles / (2 * np.pi)
        mesh.add_surface(Surface(points if side > 0 else points[:, ::-1], uv if side > 0 else uv[:, ::-1]))
    for radius, outwards in ((.24, False), (PROPELLER_RADIUS, True)):
        rings = []
        for side in (-1, 1):
            ring = np.stack([radius * np.cos(angles), radius * np.sin(angles), np.full(49, side * .004)], 1)
            ring[-1] = ring[0]
            rings.append(ring + PROPELLER_CENTRE)
        points = np.stack(rings)
        uv = np.zeros(points.shape[:2] + (2,))
        uv[..., 0], uv[..., 1] = radius / PROPELLER_RADIUS, angles / (2 * np.pi)
        mesh.add_surface(Surface(points[:, ::-1] if outwards else points, uv))
    return mesh


# --- Cockpit, seen from inside only -------------------------------------------------------------------------

def box(low, high, swatch):
    low, high = np.asarray(low, float), np.asarray(high, float)
    mesh = MeshBuilder()
    corners = np.array([[x, y, z] for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])])
    for face in ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)):
        uv = np.broadcast_to(swatch_uv(swatch) if isinstance(swatch, str) else np.zeros(2), (4, 2)).copy()
        if not isinstance(swatch, str) and face == (1, 5, 7, 3):  # the face towards +z carries a picture
            uv = np.stack([place_uv(swatch, s, t) for s, t in ((0, 1), (1, 1), (1, 0), (0, 0))])
        elif not isinstance(swatch, str):
            uv[:] = swatch_uv("glare")
        quad = corners[list(face)]
        mesh.add_triangles(np.stack([quad[[0, 1, 2]], quad[[0, 2, 3]]]), np.stack([uv[[0, 1, 2]], uv[[0, 2, 3]]]))
    return mesh


def cockpit():
    mesh = MeshBuilder()
    mesh.add(box([-.50, .12, -1.20], [.50, .505, -1.05], PANEL))
    mesh.add(box([-.51, .505, -1.27], [.51, .535, -.99], "glare"))
    for side in (-1, 1):
        mesh.add(beam([side * .50, .45, -1.26], [side * .43, 1.03, -.66], .026, "frame"))
        mesh.add(beam([side * .515, .16, -1.25], [side * .535, .50, .6], .022, "frame"))
        # The wall below the window, its sill, and the post behind the door.
        inner, outer = sorted((side * .49, side * .525))
        mesh.add(box([inner, -.50, -1.26], [outer, .44, 1.3], "frame"))
        inner, outer = sorted((side * .47, side * .535))
        mesh.add(box([inner, .44, -1.10], [outer, .47, 1.3], "glare"))
        mesh.add(beam([side * .50, .46, .15], [side * .46, 1.04, .15], .03, "frame"))
    mesh.add(beam([-.44, 1.02, -.68], [.44, 1.02, -.68], .03, "frame"))
    mesh.add(box([-.53, -.54, -1.26], [.53, -.50, 1.3], "glare"))
    return mesh


def beam(start, end, radius, swatch, count=10):
    start, end = np.asarray(start, float), np.asarray(end, float)
    axis = (end - start) / np.linalg.norm(end - start)
    side = np.cross(axis, [0, 1.0, 0.1])
    side /= np.linalg.norm(side)
    other = np.cross(axis, side)
    angles = np.linspace(0, 2 * np.pi, count + 1)
    circle = radius * (np.cos(angles)[:, None] * side + np.sin(angles)[:, None] * other)
    circle[-1] = circle[0]
    points = np.stack([start + circle, end + circle]).transpose(1, 0, 2)
    mesh = MeshBuilder()
    mesh.add_surface(Surface(points, np.broadcast_to(swatch_uv(swatch), points.shape[:2] + (2,))))
    mesh.add_fan(points[:, 0], swatch_uv(swatch), reverse=True)
    mesh.add_fan(points[:, 1], swatch_uv(swatch))
    return mesh
