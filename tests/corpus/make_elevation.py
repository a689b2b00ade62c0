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
        with open(os.path.join(folder, name), "wb") as file:
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


main()
