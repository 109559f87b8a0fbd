// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh files of formats that are not ours: the one file that knows assimp, which is optional.
#include "experiments/cases/workloads/meshes.h"

#ifdef TOUCHSTONE_ASSIMP
#include <assimp/commonMetaData.h>
#include <assimp/config.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <Eigen/Core>
#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <cstdint>
#include <fstream>
#include <limits>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/io/detail/legible.h"

namespace touchstone::workloads {
namespace {

/// Collects what assimp complains of while it exists; without it, assimp is silent about what it leaves out.
class AssimpLog {
 public:
  AssimpLog() {
    Assimp::DefaultLogger::create(nullptr, Assimp::Logger::NORMAL, 0);
    Assimp::DefaultLogger::get()->attachStream(new Stream(said_), Assimp::Logger::Err | Assimp::Logger::Warn);
  }
  AssimpLog(const AssimpLog&) = delete;
  AssimpLog& operator=(const AssimpLog&) = delete;
  ~AssimpLog() { Assimp::DefaultLogger::kill(); }  // deletes the stream

  struct Entry {
    bool is_error;
    std::string text;
  };
  [[nodiscard]] const std::vector<Entry>& said() const { return said_; }

 private:
  class Stream : public Assimp::LogStream {
   public:
    explicit Stream(std::vector<Entry>& said) : said_(said) {}
    void write(const char* message) override {  // such as "Warn,  T0: reason\n"
      const std::string_view text(message);
      const std::size_t colon = text.find(": "), begin = colon == std::string_view::npos ? 0 : colon + 2;
      // Its reader of glTF warns of faces that it drops.
      const bool is_error = text.starts_with("Error") || text.find("dropped") != std::string_view::npos;
      said_.push_back({is_error, io::legible(text.substr(begin, text.find('\n') - begin))});
    }

   private:
    std::vector<Entry>& said_;
  };

  std::vector<Entry> said_;
};

Eigen::Matrix4d matrix_of(const aiMatrix4x4& m) {
  Eigen::Matrix4d matrix;
  for (unsigned row = 0; row < 4; ++row)
    for (unsigned column = 0; column < 4; ++column) matrix(row, column) = static_cast<double>(m[row][column]);
  return matrix;
}

/// Takes the meshes of a scene, as often as its nodes place them.
class SceneReader {
 public:
  SceneReader(std::string name, OnFault on_fault) : name_(std::move(name)), on_fault_(on_fault) {}

  /// Reports a fault of a part: refuses the file, or counts the part as left out.
  void fault(const std::string& reason) {
    const std::string sentence = name_ + ": " + reason;
    if (on_fault_ == OnFault::Refuse) throw BrokenMesh(sentence);
    if (read_.parts_left_out++ < kMostSentences) read_.left_out.push_back(sentence);
  }
  void warn(const std::string& reason) { read_.warnings.push_back(name_ + ": " + reason); }

  /// Adds the meshes of a node and of all nodes below it. Numbers of nodes are multiplied in doubles.
  void add(const aiScene& scene, const aiNode& root, const Eigen::Matrix4d& own) {
    std::vector<std::pair<const aiNode*, Eigen::Matrix4d>> open{{&root, own}};
    while (!open.empty()) {
      const auto [node, matrix] = open.back();
      open.pop_back();
      for (const unsigned number : std::span(node->mMeshes, node->mNumMeshes))
        add(*scene.mMeshes[number], number, matrix);
      for (unsigned i = node->mNumChildren; i-- > 0;)
        open.emplace_back(node->mChildren[i], matrix * matrix_of(node->mChildren[i]->mTransformation));
    }
  }

  [[nodiscard]] ReadMesh finish() && {
    if (read_.mesh.faces.empty())
      throw BrokenMesh((read_.left_out.empty() ? name_ + ":" : read_.left_out.front() + ";") + " the file has no face");
    return std::move(read_);
  }

