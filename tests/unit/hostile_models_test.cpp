// Files that mean harm, or that two readers read differently: small ones that would grow, and those that make
// a usual algorithm slow.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/render/models/model_import.h"
#include "support/cost.h"
#include "support/mutants.h"
#include "support/paths.h"
#include "support/process.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"
#include "support/triangle_glb.h"

namespace skydrop::render {
namespace {

const std::filesystem::path kCorpus = test::sourceDir() + "/tests/corpus/models";

// Seconds of processor time within which the largest files are read, with the sanitizers: a hundred times
// what they take without (a quadratic algorithm takes a thousand times that).
constexpr int kMostCpuSeconds = 60;

bool isModel(const std::filesystem::path& path) {
  return path.extension() == ".glb" || path.extension() == ".gltf" || path.extension() == ".obj";
}

// What an accepted model promises (model_import.h).
void expectSound(const ModelData& model) {
  for (const ModelMesh& mesh : model.meshes) {
    ASSERT_LT(static_cast<std::size_t>(mesh.material), model.materials.size());
    ASSERT_EQ(mesh.data.indices.size() % 3, 0u);
    for (const std::uint32_t index : mesh.data.indices) ASSERT_LT(index, mesh.data.vertices.size());
    for (const MeshVertex& v : mesh.data.vertices) {
      ASSERT_LE(glm::length(v.position), 2 * kMaxModelCoordinate);
      ASSERT_NEAR(glm::length(v.normal), 1, 1e-3);
      ASSERT_TRUE(std::isfinite(v.uv.x) && std::isfinite(v.uv.y));
    }
  }
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const ModelNode& node = model.nodes[i];
    ASSERT_LT(node.parent, static_cast<int>(i));
    for (const int mesh : node.meshes) ASSERT_LT(static_cast<std::size_t>(mesh), model.meshes.size());
    const float volume = glm::determinant(glm::mat3(node.toParent));
    ASSERT_TRUE(std::isfinite(volume) && volume != 0);
    for (int k = 0; k < 4; ++k) ASSERT_EQ(node.toParent[k][3], k == 3 ? 1.0f : 0.0f);
  }
}

class HostileModels : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& content) const {
    return folder_.write(name, content);
  }
  std::string refusal(const std::string& name, const std::string& content) const {
    const std::string path = write(name, content);
    const std::string line = test::refusalOf<core::DataError>([&] { importModel(path); });
    if (!line.empty()) {
      EXPECT_TRUE(test::isOneLineAbout(line, name)) << line;
    }
    return line;
  }
  std::string refusal(const test::TriangleGlb& glb) const { return refusal("model.glb", glb.bytes()); }
  // Whether the file is read, or else refused, within bounds of time and memory.
  void expectBounded(const std::string& name, const std::string& content, bool isGood, long mostMiB) const {
    const std::string path = write(name, content);
    const test::Cost cost = test::costOf(
        [&] { return test::refusalOf<core::DataError>([&] { importModel(path); }).empty() == isGood; },
        kMostCpuSeconds);
    EXPECT_TRUE(cost.isDone) << name << ": after " << cost.cpuSeconds << " s of processor time";
    EXPECT_LT(cost.moreMiB, mostMiB) << name;
  }

  test::TemporaryFolder folder_;
};

// Files that are good or wrong in one way: read, or refused in one line. tests/corpus/make_corpus.py.
TEST_F(HostileModels, theCorpusIsReadOrRefused) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kCorpus)) {
    if (!isModel(entry.path())) continue;
    const std::string name = entry.path().filename().string();
    const std::string line =
        test::refusalOf<core::DataError>([&] { expectSound(importModel(entry.path())); });
    EXPECT_EQ(line.empty(), name.starts_with("good")) << name << ": " << line;
    // A fault of a material file names that.
    if (!line.empty()) {
      EXPECT_TRUE(test::isOneLineAbout(line, kCorpus.filename().string())) << line;
    }
    ++files;
  }
  EXPECT_GE(files, 60);
}

