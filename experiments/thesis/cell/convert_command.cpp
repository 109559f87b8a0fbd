// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/run/write_file.h"
#include "experiments/thesis/cell/cell_commands.h"
#include "experiments/thesis/cell/model/convert.h"

namespace touchstone::cell {
namespace {

struct ConvertOptions {
  std::string from, to, name;
  bool weld = false, merge = false, force = false, json = false, quiet = false;
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

std::string table(const ModelCounts& read, const ModelCounts& written, const ModelCounts& read_again) {
  return fmt::format("{:<10} {:>6} {:>9} {:>9} {:>10} {:>6} {:>8}  {}\n", "", "parts", "vertices", "polygons",
                     "triangles", "holes", "points", "bounds") +
         row("read", read) + row("written", written) + row("read again", read_again);
}

nlohmann::ordered_json json(const ModelCounts& counts) {
  const auto corner = [&](const Eigen::Vector3d& at) {
    return counts.bounds.isEmpty() ? nlohmann::ordered_json() : nlohmann::ordered_json{at.x(), at.y(), at.z()};
  };
  return {{"parts", counts.parts},
          {"vertices", counts.vertices},
          {"polygons", counts.polygons},
          {"triangles", counts.triangles},
          {"holes", counts.holes},
          {"points", counts.points},
          {"lowest", corner(counts.bounds.min())},
          {"highest", corner(counts.bounds.max())}};
}

int run(const ConvertOptions& options) {
  constexpr int kDiffers = 1;
  run::refuse_overwrite(options.to, options.force);
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
  run::write_file(options.to, text, options.force);
  const LinkModel read = read_model(options.to);

  const ModelCounts was = counts_of(model), is = counts_of(written), again = counts_of(read);
  if (options.json) {
    const nlohmann::ordered_json all{{"read", json(was)}, {"written", json(is)}, {"read_again", json(again)}};
    fmt::print("{}\n", all.dump());
  } else if (!options.quiet) {
    fmt::print("{}", table(was, is, again));
  }
  const std::vector<std::string> sentences = differences(written, read);
  for (const std::string& sentence : sentences) fmt::print(stderr, "touchstone: {}: {}\n", options.to, sentence);
  return sentences.empty() ? 0 : kDiffers;
}

}  // namespace

run::Command convert_command() {
  run::Command command("convert",
                       "Convert between model files (.txt) and meshes (OBJ, OFF, STL, PLY); compare counts and bounds");
  auto options = std::make_shared<ConvertOptions>();
  command.text("FROM", options->from, "A model file or mesh").required();
  command.text("TO", options->to, "The file to write; its extension selects the format").required();
  command.flag("--weld", options->weld, "Merge equal vertices");
  command.flag("--merge", options->merge, "Merge coplanar faces into polygons with holes").excludes("--weld");
  command.text("--name", options->name, "The name of the link, one word (default: that of the file or model)");
  command.flag("--force", options->force, "Overwrite an existing file");
  command.quiet(options->quiet, "Print no table; the exit status tells whether the written file is the same model");
  command.json(options->json, "Print the counts as one JSON object, with the lowest and highest coordinates")
      .excludes("--quiet");
  command.example("cell convert part.stl part.obj --merge");
  command.runs([options] { return run(*options); });
  return command;
}

}  // namespace touchstone::cell
