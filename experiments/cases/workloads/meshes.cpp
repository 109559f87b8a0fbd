// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/workloads/meshes.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "geometry/io/detail/legible.h"

namespace touchstone::workloads {
namespace {

std::string short_name(const std::filesystem::path& file) {
  const auto folder = file.parent_path().filename();
  return (folder.empty() || folder == "." ? file.stem() : folder / file.stem()).string();
}

}  // namespace

std::string with_hashes(const std::vector<std::string>& files) {
  std::vector<std::string> named;
  for (const std::string& file : files) {
    std::ifstream stream(file, std::ios::binary);
    const std::string content{std::istreambuf_iterator<char>(stream), {}};
    named.push_back(stream ? fmt::format("{} (hash {:016x})", file, std::hash<std::string>()(content)) : file);
  }
  return fmt::format("{}", fmt::join(named, ","));
}

std::vector<std::string> short_names(const std::vector<std::string>& files) {
  std::vector<std::string> names;
  for (const std::string& file : files) names.push_back(short_name(file));
  std::set<std::string> taken(names.begin(), names.end());
  std::map<std::string, int> last;  // number, by the name without it
  for (std::string& name : names) {
    int& number = last[name];
    if (++number == 1) continue;
    std::string numbered;
    while (!taken.insert(numbered = fmt::format("{}#{}", name, number)).second) ++number;
    name = std::move(numbered);
  }
  return names;
}

bool is_own_format(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension == ".obj" || extension == ".off" || extension == ".stl" || extension == ".ply";
}

std::string sentence_of_face(const std::string& file, const ReadMesh& content, const mesh::RejectedFace& rejected) {
  const auto& [face, rejection] = rejected;
  const std::string reason = fmt::format("face {}: {}: {}", face, to_string(rejection.code), rejection.message);
  return content.places.empty() ? io::all_legible(file) + ": " + reason
                                : io::sentence(file, content.places[face], reason);
}

ReadMesh read_with_warnings(const std::filesystem::path& file, OnFault on_fault) {
  ReadMesh mesh = read_mesh(file, on_fault);
  for (const std::string& warning : mesh.warnings) fmt::print(stderr, "touchstone: warning: {}\n", warning);
  return mesh;
}

NamedFiles read_named_files(const std::vector<std::string>& files, OnFault on_fault) {
  constexpr std::size_t kShown = 3;
  NamedFiles result;
  std::vector<std::string> names = short_names(files);
  for (std::size_t k = 0; k < files.size(); ++k) {
    const std::string& file = files[k];
    try {
      ReadMesh mesh = read_with_warnings(file, on_fault);
      for (std::size_t i = 0; i < mesh.left_out.size() && i < kShown; ++i)
        fmt::print(stderr, "touchstone: left out: {}\n", mesh.left_out[i]);
      if (mesh.parts_left_out > kShown)
        fmt::print(stderr, "touchstone: left out: {}: {} more parts\n", io::all_legible(file),
                   mesh.parts_left_out - kShown);
      result.parts_left_out += mesh.parts_left_out;
      result.read.push_back({std::move(names[k]), file, std::move(mesh)});
    } catch (const BrokenMesh& broken) {
      fmt::print(stderr, "touchstone: {}\n", broken.what());
      result.all_read = false;
    }
  }
  return result;
}

std::string left_out_text(const NamedFiles& files) {
  std::string text;
  for (const NamedFile& file : files.read) {
    for (const std::string& sentence : file.content.left_out) text += sentence + "\n";
    if (file.content.parts_left_out > file.content.left_out.size())
      text += fmt::format("{}: {} more parts\n", io::all_legible(file.file),
                          file.content.parts_left_out - file.content.left_out.size());
  }
  return text;
}

}  // namespace touchstone::workloads
