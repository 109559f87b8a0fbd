// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/link_model.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "experiments/thesis/cell/model/cell_entry.h"
#include "geometry/io/detail/legible.h"
#include "geometry/io/detail/text_reader.h"

namespace touchstone::cell {
namespace {

using io::TextReader;

constexpr std::size_t kMostMib = 256;

class Reader {
 public:
  explicit Reader(const io::MeshSource& source) : lines_(source, {.comments = true}) {}

  LinkModel file() {
    LinkModel model{name("Link"), {}};
    const std::int64_t parts = count("Parts");
    for (std::int64_t i = 0; i < parts; ++i) {
      LinkPart part{name("Part"), {}, {}};
      const std::int64_t vertices = count("Vertices");
      for (std::int64_t k = 0; k < vertices; ++k) {
        next("vertex", k, vertices);
        part.vertices.push_back(lines_.take_point("for a vertex"));
        line_is_done();
      }
      const std::int64_t polygons = count("Polygons");
      for (std::int64_t k = 0; k < polygons; ++k) {
        next("polygon", k, polygons);
        part.polygons.push_back(polygon(part));
      }
      model.parts.push_back(std::move(part));
    }
    if (lines_.next_line()) lines_.broken("the file continues after the announced counts");
    return model;
  }

 private:
  /// Continues with the line that begins with the word.
  void expect(const char* word) {
    if (!lines_.next_line()) lines_.truncated(std::string("expected '") + word + "'");
    const std::string_view found = lines_.take();
    if (found != word) lines_.broken(std::string("expected '") + word + "', found " + TextReader::quoted(found));
  }

  std::string name(const char* word) {
    expect(word);
    std::string name(lines_.take());
    if (name.empty()) lines_.broken(std::string("a name is expected after '") + word + "'");
    if (io::all_legible(name) != name)
      lines_.broken("the name '" + io::legible(name) + "' has a control character, or is not UTF-8");
    line_is_done();
    return name;
  }

  std::int64_t count(const char* word) {
    expect(word);
    const std::int64_t count = lines_.take_count();
    line_is_done();
    return count;
  }

  void next(const char* what, std::int64_t index, std::int64_t count) {
    if (!lines_.next_line())
      lines_.truncated(std::string(what) + " " + std::to_string(index) + " of " + std::to_string(count) +
                       " is missing");
  }

  std::vector<std::uint32_t> loop(const LinkPart& part) {
    const std::int64_t count = lines_.take_count();
    if (count < 3) lines_.broken("a loop needs at least 3 vertices, this one has " + std::to_string(count));
    lines_.take_corners(count, corners_);
    std::vector<std::uint32_t> loop;
    for (const std::int64_t number : corners_) {
      if (number < 0 || static_cast<std::size_t>(number) >= part.vertices.size())
        lines_.broken("vertex " + std::to_string(number) + " is out of range: the part has " +
                      std::to_string(part.vertices.size()) + " vertices, numbered from 0");
      loop.push_back(static_cast<std::uint32_t>(number));
    }
    return loop;
  }

  LinkPolygon polygon(const LinkPart& part) {
    LinkPolygon polygon{loop(part), {}};
    while (!lines_.line_is_done()) {
      const std::string_view word = lines_.take();
      if (word != "Hole") lines_.broken("expected 'Hole' or the end of the line, found " + TextReader::quoted(word));
      polygon.holes.push_back(loop(part));
    }
    return polygon;
  }

  void line_is_done() {
    if (!lines_.line_is_done())
      lines_.broken("expected the end of the line, found " + TextReader::quoted(lines_.peek()));
  }

  TextReader lines_;
  std::vector<std::int64_t> corners_;
};

void append(std::string& text, double number) {
  std::array<char, 32> digits;
  const auto [end, error] = std::to_chars(digits.begin(), digits.end(), number);
  text.append(digits.begin(), end);
}

void append_loop(std::string& text, const std::vector<std::uint32_t>& loop) {
  text += std::to_string(loop.size());
  for (const std::uint32_t number : loop) text.append(" ").append(std::to_string(number));
}

const std::string& one_word(const std::string& name) {
  if (io::all_legible(name) != name || name.find_first_of(" #") != std::string::npos)
    throw std::invalid_argument("the name \"" + io::legible(name) + "\" is not one word of UTF-8 without '#'");
  if (name.empty()) throw std::invalid_argument("a name is empty");
  return name;
}

}  // namespace

LinkModel read_link_model(const std::filesystem::path& file) {
  const io::MeshSource source{file.string(), read_at_most<BrokenMesh>(file, kMostMib)};
  return Reader(source).file();
}

std::string link_model_text(const LinkModel& model) {
  std::string text = "Link " + one_word(model.name) + "\nParts " + std::to_string(model.parts.size()) + "\n";
  for (const LinkPart& part : model.parts) {
    text += "Part " + one_word(part.name) + "\nVertices " + std::to_string(part.vertices.size()) + "\n";
    for (const Eigen::Vector3d& vertex : part.vertices)
      for (int axis = 0; axis < 3; ++axis) {
        append(text, vertex[axis]);
        text += axis < 2 ? ' ' : '\n';
      }
    text += "Polygons " + std::to_string(part.polygons.size()) + "\n";
    for (const LinkPolygon& polygon : part.polygons) {
      append_loop(text, polygon.outer);
      for (const std::vector<std::uint32_t>& hole : polygon.holes) {
        text += " Hole ";
        append_loop(text, hole);
      }
      text += '\n';
    }
  }
  return text;
}

LinkPart link_part(std::string name, const SolidFaces& solid) {
  LinkPart part{std::move(name), {}, {}};
  NumberedPoints vertices;
  for (const Face& face : solid.faces) {
    const Polygon& polygon = face.polygon;
    LinkPolygon result;
    for (std::size_t loop = 0; loop < polygon.loop_count(); ++loop) {
      std::vector<std::uint32_t> numbers;
      for (std::size_t i = polygon.loop_begin(loop); i < polygon.loop_end(loop); ++i)
        numbers.push_back(vertices.number(polygon.vertex(i)));
      if (loop == 0)
        result.outer = std::move(numbers);
      else
        result.holes.push_back(std::move(numbers));
    }
    part.polygons.push_back(std::move(result));
  }
  part.vertices = std::move(vertices.points);
  return part;
}

std::map<std::string, LinkModel> link_models(const std::vector<ModelPart>& parts) {
  std::map<std::string, LinkModel> models;
  for (const ModelPart& part : parts) {
    const std::size_t slash = part.name.find('/');
    const std::string owner = part.name.substr(0, slash);
    const std::string own = slash == std::string::npos ? part.name : part.name.substr(slash + 1);
    const bool stands = part.carrier == Carrier::Storage || part.carrier == Carrier::Machine;
    const std::string file = part.carrier == Carrier::Link ? owner : stands ? owner + "-" + own : own;
    LinkModel& model = models[file];
    model.name = file;
    model.parts.push_back(link_part(own, part.faces));
  }
  return models;
}

}  // namespace touchstone::cell
