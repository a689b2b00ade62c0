#!/usr/bin/env python3
"""Writes the elevation files of tests/corpus/elevation: good* are read, bad* are refused. Standard library alone.

    make_elevation.py [FOLDER]
"""
import math
import os
import struct
import sys
import zipfile
import zlib

WIDTH, HEIGHT = 20, 12


def height(column, row):
    return 500 + 30 * math.sin(column / 3) + 5 * row


def tiff(entries, blobs):
    """entries: tag -> (type, count, value or bytes); blobs: data that the entry 'data' of offsets points to."""
    sizes = {1: 1, 2: 1, 3: 2, 4: 4, 12: 8}
    head = 8
    data = b"".join(blobs)
    offsets, at = [], head
    for blob in blobs:
        offsets.append(at)
        at += len(blob)
    data += b"\0" * (at % 2)
    at += at % 2
    directory, extra = b"", b""
    ifd = at
    after = ifd + 2 + 12 * len(entries) + 4
    for tag in sorted(entries):
        kind, count, value = entries[tag]
        if value == "offsets":
            value = b"".join(struct.pack("<I", o) for o in offsets)
        if len(value) <= 4:
            field = value.ljust(4, b"\0")
        else:
            field = struct.pack("<I", after + len(extra))
            extra += value + b"\0" * (len(value) % 2)
        assert len(value) == sizes[kind] * count, tag
        directory += struct.pack("<HHI", tag, kind, count) + field
    return (b"II*\0" + struct.pack("<I", ifd) + data + struct.pack("<H", len(entries)) + directory +
            struct.pack("<I", 0) + extra)


def short(*values):
    return (3, len(values), b"".join(struct.pack("<H", v) for v in values))


def long(*values):
    return (4, len(values), b"".join(struct.pack("<I", v) for v in values))


def double(*values):
    return (12, len(values), b"".join(struct.pack("<d", v) for v in values))


def geo(entries, nodata="-9999"):
    keys = [1, 1, 0, 3, 1024, 0, 1, 1, 1025, 0, 1, 1, 3072, 0, 1, 2056]
    entries.update({33550: double(2, 2, 0), 33922: double(0, 0, 0, 2600000, 1200000, 0), 34735: short(*keys)})
    text = nodata.encode() + b"\0"
    entries[42113] = (2, len(text), text)
    return entries


def strips(rows_per_strip=5, width=WIDTH, length=HEIGHT, compress=False, **changes):
    blobs = []
    for top in range(0, HEIGHT, rows_per_strip):
        raw = b"".join(struct.pack("<h", round(height(c, r))) for r in range(top, min(top + rows_per_strip, HEIGHT))
                       for c in range(WIDTH))
        blobs.append(zlib.compress(raw) if compress else raw)
    entries = {256: long(width), 257: long(length), 258: short(16), 259: short(8 if compress else 1),
               262: short(1), 273: (4, len(blobs), "offsets"), 277: short(1), 278: long(rows_per_strip),
               279: long(*[len(b) for b in blobs]), 339: short(2)}
    entries = geo(entries)
    entries.update(changes.get("entries", {}))
    return tiff(entries, blobs)


def float_tiles(side=16):
    blobs = []
    for top in range(0, HEIGHT, side):
        for left in range(0, WIDTH, side):
            raw = b"".join(struct.pack("<f", -9999 if (c, r) == (3, 4) else height(c, r))
                           for r in range(top, top + side) for c in range(left, left + side))
            blobs.append(zlib.compress(raw))
    entries = {256: long(WIDTH), 257: long(HEIGHT), 258: short(32), 259: short(8), 262: short(1), 277: short(1),
               322: long(side), 323: long(side), 324: (4, len(blobs), "offsets"),
               325: long(*[len(b) for b in blobs]), 339: short(3)}
    return tiff(geo(entries), blobs)


