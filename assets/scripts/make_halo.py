#!/usr/bin/env python3
"""Makes assets/optics/halo.dds and sun_dogs.dds: where crystals of ice send sunlight that went through two of their
faces, by rays through hexagonal prisms.

    make_halo.py FOLDER [--rays 800000] [--dog-rays 250000] [--slice I ...]

halo.dds: crystals of all orientations. Texels in x: 16 to 64 degrees from the light.
sun_dogs.dds, a volume: plates that fall level, but for tilts of 1.5 degrees. x: distance from the place of the least
deviation along the circle of the light's elevation, measured on the sky, -3 to 21 degrees; y: height above that
circle, -5 to 5 degrees; z: elevation of the light, 0 to 60 degrees in equal steps
(--slice: only these are made, the others are 0, and no halo.dds).

Values are scattered radiance per the light's illuminance and optical depth of extinction (1/sr; ice blocks twice its
cross-section), as linear sRGB relative to sunlight. Fresnel's reflectances, total reflections and up to eight meetings
with faces are in it; diffraction, and light that goes on within 10 degrees, are not. The sun's disc is in it. From 54
to 64 degrees halos fade out, and so does what lies at the edges of the sun dogs.
"""
import argparse
import pathlib

import numpy as np

import optics

HALO_TEXELS, HALO_FROM, HALO_TO, HALO_FADES = 481, 16.0, 64.0, 54.0
DOG_TEXELS, DOG_FROM, DOG_TO = 97, -3.0, 21.0
DOG_ROWS, DOG_RISE = 33, 5.0
DOG_ELEVATIONS, DOG_HIGHEST = 21, 60.0
COLUMNS = (0.4, 1.0, 2.5)  # lengths of the prisms over their diameters, each with the same share of light
PLATE = 0.2                # the same of plates
TILT = 1.5                 # degrees, standard deviation of a plate's normal about each level axis
COLOURS = 16
MEETINGS = 8
SMALLEST_DEVIATION = 10.0
RED_INDEX = 1.3070         # of ice where red ends; shaders/shared/atmospheric_optics.glsl has it too


def prism(length):
    """Outward normals [8, 3] and distances [8] of the faces of a prism 1 in radius, its axis along z."""
    around = np.radians(60 * np.arange(6))
    sides = np.stack([np.cos(around), np.sin(around), 0 * around], axis=1)
    normals = np.concatenate([sides, [[0, 0, 1], [0, 0, -1]]])
    return normals, np.concatenate([np.full(6, np.sqrt(0.75)), [length, length]])


def fresnel(cos_in, cos_out, ratio):
    """Reflectance of unpolarised light, ratio = index inside / outside as seen by the incoming ray."""
    s = (cos_in - ratio * cos_out) / (cos_in + ratio * cos_out)
    p = (ratio * cos_in - cos_out) / (ratio * cos_in + cos_out)
    return (s * s + p * p) / 2


def sequence(count, dimensions):
    """Points that fill [0, 1)^dimensions evenly: Roberts (2018), an additive recurrence."""
    root = 2.0
    for _ in range(64):
        root = (1 + root) ** (1 / (dimensions + 1))
    return (0.5 + np.arange(1, count + 1)[:, None] * root ** -np.arange(1.0, dimensions + 1)) % 1


def leave(normals, distances, place, towards, face, index):
    """Rays (unit `towards`, at `place` of face `face`, before they enter) through the prism: yields directions and
    energies of what comes out, and the numbers of the rays that it belongs to."""
    normal = normals[face]
    cos_in = -(normal * towards).sum(axis=1)
    cos_out = np.sqrt(1 - (1 - cos_in**2) / index**2)
    energy = 1 - fresnel(cos_in, cos_out, index)
    inside = towards / index + ((cos_in / index - cos_out)[:, None]) * normal
    number = np.arange(len(place))
    for _ in range(MEETINGS):
        slopes = inside @ normals.T
        with np.errstate(divide="ignore", invalid="ignore"):
            ways = np.where(slopes > 1e-9, (distances - place @ normals.T) / slopes, np.inf)
        ways[np.arange(len(face)), face] = np.inf
        face = ways.argmin(axis=1)
        rows = np.arange(len(face))
        way, cos_in = np.maximum(ways[rows, face], 0), slopes[rows, face]
        place = place + inside * way[:, None]
        normal = normals[face]
        square = 1 - index**2 * (1 - cos_in**2)
        out = square > 0
        cos_out = np.sqrt(np.where(out, square, 0))
        reflected = np.where(out, fresnel(cos_in, cos_out, 1 / index), 1)
        direction = inside * index + (cos_out - index * cos_in)[:, None] * normal
        yield direction[out], (energy * (1 - reflected))[out], number[out]
        energy = energy * reflected
        inside = inside - 2 * cos_in[:, None] * normal
        keep = energy > 1e-3
        place, inside, energy, face, number = (v[keep] for v in (place, inside, energy, face, number))
        if len(place) == 0:
            return