// The line gives the true reason, and the place.
TEST_F(HostileModels, refusalsGiveTheirReason) {
  for (const auto& [name, reason] :
       {std::pair{"badDoublingNodes.glb", "has two parents"},
        {"badRootListedTwice.glb", "lists a node twice"},
        {"badRootWithParent.glb", "nodes[1] 'part': has a parent"},
        {"badSecondBinaryChunk.glb", "BIN chunk: more follows it"},
        {"badSecondJsonChunk.glb", "BIN chunk: another chunk is in its place"},
        {"badBase64.gltf", "buffers[0].uri: a character that is not base64"},
        {"badShortBuffer.gltf", "buffers[0]: says 108 bytes and has 3"},
        {"badPercentEncoded.gltf", "'../secret.bin' is not a file in the model's folder"},
        {"badIndex.glb", "meshes[0].primitives[0].indices[2]: 3 is out of range"},
        {"badPosition.glb", "a position is not finite"},
        {"badSparse.glb", "sparse accessors are not read"},
        {"badDraco.glb", "'KHR_draco_mesh_compression' is not read"},
        {"badMorphTargets.glb", "morph targets are not read"},
        {"badLight.glb", "'KHR_lights_punctual' is not read"},
        {"badZeroScale.glb", "nodes[1] 'part': its transform flattens"},
        {"badZeroRotation.glb", "nodes[1] 'part'.rotation: is not of length 1"},
        {"badZeroMatrix.glb", "nodes[0] 'root'.matrix: is not affine"},
        {"badFlatMatrix.glb", "nodes[0] 'root': its transform flattens"},
        {"badProjectiveMatrix.glb", "nodes[0] 'root'.matrix: is not affine"},
        {"badMatrixBesideScale.glb", "beside translation, rotation or scale"},
        {"badManyScales.glb", "with that of its parents flattens"},
        {"badMixedCorners.obj", "line 6: the corners of a face have different kinds"},
        {"badNormal.obj", "line 6: normal '1' is not of length 1"},
        {"badFiveNumbers.obj", "line 5: has the wrong count of numbers"},
        {"badMaterialFileMissing.obj", "line 1: file 'none.mtl' is missing"},
        {"badMaterialUndefined.obj", "line 6: material 'red' is not defined"},
        {"badMaterialTwice.obj", "twice.mtl: line 2: material 'white' is defined twice"}}) {
    const std::string line = test::refusalOf<core::DataError>([&] { importModel(kCorpus / name); });
    EXPECT_NE(line.find(reason), std::string::npos) << name << ": " << line;
  }
}

// Damaged copies of every good file, beside the files that it names: sound, or refused in one line.
TEST_F(HostileModels, damagedFilesAreReadOrRefused) {
  for (const auto& entry : std::filesystem::directory_iterator(kCorpus)) {
    if (!entry.path().filename().string().starts_with("good")) {
      std::filesystem::copy_file(entry.path(), folder_.path() / entry.path().filename());
    }
  }
  for (const auto& entry : std::filesystem::directory_iterator(kCorpus)) {
    if (!entry.path().filename().string().starts_with("good")) continue;
    const std::string name = "mutant" + entry.path().extension().string();
    test::forEachMutant(core::readTextFile(entry.path()), 60, [&](const std::string& bytes) {
      const std::string path = test::writePlainly(folder_.path() / name, bytes);
      const std::string line = test::refusalOf<core::DataError>([&] { expectSound(importModel(path)); });
      ASSERT_TRUE(line.empty() || test::isOneLineAbout(line, folder_.path().filename().string())) << line;
    });
  }
  for (const char* file : {"square.mtl", "white.png", "three corners.bin"}) {
    for (const char* model : {"goodSquare.obj", "goodPercentEncoded.gltf"}) {
      std::filesystem::copy_file(kCorpus / model, folder_.path() / model,
                                 std::filesystem::copy_options::overwrite_existing);
    }
    const std::string good = core::readTextFile(kCorpus / file);
    test::forEachMutant(good, 30, [&](const std::string& bytes) {
      test::writePlainly(folder_.path() / file, bytes);
      for (const char* model : {"goodSquare.obj", "goodPercentEncoded.gltf"}) {
        const std::string line =
            test::refusalOf<core::DataError>([&] { expectSound(importModel(folder_.path() / model)); });
        ASSERT_TRUE(line.empty() || test::isOneLineAbout(line, folder_.path().filename().string())) << line;
      }
    });
    write(file, good);
  }
}

