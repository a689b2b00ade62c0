#!/usr/bin/env python3
"""Makes assets/optics/rainbow.dds: how raindrops scatter sunlight around the antisolar point, by Mie's theory.

    make_rainbow.py FOLDER [--rows 15] [--row I ...]

Texels in x: 0 to 90 degrees from the antisolar point; in y: median radii of the drops, 0.1 to 1 mm in equal steps of
their logarithm (--rows: how many; --row: only these are made, the others are 0). Values are scattered radiance per
sunlight's illuminance and optical depth of extinction (1/sr), as linear sRGB relative to sunlight. Mie's series as in
Bohren and Huffman (1983), appendix A; drops vary by 12 % about their median; the sun's disc is in it. From 70 to 90
degrees it fades out: what rain scatters there is no rainbow.
"""
import argparse
import pathlib

import numpy as np

import optics

ANGLES = 1024
FARTHEST = 90.0
SPREAD = 0.12   # standard deviation of radii, relative
SIZES = 9       # radii about each median
COLOURS = 32
FADES_FROM = 70.0


def radii_mm(rows):
    return 10 ** np.linspace(-1, 0, rows)


def coefficients(x, m):
    """Mie's a_n, b_n [n, sphere] for arrays of size parameters x and real indices m."""
    orders = int(np.max(x + 4 * np.cbrt(x) + 2)) + 1
    mx = m * x
    start = int(max(orders, np.max(mx))) + 16
    log_derivative = np.zeros((orders + 1, len(x)))
    d = np.zeros(len(x))
    for n in range(start, 0, -1):
        d = n / mx - 1 / (d + n / mx)
        if n - 1 <= orders:
            log_derivative[n - 1] = d
    psi0, psi1, chi0, chi1 = np.cos(x), np.sin(x), -np.sin(x), np.cos(x)
    a, b = np.zeros((2, orders, len(x)), complex)
    last = x + 4 * np.cbrt(x) + 2
    for n in range(1, orders + 1):
        psi = (2 * n - 1) * psi1 / x - psi0
        chi = (2 * n - 1) * chi1 / x - chi0
        xi, xi1 = psi - 1j * chi, psi1 - 1j * chi1
        ta = log_derivative[n] / m + n / x
        tb = log_derivative[n] * m + n / x
        counts = n <= last
        a[n - 1] = np.where(counts, (ta * psi - psi1) / (ta * xi - xi1), 0)
        b[n - 1] = np.where(counts, (tb * psi - psi1) / (tb * xi - xi1), 0)
        psi0, psi1 = psi1, np.where(counts, psi, 0)
        chi0, chi1 = chi1, np.where(counts, chi, 1)
    return a, b


def scattering(x, m, cosines):
    """(|S1|^2 + |S2|^2) / 2 [angle, sphere] and the efficiency of extinction [sphere]."""
    a, b = coefficients(x, m)
    orders = len(a)
    n = np.arange(1, orders + 1)[:, None]
    extinction = 2 / x**2 * ((2 * n + 1) * (a + b).real).sum(axis=0)
    s1, s2 = np.zeros((2, len(cosines), len(x)), complex)
    pi0, pi1 = np.zeros(len(cosines)), np.ones(len(cosines))
    block = 512
    for first in range(1, orders + 1, block):
        count = min(block, orders + 1 - first)
        pis, taus = np.empty((2, len(cosines), count))
        for i in range(count):
            order = first + i
            pis[:, i] = pi1
            taus[:, i] = order * cosines * pi1 - (order + 1) * pi0
            pi0, pi1 = pi1, ((2 * order + 1) * cosines * pi1 - (order + 1) * pi0) / order
        part = slice(first - 1, first - 1 + count)
        weight = (2 * n[part] + 1) / (n[part] * (n[part] + 1))
        wa, wb = weight * a[part], weight * b[part]
        for s, left, right in ((s1, wa, wb), (s2, wb, wa)):
            s.real += pis @ left.real + taus @ right.real
            s.imag += pis @ left.imag + taus @ right.imag
    return (np.abs(s1) ** 2 + np.abs(s2) ** 2) / 2, extinction


def row(radius_mm):
    """[angle, 3] of drops about a median radius."""
    degrees = FARTHEST * np.arange(ANGLES) / (ANGLES - 1)
    cosines = -np.cos(np.radians(degrees))
    nm = optics.wavelengths(COLOURS)
    m = optics.water_index(nm)
    scattered, extinct = np.zeros((ANGLES, COLOURS)), np.zeros(COLOURS)
    for step in np.linspace(-2, 2, SIZES):
        radius_nm = radius_mm * 1e6 * (1 + SPREAD * step)
        share = np.exp(-0.5 * step**2)
        k = 2 * np.pi / nm
        intensity, efficiency = scattering(k * radius_nm, m, cosines)
        scattered += share * intensity / k**2
        extinct += share * efficiency * np.pi * radius_nm**2
    rgb = (scattered / extinct) @ optics.srgb_weights(nm).T
    rgb = optics.into_gamut(optics.through_disc(rgb, FARTHEST / (ANGLES - 1)))
    return rgb * optics.smooth_step((FARTHEST - degrees) / (FARTHEST - FADES_FROM))[:, None]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--rows", type=int, default=15)
    parser.add_argument("--row", type=int, action="append")
    given = parser.parse_args()
    table = np.zeros((given.rows, ANGLES, 3))
    for i, radius in enumerate(radii_mm(given.rows)):
        if given.row is None or i in given.row:
            table[i] = row(radius)
    given.folder.mkdir(parents=True, exist_ok=True)
    (given.folder / "rainbow.dds").write_bytes(optics.dds(table))


if __name__ == "__main__":
    main()
