// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/junit.h"

#include <fmt/core.h>

#include "experiments/judge/tally.h"
#include "experiments/run/xml_text.h"

namespace touchstone::judge {

using run::xml_text;

void JunitReport::add(const Judged& judged) {
  const std::string family = family_of_file(judged.line.file);
  Suite& suite = suites_[{std::string(judged.method), family}];
  ++suite.tests;
  suite.cases +=
      fmt::format("    <testcase classname=\"{}\" name=\"{}\"", xml_text(family), xml_text(*judged.line.read->id));
  std::string sentences;
  for (const cases::Difference& difference : judged.differences)
    sentences.append(sentences.empty() ? "" : "\n").append(to_string(difference));
  if (!judged.fault.empty()) {
    ++suite.errors;
    suite.cases +=
        fmt::format("><error message=\"{}\">{}</error></testcase>\n", xml_text(judged.fault), xml_text(sentences));
  } else if (!judged.differences.empty()) {
    ++suite.failures;
    suite.cases += fmt::format("><failure message=\"{} of {} keys differ\">{}</failure></testcase>\n",
                               judged.differences.size(), judged.compared.size(), xml_text(sentences));
  } else {
    suite.cases += "/>\n";
  }
}

std::string JunitReport::text() const {
  Suite all;
  std::string suites;
  for (const auto& [names, suite] : suites_) {
    all.tests += suite.tests;
    all.failures += suite.failures;
    all.errors += suite.errors;
    suites += fmt::format(
        "  <testsuite name=\"{}: {}\" tests=\"{}\" failures=\"{}\" errors=\"{}\">\n{}  </testsuite>\n",
        xml_text(names.first), xml_text(names.second), suite.tests, suite.failures, suite.errors, suite.cases);
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"touchstone judge\" tests=\"{}\" failures=\"{}\" "
      "errors=\"{}\">\n{}</testsuites>\n",
      all.tests, all.failures, all.errors, suites);
}

}  // namespace touchstone::judge
