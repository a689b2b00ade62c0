"""Draws the program's icon as SVG: the aircraft's package under its parachute, before a sky with a cloud over a ridge.

make_icon.py FOLDER writes FOLDER/skydrop.svg, the same bytes at each run.
"""
import math
import pathlib
import sys

SIDE = 128


def polygon(points, fill):
    text = " ".join(f"{x:g},{y:g}" for x, y in points)
    return f'<polygon points="{text}" fill="{fill}"/>'


def circle(x, y, radius, fill):
    return f'<circle cx="{x:g}" cy="{y:g}" r="{radius:g}" fill="{fill}"/>'


def gradient(name, upper, lower):
    return (f'<linearGradient id="{name}" x1="0" y1="0" x2="0" y2="1"><stop offset="0" stop-color="{upper}"/>'
            f'<stop offset="1" stop-color="{lower}"/></linearGradient>')


def cloud(x, y, size):
    puffs = [(-1.1, 0.25, 0.55), (-0.45, -0.15, 0.75), (0.4, -0.3, 0.85), (1.15, 0.2, 0.6)]
    parts = [circle(x + dx * size, y + dy * size, radius * size, "url(#cloud)") for dx, dy, radius in puffs]
    parts.append(f'<rect x="{x - 1.6 * size:g}" y="{y + 0.1 * size:g}" width="{3.3 * size:g}" height="{0.7 * size:g}" '
                 f'rx="{0.35 * size:g}" fill="url(#cloud)"/>')
    return parts


def canopy(x, y, radius):
    """Half a disc of six gores, scalloped below; where its lines begin."""
    gores = 6
    edges = [x - radius * math.cos(math.pi * i / gores) for i in range(gores + 1)]
    parts = []
    for i in range(gores):
        left, right = edges[i], edges[i + 1]
        fill = "#e8502e" if i % 2 == 0 else "#fbe9d2"
        parts.append(f'<path d="M{x:.2f} {y - radius:.2f} Q{left:.2f} {y - 0.85 * radius:.2f} {left:.2f} {y:.2f} '
                     f'Q{(left + right) / 2:.2f} {y - 0.16 * radius:.2f} {right:.2f} {y:.2f} '
                     f'Q{right:.2f} {y - 0.85 * radius:.2f} {x:.2f} {y - radius:.2f} Z" fill="{fill}"/>')
    return parts, [(edge, y) for edge in edges]


def icon():
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {SIDE} {SIDE}" width="{SIDE}" height="{SIDE}">',
             "<title>Skydrop</title>", "<defs>", gradient("sky", "#2f76c4", "#bfe0f2"),
             gradient("cloud", "#ffffff", "#d3dfea"), gradient("near", "#5f8f4a", "#35592f"),
             f'<clipPath id="frame"><rect width="{SIDE}" height="{SIDE}" rx="26"/></clipPath>', "</defs>",
             '<g clip-path="url(#frame)">', f'<rect width="{SIDE}" height="{SIDE}" fill="url(#sky)"/>',
             circle(102, 24, 11, "#fff3c4")]
    parts += cloud(30, 36, 13)
    parts += cloud(100, 62, 9)
    parts.append(polygon([(0, 106), (24, 84), (40, 98), (66, 78), (92, 100), (108, 88), (128, 102), (128, 128),
                          (0, 128)], "#7d95a6"))
    parts.append(polygon([(57, 85), (66, 78), (75, 85.6), (69, 89), (64, 86)], "#f5f8fa"))
    parts.append('<path d="M0 112 Q30 98 62 110 T128 106 V128 H0 Z" fill="url(#near)"/>')
    gores, edges = canopy(64, 50, 27)
    box = 17
    top = 82
    for x, y in edges:
        corner = 64 + (x - 64) / 27 * box / 2
        parts.append(f'<line x1="{x:.2f}" y1="{y:.2f}" x2="{corner:.2f}" y2="{top}" stroke="#3b3f46" stroke-width="1.1"/>')
    parts += gores
    parts.append(f'<rect x="{64 - box / 2:g}" y="{top}" width="{box}" height="{box}" rx="2" fill="#b9813f"/>')
    parts.append(f'<rect x="{64 - 1.75:g}" y="{top}" width="3.5" height="{box}" fill="#f0d9a6"/>')
    parts.append(f'<rect x="{64 - box / 2:g}" y="{top + 6.75:g}" width="{box}" height="3.5" fill="#f0d9a6"/>')
    parts += ["</g>", "</svg>"]
    return "\n".join(parts) + "\n"


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "skydrop.svg").write_text(icon(), encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