def picture(bands=3, side=0, compress=False, rows_per_strip=5, **changes):
    """An aerial image of 8-bit bands, in tiles where a side is given."""
    def pixel(c, r):
        return bytes([(c * 12) & 255, (r * 20) & 255, 128, 255 if c > 2 else 0][:bands] if bands > 1 else [c * 12 & 255])

    blobs = []
    if side:
        parts = [(x, y, side, side) for y in range(0, HEIGHT, side) for x in range(0, WIDTH, side)]
    else:
        parts = [(0, y, WIDTH, min(rows_per_strip, HEIGHT - y)) for y in range(0, HEIGHT, rows_per_strip)]
    for x, y, columns, rows in parts:
        raw = b"".join(pixel(x + c, y + r) for r in range(rows) for c in range(columns))
        blobs.append(zlib.compress(raw) if compress else raw)
    entries = {256: long(WIDTH), 257: long(HEIGHT), 258: short(*[8] * bands), 259: short(8 if compress else 1),
               262: short(2 if bands >= 3 else 1), 277: short(bands), 284: short(1)}
    if bands in (2, 4):
        entries[338] = short(2)
    counts = long(*[len(b) for b in blobs])
    if side:
        entries.update({322: long(side), 323: long(side), 324: (4, len(blobs), "offsets"), 325: counts})
    else:
        entries.update({273: (4, len(blobs), "offsets"), 278: long(rows_per_strip), 279: counts})
    entries = geo(entries)
    del entries[42113]
    entries.update(changes.get("entries", {}))
    return tiff(entries, blobs)