// The corpus is what its script writes.
TEST_F(HostileModels, theCorpusIsMadeByItsScript) {
  const std::filesystem::path script = kCorpus.parent_path() / "make_corpus.py";
  const test::ProcessResult made =
      test::runProcess({"/usr/bin/env", "python3", script.string(), folder_.path().string()});
  ASSERT_EQ(made.exitCode, 0) << made.err;
  for (const char* kind : {"models", "sounds"}) {
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path() / kind)) {
      const std::filesystem::path kept = kCorpus.parent_path() / kind / entry.path().filename();
      EXPECT_EQ(core::readTextFile(entry.path()), core::readTextFile(kept)) << kept;
      ++files;
    }
    const auto all = std::filesystem::directory_iterator(kCorpus.parent_path() / kind);
    EXPECT_EQ(files, std::distance(begin(all), end(all)));
  }
}

// A member that comes twice is refused at every depth, whichever of the two is harmless.
TEST_F(HostileModels, membersThatComeTwiceAreRefused) {
  const test::TriangleGlb glb;
  const std::string text = glb.json.dump();
  for (const char* member :
       {"\"nodes\":", "\"name\":", "\"POSITION\":", "\"byteLength\":", "\"count\":", "\"mesh\":"}) {
    std::string twice = text;
    twice.insert(twice.find(member), std::string(member) + "0,");
    EXPECT_NE(refusal("model.glb", glb.bytes(twice)), "") << member;
  }
  EXPECT_EQ(refusal("model.glb", glb.bytes(text)), "");
}

// 22 nodes that name the next twice are 2^21 triangles after expansion; the 800 bytes are refused at the cost
// of 800 bytes, and so are nodes that all show the same large mesh.
TEST_F(HostileModels, instancesAreCountedAfterExpansion) {
  for (const char* name : {"badTwoNodeLists.glb", "badDoublingNodes.glb"}) {
    expectBounded(name, core::readTextFile(kCorpus / name), false, 400);
  }
  test::TriangleGlb glb;
  const std::size_t vertices = 30000;
  glb.binary.append(vertices * 12, '\0');
  glb.json["buffers"][0]["byteLength"] = glb.binary.size();
  glb.json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 84}, {"byteLength", vertices * 12}});
  glb.json["accessors"].push_back(
      {{"bufferView", 3}, {"componentType", 5126}, {"count", vertices}, {"type", "VEC3"}});
  glb.json["meshes"][0]["primitives"][0] = {{"attributes", {{"POSITION", 3}}}};
  for (int i = 2; i < 30; ++i) {
    glb.json["nodes"].push_back({{"mesh", 0}});
    glb.json["nodes"][0]["children"].push_back(i);
  }
  EXPECT_EQ(refusal(glb), "");
  for (int i = 30; i < 40; ++i) {
    glb.json["nodes"].push_back({{"mesh", 0}});
    glb.json["nodes"][0]["children"].push_back(i);
  }
  EXPECT_NE(refusal(glb).find("the model is too large"), std::string::npos);
}

// The same buffer named again and again, and embedded pictures that share their bytes, are bounded together.
TEST_F(HostileModels, filesAndPicturesAreBoundedTogether) {
  core::writeFileAtomically(folder_.path() / "large.bin", std::string(std::size_t{20} << 20, '\0'));
  test::TriangleGlb glb;
  for (int i = 0; i < 4000; ++i) glb.json["buffers"].push_back({{"byteLength", 1}, {"uri", "large.bin"}});
  expectBounded("model.glb", glb.bytes(), false, 600);
  // A PNG of 100 bytes that says 60 000 x 60 000 texels.
  std::string png = core::readTextFile(kCorpus / "white.png");
  png.replace(16, 8, std::string("\0\0\xea\x60\0\0\xea\x60", 8));
  write("white.png", png);
  expectBounded("a.glb", core::readTextFile(kCorpus / "goodTriangle.glb"), false, 400);
}