def degrees_between(a, b):
    return np.degrees(np.arctan2(np.linalg.norm(np.cross(a, b), axis=1), (a * b).sum(axis=1)))


def halo(rays):
    """[angle, 3]."""
    nm = optics.wavelengths(COLOURS)
    step = (HALO_TO - HALO_FROM) / (HALO_TEXELS - 1)
    edges = HALO_FROM + step * (np.arange(HALO_TEXELS + 1) - 0.5)
    rings = 2 * np.pi * (np.cos(np.radians(edges[:-1])) - np.cos(np.radians(edges[1:])))
    spectrum = np.zeros((HALO_TEXELS, COLOURS))
    for length in COLUMNS:
        normals, distances = prism(length)
        reach = np.hypot(1, length)
        u = sequence(rays, 4)
        # Towards: even over the sphere, in axes of the crystal. The place: even on a disc across it.
        rise, turn = 2 * u[:, 0] - 1, 2 * np.pi * u[:, 1]
        level = np.sqrt(1 - rise**2)
        towards = np.stack([level * np.cos(turn), level * np.sin(turn), rise], axis=1)
        side = np.stack([-np.sin(turn), np.cos(turn), 0 * turn], axis=1)
        other = np.cross(towards, side)
        out, about = reach * np.sqrt(u[:, 2]), 2 * np.pi * u[:, 3]
        place = (out * np.cos(about))[:, None] * side + (out * np.sin(about))[:, None] * other
        slopes = towards @ normals.T
        with np.errstate(divide="ignore", invalid="ignore"):
            ways = (distances - place @ normals.T) / slopes
        entries = np.where(slopes < -1e-9, ways, -np.inf)
        exits = np.where(slopes > 1e-9, ways, np.inf)
        face, way = entries.argmax(axis=1), entries.max(axis=1)
        hits = way < exits.min(axis=1)
        place = (place + towards * way[:, None])[hits]
        towards, face = towards[hits], face[hits]
        for colour, index in enumerate(optics.ice_index(nm)):
            for direction, energy, number in leave(normals, distances, place, towards, face, index):
                angle = degrees_between(direction, towards[number])
                bins = np.floor((angle - edges[0]) / step).astype(int)
                fits = (bins >= 0) & (bins < HALO_TEXELS) & (angle > SMALLEST_DEVIATION)
                spectrum[:, colour] += np.bincount(bins[fits], energy[fits], HALO_TEXELS) / (2 * len(towards))
    spectrum /= len(COLUMNS) * rings[:, None]
    rgb = optics.through_disc(spectrum @ optics.srgb_weights(nm).T, step)
    degrees = HALO_FROM + step * np.arange(HALO_TEXELS)
    return optics.into_gamut(rgb) * optics.smooth_step((HALO_TO - degrees) / (HALO_TO - HALO_FADES))[:, None]


def least_azimuth(elevation, index):
    """Azimuth from the light (degrees) at which level plates deviate it least (Bravais 1847)."""
    skewed = np.sqrt((index**2 - np.sin(elevation) ** 2) / np.cos(elevation) ** 2)
    return 2 * np.degrees(np.arcsin(np.minimum(skewed / 2, 1))) - 60


