"""Meshes, textures and binary glTF: what the model scripts share.

Every number that reaches a file is rounded to a coarse step first. Sine, square root and FFT may differ in
their last bit between processors and numpy versions; after the rounding the files are the same bit for bit.
"""

import json
import struct
import zlib

import numpy as np

POSITION_STEP = 2.0**-14  # metres, 0.06 mm
NORMAL_STEP = 2.0**-12
UV_STEP = 2.0**-14
TIE_SHIFT = 1e-4  # of a step: designed values that sit between two steps round the same way everywhere


def quantise(values, step):
    return np.floor(np.asarray(values, float) / step + 0.5 + TIE_SHIFT) * step + 0.0


class Surface:
    """A grid of points P[i, j] with texture coordinates, wound so that (dP/di) x (dP/dj) points outwards."""

    def __init__(self, points, uv):
        self.points = np.asarray(points, float)
        self.uv = np.asarray(uv, float)


class MeshBuilder:
    """Triangles with a position and a texture coordinate at each corner; normals come at the end."""

    def __init__(self):
        self.positions = []
        self.uvs = []

    def add_triangles(self, positions, uvs):
        positions = quantise(positions, POSITION_STEP).reshape(-1, 3, 3)
        uvs = np.broadcast_to(np.asarray(uvs, float), positions.shape[:2] + (2,))
        a, b, c = positions[:, 0], positions[:, 1], positions[:, 2]
        area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
        same = (a == b).all(1) | (b == c).all(1) | (c == a).all(1)
        keep = ~same & (area > 0)
        if (~same & (area == 0)).any():
            raise ValueError("a triangle without area would leave a gap")
        self.positions.append(positions[keep])
        self.uvs.append(uvs[keep])

    def add_surface(self, surface):
        p, t = surface.points, surface.uv
        quads = np.stack([p[:-1, :-1], p[1:, :-1], p[1:, 1:], p[:-1, 1:]], axis=2)
        quad_uvs = np.stack([t[:-1, :-1], t[1:, :-1], t[1:, 1:], t[:-1, 1:]], axis=2)
        for corners in ((0, 1, 2), (0, 2, 3)):
            self.add_triangles(quads[:, :, corners], quad_uvs[:, :, corners].reshape(-1, 3, 2))

    def add_fan(self, ring, uv, reverse=False):
        """Closes a ring of points with triangles around its middle, all at one texture coordinate."""
        ring = np.asarray(ring, float)
        if np.allclose(ring[0], ring[-1], atol=1e-9):
            ring = ring[:-1]
        middle = np.broadcast_to(ring.mean(0), ring.shape)
        following = np.roll(ring, -1, axis=0)
        order = (middle, following, ring) if reverse else (middle, ring, following)
        self.add_triangles(np.stack(order, axis=1), np.broadcast_to(uv, (len(ring), 3, 2)))

    def add(self, other, matrix=None):
        """Adds another mesh, turned and moved by a 4 x 4 matrix."""
        for positions, uvs in zip(other.positions, other.uvs):
            if matrix is not None:
                positions = positions @ matrix[:3, :3].T + matrix[:3, 3]
                if np.linalg.det(matrix[:3, :3]) < 0:
                    positions, uvs = positions[:, ::-1], uvs[:, ::-1]
            self.add_triangles(positions, uvs)

    def finish(self, crease_degrees=38.0):
        """Vertices (position, unit normal, uv) and indices; faces that meet at less than the crease angle
        share a smooth normal. Raises where the mesh is not closed."""
        triangles = np.concatenate(self.positions)
        uvs = quantise(np.concatenate(self.uvs), UV_STEP)
        corner_count = len(triangles) * 3
        _, weld = np.unique(triangles.reshape(-1, 3), axis=0, return_inverse=True)
        weld = weld.reshape(-1, 3)
        require_closed(weld)
        require_outward(triangles, weld)

        edges = np.stack([triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 1],
                          triangles[:, 0] - triangles[:, 2]], axis=1)
        face = np.cross(edges[:, 0], -edges[:, 2])
        face_unit = face / np.linalg.norm(face, axis=1, keepdims=True)
        unit = edges / np.linalg.norm(edges, axis=2, keepdims=True)
        cosine = np.stack([-(unit[:, 2] * unit[:, 0]).sum(1), -(unit[:, 0] * unit[:, 1]).sum(1),
                           -(unit[:, 1] * unit[:, 2]).sum(1)], axis=1)
        angle = np.arccos(np.clip(cosine, -1, 1))  # corner angles weigh the faces: independent of the diagonal

        order = np.argsort(weld.ravel(), kind="stable")
        starts = np.flatnonzero(np.diff(weld.ravel()[order], prepend=-1))
        normals = np.empty((corner_count, 3))
        limit = np.cos(np.radians(crease_degrees))
        for start, end in zip(starts, np.append(starts[1:], corner_count)):
            corners = order[start:end]
            faces = corners // 3
            n = face_unit[faces]
            weights = angle.ravel()[corners] * ((n @ n.T) > limit)
            total = weights @ n
            normals[corners] = total / np.linalg.norm(total, axis=1, keepdims=True)
        normals = quantise(normals, NORMAL_STEP)
        normals = quantise(normals / np.linalg.norm(normals, axis=1, keepdims=True), 2.0**-20)

        vertices = np.concatenate([triangles.reshape(-1, 3), normals, uvs.reshape(-1, 2)], axis=1)
        vertices, indices = np.unique(vertices, axis=0, return_inverse=True)
        return vertices.astype("<f4"), indices.reshape(-1).astype("<u4")


