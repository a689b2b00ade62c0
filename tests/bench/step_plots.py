#!/usr/bin/env python3
"""Plots of a step in each control for docs/flight.md, one SVG file a control, from the program's own flights.

    python3 tests/bench/step_plots.py PROGRAM docs/figures

For every curve it writes an input log (a control goes to its end in one step, stays there, and is let go), flies
it with `simulate --replay LOG --trace FILE.csv` and draws columns of that table. Needs Python 3 only.
"""

import argparse
import csv
import json
import pathlib
import subprocess
import tempfile

STEPS_PER_SECOND = 120
CONTROLS = ("thrust", "brake", "pitch", "roll", "yaw")
COLOURS = ("#1b7fb5", "#222222", "#d1602a")  # low, default, high
WIDTH, HEIGHT, LEFT, TOP, GAP_X, GAP_Y = 250, 130, 58, 58, 52, 46


class Figure:
    """A control, when it is let go, the parameters to vary and the columns to draw of each."""

    def __init__(self, control, hold, seconds, speed, panels):
        self.control, self.hold, self.seconds, self.speed, self.panels = control, hold, seconds, speed, panels


LOAD = ("load_factor", "load, g")
FIGURES = {
    "pitch": Figure("pitch", 2, 7, 90, [
        ("aircraft.pitchSpeed", (10, 20, 35), [("pitch_deg", "pitch, °"), LOAD]),
        ("aircraft.pitchFade", (0, .5, 1), [("pitch_deg", "pitch, °"), LOAD]),
        ("aircraft.stabilizingPitch", (.2, .65, 1.3), [("pitch_deg", "pitch, °"), LOAD])]),
    "roll": Figure("roll", 1.5, 8, 70, [
        ("aircraft.rollFactor", (.4, .75, 1.2), [("bank_deg", "bank, °"), ("roll_rate_dps", "roll rate, °/s")]),
        ("aircraft.stabilizingRoll", (.2, .5, 1), [("bank_deg", "bank, °"), ("roll_rate_dps", "roll rate, °/s")]),
        ("aircraft.rollSpeed", (16, 32.175, 64), [("bank_deg", "bank, °"), ("roll_rate_dps", "roll rate, °/s")]),
        ("aircraft.inducedYawFactor", (0, .055, .5), [("bank_deg", "bank, °"), ("yaw_rate_dps", "yaw rate, °/s")])]),
    "yaw": Figure("yaw", 3, 8, 70, [
        ("aircraft.yawSpeed", (16, 32.175, 64), [("nose_deg", "nose, °"), ("slip_deg", "nose off the path, °")])]),
    "throttle": Figure("thrust", 40, 90, 70, [
        ("aircraft.maxThrottle", (120, 198, 300), [("airspeed_mps", "airspeed, m/s"), ("throttle", "throttle")])]),
}


def fly(program, folder, figure, path, value):
    """The table of one flight, as columns."""
    scene = folder / "scene.json"
    scene.write_text(json.dumps({"schema": 1, "description": "High over the sea.", "effects": ["aircraft"],
                                 "start": {"position": [0, 2000, 0], "heading": 0, "speed": figure.speed}}))

    def run(seconds, level):
        controls = [level if name == figure.control else 0 for name in CONTROLS]
        return [round(seconds * STEPS_PER_SECOND), *controls, 0]

    log, table = folder / "log.json", folder / "trace.csv"
    log.write_text(json.dumps({
        "schema": 1, "kind": "skydrop input log", "scene": str(scene), "seed": 1,
        "settings": [[path, str(value)]], "changes": [],
        "runs": [run(figure.hold, 127), run(figure.seconds - figure.hold, 0)]}))
    subprocess.run([program, "simulate", "--replay", str(log), "--seconds", str(figure.seconds), "--trace",
                    str(table)], check=True, stdout=subprocess.DEVNULL)
    with table.open() as file:
        rows = list(csv.DictReader(file))
    columns = {name: [float(row[name]) for row in rows] for name in rows[0]}
    columns["nose_deg"] = [(h + 180) % 360 - 180 for h in columns["heading_deg"]]
    columns["slip_deg"] = [-s for s in columns["sideslip_deg"]]
    return columns


