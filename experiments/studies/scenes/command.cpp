// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "experiments/cases/workloads/meshes.h"
#include "experiments/cases/workloads/unit.h"
#include "experiments/methods/registry.h"
#include "experiments/methods/selection.h"
#include "experiments/run/command_run.h"
#include "experiments/run/numbers.h"
#include "experiments/run/output.h"
#include "experiments/run/study.h"
#include "experiments/studies/scenes/measure.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::commands {
namespace {

using namespace scenes;

std::vector<std::string> split_at_commas(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

struct SceneOptions : run::FolderOptions {
  std::vector<std::string> files, objects, units, engines;
  std::string balls, scene_unit, method = "filtered";
  std::uint64_t random = 0, seed = 1;
  unsigned threads = run::all_threads();
  bool any = false, all = false, nearest = false, merge = false, as_segments = false, skip_bad = false;

  [[nodiscard]] Question question() const { return any ? Question::Any : nearest ? Question::Nearest : Question::All; }
  [[nodiscard]] Taken taken() const { return merge ? Taken::Merged : as_segments ? Taken::AsSegments : Taken::Alone; }
  [[nodiscard]] bool filtered() const { return method == "filtered" && engines.empty(); }
};

/// The units of the meshes, one each, and of balls and answers; empty if no units are given.
struct Units {
  std::vector<workloads::Unit> meshes;
  std::optional<workloads::Unit> scene;
};

Units units_of(const SceneOptions& options) {
  Units units;
  for (const std::string& name : options.units) units.meshes.push_back(workloads::find_unit(name));
  if (units.meshes.empty()) {
    if (!options.scene_unit.empty()) throw std::invalid_argument("--scene-unit needs --unit, that of the meshes");
    return units;
  }
  if (units.meshes.size() == 1) units.meshes.resize(options.files.size(), units.meshes.front());
  if (units.meshes.size() != options.files.size())
    throw std::invalid_argument(fmt::format("--unit takes one unit, or one for each mesh: {} were given for {} meshes",
                                            units.meshes.size(), options.files.size()));
  units.scene = options.scene_unit.empty() ? units.meshes.front() : workloads::find_unit(options.scene_unit);
  return units;
}

/// Returns the method that is asked: the engine, if there is one.
const cases::Method& method_of(const SceneOptions& options) {
  const auto methods = methods::Selection{{options.method}, options.engines}.methods();
  if (options.method == "all" || methods.size() > 2) throw std::invalid_argument("--method takes one method");
  return *methods.back();
}

struct Loaded {
  std::vector<Object> objects;
  std::string left_out;  ///< a sentence a line
  std::uint64_t parts_left_out = 0;
};

/// Returns nothing if a file cannot be read as requested, and reports that on standard error.
std::optional<Loaded> load(const run::CommandRun& run, const SceneOptions& options, const Units& units) {
  constexpr std::size_t kShown = 3;
  workloads::NamedFiles files =
      workloads::read_named_files(options.files, options.skip_bad ? OnFault::Skip : OnFault::Refuse);
  if (!files.all_read) return std::nullopt;
  Loaded loaded{{}, workloads::left_out_text(files), files.parts_left_out};
  bool refused = false, empty = false;
  run::ProgressLine line = run.progress("scene: meshes", files.read.size());
  for (std::size_t i = 0; i < files.read.size(); ++i) {
    workloads::NamedFile& file = files.read[i];
    if (units.scene) {
      try {
        convert(file.content.mesh, units.meshes[i], *units.scene);
      } catch (const std::range_error& error) {
        throw std::range_error(file.file + ": " + error.what());
      }
    }
    const std::string name = io::all_legible(file.file);
    loaded.objects.push_back(object_of(std::move(file), options.taken()));
    Object& object = loaded.objects.back();
    const char* what = options.skip_bad ? "left out: " : "";
    for (std::size_t k = 0; k < object.rejected.size() && k < kShown; ++k)
      fmt::print(stderr, "touchstone: {}{}\n", what, object.rejected[k]);
    if (object.faces_rejected > kShown)
      fmt::print(stderr, "touchstone: {}{}: {} more faces\n", what, name, object.faces_rejected - kShown);
    for (const std::string& sentence : object.rejected) loaded.left_out += sentence + "\n";
    if (object.faces_rejected > object.rejected.size())
      loaded.left_out += fmt::format("{}: {} more faces\n", name, object.faces_rejected - object.rejected.size());
    loaded.parts_left_out += object.faces_rejected;
    refused = refused || object.faces_rejected > 0;
    if (object.numbers.empty()) {  // nothing would touch it, and what was meant is another file
      fmt::print(stderr, "touchstone: {}: no face is left\n", name);
      empty = true;
    }
    line(i + 1);
  }
  if (empty || (refused && !options.skip_bad)) return std::nullopt;
  return loaded;
}

/// The objects that --objects names, ascending; all where it names none.
std::vector<std::uint32_t> chosen(const SceneOptions& options, const std::vector<Object>& objects) {
  std::vector<std::uint32_t> numbers;
  std::vector<std::string> names;
  for (const Object& object : objects) names.push_back(object.name);
  const auto choose = [&](const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) numbers.push_back(static_cast<std::uint32_t>(found - names.begin()));
    return found != names.end();
  };
  for (const std::string& word : options.objects) {
    if (choose(word)) continue;  // a name may hold commas
    for (const std::string& name : split_at_commas(word))
      if (!choose(name))
        throw std::invalid_argument("--objects: there is no object \"" + name + "\"; there are " + run::joined(names));
  }
  if (options.objects.empty()) {
    numbers.resize(objects.size());
    std::iota(numbers.begin(), numbers.end(), 0U);
  }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

/// Balls by number: those of a file are read at once, random ones are drawn when they are needed.
struct Source {
  std::uint64_t count;
  std::function<NamedBall(std::uint64_t)> ball;
};

Source source_of(const SceneOptions& options, const std::vector<Object>& objects) {
  if (!options.balls.empty()) {
    auto balls = std::make_shared<const std::vector<NamedBall>>(read_balls(options.balls));
    const auto moves = [](const NamedBall& ball) { return std::holds_alternative<Motion>(ball.question); };
    const auto moving = std::ranges::find_if(*balls, moves);
    if (options.nearest && moving != balls->end())
      throw std::invalid_argument("--nearest is about balls at a place, but the ball \"" + io::all_legible(moving->id) +
                                  "\" moves; --all lists the faces on its way, the first one first");
    return {balls->size(), [balls](std::uint64_t i) { return (*balls)[i]; }};
  }
  std::vector<scene::Faces> faces;
  for (const Object& object : objects) faces.push_back(object.faces);
  auto random = std::make_shared<const RandomBalls>(faces);
  return {options.random, [random, seed = options.seed](std::uint64_t i) { return random->draw(seed, i); }};
}

/// The sums of the answers so far.
struct Sums {
  std::uint64_t balls = 0;
  Differences differences;
};

std::string summary(const SceneOptions& options, const Units& units, const Loaded& loaded, const Sums& sums) {
  using run::counted;
  std::uint64_t faces = 0;
  std::uint64_t lifted = 0, segments = 0;
  double farthest = 0;
  for (const Object& object : loaded.objects) {
    faces += object.numbers.size();
    segments += object.segments.size();
    for (const double off_plane : object.off_plane) {
      lifted += off_plane > 0 ? 1 : 0;
      farthest = std::max(farthest, off_plane);
    }
  }
  std::string text = fmt::format("{}, {} of {}, {} of files left out{}.\n", counted(sums.balls, "ball"),
                                 counted(loaded.objects.size(), "object"), counted(faces, "face"),
                                 counted(loaded.parts_left_out, "part"),
                                 units.scene ? fmt::format("; lengths in {}", units.scene->name) : "");
  if (segments > 0)
    text += fmt::format("{} of no area: segments or points.\n",
                        segments == 1 ? "1 face is" : fmt::format("{} faces are", segments));
  if (lifted > 0)
    text += fmt::format("{} not planar: vertices are displaced by up to {} onto the plane.\n",
                        lifted == 1 ? "1 face is" : fmt::format("{} faces are", lifted), farthest);
  if (!options.filtered()) {
    const Differences& differences = sums.differences;
    text += fmt::format("{} answers otherwise than filtered to {} of {} balls", method_of(options).name(),
                        differences.answers, differences.balls);
    if (options.nearest) text += fmt::format(", gives another distance for {}", differences.distances);
    text += fmt::format(", and is unsure of some face for {}.\n", differences.unsure);
  }
  return text;
}

/// The lines go to a file of the folder, or to standard output. Throws std::runtime_error, which names it, as soon as
/// it is known that something could not be written.
class Lines {
 public:
  explicit Lines(const std::string& folder) {
    if (!folder.empty()) name_ = (std::filesystem::path(folder) / "answers.jsonl").string();
  }
  /// Opens the file, a new one unless it is a pipe; not before the balls are read, since an earlier one may be theirs.
  void begin() {
    if (name_ == kStandardOutput) return;
    std::error_code error;
    if (!std::filesystem::is_fifo(std::filesystem::symlink_status(name_, error))) ::unlink(name_.c_str());
    const int descriptor = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor < 0) cannot_write();
    own_.reset(::fdopen(descriptor, "wb"));
    if (!own_) cannot_write();
  }
  void write(const std::string& line) {
    // glibc counts what is still in the buffer as written where emptying the buffer fails, but sets the error.
    if (std::fwrite(line.data(), 1, line.size(), stream()) != line.size() || std::ferror(stream()) != 0) cannot_write();
  }
  void close() {
    if (std::fflush(stream()) != 0 || (own_ && std::fclose(own_.release()) != 0)) cannot_write();
  }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  [[nodiscard]] std::FILE* stream() const { return own_ ? own_.get() : stdout; }
  [[noreturn]] void cannot_write() const {
    throw std::runtime_error(name_ + ": cannot be written: " + std::generic_category().message(errno));
  }

  static constexpr const char* kStandardOutput = "standard output";
  std::string name_ = kStandardOutput;
  std::unique_ptr<std::FILE, Close> own_;
};

/// Asks about the balls in legs, one after the other, and writes the answers as they come.
Sums ask(run::CommandRun& run, const SceneOptions& options, const std::vector<Object>& objects,
         const scene::Scene& scene, const Order& order, const Source& source, Lines& lines) {
  const std::atomic<bool>& stop = run.stop();
  const cases::Method* const method = options.filtered() ? nullptr : &method_of(options);
  const std::uint64_t leg = method != nullptr ? 256 : options.question() == Question::All ? 4096 : 65536;
  const std::uint64_t blocks = std::max<std::uint64_t>(face_blocks(objects, order), 1);
  Sums sums;
  run::ProgressLine progress =
      run.progress("scenes", method == nullptr ? source.count : (source.count + leg - 1) / leg * blocks);
  for (std::uint64_t begin = 0; begin < source.count && !stop; begin += leg) {
    std::vector<NamedBall> part;
    for (std::uint64_t i = begin; i < std::min(begin + leg, source.count); ++i) part.push_back(source.ball(i));
    const std::vector<BallAnswer> truths = ask_scene(scene, order, part, stop);
    std::vector<BallAnswer> answers;
    if (method != nullptr)
      answers = ask_every_face(*method, objects, order, part, stop,
                               [&](std::uint64_t done) { progress(begin / leg * blocks + done); });
    const std::size_t done = method == nullptr ? truths.size() : std::min(truths.size(), answers.size());
    if (method != nullptr)
      for (std::size_t i = 0; i < done; ++i) sums.differences.add(answers[i], truths[i], order.question);
    const std::vector<BallAnswer>& told = method == nullptr ? truths : answers;
    for (const std::string& line : answer_lines(part, std::span(told).first(done), order, objects)) lines.write(line);
    sums.balls += done;
    if (method == nullptr) progress(sums.balls);
  }
  lines.close();
  return sums;
}

int run(const SceneOptions& options) {
  constexpr int kBadInput = 2;
  run::CommandRun run(options);
  Lines lines(options.output);
  const Units units = units_of(options);
  (void)method_of(options);
  if (options.as_segments && !options.filtered())
    throw std::invalid_argument(
        "--as-segments: filtered alone is asked about segments, as other methods take polygons");
  const std::optional<Loaded> loaded = load(run, options, units);
  if (!loaded) return kBadInput;
  const std::vector<Object>& objects = loaded->objects;
  const Order order{options.question(), options.merge, chosen(options, objects), options.threads};
  const Source source = source_of(options, objects);

  scene::Scene scene;
  for (const Object& object : objects) scene.add(object.name, object.faces);
  lines.begin();
  const Sums sums = ask(run, options, objects, scene, order, source, lines);

  const bool interrupted = sums.balls < source.count;
  const std::string text = summary(options, units, *loaded, sums);
  if (run.has_folder()) {
    run::write_file(run.folder() / "left-out.txt", loaded->left_out);
    run.finish({.seed = options.seed,
                .samples_asked = source.count,
                .samples_done = sums.balls,
                .samples_missing = source.count - sums.balls,
                .threads = options.threads,
                .interrupted = interrupted},
               text + fmt::format("Results: {}\n", io::all_legible(options.output)));
  } else if (!options.quiet) {
    fmt::print(stderr, "{}", text);
  }
  if (!interrupted) return 0;
  fmt::print(stderr, "touchstone: interrupted: these are the answers to the first {} of {} balls\n", sums.balls,
             source.count);
  return run::kInterrupted;
}

}  // namespace

