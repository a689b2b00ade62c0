#include "skydrop/render/models/model_import.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>

#include "skydrop/core/assets.h"
#include "skydrop/core/error.h"
#include "skydrop/core/hash.h"
#include "support/temporary_folder.h"
#include "support/triangle_glb.h"

namespace skydrop::render {
namespace {

class ModelImport : public ::testing::Test {
 protected:
  ModelData import(const std::string& name, const std::string& content) {
    core::writeFileAtomically(folder_.path() / name, content);
    return importModel(folder_.path() / name);
  }
  // The one line that refuses a file; empty if it is accepted.
  std::string refusal(const std::string& name, const std::string& content) {
    try {
      import(name, content);
      return "";
    } catch (const core::DataError& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      return error.what();
    }
  }
  std::string refusal(const test::TriangleGlb& glb) { return refusal("model.glb", glb.bytes()); }

  test::TemporaryFolder folder_;
};

constexpr const char* kSquareObj =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n"
    "o first\nf 1/1/1 2/2/1 3/3/1 4/4/1\no second\nf -4/1/1 -3/2/1 -2/3/1\n";

TEST_F(ModelImport, readsObjWithSeveralMeshesAndCutsPolygonsIntoTriangles) {
  // A square and a triangle: two meshes of two and of one triangle, normals of length 1.
  const ModelData model = import("square.obj", kSquareObj);
  ASSERT_EQ(model.meshes.size(), 2u);
  EXPECT_EQ(model.meshes[0].data.indices.size(), 6u);
  EXPECT_EQ(model.meshes[1].data.indices.size(), 3u);
  EXPECT_EQ(model.meshes[0].data.vertices[0].normal, glm::vec3(0, 0, 1));
}

TEST_F(ModelImport, readsTexturesOfBothKindsOnce) {
  // Two materials of an OBJ that share a diffuse and differ in their specular texture: three images.
  for (const char* name : {"a.png", "b.png", "c.png"})
    core::writePng(folder_.path() / name, core::Image(2, 2));
  core::writeFileAtomically(
      folder_.path() / "square.mtl",
      std::string_view("newmtl one\nmap_Kd a.png\nmap_Ks b.png\nnewmtl two\nmap_Kd a.png\nmap_Ks c.png\n"));
  std::string text = "mtllib square.mtl\n" + std::string(kSquareObj);
  text.insert(text.find("o first") + 8, "usemtl one\n");
  text.insert(text.find("o second") + 9, "usemtl two\n");
  const ModelData model = import("square.obj", text);
  ASSERT_EQ(model.images.size(), 3u);
  const ModelMaterial& one = model.materials[static_cast<std::size_t>(model.meshes[0].material)];
  const ModelMaterial& two = model.materials[static_cast<std::size_t>(model.meshes[1].material)];
  EXPECT_EQ(one.diffuse, two.diffuse);
  EXPECT_NE(one.specular, two.specular);
}

TEST_F(ModelImport, keepsNamesAndFramesOfGltfNodes) {
  // The part hangs on the root, moved by (1, 2, 3).
  const ModelData model = import("model.glb", test::TriangleGlb().bytes());
  ASSERT_EQ(model.nodes.size(), 2u);
  EXPECT_EQ(model.nodes[1].name, "part");
  EXPECT_EQ(model.nodes[1].parent, 0);
  EXPECT_EQ(model.nodes[1].toParent[3], glm::vec4(1, 2, 3, 1));
}

TEST_F(ModelImport, makesNormalsWhereAFileHasNone) {
  // Without NORMAL the triangle's own: +z.
  test::TriangleGlb glb;
  glb.json["meshes"][0]["primitives"][0]["attributes"].erase("NORMAL");
  const ModelData model = import("model.glb", glb.bytes());
  for (const MeshVertex& vertex : model.meshes[0].data.vertices) EXPECT_EQ(vertex.normal, glm::vec3(0, 0, 1));
}

// Every directed edge of a closed mesh has as many partners in the other direction.
void expectClosed(const ModelMesh& mesh) {
  std::map<std::array<float, 3>, int> places;
  std::map<std::pair<int, int>, int> balance;
  const auto place = [&](std::uint32_t index) {
    const glm::vec3 p = mesh.data.vertices[index].position;
    return places.emplace(std::array{p.x, p.y, p.z}, static_cast<int>(places.size())).first->second;
  };
  for (std::size_t i = 0; i < mesh.data.indices.size(); i += 3) {
    const int corner[3] = {place(mesh.data.indices[i]), place(mesh.data.indices[i + 1]),
                           place(mesh.data.indices[i + 2])};
    for (int k = 0; k < 3; ++k) {
      const int a = corner[k], b = corner[(k + 1) % 3];
      balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  }
  int open = 0;
  for (const auto& [edge, sum] : balance) open += sum != 0;
  EXPECT_EQ(open, 0) << mesh.name;
}

TEST_F(ModelImport, gamesOwnModelsAreClosedAndOfTheStatedSize) {
  // All meshes without a hole; the aircraft 8.3 m long and 10.8 m wide (within 0.1 m), its parts under their
  // names.
  for (const char* name : {"airplane.glb", "package.glb", "parachute.glb"}) {
    const ModelData model = importModel(core::assetPath(std::string("models/") + name));
    glm::vec3 low(1e9f), high(-1e9f);
    for (const ModelNode& node : model.nodes) {
      for (const int mesh : node.meshes) {
        expectClosed(model.meshes[static_cast<std::size_t>(mesh)]);
        for (const MeshVertex& v : model.meshes[static_cast<std::size_t>(mesh)].data.vertices) {
          EXPECT_NEAR(glm::length(v.normal), 1, 1e-5);
          const glm::vec3 p(node.toParent * glm::vec4(v.position, 1));
          low = glm::min(low, p), high = glm::max(high, p);
        }
      }
    }
    if (std::string_view(name) != "airplane.glb") continue;
    EXPECT_NEAR(high.z - low.z, 8.3, 0.1);
    EXPECT_NEAR(high.x - low.x, 10.8, 0.1);
    for (const char* part :
         {"propeller", "propeller_disc", "aileron_left", "aileron_right", "elevator", "rudder", "cockpit"}) {
      EXPECT_TRUE(std::any_of(model.nodes.begin(), model.nodes.end(), [&](const auto& n) {
        return n.name == part;
      })) << part;
    }
    ASSERT_EQ(model.images.size(), 2u);  // diffuse and specular
  }
}

TEST_F(ModelImport, refusesOtherFormatsByName) {
  // Formats that assimp knows and the game does not, whatever their content.
  for (const char* name : {"model.ply", "model.off", "model.fbx", "model", "model.obj.stl"}) {
    EXPECT_NE(refusal(name, kSquareObj).find("only .obj, .gltf and .glb"), std::string::npos) << name;
  }
  EXPECT_THROW(importModel(folder_.path() / "missing.glb"), core::DataError);
  // Another format under an accepted name.
  EXPECT_NE(refusal("ply.obj", "ply\nformat ascii 1.0\nelement vertex 999999999\n"), "");
  EXPECT_NE(refusal("off.glb", "OFF\n999999999 999999999 0\n"), "");
}

TEST_F(ModelImport, refusesObjThatIsWrongAndSaysInWhichLine) {
  // Each fault in line 4 or later of an otherwise good file.
  const std::string good = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const char* line :
       {"f 1 2 4", "f 1 2 0", "f 1 2 -4", "f 1 2", "f 1 2 99999999999999999999", "v nan 0 0", "v 1e999 0 0",
        "v 1 2", "f 1//1 2//1 3//1", "f 1/1/1/1 2 3", "curv2 1 2 3"}) {
    EXPECT_NE(refusal("bad.obj", good + line + "\n").find("line 4"), std::string::npos) << line;
  }
  EXPECT_NE(refusal("bad.obj", good), "");
  EXPECT_NE(refusal("bad.obj", good + std::string("f 1 2 3\n\0", 9)), "");
  EXPECT_NE(refusal("bad.obj", good + "v " + std::string(5000, '1')), "");
  EXPECT_EQ(refusal("good.obj", good + "f 1 2 3\n"), "");
}

TEST_F(ModelImport, refusesGltfWhoseNumbersLie) {
  // Counts beyond the file, offsets beyond the buffer, references to nothing: refused before a byte is
  // fetched.
  const auto broken = [&](const char* pointer, const nlohmann::json& value) {
    test::TriangleGlb glb;
    glb.json[nlohmann::json::json_pointer(pointer)] = value;
    EXPECT_NE(refusal(glb), "") << pointer << " = " << value;
  };
  for (const std::uint64_t huge : {std::uint64_t{100}, std::uint64_t{4000000000}, std::uint64_t{1} << 62}) {
    for (const char* count :
         {"/accessors/0/count", "/accessors/2/count", "/bufferViews/0/byteLength", "/buffers/0/byteLength",
          "/bufferViews/1/byteOffset", "/accessors/0/byteOffset"}) {
      test::TriangleGlb glb;
      nlohmann::json& value = glb.json[nlohmann::json::json_pointer(count)];
      value = (value.is_number() ? value.get<std::uint64_t>() : 0) + huge;
      EXPECT_NE(refusal(glb), "") << count << " + " << huge;
    }
  }
  broken("/accessors/0/count", -3);
  broken("/accessors/0/count", 0);
  broken("/accessors/0/count", 1e300);
  broken("/accessors/0/count", "three");
  broken("/accessors/0/type", "VEC9");
  broken("/accessors/0/componentType", 1);
  broken("/accessors/0/bufferView", 7);
  broken("/accessors/0/sparse", nlohmann::json::object());
  broken("/meshes/0/primitives/0/indices", 9);
  broken("/meshes/0/primitives/0/indices", 0);
  broken("/meshes/0/primitives/0/attributes/POSITION", 2);
  broken("/meshes/0/primitives/0/mode", 1);
  broken("/meshes/0/primitives/0/material", 0);
  broken("/meshes/0/primitives", nlohmann::json::array());
  broken("/nodes/1/mesh", 1);
  broken("/nodes/1/translation", "far away");
  broken("/nodes/1/translation", {1, 2});
  broken("/nodes/0/children", {7});
  broken("/nodes/1/children", {0});  // its own grandfather
  broken("/nodes/0/children", {1, 1});
  broken("/scenes", nlohmann::json::array());
  broken("/scene", 3);
  broken("/extensionsRequired", {"KHR_draco_mesh_compression"});
  broken("/asset/version", "1.0");
  broken("/animations", {nlohmann::json::object()});
  broken("/meshes", nlohmann::json::object());
}

TEST_F(ModelImport, refusesGeometryThatIsNotFiniteOrLeavesItsMesh) {
  // NaN, infinity and 1e30 m as position; NaN and (0, 0, 0) as normal; an index past the last vertex.
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e30f}) {
    test::TriangleGlb glb;
    glb.setFloat(16, bad);
    EXPECT_NE(refusal(glb), "") << bad;
  }
  for (const float bad : {0.0f, std::numeric_limits<float>::quiet_NaN(), 7.0f}) {
    test::TriangleGlb glb;
    glb.setFloat(36 + 8, bad);
    EXPECT_NE(refusal(glb), "") << bad;
  }
  for (const std::uint32_t bad : {3u, 0x7fffffffu, 0xffffffffu}) {
    test::TriangleGlb glb;
    glb.setIndex(1, bad);
    EXPECT_NE(refusal(glb), "") << bad;
  }
}