def ticks(low, high):
    """Three to six round numbers."""
    step = 1e-3
    while (high - low) / step > 6:
        step *= 2.5 if str(step).lstrip("0.")[0] == "2" else 2
    first = int(low / step) - 1
    return [round(k * step, 6) for k in range(first, first + 12) if low <= k * step <= high]


def panel(x, y, title, label, seconds, hold, curves):
    values = [v for _, _, column in curves for v in column]
    low, high = min(values + [0]), max(values)
    margin = .06 * (high - low or 1)
    low, high = low - margin, high + margin
    to_x = lambda t: x + WIDTH * t / seconds
    to_y = lambda v: y + HEIGHT * (high - v) / (high - low)
    out = [f'<rect x="{x}" y="{y}" width="{WIDTH * hold / seconds:.1f}" height="{HEIGHT}" fill="#eef1f4"/>']
    for v in ticks(low, high):
        out.append(f'<path d="M{x} {to_y(v):.1f}h{WIDTH}" stroke="#d4d9de"/>'
                   f'<text x="{x - 5}" y="{to_y(v) + 4:.1f}" text-anchor="end">{v:g}</text>')
    for t in ticks(0, seconds):
        out.append(f'<text x="{to_x(t):.1f}" y="{y + HEIGHT + 14}" text-anchor="middle">{t:g} s</text>')
    for colour, times, column in curves:
        every = max(1, len(column) // 160)
        points = list(zip(times, column))[::every]
        out.append(f'<polyline fill="none" stroke="{colour}" stroke-width="1.6" points="' +
                   " ".join(f"{to_x(t):.1f},{to_y(v):.1f}" for t, v in points) + '"/>')
    out.append(f'<rect x="{x}" y="{y}" width="{WIDTH}" height="{HEIGHT}" fill="none" stroke="#8a939b"/>')
    out.append(f'<text x="{x + WIDTH - 6}" y="{y + 15}" text-anchor="end" font-style="italic">{label}</text>')
    if title:
        out.append(f'<text x="{x}" y="{y - 22}" font-weight="bold">{title[0]}</text>')
        for k, value in enumerate(title[1]):
            out.append(f'<text x="{x + 75 * k}" y="{y - 7}" fill="{COLOURS[k]}">— {value:g}</text>')
    return out


def draw(name, figure, program, folder):
    rows = max(len(columns) for _, _, columns in figure.panels)
    width = max(LEFT + len(figure.panels) * (WIDTH + GAP_X), 480)
    height = TOP + rows * (HEIGHT + GAP_Y) - 10
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
           f'viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="11">',
           f'<rect width="{width}" height="{height}" fill="white"/>',
           f'<text x="10" y="18" font-size="13">Step of {name}: full for {figure.hold:g} s (grey), then let go; '
           f'level flight at {figure.speed:g} m/s</text>']
    for column, (path, values, responses) in enumerate(figure.panels):
        flights = [fly(program, folder, figure, path, value) for value in values]
        for row, (key, label) in enumerate(responses):
            x, y = LEFT + column * (WIDTH + GAP_X), TOP + row * (HEIGHT + GAP_Y)
            title = (path.split(".")[1], values) if row == 0 else None
            curves = [(COLOURS[k], flight["time_s"], flight[key]) for k, flight in enumerate(flights)]
            curves = [curves[0], curves[2], curves[1]]  # the default on top
            out += panel(x, y, title, label, figure.seconds, figure.hold, curves)
    return "\n".join(out + ["</svg>", ""])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="the built skydrop")
    parser.add_argument("folder", type=pathlib.Path, help="where the SVG files go")
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary:
        for name, figure in FIGURES.items():
            text = draw(name, figure, arguments.program, pathlib.Path(temporary))
            (arguments.folder / f"step_{name}.svg").write_text(text)


if __name__ == "__main__":
    main()
