// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "experiments/run/checkpoint.h"
#include "experiments/soak/campaign.h"

namespace touchstone::soak {

/// What has been done of a campaign, in a file that always holds one whole state.
class Checkpoint {
 public:
  Checkpoint(std::filesystem::path path, const Settings& settings);

  /// Throws std::runtime_error, which names the file, where it cannot be written.
  void write(const Tally& tally) const;

  /// The tally to go on with: empty where there is no file yet. Throws std::runtime_error, which says why, for a file
  /// that is damaged, or that belongs to another seed, first case or version, or holds more cases than are asked for.
  [[nodiscard]] Tally read() const;

 private:
  run::Checkpoint file_;
  std::uint64_t cases_;
};

}  // namespace touchstone::soak
