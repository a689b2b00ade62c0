#!/usr/bin/env python3
"""A second judge of light in clouds: Mitsuba 3 (pip install mitsuba) on a grid that a test has too.

Prints what tests/stability/cloud_mitsuba_test.cpp holds clouds::traceRays() against: the mean radiance of a picture
of a box of cloud of 16 x 16 x 16 voxels, lit by a sun of illuminance 1, with its standard error.

    pip install mitsuba
    noise_scripts/cloud_mitsuba.py [paths a pixel]
"""

import sys

import mitsuba as mi
import numpy as np

mi.set_variant("scalar_rgb")

SIDE = 16  # voxels
BOX_M = 1000.0
EXTINCTION = 0.04  # 1/m, of the densest voxel
PIXELS = 8
SUN = np.array([0.48, 0.6, 0.64])
EYE = np.array([-1500.0, 200.0, 900.0])
FOV_DEGREES = 35.0


def density(x, y, z):
    """Of a voxel, in [0, 1]; integers alone, so that every language has the same bits."""
    bump = (3 * x * (15 - x) + 5 * y * (15 - y) + 4 * z * (15 - z)) / 675.0
    hole = ((x * 7 + y * 3 + z * 5) % 4) / 3.0
    return bump * (0.4 + 0.6 * hole)


def scene(phase):
    grid = np.zeros((SIDE, SIDE, SIDE, 1), dtype=np.float32)  # z, y, x
    for z in range(SIDE):
        for y in range(SIDE):
            for x in range(SIDE):
                grid[z, y, x, 0] = density(x, y, z)
    to_world = mi.ScalarTransform4f().scale(BOX_M)
    return mi.load_dict({
        "type": "scene",
        "integrator": {"type": "volpath", "max_depth": -1, "rr_depth": 1000},
        "sun": {"type": "directional", "direction": (-SUN).tolist(), "irradiance": {"type": "rgb", "value": 1.0}},
        "box": {
            "type": "cube",
            "to_world": mi.ScalarTransform4f().translate(BOX_M / 2).scale(BOX_M / 2),
            "bsdf": {"type": "null"},
            "interior": {
                "type": "heterogeneous",
                "albedo": 1.0,
                "scale": EXTINCTION,
                "sigma_t": {
                    "type": "gridvolume",
                    "grid": mi.VolumeGrid(grid),
                    "filter_type": "nearest",
                    "use_grid_bbox": False,
                    "to_world": to_world,
                },
                "phase": phase,
            },
        },
        "sensor": {
            "type": "perspective",
            "fov": FOV_DEGREES,
            "to_world": mi.ScalarTransform4f().look_at(EYE.tolist(), [BOX_M / 2] * 3, [0, 1, 0]),
            "film": {"type": "hdrfilm", "width": PIXELS, "height": PIXELS, "rfilter": {"type": "box"},
                     "pixel_format": "luminance", "component_format": "float32"},
            "sampler": {"type": "independent"},
        },
    })


def main():
    paths = int(sys.argv[1]) if len(sys.argv) > 1 else 1024
    phases = {
        "even": {"type": "isotropic"},
        "g .3": {"type": "hg", "g": 0.3},
        "two lobes": {"type": "blendphase", "weight": 0.15, "a": {"type": "hg", "g": 0.119}, "b": {"type": "hg", "g": 0.85}},
    }
    parts = 16
    for name, phase in phases.items():
        of = scene(phase)
        means = [float(np.mean(np.array(mi.render(of, spp=max(paths // parts, 1), seed=i)))) for i in range(parts)]
        print(f"{name}: {np.mean(means):.6f} +- {np.std(means, ddof=1) / parts ** 0.5:.6f}")


if __name__ == "__main__":
    main()