def require_closed(triangles):
    """Each directed edge must be met by as many edges of the other direction: no hole, no flipped face."""
    a = triangles[:, [0, 1, 2]].ravel().astype(np.int64)
    b = triangles[:, [1, 2, 0]].ravel().astype(np.int64)
    size = int(triangles.max()) + 1
    forward = np.sort(a * size + b)
    backward = np.sort(b * size + a)
    if not np.array_equal(forward, backward):
        raise ValueError(f"mesh is not closed: {np.setxor1d(forward, backward).size} open edges")


def require_outward(triangles, weld):
    """Each connected body must have a positive volume: its faces look outwards."""
    label = np.arange(weld.max() + 1)
    while True:
        lowest = label[weld].min(1)
        before = label.copy()
        np.minimum.at(label, weld.ravel(), np.repeat(lowest, 3))
        if np.array_equal(before, label):
            break
    volume = np.einsum("ij,ij->i", triangles[:, 0], np.cross(triangles[:, 1], triangles[:, 2])) / 6
    bodies, body = np.unique(label[weld[:, 0]], return_inverse=True)
    inside_out = np.bincount(body, volume) <= 0
    if inside_out.any():
        at = triangles[body == np.flatnonzero(inside_out)[0], 0].mean(0)
        raise ValueError(f"{inside_out.sum()} of {len(bodies)} bodies are inside out, one near {at}")


def rotation_matrix(axis, angle):
    x, y, z = np.asarray(axis, float) / np.linalg.norm(axis)
    c, s = np.cos(angle), np.sin(angle)
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    result = np.eye(4)
    result[:3, :3] = np.eye(3) + s * k + (1 - c) * (k @ k)
    return result


def translation_matrix(offset):
    result = np.eye(4)
    result[:3, 3] = offset
    return result


MIRROR_X = np.diag([-1.0, 1.0, 1.0, 1.0])


def frame_matrix(origin, x_axis, y_hint):
    """A node's frame: its x axis along x_axis, its y axis as near to y_hint as that allows."""
    x = np.asarray(x_axis, float) / np.linalg.norm(x_axis)
    z = np.cross(x, y_hint)
    z /= np.linalg.norm(z)
    result = np.eye(4)
    result[:3, 0], result[:3, 1], result[:3, 2], result[:3, 3] = x, np.cross(z, x), z, origin
    return result


class Node:
    """A named part. The mesh is given in body axes; the file stores it relative to the node's frame."""

    def __init__(self, name, mesh, material, frame=None, crease_degrees=38.0):
        self.name, self.mesh, self.material = name, mesh, material
        self.frame = np.eye(4) if frame is None else frame
        self.crease_degrees = crease_degrees