TEST_F(ModelImport, refusesTexturesThatAreMissingOrElsewhere) {
  // A missing file, one outside the folder, one that is no PNG, a URL: one line that names it.
  test::TriangleGlb glb;
  glb.json["images"] = {{{"uri", "none.png"}}};
  glb.json["textures"] = {{{"source", 0}}};
  glb.json["materials"] = {
      {{"name", "paint"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  glb.json["meshes"][0]["primitives"][0]["material"] = 0;
  EXPECT_NE(refusal(glb).find("none.png"), std::string::npos);
  for (const char* elsewhere :
       {"../../secret.png", "/etc/passwd", "http://example.org/a.png", "a/../../b.png", ""}) {
    glb.json["images"][0]["uri"] = elsewhere;
    EXPECT_NE(refusal(glb), "") << elsewhere;
  }
  core::writeFileAtomically(folder_.path() / "text.png", std::string_view("not a picture"));
  glb.json["images"][0]["uri"] = "text.png";
  EXPECT_THROW(import("model.glb", glb.bytes()), core::DataError);
  glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 5;
  EXPECT_NE(refusal(glb), "");
}

TEST_F(ModelImport, refusesJsonThatIsNestedForEver) {
  // 100 000 brackets would end the stack of a recursive reader.
  const std::string deep = R"({"asset": {"version": "2.0"}, "extras": )" + std::string(100000, '[');
  EXPECT_NE(refusal("deep.gltf", deep), "");
  EXPECT_NE(refusal("deep.gltf", deep + std::string(100000, ']') + "}"), "");
}

TEST_F(ModelImport, survivesEveryTruncationAndFlippedBytes) {
  // Each prefix of a good file, and 1000 copies with up to four bytes changed: read or refused, nothing else.
  const std::string good = test::TriangleGlb().bytes();
  for (std::size_t size = 0; size < good.size(); ++size) {
    EXPECT_NE(refusal("cut.glb", good.substr(0, size)), "") << size;
  }
  core::RandomStream random{11, 0};
  for (int round = 0; round < 1000; ++round) {
    std::string bytes = round % 3 == 0 ? std::string(kSquareObj) : good;
    for (std::uint64_t n = 1 + random.next() % 4; n > 0; --n)
      bytes[random.next() % bytes.size()] = static_cast<char>(random.next());
    refusal(round % 3 == 0 ? "fuzz.obj" : "fuzz.glb", bytes);
  }
}

}  // namespace
}  // namespace skydrop::render
