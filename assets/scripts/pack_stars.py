#!/usr/bin/env python3
"""Packs a star catalogue of d3-celestial into assets/stars/stars.bin (format: include/skydrop/sky/stars.h).

    npm pack d3-celestial@0.7.35 && tar xzf d3-celestial-0.7.35.tgz
    pack_stars.py package/data/stars.6.json FOLDER

Refuses any other content than that of version 0.7.35, so that it writes the same bytes at each run.
"""

import hashlib
import json
import pathlib
import struct
import sys

SHA256 = "0297b8fa3adfbce1dc26566f61c4abcc1df4f29c6a28729ca06b56d1c6d25602"
# Two stars have no B-V there: theta 1 Orionis C, of type O7 (0.02), and HIP 32609, which is drawn white.
MISSING = {26220: 20, 32609: 0}


def main():
    source, folder = pathlib.Path(sys.argv[1]).read_bytes(), pathlib.Path(sys.argv[2])
    if hashlib.sha256(source).hexdigest() != SHA256:
        sys.exit("%s is not stars.6.json of d3-celestial 0.7.35" % sys.argv[1])
    stars = []
    for feature in json.loads(source)["features"]:
        ascension, declination = feature["geometry"]["coordinates"]  # degrees, ascension -180 to 180
        color = feature["properties"]["bv"]
        stars.append((round(feature["properties"]["mag"] * 1000), feature["id"],
                      round(ascension * 10000) % 3600000, round(declination * 10000),
                      round(float(color) * 1000) if color != "" else MISSING[feature["id"]]))
    stars.sort()
    packed = b"SKYSTAR1" + struct.pack("<I", len(stars))
    for magnitude, number, ascension, declination, color in stars:
        packed += struct.pack("<Iiihh", number, ascension, declination, magnitude, color)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "stars.bin").write_bytes(packed)


if __name__ == "__main__":
    main()
