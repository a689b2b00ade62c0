"""The aircraft's paint: every texel is coloured by the place in space that it covers."""

import numpy as np

import paint
from airplane_shape import (
    ATLAS_HEIGHT, ATLAS_WIDTH, FIN_LEFT, FIN_RIGHT, FIN_Y, FIN_Z, FUSELAGE, FUSELAGE_STATIONS, PANEL,
    SWATCHES, SWATCH_NAMES, TAIL_BOTTOM, TAIL_TOP, TAIL_X, TAIL_Z, WING_BOTTOM, WING_TOP, WING_X, WING_Z,
    fuselage_point, monotone, place_fractions)

SEED = 20260101  # weathering of the paint

WHITE = (.93, .92, .89)
RED = (.80, .16, .09)
NAVY = (.09, .14, .27)
BLACK = (.06, .06, .065)
GLASS = (.045, .06, .075)
METAL = (.62, .63, .65)
PAINT_SURFACE = (.22, .72)  # specular reflectance (encoded like the colours) and gloss
MATT_SURFACE = (.16, .25)
GLASS_SURFACE = (.36, .96)
METAL_SURFACE = (.62, .70)


# Where the red belly ends, (z, y): it dips under the windows and sweeps up into the fin.
SWEEP = np.array([(-3.0, .29), (-2.2, .26), (-1.2, .12), (-.2, -.02), (1.0, -.10), (2.0, -.07), (2.8, .06), (3.4, .24),
                  (4.0, .50), (4.8, .92), (5.2, 1.10)])


def above_sweep(z, y):
    return y - monotone(SWEEP[:, 0], SWEEP[:, 1], z)


def window_shapes(z, y):
    """Side windows, as distances over (z, y)."""
    shapes = [[(-.60, .47), (.10, .47), (.10, .90), (-.60, .90)],
              [(.20, .47), (.82, .50), (.82, .88), (.20, .90)],
              [(.92, .51), (1.48, .58), (1.30, .74), (.92, .86)]]
    return np.minimum.reduce([paint.polygon_distance(z, y, s, .06) for s in shapes])


def grime(coat, u, v, amount):
    noise = .6 * paint.value_noise(u * 3, v * 3, SEED) + .4 * paint.value_noise(u * 11, v * 11, SEED + 1)
    coat.colour *= (1 - amount * noise)[..., None]


def line(value, at, width=.016):
    return np.abs(value - at) - width / 2


