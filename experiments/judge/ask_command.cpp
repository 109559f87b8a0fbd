// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <variant>

#include "experiments/cases/comparison.h"
#include "experiments/cases/key.h"
#include "experiments/cases/verdict.h"
#include "experiments/cases/workloads/ulp.h"
#include "experiments/judge/ask.h"
#include "experiments/judge/show/case_view.h"
#include "experiments/methods/process/engine_process.h"
#include "experiments/methods/registry.h"
#include "experiments/program/command.h"
#include "experiments/program/input.h"
#include "experiments/program/output.h"
#include "experiments/program/printing.h"
#include "geometry/io/detail/legible.h"
#include "geometry/shapes/rejection.h"
#include "robust/mesh/scene_faces.h"
#include "robust/scene/scene.h"

namespace touchstone::commands {
namespace {

struct AskOptions {
  std::string ball, balls, to, polygon, mesh, show, output;
  methods::Selection methods{{"fast"}};
  bool print = false, nearest = false, force = false;
};

/// Calls f, and names the option in what it throws.
template <class F>
auto of_option(const std::string& option, const F& f) {
  try {
    return f();
  } catch (const program::UsageError&) {
    throw;
  } catch (const Rejected& rejected) {
    throw program::UsageError(option,
                              fmt::format("rejected: {}: {}", to_string(rejected.rejection().code), rejected.what()));
  } catch (const std::runtime_error& error) {
    throw program::UsageError(option, error.what());
  }
}

cases::Question question_of(const AskOptions& options) {
  const Ball ball = of_option("--ball", [&] {
    const Eigen::VectorXd numbers = judge::numbers_of(options.ball, 4);
    if (numbers[3] < 0) throw Rejected({RejectionCode::NegativeRadius, "the radius is below 0"});
    return Ball{numbers.head<3>(), numbers[3]};
  });
  if (options.to.empty()) return ball;
  return Motion(ball, of_option("--to", [&] { return Eigen::Vector3d(judge::numbers_of(options.to, 3)); }));
}

Polygon polygon_of(const AskOptions& options) {
  return of_option("--polygon", [&] {
    std::error_code too_long;  // loops of many points are not the name of a file
    if (!std::filesystem::is_regular_file(options.polygon, too_long)) return judge::polygon_of(options.polygon);
    std::ifstream stream = program::open_file(options.polygon);
    return of_option("--polygon " + options.polygon,
                     [&] { return judge::polygon_of(std::string(std::istreambuf_iterator<char>(stream), {})); });
  });
}

/// Returns a value of an answer in words: `edge 3`, `(1, 0, 0)`, `none`.
std::string in_words(const std::string& text) {
  const auto value = nlohmann::json::parse(text);
  if (value.is_string()) return value.get<std::string>();
  if (value.is_object()) {
    const auto kind = value.at("kind").get<std::string>();
    return kind == "face" ? kind : fmt::format("{} {}", kind, value.at("index").get<std::size_t>());
  }
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_array() && value.empty()) return "none";
  if (value.is_array()) return fmt::format("({})", boost::replace_all_copy(text.substr(1, text.size() - 2), ",", ", "));
  return value.is_null() ? "none" : text;
}

/// Returns by how much a number is off, as a sentence; empty for other values.
std::string error_of(const cases::Key& key, const cases::PartialAnswer& exact, const cases::PartialAnswer& found) {
  return key.visit([&](auto member) -> std::string {
    const auto &a = exact.*member, &b = found.*member;
    if constexpr (std::is_same_v<decltype(member), cases::Member<double>>) {
      if (!a || !b || !std::isfinite(*a) || !std::isfinite(*b)) return {};
      const double doubles = std::abs(static_cast<double>(workloads::doubles_between(*a, *b)));
      const std::string counted = program::counted(static_cast<std::uint64_t>(doubles), "double");
      return fmt::format("; off by {:.2g}{}", std::abs(*b - *a), doubles <= 1e6 ? ", " + counted : "");
    } else if constexpr (std::is_same_v<decltype(member), cases::Member<Eigen::Vector3d>>) {
      return a && b && b->allFinite() ? fmt::format("; off by {:.2g}", (*b - *a).stableNorm()) : std::string();
    }
    return {};
  });
}

void print_answer(const show::CaseView& view) {
  fmt::print("{}\n\nexact\n", show::margin_text(view));
  const cases::StatedAnswer exact = cases::stated(view.truth);
  for (const cases::Key& key : cases::kKeys)
    if (const auto text = exact.texts.find(std::string(key.name)); text != exact.texts.end())
      fmt::print("  {:<16}{}\n", key.name, in_words(text->second));
  for (const show::Verdict& verdict : view.verdicts) {
    fmt::print("\n{}\n", io::legible(verdict.method));
    if (!verdict.fault.empty()) {
      fmt::print("  no answer: {}\n", verdict.fault);
      continue;
    }
    bool differs = false;
    const auto differences = cases::differences(exact, verdict.answer);
    for (const cases::Key& key : cases::kKeys) {
      const auto difference = std::ranges::find(differences, key.name, &cases::Difference::key);
      if (difference == differences.end() || !difference->found) continue;
      differs = true;
      fmt::print("  {:<16}{}, exactly {}{}\n", key.name, in_words(*difference->found), in_words(difference->expected),
                 error_of(key, view.truth, verdict.answer.values));
    }
    if (!differs) fmt::print("  the same\n");
  }
}

void answer(const AskOptions& options, const cases::Shapes& shapes) {
  if (options.print) {
    fmt::print("{}", cases::case_line("asked", shapes, {}));
    return;
  }
  show::CaseView view = show::view_of("asked", {}, shapes);
  for (const auto* method : options.methods.methods()) view.verdicts.push_back(show::verdict_of(view, *method));
  print_answer(view);
  if (!options.show.empty())
    program::write_file(options.show, show::page_of("A ball and a polygon", show::section_of(view)), options.force);
}

/// Returns the numbers, at most ten of them, and how many more there are.
std::string some_of(const std::vector<std::uint32_t>& numbers) {
  constexpr std::size_t kMost = 10;
  const std::size_t shown = std::min(numbers.size(), kMost);
  std::string text = fmt::format("{}", fmt::join(numbers.begin(), numbers.begin() + static_cast<long>(shown), ", "));
  return numbers.size() > shown ? fmt::format("{} and {} more", text, numbers.size() - shown) : text;
}

/// Prints which faces the ball touches, and returns the one that is nearest or touched first, as a polygon.
Polygon ask_mesh(const AskOptions& options, const cases::Question& question) {
  const judge::AskedMesh asked = of_option("--mesh", [&] { return judge::read_asked_mesh(options.mesh); });
  const scene::Scene& scene = asked.scene;
  const auto* motion = std::get_if<Motion>(&question);
  std::vector<std::uint32_t> touched;
  for (const scene::FaceId& id : motion != nullptr ? scene.touched(*motion) : scene.touched(std::get<Ball>(question)))
    touched.push_back(asked.numbers[id.face]);
  std::ranges::sort(touched);
  std::uint32_t face = scene.nearest(cases::ball_of(question))->face.face;
  if (motion != nullptr)
    if (const auto first = scene.first_contact(*motion)) face = first->face.face;
  if (!options.print) {
    const std::string all = program::counted(asked.mesh.faces.size(), "face");
    fmt::print("The ball touches {} of {}{}{}.\n", touched.size(), all, touched.empty() ? "" : ": ", some_of(touched));
    const char* which = motion == nullptr ? "nearest" : touched.empty() ? "nearest to the start" : "first";
    fmt::print("Face {} is {}. About this face:\n\n", asked.numbers[face], which);
  }
  return mesh::face_polygon(asked.mesh, asked.numbers[face]);
}

/// Prints or writes a line for each ball of the file.
void ask_about_balls(const AskOptions& options) {
  constexpr std::size_t kTogether = 1 << 14;  // so that their answers fit into memory, and many share a walk
  if (!options.output.empty()) program::refuse_overwrite(options.output, options.force);
  const judge::AskedMesh mesh = of_option("--mesh", [&] { return judge::read_asked_mesh(options.mesh); });
  const auto balls = of_option("--balls", [&] { return judge::read_balls(options.balls); });
  const auto moves = [](const judge::ListedBall& ball) { return std::holds_alternative<Motion>(ball.question); };
  const auto moving = std::ranges::find_if(balls, moves);
  if (options.nearest && moving != balls.end())
    throw program::UsageError("--nearest",
                              fmt::format("it is about balls at a place, but that of line {} moves; without it, "
                                          "the faces on its way are listed, the first one first",
                                          moving->line));
  std::string file;
  for (std::size_t first = 0; first < balls.size(); first += kTogether) {
    const auto some = std::span(balls).subspan(first, std::min(kTogether, balls.size() - first));
    const std::string lines = judge::answers_about(mesh, some, options.nearest);
    const methods::DeferSignals whole;
    if (options.output.empty())
      fmt::print("{}", lines);
    else
      file += lines;
    program::flush_standard_output();
  }
  if (!options.output.empty()) program::write_file(options.output, file, options.force);
}

}  // namespace

