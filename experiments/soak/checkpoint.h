// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "experiments/soak/campaign.h"

namespace touchstone::soak {

/// What has been done of a campaign, in a file that always holds one whole state: it is written beside and renamed.
class Checkpoint {
 public:
  explicit Checkpoint(std::filesystem::path path) : path_(std::move(path)) {}

  /// Throws std::runtime_error, which names the file, where it cannot be written.
  void write(const Settings& settings, const Tally& tally) const;

  /// The tally to go on with: empty where there is no file yet. Throws std::runtime_error, which says why, for a file
  /// that is damaged, or that belongs to another seed, first case or version, or holds more cases than are asked for.
  [[nodiscard]] Tally read(const Settings& settings) const;

 private:
  std::filesystem::path path_;
};

}  // namespace touchstone::soak