def paint_fuselage():
    s, t = place_fractions(FUSELAGE)
    z = FUSELAGE_STATIONS[0] + np.clip(s, 0, 1) * (FUSELAGE_STATIONS[-1] - FUSELAGE_STATIONS[0])
    points = fuselage_point(z, np.clip(t, 0, 1))
    x, y = points[..., 0], points[..., 1]
    coat = paint.Coat(s.shape, WHITE, *PAINT_SURFACE)
    # The belly and the cowling are red; the edge sweeps up to the fin, with a navy line above it.
    edge = above_sweep(z, y)
    coat.cover(edge - .085, NAVY, *PAINT_SURFACE)
    coat.cover(edge - .035, WHITE, *PAINT_SURFACE)
    coat.cover(edge, RED, *PAINT_SURFACE)
    coat.cover(np.maximum(z + 2.62, -10), RED, *PAINT_SURFACE)
    # Matt black before the windscreen against glare.
    coat.cover(np.maximum(np.abs(x) - .30 - .05 * (z + 2.0), np.maximum(.3 - y, z + 1.31)), BLACK, *MATT_SURFACE)
    # Glass: windscreen with its middle bar, and three windows on each side.
    screen = paint.polygon_distance(z, y, [(-1.27, .545), (-1.00, .545), (-.70, .60), (-.70, 1.2), (-1.27, 1.2)], .03)
    glass = np.minimum(np.maximum(screen, -(np.abs(x) - .012)), np.maximum(window_shapes(z, y), .2 - np.abs(x)))
    coat.cover(glass - .016, BLACK, *MATT_SURFACE)
    coat.cover(glass, GLASS, *GLASS_SURFACE)
    # The glass shows a little of the sky above and the cabin below.
    coat.cover(np.maximum(glass, .62 + .12 * np.sin(z * 5) - y), (.10, .135, .17), edge=.12, opacity=.7)
    # Doors, panel lines, cowling flaps, rivets.
    side = .2 - np.abs(x)
    for low, high in ((-.66, .14), (.14, .88)):
        door = np.abs(paint.polygon_distance(z, y, [(low, -.38), (high, -.38), (high, .95), (low, .95)], .07)) - .005
        coat.darken(np.maximum(door, side), .45)
        handle = paint.polygon_distance(z, y, [(high - .15, .34), (high - .04, .34), (high - .04, .37), (high - .15, .37)])
        coat.cover(np.maximum(handle, side), METAL, *METAL_SURFACE)
    for at in (-2.62, -1.36, 1.62, 2.5, 3.4, 4.1):
        coat.darken(line(z, at), .22)
    for at in (-2.3, -2.1, -1.9):
        vent = paint.polygon_distance(z, y, [(at, -.28), (at + .10, -.28), (at + .13, -.12), (at + .03, -.12)], .02)
        coat.cover(np.maximum(vent, side), BLACK, *MATT_SURFACE)
    rivets = np.hypot((z * 20) % 1 - .5, 12 * ((t * 24) % 1 - .5)) - .12
    coat.darken(np.where(z > -1.3, rivets, 1.0), .10, .05)
    # Name on both sides, read from outside.
    height, stroke = .24, .050
    width = paint.text_width("SKYDROP", height)
    for sign in (-1, 1):
        start = 1.62 if sign < 0 else 1.62 + width
        along = (z - start) if sign < 0 else (start - z)
        text = paint.text_distance(along, y - .07 - .10 * (z - 1.62), "SKYDROP", height, stroke)
        coat.cover(np.maximum(text, -sign * x - .0), NAVY, *PAINT_SURFACE)
    soot = np.exp(-((np.abs(x) - .26) / .10) ** 2) * np.clip((z + 1.6) / .3, 0, 1) * np.exp(-np.clip(z + 1.4, 0, 9) / 1.2)
    coat.colour *= (1 - .55 * soot * (y < -.2))[..., None]
    grime(coat, z, t * 4, .05)
    return coat


def paint_wing(top):
    s, t = place_fractions(WING_TOP)
    x = WING_X[0] + s * (WING_X[1] - WING_X[0])
    z = WING_Z[0] + t * (WING_Z[1] - WING_Z[0])
    coat = paint.Coat(s.shape, WHITE, *PAINT_SURFACE)
    slant = np.abs(x) - .18 * z
    coat.cover(4.20 - slant, NAVY, *PAINT_SURFACE)
    coat.cover(4.29 - slant, WHITE, *PAINT_SURFACE)
    coat.cover(4.34 - slant, RED, *PAINT_SURFACE)
    height, stroke, text = .62, .11, "SD-1"
    width = paint.text_width(text, height)
    middle = 2.25 if top else -2.25
    along = (x - middle if top else middle - x) + width / 2
    coat.cover(paint.text_distance(along, .42 - z, text, height, stroke), NAVY, *PAINT_SURFACE)
    for at in (0.6, 1.4, 2.2, 2.95, 3.6, 4.95):
        coat.darken(line(np.abs(x), at), .14)
    coat.darken(line(z, -.18), .10)
    coat.darken(np.where(np.abs(x) < 2.95, line(z, .46, .022), 1.0), .28)
    coat.darken(paint.circle_distance(np.abs(x), z, 1.0, -.42, .055), .35)
    rivets = np.hypot((x * 18) % 1 - .5, 6 * ((z * 4.4) % 1 - .5)) - .12
    coat.darken(rivets, .08, .05)
    if top:  # the walkway beside the cabin and the shade where wing and cabin meet
        coat.colour *= (1 - .25 * np.exp(-np.clip(np.abs(x) - .45, 0, 9) / .10) * (np.abs(x) > .45))[..., None]
    else:
        coat.colour *= (1 - .45 * np.exp(-np.clip(np.abs(x) - .55, 0, 9) / .22))[..., None]
    grime(coat, x, z * 3, .05)
    return coat


