// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "experiments/cell/cell_commands.h"
#include "experiments/cell/model/convert.h"
#include "experiments/harness/processes.h"
#include "experiments/harness/write_file.h"

namespace touchstone::cell {
namespace {

struct ConvertOptions {
  std::string from, to, name;
  bool weld = false, merge = false, force = false;
};

std::string row(const char* what, const ModelCounts& counts) {
  std::string bounds = "none";
  if (!counts.bounds.isEmpty()) {
    const Eigen::Vector3d &a = counts.bounds.min(), &b = counts.bounds.max();
    bounds = fmt::format("[{}, {}] x [{}, {}] x [{}, {}]", a.x(), b.x(), a.y(), b.y(), a.z(), b.z());
  }
  return fmt::format("{:<10} {:>6} {:>9} {:>9} {:>10} {:>6} {:>8}  {}\n", what, counts.parts, counts.vertices,
                     counts.polygons, counts.triangles, counts.holes, counts.points, bounds);
}

int run(const ConvertOptions& options) {
  constexpr int kDiffers = 1;
  harness::refuse_overwrite(options.to, options.force);
  LinkModel model = read_model(options.from);
  if (!options.name.empty()) {
    // A mesh is one part of the link's name.
    if (model.parts.size() == 1 && model.parts[0].name == model.name) model.parts[0].name = options.name;
    model.name = options.name;
  }
  const Preparation preparation = options.merge  ? Preparation::Merge
                                  : options.weld ? Preparation::Weld
                                                 : Preparation::None;
  LinkModel written;
  std::string text;
  try {
    written = prepared(model, preparation, options.to);
    text = model_text(written, options.to);
  } catch (const std::invalid_argument& error) {
    throw BadConversion(fmt::format("{}: {}; --name gives another", options.from, error.what()));
  }
  harness::write_file(options.to, text, options.force);
  const LinkModel read = read_model(options.to);

  fmt::print("{:<10} {:>6} {:>9} {:>9} {:>10} {:>6} {:>8}  {}\n", "", "parts", "vertices", "polygons", "triangles",
             "holes", "points", "bounds");
  fmt::print("{}{}{}", row("read", counts_of(model)), row("written", counts_of(written)),
             row("read again", counts_of(read)));
  const std::vector<std::string> sentences = differences(written, read);
  for (const std::string& sentence : sentences) fmt::print(stderr, "touchstone: {}: {}\n", options.to, sentence);
  return sentences.empty() ? 0 : kDiffers;
}

}  // namespace

harness::Command convert_command() {
  harness::Command command(
      "convert", "Convert between model files (.txt) and meshes (OBJ, OFF, STL, PLY); compare counts and bounds");
  auto options = std::make_shared<ConvertOptions>();
  command.text("FROM", options->from, "A model file or mesh").required();
  command.text("TO", options->to, "The file to write; its extension selects the format").required();
  command.flag("--weld", options->weld, "Merge equal vertices");
  command.flag("--merge", options->merge, "Merge coplanar faces into polygons with holes").excludes("--weld");
  command.text("--name", options->name, "The name of the link, one word (default: that of the file or model)");
  command.flag("--force", options->force, "Overwrite an existing file");
  command.example("cell convert part.stl part.obj --merge");
  command.runs([options] { return harness::run_alone([&] { return run(*options); }); });
  return command;
}

}  // namespace touchstone::cell
