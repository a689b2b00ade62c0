#!/usr/bin/env python3
"""Writes tests/corpus/models, sounds and stars: small files that are good (good*), or wrong in one way
each that their name says (bad*). The tests read each, and damaged copies of each.

    make_corpus.py [FOLDER]     beside this script unless told
"""

import base64
import copy
import json
import math
import pathlib
import struct
import sys
import zlib

# --- Models -------------------------------------------------------------------------------------------------

POSITIONS = [0, 0, 0, 1, 0, 0, 0, 1, 0]
NORMALS = [0, 0, 1] * 3
UVS = [0, 0, 1, 0, 0, 1]
BINARY = struct.pack("<24f3I", *POSITIONS, *NORMALS, *UVS, 0, 1, 2)

TRIANGLE = {
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"name": "root", "children": [1]}, {"name": "part", "mesh": 0, "translation": [1, 2, 3]}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}, "indices": 3,
                                "material": 0}]}],
    "materials": [{"name": "paint", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
    "textures": [{"source": 0}], "images": [{"uri": "white.png"}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                  {"bufferView": 0, "byteOffset": 36, "componentType": 5126, "count": 3, "type": "VEC3"},
                  {"bufferView": 0, "byteOffset": 72, "componentType": 5126, "count": 3, "type": "VEC2"},
                  {"bufferView": 1, "componentType": 5125, "count": 3, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteLength": 96}, {"buffer": 0, "byteOffset": 96, "byteLength": 12}],
    "buffers": [{"byteLength": len(BINARY)}],
}


def with_change(path, value, root=TRIANGLE):
    """A copy with one member set: "nodes/1/scale"; None takes it away."""
    root = copy.deepcopy(root)
    *way, last = [int(word) if word.isdigit() else word for word in path.split("/")]
    place = root
    for word in way:
        place = place[word]
    if value is None:
        del place[last]
    else:
        place[last] = value
    return root


def chunk(kind, content, fill):
    content += fill * (-len(content) % 4)
    return struct.pack("<I", len(content)) + kind + content


def glb(root, binary=BINARY, more=b""):
    text = root if isinstance(root, str) else json.dumps(root, separators=(",", ":"))
    body = chunk(b"JSON", text.encode(), b" ") + (chunk(b"BIN\0", binary, b"\0") if binary else b"") + more
    return b"glTF" + struct.pack("<II", 2, 12 + len(body)) + body


def gltf(root, uri=None):
    uri = uri or "data:application/octet-stream;base64," + base64.b64encode(BINARY).decode()
    return json.dumps(with_change("buffers/0/uri", uri, root)).encode()


def png(width, height):
    def part(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
    rows = (b"\0" + b"\xff" * (3 * width)) * height
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + part(b"IHDR", header) + part(b"IDAT", zlib.compress(rows, 0)) +
            part(b"IEND", b""))


def interleaved():
    """Positions and texture coordinates (normalised shorts) in turn, indices of one byte, no normals."""
    corners = b"".join(struct.pack("<3f2H", *POSITIONS[3 * i:3 * i + 3], *[int(65535 * t) for t in UVS[2 * i:2 * i + 2]])
                       for i in range(3))
    root = copy.deepcopy(TRIANGLE)
    root["meshes"][0]["primitives"][0]["attributes"] = {"POSITION": 0, "TEXCOORD_0": 1}
    root["meshes"][0]["primitives"][0]["indices"] = 2
    root["bufferViews"] = [{"buffer": 0, "byteLength": 48, "byteStride": 16},
                           {"buffer": 0, "byteOffset": 48, "byteLength": 3}]
    root["accessors"] = [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                         {"bufferView": 0, "byteOffset": 12, "componentType": 5123, "normalized": True, "count": 3,
                          "type": "VEC2"},
                         {"bufferView": 1, "componentType": 5121, "count": 3, "type": "SCALAR"}]
    root["buffers"] = [{"byteLength": 51}]
    return glb(root, corners + bytes([0, 1, 2]))


def doubling_nodes(count=22):
    """Each node names the next twice: 2^21 instances of the triangle."""
    return [{"children": [i + 1, i + 1]} for i in range(count - 1)] + [{"mesh": 0}]


def models():
    two = lambda name, first: json.dumps(TRIANGLE, separators=(",", ":"))[:-1] + f',"{name}":{json.dumps(first)}}}'
    matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
    wrong_index = BINARY[:-4] + struct.pack("<I", 3)
    nan = struct.pack("<f", math.nan) + BINARY[4:]
    primitive = "meshes/0/primitives/0"
    square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
    files = {
        "white.png": png(2, 2),
        "goodTriangle.glb": glb(TRIANGLE),
        "goodInterleaved.glb": interleaved(),
        "goodMirrored.glb": glb(with_change("nodes/1/scale", [-1, 1, 1])),
        "goodDataUri.gltf": gltf(with_change(
            "images/0/uri", "data:image/png;base64," + base64.b64encode(png(1, 1)).decode())),
        "goodPercentEncoded.gltf": gltf(TRIANGLE, "three%20corners.bin"),
        "three corners.bin": BINARY,
        "badTwoNodeLists.glb": glb(two("nodes", doubling_nodes())),
        "badTwoMeshLists.glb": glb(two("meshes", [])),
        "badDoublingNodes.glb": glb(with_change("nodes", doubling_nodes())),
        "badRootListedTwice.glb": glb(with_change("scenes/0/nodes", [0, 0])),
        "badRootWithParent.glb": glb(with_change("scenes/0/nodes", [0, 1])),
        "badSecondBinaryChunk.glb": glb(TRIANGLE, more=chunk(b"BIN\0", BINARY, b"\0")),
        "badSecondJsonChunk.glb": glb(TRIANGLE, b"", chunk(b"JSON", b"{}", b" ")),
        "badBase64.gltf": gltf(TRIANGLE, "data:;base64,AAA*"),
        "badShortBuffer.gltf": gltf(TRIANGLE, "data:;base64,AAAA"),
        "badPercentEncoded.gltf": gltf(TRIANGLE, "%2e%2e/secret.bin"),
        "badIndex.glb": glb(TRIANGLE, wrong_index),
        "badPosition.glb": glb(TRIANGLE, nan),
        "badFourCorners.glb": glb(with_change("accessors/3/count", 2)),
        "badNegativeCount.glb": glb(with_change("accessors/0/count", -3)),
        "badFractionalCount.glb": glb(with_change("accessors/0/count", 3.0)),
        "badSparse.glb": glb(with_change("accessors/0/sparse", {"count": 1})),
        "badIntegerPositions.glb": glb(with_change("accessors/0/componentType", 5125)),
        "badIntegerTextureCoordinates.glb": glb(with_change("accessors/2/componentType", 5123)),
        "badSecondTextureCoordinates.glb": glb(with_change(
            "materials/0/pbrMetallicRoughness/baseColorTexture/texCoord", 1)),
        "badTextureTransform.glb": glb(with_change(
            "materials/0/pbrMetallicRoughness/baseColorTexture/extensions", {"KHR_texture_transform": {"scale": [2, 2]}})),
        "badDraco.glb": glb(with_change("extensionsRequired", ["KHR_draco_mesh_compression"])),
        "badMorphTargets.glb": glb(with_change(primitive + "/targets", [{"POSITION": 0}])),
        "badSkin.glb": glb(with_change("nodes/1/skin", 0)),
        "badCamera.glb": glb(with_change("nodes/0/camera", 0)),
        "badAnimation.glb": glb(with_change("animations", [{}])),
        "badLight.glb": glb(with_change("nodes/0/extensions", {"KHR_lights_punctual": {"light": 0}})),
        "badInstances.glb": glb(with_change("nodes/1/extensions", {"EXT_mesh_gpu_instancing": {"attributes": {}}})),
        "badStrips.glb": glb(with_change(primitive + "/mode", 5)),
        "badZeroScale.glb": glb(with_change("nodes/1/scale", [1, 0, 1])),
        "badZeroRotation.glb": glb(with_change("nodes/1/rotation", [0, 0, 0, 0])),
        "badZeroMatrix.glb": glb(with_change("nodes/0/matrix", [0] * 16)),
        "badFlatMatrix.glb": glb(with_change("nodes/0/matrix", matrix[:8] + [0, 1, 0, 0] + matrix[12:])),
        "badProjectiveMatrix.glb": glb(with_change("nodes/0/matrix", matrix[:3] + [0.5] + matrix[4:])),
        "badMatrixBesideScale.glb": glb(with_change("nodes/1/matrix", matrix)),
        "badManyScales.glb": glb(with_change("nodes", [
            {"scale": [1e-4, 1e-4, 1e-4], "children": [1]}, {"scale": [1e-4, 1e-4, 1e-4], "mesh": 0}])),
        "goodSquare.obj": ("mtllib square.mtl\no square\n" + square + "vt 0 0\nvn 0 0 1\nusemtl white\n"
                           "f 1/1/1 2/1/1 3/1/1 4/1/1\nf -4 -3 -2\n").encode(),
        "square.mtl": b"newmtl white\nKd 1 1 1\nmap_Kd white.png\nnewmtl grey\n",
        "goodLeadingZero.obj": (square + "f 01 2 3\n").encode(),
        "goodWithoutArea.obj": (square + "f 1 2 3\nf 1 1 2\n").encode(),
        "goodSeparateLineEnds.obj": (square + "g a b\nf 1 2 3\ng c\nf 1 3 4\n").replace("\n", "\r").encode(),
        "badIndexZero.obj": (square + "f 0 1 2\n").encode(),
        "badIndexBeforeFirst.obj": (square + "f -5 1 2\n").encode(),
        "badIndexBeyondLast.obj": (square + "f 1 2 5\n").encode(),
        "badMixedCorners.obj": (square + "vn 0 0 1\nf 1//1 2 3//1\n").encode(),
        "badNotANumber.obj": (square + "v nan 0 0\nf 1 2 3\n").encode(),
        "badInfinity.obj": (square + "v 0 -inf 0\nf 1 2 3\n").encode(),
        "badFarAway.obj": (square + "v 0 1e30 0\nf 1 2 3\n").encode(),
        "badFiveNumbers.obj": (square + "v 0 0 0 1 1\nf 1 2 3\n").encode(),
        "badWeight.obj": (square + "v 0 0 0 2\nf 1 2 3\n").encode(),
        "badNormal.obj": (square + "vn 0 0 0\nf 1//1 2//1 3//1\n").encode(),
        "badContinuedLine.obj": (square + "f 1 2 \\\n3\n").encode(),
        "badNoFace.obj": square.encode(),
        "badMaterialFileMissing.obj": ("mtllib none.mtl\n" + square + "f 1 2 3\n").encode(),
        "badMaterialUndefined.obj": ("mtllib square.mtl\n" + square + "usemtl red\nf 1 2 3\n").encode(),
        "badMaterialTwice.obj": ("mtllib twice.mtl\n" + square + "f 1 2 3\n").encode(),
        "twice.mtl": b"newmtl white\nnewmtl white\n",
        "badTextureBeforeMaterial.obj": ("mtllib early.mtl\n" + square + "f 1 2 3\n").encode(),
        "early.mtl": b"map_Kd white.png\n",
        "badTextureOptions.obj": ("mtllib options.mtl\n" + square + "f 1 2 3\n").encode(),
        "options.mtl": b"newmtl white\nmap_Kd -s 2 2 2 white.png\n",
    }
    return files


# --- Sounds -------------------------------------------------------------------------------------------------

RATE = 8000
FRAMES = 128
SINE = [0.5 * math.sin(2 * math.pi * 500 * i / RATE) for i in range(FRAMES)]
GUID = bytes.fromhex("000000001000800000aa00389b71")


def fmt(tag, bits, channels=1, rate=RATE, block=None, more=b""):
    block = channels * bits // 8 if block is None else block
    return b"fmt ", struct.pack("<HHIIHH", tag, channels, rate, rate * block % 2**32, block, bits) + more


def extensible(tag, bits, guid=GUID, valid=None):
    return fmt(0xFFFE, bits, more=struct.pack("<HHIH", 22, bits if valid is None else valid, 4, tag) + guid)


def data(content):
    return b"data", content


def riff(*chunks, mark=b"RIFF", form=b"WAVE", size=None, sizes={}):
    body = form
    for kind, content in chunks:
        body += kind + struct.pack("<I", sizes.get(kind, len(content))) + content + b"\0" * (len(content) % 2)
    return mark + struct.pack("<I", len(body) if size is None else size) + body


def rf64(*chunks, sizes={}, data_bytes=None):
    total = 4 + 8 + 28 + sum(8 + len(c) + len(c) % 2 for _, c in chunks)
    there = next(len(c) for kind, c in chunks if kind == b"data")
    ds64 = b"ds64", struct.pack("<QQQI", total, there if data_bytes is None else data_bytes, FRAMES, 0)
    return riff(ds64, *chunks, mark=b"RF64", size=0xFFFFFFFF, sizes={b"data": 0xFFFFFFFF, **sizes})


def pcm(bits):
    if bits == 8:
        return bytes(round(128 + 127 * s) for s in SINE)
    return b"".join(struct.pack("<i", round((2**31 - 1) * s))[4 - bits // 8:] for s in SINE)


def floats(letter, samples=None):
    samples = SINE if samples is None else samples
    return struct.pack(f"<{len(samples)}{letter}", *samples)


def sounds():
    pcm16 = fmt(1, 16), data(pcm(16))
    broken = lambda bad: SINE[:7] + [bad] + SINE[8:]
    odd = fmt(1, 8), data(pcm(8)[:-1])
    return {
        **{f"goodPcm{bits}.wav": riff(fmt(1, bits), data(pcm(bits))) for bits in (8, 16, 24, 32)},
        "goodFloat32.wav": riff(fmt(3, 32), data(floats("f"))),
        "goodFloat64.wav": riff(fmt(3, 64), data(floats("d"))),
        "goodALaw.wav": riff(fmt(6, 8), data(bytes([0xD5, 0x55] * 64))),
        "goodMuLaw.wav": riff(fmt(7, 8), data(bytes([0xFF, 0x7F] * 64))),
        "goodExtensible.wav": riff(extensible(1, 24), data(pcm(24))),
        "goodExtensibleFloat.wav": riff(extensible(3, 32), data(floats("f"))),
        "goodRf64.wav": rf64(*pcm16),
        "goodOddData.wav": riff(*odd, (b"LIST", b"INFO")),
        "goodOddDataWithoutPadding.wav": riff(*odd)[:-1].replace(
            struct.pack("<I", len(riff(*odd)) - 8), struct.pack("<I", len(riff(*odd)) - 9), 1),
        "goodOtherChunks.wav": riff((b"JUNK", b"abc"), pcm16[0], (b"fact", struct.pack("<I", FRAMES)), pcm16[1]),
        "goodMoreAfterRiff.wav": riff(*pcm16) + b"junk",
        "badBigEndian.wav": riff(*pcm16, mark=b"RIFX"),
        "badAiff.wav": b"FORM" + struct.pack(">I", 4) + b"AIFF",
        "badAvi.wav": riff(*pcm16, form=b"AVI "),
        "badTwoFormats.wav": riff(pcm16[0], *pcm16),
        "badTwoDatas.wav": riff(*pcm16, pcm16[1]),
        "badDataFirst.wav": riff(*reversed(pcm16)),
        "badNoData.wav": riff(pcm16[0]),
        "badNoFormat.wav": riff((b"LIST", b"INFO")),
        "badEmptyData.wav": riff(pcm16[0], data(b"")),
        "badLongData.wav": riff(*pcm16, sizes={b"data": 5000}),
        "badLongDataBeforeChunk.wav": riff(*pcm16, (b"LIST", b"INFO"), sizes={b"data": 5000}),
        "badLongDataExtensible.wav": riff(extensible(1, 16), pcm16[1], sizes={b"data": 5000}),
        "badLongDataRf64.wav": rf64(*pcm16, data_bytes=5000),
        "badUnknownData.wav": riff(*pcm16, sizes={b"data": 0xFFFFFFFF}),
        "badTruncated.wav": riff(*pcm16)[:-20],
        "badTruncatedRf64.wav": rf64(*pcm16)[:-20],
        "badRf64WithoutSizes.wav": riff(*pcm16, mark=b"RF64", size=0xFFFFFFFF),
        "badRf64TwoSizes.wav": rf64(*pcm16, sizes={b"data": 20}),
        "badPartialFrame.wav": riff(pcm16[0], data(pcm(16)[:-1])),
        "badNoChannel.wav": riff(fmt(1, 16, channels=0), pcm16[1]),
        "badThreeChannels.wav": riff(fmt(1, 16, channels=3), data(pcm(16)[:240])),
        "badLowRate.wav": riff(fmt(1, 16, rate=1), pcm16[1]),
        "badHighRate.wav": riff(fmt(1, 16, rate=2**32 - 1), pcm16[1]),
        "badTwelveBits.wav": riff(fmt(1, 12, block=2), pcm16[1]),
        "badBlock.wav": riff(fmt(1, 24, block=4), data(pcm(24))),
        "badShortFormat.wav": riff((b"fmt ", pcm16[0][1][:14]), pcm16[1]),
        "badShortExtension.wav": riff((b"fmt ", extensible(1, 16)[1][:30]), pcm16[1]),
        "badSubFormat.wav": riff(extensible(1, 16, GUID[::-1]), pcm16[1]),
        "badValidBits.wav": riff(extensible(1, 16, valid=24), pcm16[1]),
        "badNotANumber.wav": riff(fmt(3, 32), data(floats("f", broken(math.nan)))),
        "badInfinity.wav": riff(fmt(3, 64), data(floats("d", broken(-math.inf)))),
        "badFullScale.wav": riff(fmt(3, 32), data(floats("f", [32768 * s for s in SINE]))),
        "badMp3.wav": riff(fmt(0x55, 0, block=1, more=bytes(14)), data(bytes(100))),
        "badGsm.wav": riff(fmt(0x31, 0, block=65, more=struct.pack("<HH", 2, 320)), data(bytes(65))),
        "badUnknownEncoding.wav": riff(fmt(0x4242, 8), data(bytes(100))),
        "badAdpcmBlock.wav": riff(fmt(0x11, 4, block=256, more=struct.pack("<HH", 2, 99)), data(bytes(256))),
    }


# --- Stars --------------------------------------------------------------------------------------------------

STARS = [(32349, 1012872, -167161, -1440, 9), (11767, 379546, 892641, 1970, 636), (88, 2691, -488099, 5710, 911)]


def star_file(rows=STARS, count=None, magic=b"SKYSTAR1", more=b""):
    packed = b"".join(struct.pack("<Iiihh", *row) for row in rows)
    return magic + struct.pack("<I", len(rows) if count is None else count) + packed + more


def with_star(index, value):
    """The last star with one number set."""
    row = list(STARS[-1])
    row[index] = value
    return star_file(STARS[:-1] + [tuple(row)])


def stars():
    whole = star_file()
    return {
        "goodThree.bin": whole,
        "goodOne.bin": star_file(STARS[:1]),
        "badEmpty.bin": b"",
        "badHeaderAlone.bin": whole[:12],
        "badTruncatedHeader.bin": whole[:11],
        "badTruncatedStar.bin": whole[:-1],
        "badTrailingByte.bin": star_file(more=b"\0"),
        "badMagic.bin": star_file(magic=b"SKYSTAR2"),
        "badNone.bin": star_file([]),
        "badCountBeyondTheFile.bin": star_file(count=4),
        "badHugeCount.bin": star_file(count=0xFFFFFFFF),
        "badCountThatOverflows.bin": star_file(count=0x10000003),
        "badAscension360.bin": with_star(1, 3600000),
        "badAscensionNegative.bin": with_star(1, -1),
        "badDeclinationBeyondThePole.bin": with_star(2, 900001),
        "badMagnitude.bin": with_star(3, 8001),
        "badColour.bin": with_star(4, -1001),
        "badOrder.bin": with_star(3, 1969),
    }


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent
    for name, files in (("models", models()), ("sounds", sounds()), ("stars", stars())):
        (folder / name).mkdir(parents=True, exist_ok=True)
        for file, content in files.items():
            (folder / name / file).write_bytes(content)


if __name__ == "__main__":
    main()