def write_glb(path, root_name, nodes, materials):
    """materials: name -> (diffuse PNG[, specular PNG]), as file names beside the model."""
    blob = bytearray()
    gltf = {
        "asset": {"version": "2.0", "generator": "skydrop assets/scripts"},
        "extensionsUsed": ["KHR_materials_pbrSpecularGlossiness"],
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"name": root_name, "children": list(range(1, len(nodes) + 1))}],
        "meshes": [], "accessors": [], "bufferViews": [], "materials": [], "textures": [], "images": [],
        "samplers": [{"magFilter": 9729, "minFilter": 9987, "wrapS": 33071, "wrapT": 33071}],
    }
    material_index = {}
    for name, images in materials.items():
        first = len(gltf["textures"])
        for image in images:
            gltf["textures"].append({"source": len(gltf["images"]), "sampler": 0})
            gltf["images"].append({"uri": image})
        material_index[name] = len(gltf["materials"])
        specular = {"specularGlossinessTexture": {"index": first + 1}} if len(images) > 1 else {
            "specularFactor": [0.02, 0.02, 0.02], "glossinessFactor": 0.2}
        gltf["materials"].append({
            "name": name,
            "pbrMetallicRoughness": {"baseColorTexture": {"index": first}, "metallicFactor": 0.0},
            "extensions": {"KHR_materials_pbrSpecularGlossiness": {"diffuseTexture": {"index": first}, **specular}},
        })

    def add_accessor(array, target, kind, component, bounds=False):
        view = {"buffer": 0, "byteOffset": len(blob), "byteLength": array.nbytes, "target": target}
        blob.extend(array.tobytes())
        accessor = {"bufferView": len(gltf["bufferViews"]), "componentType": component,
                    "count": len(array), "type": kind}
        if bounds:
            accessor["min"] = [float(v) for v in array.min(0)]
            accessor["max"] = [float(v) for v in array.max(0)]
        gltf["bufferViews"].append(view)
        gltf["accessors"].append(accessor)
        return len(gltf["accessors"]) - 1

    for node in nodes:
        local = MeshBuilder()
        local.add(node.mesh, np.linalg.inv(node.frame))
        vertices, indices = local.finish(node.crease_degrees)
        attributes = {
            "POSITION": add_accessor(np.ascontiguousarray(vertices[:, 0:3]), 34962, "VEC3", 5126, True),
            "NORMAL": add_accessor(np.ascontiguousarray(vertices[:, 3:6]), 34962, "VEC3", 5126),
            "TEXCOORD_0": add_accessor(np.ascontiguousarray(vertices[:, 6:8]), 34962, "VEC2", 5126),
        }
        gltf["nodes"].append({"name": node.name, "mesh": len(gltf["meshes"])})
        if not np.array_equal(node.frame, np.eye(4)):
            gltf["nodes"][-1]["matrix"] = [float(v) for v in quantise(node.frame, 2.0**-20).T.ravel()]
        gltf["meshes"].append({"name": node.name, "primitives": [{
            "attributes": attributes, "indices": add_accessor(indices, 34963, "SCALAR", 5125),
            "material": material_index[node.material]}]})
        print(f"  {node.name}: {len(vertices)} vertices, {len(indices) // 3} triangles")

    gltf["buffers"] = [{"byteLength": len(blob)}]
    text = json.dumps(gltf, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    blob += b"\0" * (-len(blob) % 4)
    with open(path, "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 12 + 8 + len(text) + 8 + len(blob)))
        file.write(struct.pack("<I4s", len(text), b"JSON") + text)
        file.write(struct.pack("<I4s", len(blob), b"BIN\0") + blob)


def write_png(path, colour):
    """colour: rows from the top, 3 or 4 channels in 0..1, already encoded as sRGB where it is a colour."""
    pixels = quantise(np.clip(colour, 0, 1) * 255, 1).astype(np.uint8)
    height, width, channels = pixels.shape
    # Each row is stored as the difference to the row above (PNG filter "up"): flat paint becomes zeros.
    rows = pixels.reshape(height, -1)
    above = np.vstack([np.zeros_like(rows[:1]), rows[:-1]])
    filtered = np.hstack([np.full((height, 1), 2, np.uint8), rows - above])

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, {3: 2, 4: 6}[channels], 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
                   + chunk(b"IDAT", zlib.compress(filtered.tobytes(), 9)) + chunk(b"IEND", b""))