def sun_dogs(elevation, rays):
    """[row, x, 3] for a light at an elevation (radians)."""
    nm = optics.wavelengths(COLOURS)
    normals, distances = prism(PLATE)
    towards = -np.array([np.cos(elevation), 0, np.sin(elevation)])  # the light stands at +x
    u = sequence(rays, 6)
    # Turned about the vertical, then tilted by a Gaussian (Box and Muller); faces are lit by their cosines.
    turn = np.pi / 3 * u[:, 0]
    tilt, lean = np.radians(TILT) * np.sqrt(-2 * np.log1p(-u[:, 1])), 2 * np.pi * u[:, 2]
    axis = np.stack([np.cos(lean), np.sin(lean), 0 * lean], axis=1)

    def turned(v, back):
        """From the crystal's axes to the sky's, or back."""
        c, s = np.cos(turn)[:, None], np.sin(turn)[:, None]
        angle = tilt if not back else -tilt

        def about_axis(w):
            ct, st = np.cos(angle)[:, None], np.sin(angle)[:, None]
            return w * ct + np.cross(axis, w) * st + axis * ((axis * w).sum(axis=1) * (1 - ct[:, 0]))[:, None]

        def about_up(w, sign):
            return np.stack([w[:, 0] * c[:, 0] - sign * w[:, 1] * s[:, 0],
                             w[:, 1] * c[:, 0] + sign * w[:, 0] * s[:, 0], w[:, 2]], axis=1)

        return about_up(about_axis(v), -1) if back else about_axis(about_up(v, 1))

    seen = turned(np.broadcast_to(towards, (rays, 3)), True)
    lit = np.maximum(-seen @ normals.T, 0) * np.concatenate([np.full(6, 2 * PLATE), np.full(2, 1.5 * np.sqrt(3))])
    cross_section = lit.sum(axis=1).mean()
    # Only light through the sides makes sun dogs: a side is drawn by its lit area, and a place on it.
    sides = np.cumsum(lit[:, :6], axis=1)
    face = np.minimum((sides < (u[:, 3] * sides[:, -1])[:, None]).sum(axis=1), 5)
    normal = normals[face]
    across = np.stack([-normal[:, 1], normal[:, 0], 0 * turn], axis=1)
    place = normal * distances[face][:, None] + across * (u[:, 4] - 0.5)[:, None]
    place[:, 2] = PLATE * (2 * u[:, 5] - 1)
    share = sides[:, -1] / cross_section / (2 * rays)

    step, rise_step = (DOG_TO - DOG_FROM) / (DOG_TEXELS - 1), 2 * DOG_RISE / (DOG_ROWS - 1)
    least = least_azimuth(elevation, RED_INDEX)
    spectrum = np.zeros((DOG_ROWS, DOG_TEXELS, COLOURS))
    for colour, index in enumerate(optics.ice_index(nm)):
        for direction, energy, number in leave(normals, distances, place, seen, face, index):
            sky = np.empty_like(direction)
            keep_turn, keep_tilt, keep_axis = turn, tilt, axis
            turn, tilt, axis = turn[number], tilt[number], axis[number]
            sky[:] = -turned(direction, False)  # where it is seen
            turn, tilt, axis = keep_turn, keep_tilt, keep_axis
            azimuth = np.degrees(np.arctan2(np.abs(sky[:, 1]), sky[:, 0]))
            rise = np.degrees(np.arctan2(sky[:, 2], np.hypot(sky[:, 0], sky[:, 1])) - elevation)
            along = (azimuth - least) * np.cos(elevation)
            x = np.floor((along - DOG_FROM) / step + 0.5).astype(int)
            y = np.floor((rise + DOG_RISE) / rise_step + 0.5).astype(int)
            fits = (x >= 0) & (x < DOG_TEXELS) & (y >= 0) & (y < DOG_ROWS) & \
                (degrees_between(-sky, np.broadcast_to(towards, sky.shape)) > SMALLEST_DEVIATION)
            spectrum[:, :, colour] += np.bincount(y[fits] * DOG_TEXELS + x[fits], (energy * share[number])[fits],
                                                  DOG_ROWS * DOG_TEXELS).reshape(DOG_ROWS, DOG_TEXELS)
    # Both sun dogs have been added up in one. Solid angle of a texel: along is measured on the sky at the light's
    # elevation, and widths at other heights go by their cosine.
    rises = np.radians(-DOG_RISE + rise_step * np.arange(DOG_ROWS))
    spread = np.cos(elevation + rises) / np.cos(elevation)
    solid = np.radians(step) * np.radians(rise_step) * np.maximum(spread, 1e-3)[:, None, None]
    rgb = (spectrum / (2 * solid)) @ optics.srgb_weights(nm).T
    rgb = optics.through_disc(optics.through_disc(rgb, step, 1), rise_step, 0)
    x = DOG_FROM + step * np.arange(DOG_TEXELS)
    fade = optics.smooth_step((x - DOG_FROM) / 1.0) * optics.smooth_step((DOG_TO - x) / 6)
    fade_rows = optics.smooth_step((DOG_RISE - np.abs(np.degrees(rises))) / 1.0)
    return optics.into_gamut(rgb) * fade[None, :, None] * fade_rows[:, None, None]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--rays", type=int, default=800000)
    parser.add_argument("--dog-rays", type=int, default=250000)
    parser.add_argument("--slice", type=int, action="append")
    given = parser.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    if given.slice is None:
        (given.folder / "halo.dds").write_bytes(optics.dds(halo(given.rays)[None]))
    elevations = np.radians(np.linspace(0, DOG_HIGHEST, DOG_ELEVATIONS))
    dogs = np.zeros((DOG_ELEVATIONS, DOG_ROWS, DOG_TEXELS, 3))
    for i, elevation in enumerate(elevations):
        if given.slice is None or i in given.slice:
            dogs[i] = sun_dogs(elevation, given.dog_rays)
    (given.folder / "sun_dogs.dds").write_bytes(optics.dds(dogs))


if __name__ == "__main__":
    main()