run::Command scenes_command() {
  run::Command command("scenes", "Find the faces of meshes (OBJ, OFF, STL, PLY) that balls touch, or the nearest");
  auto options = std::make_shared<SceneOptions>();
  run::declare_meshes(command, options->files, "Mesh files; each is an object named by folder and file, as arm/link1")
      .required();
  command
      .text(
          "--balls", options->balls,
          "A file of balls, one a line: {\"id\":\"a\",\"ball\":{\"center\":[x,y,z],\"radius\":r}} as in a case, or "
          "the numbers x y z r; of a ball that moves also \"motion\":{\"to\":[x,y,z]}, or the three numbers of the end "
          "of its way; # begins a comment; or an array of such rows, as numpy.save writes it; - is standard input")
      .takes("FILE");
  command.whole("--samples", options->random, "The number of random balls, half of them near a face", 1,
                run::kMostSamples);
  run::require_one_of(command, {"--balls", "--samples"});
  run::declare_seed(command, options->seed, "The seed of --samples; the same seed gives the same bytes");
  command.flag("--any", options->any, "Answer whether the ball touches any face");
  command.flag("--all", options->all,
               "Answer which faces it touches (default); of a ball that moves, in the order of time");
  command.flag("--nearest", options->nearest, "Answer which face is nearest to its centre, and where");
  run::allow_one_of(command, {"--any", "--all", "--nearest"});
  command
      .text(
          "--method", options->method,
          "filtered uses the scene's hierarchy; any other method is asked about every face, and compared with filtered")
      .takes("METHOD");
  methods::declare_engines(command, options->engines,
                           "Instead of --method: an engine of yours, COMMAND or COMMAND=NAME")
      .excludes("--method");
  command.texts("--objects", options->objects,
                "Ask about these objects only: a name, or names separated by commas; may be repeated");
  command.names("--unit", options->units,
                "The unit of the meshes' numbers, one for all or one each: um, mm, cm, m, inch, foot. Where all are "
                "the same it changes no number; a mesh in another unit than the scene is scaled, each coordinate "
                "rounded once to the nearest double");
  command.text("--scene-unit", options->scene_unit, "The unit of balls and answers (default: that of the first mesh)");
  command.flag("--merge", options->merge,
               "Merge neighbouring faces that lie exactly in one plane, so that a ball on them meets no seam; answers "
               "then list the merged faces");
  command.flag(
      "--as-segments", options->as_segments,
      "Take a face whose corners lie on one line as the segment or the point that they span; answers then list "
      "these corners");
  run::allow_one_of(command, {"--merge", "--as-segments"});
  command.flag("--skip-bad", options->skip_bad,
               "Leave out faulty parts of a file and faces that are not valid polygons, and report them");
  run::declare_threads(command, options->threads);
  run::declare_output(command, *options,
                      "A folder for answers.jsonl, left-out.txt and run.json (default: answers go to standard "
                      "output, their number to standard error)");
  command.help().footer = "Exit status: 2 for wrong input, 130 if interrupted, otherwise 0.";
  run::declare_quiet(command, options->quiet,
                     "Print no number of answers and no progress; without --output, the answers alone");
  command.help().examples.emplace_back("scenes part.obj --samples 100 --nearest");
  command.runs([options] { return run(*options); });
  return command;
}

}  // namespace touchstone::commands