def paint_tail(top):
    s, t = place_fractions(TAIL_TOP)
    x = TAIL_X[0] + s * (TAIL_X[1] - TAIL_X[0])
    z = TAIL_Z[0] + t * (TAIL_Z[1] - TAIL_Z[0])
    coat = paint.Coat(s.shape, WHITE, *PAINT_SURFACE)
    slant = np.abs(x) - .18 * (z - 4.4)
    coat.cover(1.16 - slant, NAVY, *PAINT_SURFACE)
    coat.cover(1.20 - slant, WHITE, *PAINT_SURFACE)
    coat.cover(1.23 - slant, RED, *PAINT_SURFACE)
    for at in (.6, 1.05):
        coat.darken(line(np.abs(x), at), .14)
    grime(coat, x, z * 3, .05)
    return coat


def paint_fin(sign):
    s, t = place_fractions(FIN_LEFT)
    z = FIN_Z[0] + s * (FIN_Z[1] - FIN_Z[0])
    y = FIN_Y[1] + t * (FIN_Y[0] - FIN_Y[1])
    coat = paint.Coat(s.shape, RED, *PAINT_SURFACE)
    edge = above_sweep(z, y)
    coat.cover(np.abs(edge - .015) - .022, WHITE, *PAINT_SURFACE)
    coat.cover(np.abs(edge - .060) - .025, NAVY, *PAINT_SURFACE)
    # The badge: a parachute over a crate.
    cx, cy, r = 4.50, 1.33, .19
    canopy = np.maximum(paint.circle_distance(z, y, cx, cy, r), cy - .02 - y)
    for k in (-1, 0, 1):
        canopy = np.maximum(canopy, -paint.circle_distance(z, y, cx + k * r * .667, cy - .045, r * .36))
    badge = canopy
    for k in (-.92, -.33, .33, .92):
        badge = np.minimum(badge, paint.segment_distance(z, y, (cx + k * r, cy), (cx, cy - .24)) - .007)
    badge = np.minimum(badge, paint.polygon_distance(z, y, [(cx - .05, cy - .32), (cx + .05, cy - .32),
                                                            (cx + .05, cy - .22), (cx - .05, cy - .22)]))
    coat.cover(badge, WHITE, *PAINT_SURFACE)
    coat.darken(line(y, .78), .12)
    grime(coat, z + sign, y * 3, .05)
    return coat


