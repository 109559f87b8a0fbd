// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "experiments/commands.h"

namespace touchstone::commands {
namespace {

using program::Command;
using program::TableDescription;

/// Calls visit(name, table) for every table of the commands, in their order.
template <class Visit>
void for_each_table(const std::vector<Command>& commands, const std::string& prefix, const Visit& visit) {
  for (const Command& command : commands) {
    const std::string name = prefix + command.name();
    for (const TableDescription& table : command.tables()) visit(name, table);
    for_each_table(command.subcommands(), name + " ", visit);
  }
}

std::string plain(const std::string& name, const TableDescription& table) {
  std::size_t width = 0;
  for (const auto& [column, meaning] : table.columns) width = std::max(width, column.size());
  std::string text = fmt::format("{} ({}): each line is about {}\n", table.file, name, table.row);
  for (const auto& [column, meaning] : table.columns) text += fmt::format("  {:<{}}  {}\n", column, width, meaning);
  return text;
}

std::string markdown(const std::string& name, const TableDescription& table) {
  std::string text = fmt::format("## `{}` ({})\n\nEach line is about {}.\n\n| column | meaning |\n|---|---|\n",
                                 table.file, name, table.row);
  for (const auto& [column, meaning] : table.columns) text += fmt::format("| `{}` | {} |\n", column, meaning);
  return text + "\n";
}

nlohmann::ordered_json json(const std::string& name, const TableDescription& table) {
  nlohmann::ordered_json columns = nlohmann::ordered_json::array();
  for (const auto& [column, meaning] : table.columns) columns.push_back({{"column", column}, {"meaning", meaning}});
  return {{"file", table.file}, {"command", name}, {"row", table.row}, {"columns", columns}};
}

}  // namespace

Command columns_command(const std::vector<Command>& commands) {
  struct Options {
    std::string of;
    bool markdown = false, json = false;
  };
  auto options = std::make_shared<Options>();
  Command command("columns", "List the tables that commands write, and the meaning of their columns");
  command.text("NAME", options->of, "Only the tables of this command, or the tables with this file name");
  command.flag("--markdown", options->markdown, "Print the tables of a page");
  command.help().examples.emplace_back("columns near-edge");
  program::declare_json(command, options->json, "Print them as a JSON array").excludes("--markdown");
  command.runs([options, commands] {
    bool found = false;
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for_each_table(commands, "", [&](const std::string& name, const TableDescription& table) {
      if (!options->of.empty() && options->of != name && options->of != table.file) return;
      if (options->json)
        list.push_back(json(name, table));
      else
        fmt::print("{}{}", found && !options->markdown ? "\n" : "",
                   options->markdown ? markdown(name, table) : plain(name, table));
      found = true;
    });
    if (!found)
      throw program::UsageError("NAME",
                                "no command that writes tables, and no table, is called \"" + options->of + "\"");
    if (options->json) fmt::print("{}\n", list.dump());
    return 0;
  });
  return command;
}

}  // namespace touchstone::commands