def png(decode_base):
    rows = b""
    for r in range(8):
        rows += b"\0"
        for c in range(8):
            code = decode_base(height(c, r))
            rows += bytes([code >> 16 & 255, code >> 8 & 255, code & 255])
    def chunk(name, body):
        return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 8, 8, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def ascii_grid():
    lines = ["ncols 6", "nrows 4", "xllcorner 2600000", "yllcorner 1200000", "cellsize 10", "NODATA_value -9999"]
    for r in range(4):
        lines.append(" ".join("-9999" if (c, r) == (1, 1) else "%.1f" % height(c, r) for c in range(6)))
    return "\n".join(lines) + "\n"


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), "elevation")

    def write(name, content):
        path = os.path.join(folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "wb") as file:
            file.write(content if isinstance(content, bytes) else content.encode())

    good = strips()
    write("goodStrips.tif", good)
    write("goodDeflate.tif", strips(compress=True))
    write("goodTiles.tif", float_tiles())
    write("good.asc", ascii_grid())
    write("good.xyz", "X Y Z\n" + "".join("%d %d %.2f\n" % (2600001 + 2 * c, 1200001 + 2 * r, height(c, r))
                                         for r in range(5) for c in range(7)))
    write("goodTerrarium.png", png(lambda h: round((h + 32768) * 256)))
    write("goodRgb.png", png(lambda h: round((h + 10000) * 10)))
    for name in ("goodTerrarium.pgw", "goodRgb.pgw", "badColours.pgw"):
        write(name, "10\n0\n0\n-10\n2600005\n1200075\n")
    posts = bytearray()
    for r in range(1201):
        posts += struct.pack(">h", 400 + r // 8) * 1201
    with zipfile.ZipFile(os.path.join(folder, "goodSrtm.hgt.zip"), "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr(zipfile.ZipInfo("N46E007.hgt", (2026, 1, 1, 0, 0, 0)), bytes(posts), zipfile.ZIP_DEFLATED, 9)

    write("badCutOff.tif", good[:200])
    write("badHuge.tif", strips(entries={256: long(200000), 257: long(200000)}))
    write("badStripCounts.tif", strips(entries={278: long(3)}))
    write("badStripBytes.tif", strips(entries={279: long(10, 10, 10)}))
    write("badRowsPerStrip.tif", strips(entries={278: long(0)}))
    write("badBands.tif", strips(entries={277: short(3)}))
    write("badBits.tif", strips(entries={258: short(7)}))
    write("badPacking.tif", strips(entries={259: short(7)}))
    write("badNoPlace.tif", strips(entries={33550: double(0, 0, 0)}))
    write("badNaNPlace.tif", strips(entries={33922: double(0, 0, 0, float("nan"), 1200000, 0)}))
    write("badSystem.tif", strips(entries={34735: short(1, 1, 0, 1, 3072, 0, 1, 31)}))
    loop = bytearray(good)
    struct.pack_into("<I", loop, 4, 2)
    write("badDirectory.tif", bytes(loop))
    write("badEmpty.asc", "")
    write("badCells.asc", "ncols 3\nnrows 2\nxllcorner 7\nyllcorner 46\ncellsize 0\n1 2 3 4 5 6\n")
    write("badHuge.asc", "ncols 200000\nnrows 200000\nxllcorner 7\nyllcorner 46\ncellsize 1\n1\n")
    write("badFew.asc", "ncols 3\nnrows 2\nxllcorner 7\nyllcorner 46\ncellsize 1\n1 2 3 4 5\n")
    write("badMany.asc", "ncols 3\nnrows 2\nxllcorner 7\nyllcorner 46\ncellsize 1\n1 2 3 4 5 6 7\n")
    write("badWord.asc", "ncols 3\nnrows 2\nxllcorner 7\nyllcorner 46\ncellsize 1\nfoo 1\n1 2 3 4 5 6\n")
    write("badGrid.xyz", "7 46 1\n7.1 46 2\n7.14 46 3\n")
    write("badLine.xyz", "7 46 1\n7.1 46\n")
    write("badInfinite.xyz", "7 46 1\ninf 46 1\n")
    write("badZip.zip", b"PK\x03\x04" + bytes(40))
    write("badColours.png", png(lambda h: 0xfe0000))

    # Aerial images.
    rgb = picture()
    write("../aerial/goodStrips.tif", rgb)
    write("../aerial/goodTiles.tif", picture(4, 16, True))
    write("../aerial/goodGrey.tif", picture(1, compress=True))
    write("../aerial/goodPicture.png", png(lambda h: 0x4060a0 + int(h) % 32))
    write("../aerial/goodPicture.pgw", "10\n0\n0\n-10\n2600005\n1200075\n")
    write("../aerial/badCutOff.tif", rgb[:150])
    write("../aerial/badLastStrip.tif", picture(entries={279: long(300, 300, 3000000)}))
    write("../aerial/badStripCounts.tif", picture(entries={278: long(3)}))
    write("../aerial/badBits.tif", picture(entries={258: short(16, 16, 16)}))
    write("../aerial/badPlanes.tif", picture(entries={284: short(2)}))
    write("../aerial/badColours.tif", picture(entries={262: short(8)}))
    write("../aerial/badPacking.tif", picture(entries={259: short(34712)}))
    write("../aerial/badHuge.tif", picture(entries={256: long(200000), 257: long(200000)}))
    write("../aerial/badNoPlace.tif", picture(entries={33550: double(0, 0, 0)}))
    write("../aerial/badSystem.tif", picture(entries={34735: short(1, 1, 0, 1, 3072, 0, 1, 31)}))
    write("../aerial/badPixels.tif", picture(compress=True, entries={279: long(9, 9, 9)}))
    write("../aerial/badAlone.png", png(lambda h: 0))
    write("../aerial/badRotated.png", png(lambda h: 0))
    write("../aerial/badRotated.pgw", "10\n1\n1\n-10\n2600005\n1200075\n")
    write("../aerial/badWord.png", png(lambda h: 0))
    write("../aerial/badWord.pgw", "10\n0\nzero\n-10\n2600005\n1200075\n")
    write("../aerial/badFew.png", png(lambda h: 0))
    write("../aerial/badFew.pgw", "10\n0\n0\n")
    write("../aerial/badText.jpg", "no picture")


main()
