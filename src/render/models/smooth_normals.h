#pragma once

#include "skydrop/render/models/mesh_data.h"

namespace skydrop::render {

// Gives a normal to each vertex whose normal is (0, 0, 0): the mean of those of the triangles that meet at
// exactly its place, weighted by their angles there (Thuermer and Wuethrich, "Computing Vertex Normals from
// Polygonal Facets", 1998). Where they cancel, that of its own triangles; where none has an area, up.
// n log n in the count of vertices, whatever their places.
void addSmoothNormals(MeshData& mesh);

}  // namespace skydrop::render
