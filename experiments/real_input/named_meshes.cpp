// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/real_input/named_meshes.h"

#include <fmt/core.h>

#include <filesystem>
#include <map>
#include <utility>

namespace touchstone::real_input {
namespace {

std::string short_name(const std::filesystem::path& file, std::map<std::string, int>& seen) {
  const auto folder = file.parent_path().filename();
  const std::string name = (folder.empty() || folder == "." ? file.stem() : folder / file.stem()).string();
  const int number = ++seen[name];
  return number == 1 ? name : fmt::format("{}#{}", name, number);
}

}  // namespace

NamedFiles read_named_files(const std::vector<std::string>& files, OnFault on_fault) {
  constexpr std::size_t kShown = 3;
  NamedFiles result;
  std::map<std::string, int> seen;
  for (const std::string& file : files) {
    std::string name = short_name(file, seen);
    try {
      ReadMesh mesh = read_mesh(file, on_fault);
      for (std::size_t i = 0; i < mesh.left_out.size() && i < kShown; ++i)
        fmt::print(stderr, "touchstone: left out: {}\n", mesh.left_out[i]);
      if (mesh.parts_left_out > kShown)
        fmt::print(stderr, "touchstone: left out: {}: {} more parts\n", file, mesh.parts_left_out - kShown);
      result.parts_left_out += mesh.parts_left_out;
      result.read.push_back({std::move(name), file, std::move(mesh)});
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
      text += fmt::format("{}: {} more parts\n", file.file, file.content.parts_left_out - file.content.left_out.size());
  }
  return text;
}

}  // namespace touchstone::real_input