 private:
  void add(const aiMesh& mesh, unsigned number, const Eigen::Matrix4d& matrix) {
    std::vector<Eigen::Vector3d>& vertices = read_.mesh.vertices;
    if (matrix.row(3) != Eigen::RowVector4d(0, 0, 0, 1))
      return fault(fmt::format("mesh {}: the transformation of its node is not affine", number));
    if (mesh.HasBones()) warn(fmt::format("mesh {}: its bones are not applied", number));
    const std::size_t first = vertices.size();
    if (mesh.mNumVertices >= std::numeric_limits<std::uint32_t>::max() - first)
      throw BrokenMesh(name_ + ": more vertices than 32-bit numbers can count");
    for (const aiVector3D& v : std::span(mesh.mVertices, mesh.mNumVertices)) {
      const Eigen::Vector4d point(v.x, v.y, v.z, 1);
      vertices.emplace_back((matrix * point).head<3>());
    }
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      const std::span<const unsigned> corners(mesh.mFaces[i].mIndices, mesh.mFaces[i].mNumIndices);
      if (corners.size() < 3) continue;  // a point or a line
      std::vector<std::uint32_t> face;
      for (const unsigned corner : corners) {
        const bool is_there = corner < mesh.mNumVertices;
        if (is_there && vertices[first + corner].allFinite()) {
          face.push_back(static_cast<std::uint32_t>(first + corner));
          continue;
        }
        fault(fmt::format("mesh {}: face {}: vertex {} is {}", number, i, corner,
                          is_there ? "not finite" : fmt::format("out of range: there are {}", mesh.mNumVertices)));
        break;
      }
      if (face.size() == corners.size()) read_.mesh.faces.push_back(std::move(face));
    }
  }

  std::string name_;
  OnFault on_fault_;
  ReadMesh read_;
};

}  // namespace

ReadMesh read_other_mesh(const std::filesystem::path& file, OnFault on_fault) {
  const std::string name = io::all_legible(file.string());
  const AssimpLog log;
  Assimp::Importer importer;
  if (file.extension().empty() || !importer.IsExtensionSupported(file.extension().string()))
    return read_mesh(file, on_fault);  // which says what it expects
  if (!std::ifstream(file)) throw BrokenMesh(name + ": cannot be opened");
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  const aiScene* const scene = importer.ReadFile(file.string(), 0);  // nothing is joined, split, turned or removed
  if (scene == nullptr) throw BrokenMesh(name + ": assimp: " + io::legible(importer.GetErrorString()));
  if (scene->mRootNode == nullptr || (scene->mFlags & AI_SCENE_FLAGS_INCOMPLETE) != 0)
    throw BrokenMesh(name + ": assimp: it holds no whole mesh");

  SceneReader reader(name, on_fault);
  Eigen::Matrix4d root = matrix_of(scene->mRootNode->mTransformation);
  aiString format;
  if (scene->mMetaData != nullptr && scene->mMetaData->Get(AI_METADATA_SOURCE_FORMAT, format) &&
      format == aiString("Collada Importer")) {
    // There the root has no transformation of its own. assimp gives it that to metres, rounded.
    if (!root.isIdentity(0))
      reader.warn(fmt::format("numbers are kept as they are; the file gives their unit as {} m",
                              scene->mRootNode->mTransformation.a1));
    root.setIdentity();
  }
  reader.warn("coordinates are 32-bit floats, to which assimp rounds the numbers of the file");
  reader.add(*scene, *scene->mRootNode, root);
  for (const auto& [is_error, text] : log.said())
    is_error ? reader.fault("assimp: " + text) : reader.warn("assimp: " + text);
  return std::move(reader).finish();
}

}  // namespace touchstone::workloads

#else

namespace touchstone::workloads {

ReadMesh read_other_mesh(const std::filesystem::path& file, OnFault on_fault) try {
  return read_mesh(file, on_fault);
} catch (const BrokenMesh& broken) {
  throw BrokenMesh(broken.what() +
                   std::string("; this program was built without assimp (libassimp-dev), which reads others"));
}

}  // namespace touchstone::workloads

#endif
