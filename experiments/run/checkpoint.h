// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/core.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "experiments/run/state.h"

namespace touchstone::run {

/// Everything that results depend on: the values of options by their names (without dashes), and a version. The version
/// is raised when sample n of a seed changes, or when the form or the meaning of a state changes.
struct ResultSettings {
  int version;
  std::vector<std::pair<std::string, std::string>> options;
  std::string part{};  ///< of how many items; empty for a run of all
};

/// Throws DamagedArchive for a state that no run has, although it can be read: one that counts more than there is, or
/// names what there is not.
template <class State>
using StateCheck = std::function<void(const std::type_identity_t<State>&)>;

/// Accepts every state.
struct NoCheck {
  template <class State>
  void operator()(const State&) const {}
};

/// The state of a long run, in a file that always holds one complete state. A state is written as an Archive; a
/// function items_done(state) in its namespace returns how many items it covers.
class Checkpoint {
 public:
  Checkpoint(std::filesystem::path path, ResultSettings settings)
      : path_(std::move(path)), settings_(std::move(settings)) {}

  /// Throws std::runtime_error, which names the file, if it cannot be written.
  template <class State>
  void write(const State& state) const {
    write_text(items_done(state), archived(state));
  }

  /// Returns the state to continue with, or nothing if there is no file yet. Throws std::runtime_error for a file
  /// that is damaged, of another version, or of other settings: it names those that differ.
  template <class State>
  [[nodiscard]] std::optional<State> read(State state, const StateCheck<State>& check = NoCheck()) const {
    const std::optional<std::string> text = read_text();
    if (!text) return std::nullopt;
    try {
      restore(*text, state);
      check(state);
      return state;
    } catch (const DamagedArchive& error) {
      refuse(std::string("is not a checkpoint of this program: ") + error.what());
    }
  }

  /// Returns the state of a run that has ended. Throws as `read` does, and std::runtime_error, which names the file, if
  /// there is none or if the state does not cover this many items.
  template <class State>
  [[nodiscard]] State read_complete(State zero, std::uint64_t items, const StateCheck<State>& check = NoCheck()) const {
    auto state = read(std::move(zero), check);
    if (!state) refuse("does not exist");
    refuse_fewer(items_done(*state), items);
    return std::move(*state);
  }

  /// Renames an existing file to the same name with `.previous`: a new run overwrites no earlier one. Returns whether
  /// there was one. Throws std::runtime_error, which names the file, if that fails.
  bool set_aside() const;

  /// Throws std::runtime_error, which names the file, if the checkpoint holds more items than requested.
  void refuse_more(std::uint64_t held, std::uint64_t asked) const;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  void write_text(std::uint64_t done, const std::string& state) const;
  [[nodiscard]] std::optional<std::string> read_text() const;
  void refuse_fewer(std::uint64_t held, std::uint64_t wanted) const;
  /// Throws std::runtime_error, which names the file and says why.
  [[noreturn]] void refuse(const std::string& why) const;

  std::filesystem::path path_;
  ResultSettings settings_;
};

/// Returns the state from which a run begins: `zero`, or what the checkpoint holds if `resume` is true, and writes it
/// to the checkpoint. Without `resume` renames an existing checkpoint first, and says so on stderr. Throws as
/// Checkpoint does, and std::runtime_error if the checkpoint holds more than `asked` items, as items_done(state) counts
/// them.
template <class State>
State begin(const Checkpoint& checkpoint, bool resume, std::uint64_t asked, State zero,
            const StateCheck<State>& check = NoCheck()) {
  State state = std::move(zero);
  if (resume) {
    if (auto held = checkpoint.read(state, check)) state = std::move(*held);
  } else if (checkpoint.set_aside()) {
    fmt::print(stderr,
               "touchstone: starting over, without --resume; the previous checkpoint is saved as {0}.previous\n",
               checkpoint.path().string());
  }
  checkpoint.refuse_more(items_done(state), asked);
  checkpoint.write(state);
  return state;
}

}  // namespace touchstone::run
