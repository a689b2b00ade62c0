"""Painting by distance: shapes as signed distances in metres (negative inside), colours laid over each other."""

import numpy as np

# Strokes of the letters that the project's models carry, in a cell 1 high and WIDTH wide, y upwards.
_ROUND = [(np.cos(a), np.sin(a)) for a in np.linspace(0, 2 * np.pi, 25)]


def _arc(cx, cy, rx, ry, start, end, count=10):
    angles = np.radians(np.linspace(start, end, count))
    return [(cx + rx * np.cos(a), cy + ry * np.sin(a)) for a in angles]


LETTERS = {
    "S": [_arc(.3, .74, .3, .26, 25, 270) + _arc(.3, .26, .3, .26, 90, -155)],
    "K": [[(0, 0), (0, 1)], [(.58, 1), (0, .42)], [(.2, .62), (.6, 0)]],
    "Y": [[(0, 1), (.31, .5), (.62, 1)], [(.31, .5), (.31, 0)]],
    "D": [[(0, 0), (0, 1)] + _arc(.2, .5, .4, .5, 90, -90) + [(0, 0)]],
    "R": [[(0, 0), (0, 1)] + _arc(.3, .74, .28, .26, 90, -90) + [(0, .48)], [(.28, .48), (.58, 0)]],
    "O": [[(.31 + .31 * x, .5 + .5 * y) for x, y in _ROUND]],
    "P": [[(0, 0), (0, 1)] + _arc(.3, .73, .29, .27, 90, -90) + [(0, .46)]],
    "1": [[(.1, .78), (.32, 1), (.32, 0)]],
    "-": [[(.08, .48), (.5, .48)]],
}
ADVANCE = 0.92


def segment_distance(x, y, a, b):
    ax, ay, bx, by = a[0], a[1], b[0], b[1]
    dx, dy = bx - ax, by - ay
    t = np.clip(((x - ax) * dx + (y - ay) * dy) / max(dx * dx + dy * dy, 1e-12), 0, 1)
    return np.hypot(x - ax - t * dx, y - ay - t * dy)


def text_distance(x, y, text, height, stroke, reach=.1):
    """x runs with the reading direction from the first letter's edge, y upwards from the base line. Exact within reach
    (in metres) of each letter's cell; a place farther from all of them is 1e3 away."""
    x, y = np.broadcast_arrays(x, y)
    result = np.full(x.shape, 1e3)
    lines_up = (y > -reach) & (y < height + reach)
    for i, letter in enumerate(text):
        start = i * ADVANCE * height
        near = np.nonzero(lines_up & (x > start - reach) & (x < start + .62 * height + reach))
        near_x, near_y, distance = x[near], y[near], result[near]
        for line in LETTERS[letter]:
            for a, b in zip(line[:-1], line[1:]):
                ax, bx = (a[0] + i * ADVANCE) * height, (b[0] + i * ADVANCE) * height
                distance = np.minimum(distance,
                                      segment_distance(near_x, near_y, (ax, a[1] * height), (bx, b[1] * height)))
        result[near] = distance
    return result - stroke / 2


def text_width(text, height):
    return (len(text) - 1) * ADVANCE * height + .6 * height


def polygon_distance(x, y, corners, rounding=0.0):
    """Signed distance to a polygon whose corners are rounded by the given radius (it keeps its outline)."""
    corners = np.asarray(corners, float)
    if rounding:
        corners = inset(corners, rounding)
    distance = np.full(np.shape(x), 1e3)
    inside = np.zeros(np.shape(x), bool)
    for a, b in zip(corners, np.roll(corners, -1, axis=0)):
        distance = np.minimum(distance, segment_distance(x, y, a, b))
        crosses = (a[1] > y) != (b[1] > y)
        inside ^= crosses & (x < a[0] + (y - a[1]) * (b[0] - a[0]) / (b[1] - a[1] if b[1] != a[1] else 1.0))
    return np.where(inside, -distance, distance) - rounding


def inset(corners, distance):
    """The polygon (counter-clockwise or clockwise, convex) with each side moved inwards."""
    middle = corners.mean(0)
    sides = []
    for a, b in zip(corners, np.roll(corners, -1, axis=0)):
        normal = np.array([b[1] - a[1], a[0] - b[0]]) / np.linalg.norm(b - a)
        if normal @ (middle - a) < 0:
            normal = -normal
        sides.append((normal, normal @ a + distance))
    result = []
    for (n1, d1), (n2, d2) in zip(sides[-1:] + sides[:-1], sides):
        result.append(np.linalg.solve(np.array([n1, n2]), np.array([d1, d2])))
    return np.array(result)


def circle_distance(x, y, cx, cy, radius):
    return np.hypot(x - cx, y - cy) - radius


class Coat:
    """Colour (sRGB), specular reflectance and gloss for many texels at once; later layers cover earlier ones."""

    def __init__(self, shape, colour, specular, gloss):
        self.colour = np.empty(shape + (3,))
        self.surface = np.empty(shape + (2,))
        self.colour[...] = colour
        self.surface[...] = (specular, gloss)

    def cover(self, distance, colour, specular=None, gloss=None, edge=0.006, opacity=1.0):
        """Paints where distance is negative, fading over the edge's width in metres."""
        share = np.clip(0.5 - np.asarray(distance) / edge, 0, 1)[..., None] * opacity
        self.colour += share * (np.asarray(colour, float) - self.colour)
        if specular is not None:
            self.surface += share * (np.array([specular, gloss]) - self.surface)

    def darken(self, distance, amount, edge=0.006):
        self.colour *= 1 - amount * np.clip(0.5 - np.asarray(distance) / edge, 0, 1)[..., None]


def value_noise(x, y, seed):
    """Smooth noise in [0, 1] from a table of random values with the given seed; period 64 cells."""
    table = np.random.RandomState(seed).random_sample((64, 64))
    x0, y0 = np.floor(x).astype(int), np.floor(y).astype(int)
    fx, fy = x - x0, y - y0
    fx, fy = fx * fx * (3 - 2 * fx), fy * fy * (3 - 2 * fy)

    def at(i, j):
        return table[(x0 + i) % 64, (y0 + j) % 64]

    return (at(0, 0) * (1 - fx) + at(1, 0) * fx) * (1 - fy) + (at(0, 1) * (1 - fx) + at(1, 1) * fx) * fy