def paint_panel():
    s, t = place_fractions(PANEL)
    x, y = s * 1.0 - .5, .19 - t * .385
    coat = paint.Coat(s.shape, (.13, .135, .14), *MATT_SURFACE)
    dials = [(-.27 + i * .105, .105 - j * .105, .045) for i in range(3) for j in range(2)]
    dials += [(.10 + i * .09, .105, .036) for i in range(2)] + [(.10 + i * .09, .02, .036) for i in range(2)]
    for k, (cx, cy, r) in enumerate(dials):
        coat.cover(paint.circle_distance(x, y, cx, cy, r + .006), (.30, .30, .31), *METAL_SURFACE, edge=.003)
        coat.cover(paint.circle_distance(x, y, cx, cy, r), (.03, .03, .035), *GLASS_SURFACE, edge=.003)
        if k == 2:  # the artificial horizon
            inner = paint.circle_distance(x, y, cx, cy, r * .85)
            coat.cover(np.maximum(inner, cy - y), (.20, .45, .75), edge=.003)
            coat.cover(np.maximum(inner, y - cy), (.45, .28, .14), edge=.003)
            coat.cover(np.maximum(np.abs(y - cy) - .0015, np.abs(x - cx) - r * .5), (.95, .85, .2), edge=.002)
            continue
        for tick in range(10):
            a = np.radians(225 - tick * 30)
            d = paint.segment_distance(x, y, (cx + r * .72 * np.cos(a), cy + r * .72 * np.sin(a)),
                                       (cx + r * .9 * np.cos(a), cy + r * .9 * np.sin(a)))
            coat.cover(d - .0012, (.9, .9, .88), edge=.002)
        a = np.radians(200 - 37 * k % 260)
        d = paint.segment_distance(x, y, (cx, cy), (cx + r * .7 * np.cos(a), cy + r * .7 * np.sin(a)))
        coat.cover(d - .0018, (.95, .93, .88), edge=.002)
    radio = paint.polygon_distance(x, y, [(.30, -.02), (.45, -.02), (.45, .13), (.30, .13)], .008)
    coat.cover(radio, (.02, .05, .04), *GLASS_SURFACE, edge=.003)
    for k in range(4):
        coat.cover(paint.polygon_distance(x, y, [(.315, .02 + k * .024), (.41 - .02 * (k % 2), .02 + k * .024),
                                                 (.41 - .02 * (k % 2), .03 + k * .024), (.315, .03 + k * .024)]),
                   (.25, .85, .55), edge=.003)
    for k in range(7):
        coat.cover(paint.circle_distance(x, y, -.36 + k * .06, -.135, .011), (.35, .35, .36), edge=.003)
    return coat


SWATCH_COATS = {
    "black": (BLACK, MATT_SURFACE), "tyre": ((.075, .073, .072), (.14, .2)), "metal": (METAL, METAL_SURFACE),
    "red": (RED, PAINT_SURFACE), "white": (WHITE, PAINT_SURFACE), "navy": (NAVY, PAINT_SURFACE),
    "spinner": (WHITE, PAINT_SURFACE), "blade": ((.10, .10, .105), (.20, .5)), "tip": ((.93, .75, .12), PAINT_SURFACE),
    "exhaust": ((.25, .22, .20), (.45, .4)), "glare": ((.03, .03, .033), (.10, .1)),
    "frame": ((.22, .225, .23), MATT_SURFACE), "disc": ((.1, .1, .1), MATT_SURFACE),
}


def livery():
    colour = np.zeros((ATLAS_HEIGHT, ATLAS_WIDTH, 3))
    surface = np.zeros((ATLAS_HEIGHT, ATLAS_WIDTH, 2))
    for place, coat in ((WING_TOP, paint_wing(True)), (WING_BOTTOM, paint_wing(False)), (FUSELAGE, paint_fuselage()),
                        (TAIL_TOP, paint_tail(True)), (TAIL_BOTTOM, paint_tail(False)), (FIN_LEFT, paint_fin(-1)),
                        (FIN_RIGHT, paint_fin(1)), (PANEL, paint_panel())):
        x, y, width, height = place
        colour[y:y + height, x:x + width] = coat.colour
        surface[y:y + height, x:x + width] = coat.surface
    x, y, width, height = SWATCHES
    for i, name in enumerate(SWATCH_NAMES):
        x0, x1 = (x + (i % 6 + k) * width / 6 for k in (0, 1))
        y0, y1 = (y + (i // 6 + k) * height / 3 for k in (0, 1))
        field = (slice(int(y0), int(np.ceil(y1))), slice(int(x0), int(np.ceil(x1))))
        colour[field], surface[field] = SWATCH_COATS[name]
    half = surface.reshape(ATLAS_HEIGHT // 2, 2, ATLAS_WIDTH // 2, 2, 2).mean((1, 3))
    return colour, half[..., [0, 0, 0, 1]]