program::Command ask_command() {
  program::Command command(
      "ask", "Answer about a ball and a polygon or mesh in words, exact with fast beside it, or about many balls");
  auto options = std::make_shared<AskOptions>();
  command.text("--ball", options->ball, "The centre and the radius: X,Y,Z,R").takes("BALL");
  command.text("--to", options->to, "The ball moves: its centre ends here, at X,Y,Z", program::not_empty)
      .takes("POINT");
  command
      .text("--polygon", options->polygon,
            "Loops such as '0 0 0, 4 0 0, 0 4 0', holes after a semicolon; or a POLYGON of WKT; or a file of either",
            program::not_empty)
      .takes("LOOPS");
  command.text("--mesh", options->mesh, "A mesh instead: OBJ, OFF, PLY or STL", program::not_empty).takes("FILE");
  program::require_one_of(command, {"--polygon", "--mesh"});
  methods::declare_methods(command, options->methods);
  command
      .text("--show", options->show, "Also draw it, on a page in this file (HTML, self-contained)", program::not_empty)
      .takes("FILE");
  command.flag("--print", options->print, "Only print the question as a case, as `judge` and `show` take it")
      .excludes("--methods")
      .excludes("--engine")
      .excludes("--show");
  program::declare_force(command, options->force);  // before --output, which is a file here
  command
      .text(
          "--balls", options->balls,
          "Print a line of JSON for each ball of this file instead, with the faces that it touches; a line of the file "
          "has the numbers x y z r, and the end of its way if the ball moves; - is standard input",
          program::not_empty)
      .takes("FILE")
      .excludes_all_but({"--mesh", "--nearest", "--output", "--force"});
  command.flag("--nearest", options->nearest, "Answer which face is nearest to the centre, and where").needs("--balls");
  command.text("--output", options->output, "Write the lines to this file", program::not_empty)
      .takes("FILE")
      .needs("--balls");
  program::require_one_of(command, {"--ball", "--balls"});
  command.help().footer =
      "exact is certified. Another method is listed by what it answers otherwise. Exit status: 2 for wrong input, else "
      "0.";
  command.help().examples.emplace_back("ask --ball 1,1,1,1.1547005383792515 --polygon '1 0 0, 0 1 0, 0 0 1'");
  command.help().examples.emplace_back("ask --mesh part.obj --balls balls.txt --nearest");
  command.runs([options] {
    if (!options->show.empty()) program::refuse_overwrite(options->show, options->force);
    const methods::KillEngineOnSignal kill_engine_on_signal;
    if (!options->balls.empty()) {
      ask_about_balls(*options);
      return 0;
    }
    const cases::Question question = question_of(*options);
    answer(*options, {question, options->mesh.empty() ? polygon_of(*options) : ask_mesh(*options, question)});
    return 0;
  });
  return command;
}

}  // namespace touchstone::commands
