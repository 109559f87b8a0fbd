// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/methods/process/reply.h"

#include "experiments/cases/verdict.h"
#include "experiments/run/json/strict_json.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::methods {

Reply read_reply(const std::string& line) {
  Reply reply{.id = {}, .answer = {}, .echo = io::legible(line)};
  try {
    const run::StrictJson read = run::read_strict_json(line);
    if (!read.value.is_object()) return reply;
    const auto id = read.value.find("id");
    if (id != read.value.end() && id->is_string() && !read.ambiguous.contains("id")) reply.id = id->get<std::string>();
    if (read.duplicate_key)
      reply.echo = "duplicate key \"" + io::legible(*read.duplicate_key) + "\" in one object: " + reply.echo;
    else if (reply.id && !read.too_deep)
      reply.answer = cases::answer_in(read.value);
  } catch (const run::NotJson&) {
    // The reply echoes the line.
  }
  return reply;
}

}  // namespace touchstone::methods