// Triangles whose 180 000 corners all lie in one plane through the origin.
std::string planeGlb(const glm::dvec3& normal) {
  const glm::dvec3 n = glm::normalize(normal);
  const glm::dvec3 u =
      glm::normalize(glm::cross(n, std::abs(n.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  const glm::dvec3 v = glm::cross(n, u);
  constexpr int kSide = 245;  // 245^2 triangles
  std::vector<float> positions;
  for (int i = 0; i < kSide * kSide; ++i) {
    for (const auto& [a, b] : {std::pair{0.0, 0.0}, {0.7, 0.0}, {0.0, 0.7}}) {
      const glm::dvec3 p = (i % kSide + a) * u + (i / kSide + b) * v;
      for (int axis = 0; axis < 3; ++axis) positions.push_back(static_cast<float>(p[axis]));
    }
  }
  test::TriangleGlb glb;
  glb.binary.assign(reinterpret_cast<const char*>(positions.data()), positions.size() * 4);
  glb.json["buffers"] = {{{"byteLength", glb.binary.size()}}};
  glb.json["bufferViews"] = {{{"buffer", 0}, {"byteLength", glb.binary.size()}}};
  glb.json["accessors"] = {
      {{"bufferView", 0}, {"componentType", 5126}, {"count", positions.size() / 3}, {"type", "VEC3"}}};
  glb.json["meshes"][0]["primitives"][0] = {{"attributes", {{"POSITION", 0}}}};
  return glb.bytes();
}

// Normals are made in bounded work whatever plane the vertices lie in. The first plane is the one across the
// axis along which assimp 5.2.5 sorts: its smoothing takes 1.3 s of 22 700 corners there and 18 s of 89 800.
TEST_F(HostileModels, normalsOfAPlaneTakeNoLongerThanOthers) {
  for (const glm::dvec3 normal : {glm::dvec3(0.8523, 0.34321, 0.5736), glm::dvec3(1, 0, 0),
                                  glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1), glm::dvec3(1, 1, 1)}) {
    const std::string path = write("plane.glb", planeGlb(normal));
    const test::Cost cost = test::costOf(
        [&] {
          const ModelData model = importModel(path);
          bool good = model.meshes[0].data.vertices.size() == 3 * 245 * 245;
          for (const MeshVertex& v : model.meshes[0].data.vertices) {
            // Positions are rounded to 2^-16 m at 245 m: 1e-4 of a triangle's side.
            good = good && glm::dot(glm::dvec3(v.normal), glm::normalize(normal)) > 1 - 1e-6;
          }
          return good;
        },
        kMostCpuSeconds);
    EXPECT_TRUE(cost.isDone) << "after " << cost.cpuSeconds << " s of processor time";
  }
}

// OBJ files of the largest size that are unkind to one step each.
TEST_F(HostileModels, largeObjFilesTakeBoundedTime) {
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  const auto repeat = [](std::string line, int times) {
    std::string text;
    for (int i = 0; i < times; ++i) text += line;
    return text;
  };
  std::string groups = square, faces = square, materials = square;
  for (int i = 0; i < 100000; ++i) {
    groups += "g " + std::to_string(i) + "\nf 1 2 3\n";
    materials += "usemtl " + std::to_string(i) + "\nf 1 2 3\n";
  }
  for (int i = 0; i < 100000; ++i) faces += "o " + std::to_string(i) + "\n";
  std::string ring, polygon = "f";
  for (int i = 0; i < 64; ++i) {
    ring += "v " + std::to_string(std::cos(i * 0.098)) + " " + std::to_string(std::sin(i * 0.098)) + " 0\n";
    polygon += " " + std::to_string(i + 1);
  }
  expectBounded("groups.obj", groups, false, 600);
  expectBounded("materials.obj", materials, false, 600);
  expectBounded("emptyGroups.obj", faces + "f 1 2 3\n", true, 600);
  expectBounded("twoMaterials.obj", square + repeat("usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\n", 100000), false,
                600);
  expectBounded("polygons.obj", ring + repeat(polygon + "\n", 4000), true, 800);
  expectBounded("longLine.obj", square + repeat("#", 20'000'000), false, 600);
}

TEST_F(HostileModels, everyReadingOfAnAccessorIsTheFormats) {
  // Interleaved corners with normalised shorts as texture coordinates and indices of one byte.
  const ModelData model = importModel(kCorpus / "goodInterleaved.glb");
  const MeshData& mesh = model.meshes[0].data;
  ASSERT_EQ(mesh.vertices.size(), 3u);
  EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(mesh.vertices[1].position, glm::vec3(1, 0, 0));
  EXPECT_EQ(mesh.vertices[2].uv, glm::vec2(0, 0)) << "v runs upwards";
  EXPECT_EQ(mesh.vertices[1].uv, glm::vec2(1, 1));
  EXPECT_EQ(mesh.vertices[1].normal, glm::vec3(0, 0, 1)) << "which the file does not have";
}

// The winding of a triangle and its normal agree in the model's space, mirrored or not.
TEST_F(HostileModels, mirroredNodesKeepTheirOutsideOut) {
  const ModelData model = importModel(kCorpus / "goodMirrored.glb");
  const ModelNode& node = model.nodes[1];
  ASSERT_LT(glm::determinant(glm::mat3(node.toParent)), 0);
  const MeshData& mesh = model.meshes[static_cast<std::size_t>(node.meshes[0])].data;
  const auto place = [&](int k) {
    return glm::vec3(node.toParent *
                     glm::vec4(mesh.vertices[mesh.indices[static_cast<std::size_t>(k)]].position, 1));
  };
  EXPECT_GT(glm::cross(place(1) - place(0), place(2) - place(0)).z, 0) << "as its normal, +z";
}

// A triangle without area has no normal of its own; it takes that of its neighbours, or any.
TEST_F(HostileModels, trianglesWithoutAreaAreNoFault) {
  const ModelData model = importModel(kCorpus / "goodWithoutArea.obj");
  for (const MeshVertex& v : model.meshes[0].data.vertices) EXPECT_EQ(v.normal, glm::vec3(0, 0, 1));
  const std::string path = write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
  expectSound(importModel(path));
}

// Faces of one mesh may have normals or not: the given ones stay, the others are made.
TEST_F(HostileModels, facesWithoutNormalsAmongOthersGetTheirOwn) {
  const std::string path = write(
      "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 5 1 0\nv 5 0 1\nvn 0 1 0\nf 1//1 2//1 3//1\nf 4 5 6\n");
  const MeshData mesh = importModel(path).meshes[0].data;
  EXPECT_EQ(mesh.vertices[0].normal, glm::vec3(0, 1, 0));
  EXPECT_EQ(mesh.vertices[3].normal, glm::vec3(1, 0, 0));
}

// What a face names is what is drawn: leading zeros and either kind of line end change nothing.
TEST_F(HostileModels, indicesAreReadAsNumbers) {
  const MeshData mesh = importModel(kCorpus / "goodLeadingZero.obj").meshes[0].data;
  ASSERT_EQ(mesh.indices.size(), 3u);
  EXPECT_EQ(mesh.vertices[mesh.indices[2]].position, glm::vec3(1, 1, 0));
  const ModelData groups = importModel(kCorpus / "goodSeparateLineEnds.obj");
  ASSERT_EQ(groups.nodes.size(), 3u);
  EXPECT_EQ(groups.nodes[1].name, "a_b");
  EXPECT_EQ(groups.nodes[2].name, "c");
}

// A corner of a cube has the mean of its three sides, whatever triangles they are cut into.
TEST_F(HostileModels, normalsAreWeightedByAngle) {
  const std::string path = write("cube.obj",
                                 "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                                 "f 1 4 3\nf 1 3 2\nf 5 6 7\nf 5 7 8\nf 1 2 6\nf 1 6 5\n"
                                 "f 4 8 7\nf 4 7 3\nf 1 5 8\nf 1 8 4\nf 2 3 7\nf 2 7 6\n");
  const MeshData mesh = importModel(path).meshes[0].data;
  for (const MeshVertex& v : mesh.vertices) {
    EXPECT_LT(glm::distance(v.normal, glm::normalize(v.position - 0.5f)), 1e-6f);
  }
}

}  // namespace
}  // namespace skydrop::render
