// SPDX-License-Identifier: MIT
#include "experiments/design/trial_order.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace impetus::inline design {
namespace {

/// How long the run of equal levels is that a rule watches.
class RunningRun {
 public:
  explicit RunningRun(const LongestRun& rule) : rule_(&rule) {}

  /// Goes on with the run or begins another; false when it has become too long.
  bool take(const PlannedTrial& next) {
    const LevelValue& level = find_level(next.condition, rule_->factor)->value;
    length_ = last_ != nullptr && *last_ == level ? length_ + 1 : 1;
    last_ = &level;
    return length_ <= rule_->longest;
  }

 private:
  const LongestRun* rule_;
  const LevelValue* last_{nullptr};  ///< of a trial that outlives this
  std::int64_t length_{0};
};

/// The run that a rule watches and how many trials of each level of its factor are left, levels
/// counted from 0 as they come.
class RuleTally {
 public:
  explicit RuleTally(const LongestRun& rule) : rule_(&rule) {}

  /// A block begins: these trials are left. The run goes on from the block before.
  void begin(const std::vector<PlannedTrial>& block) {
    left_.assign(left_.size(), 0);
    for (const PlannedTrial& trial : block) {
      const std::size_t level = code(trial);
      left_.resize(levels_.size(), 0);
      ++left_[level];
    }
    total_ = static_cast<std::int64_t>(block.size());
  }

  void take(const PlannedTrial& next) {
    const std::size_t level = code(next);
    length_ = last_ == level ? length_ + 1 : 1;
    last_ = level;
    --left_[level];
    --total_;
  }

  /// Whether the run is no longer than allowed, and what is left can follow in some order as far
  /// as this rule goes: a level's trials fit into the gaps that the others leave, of which the
  /// first goes on with the run.
  [[nodiscard]] bool holds() const {
    if (length_ > rule_->longest) {
      return false;
    }
    for (std::size_t level = 0; level < left_.size(); ++level) {
      const std::int64_t begun = last_ == level ? length_ : 0;
      if (left_[level] > rule_->longest * (total_ - left_[level] + 1) - begun) {
        return false;
      }
    }
    return true;
  }

 private:
  std::size_t code(const PlannedTrial& trial) {
    const LevelValue& level = find_level(trial.condition, rule_->factor)->value;
    const auto known = std::find(levels_.begin(), levels_.end(), level);
    const auto index = static_cast<std::size_t>(known - levels_.begin());
    if (known == levels_.end()) {
      levels_.push_back(level);
    }
    return index;
  }

  const LongestRun* rule_;
  std::vector<LevelValue> levels_;
  std::vector<std::int64_t> left_;  ///< by level
  std::int64_t total_{0};
  std::optional<std::size_t> last_;
  std::int64_t length_{0};
};

using Tallies = std::vector<RuleTally>;

/// The tallies after `next`; none when it may not come next.
std::optional<Tallies> after(Tallies tallies, const PlannedTrial& next) {
  for (RuleTally& tally : tallies) {
    tally.take(next);
    if (!tally.holds()) {
      return std::nullopt;
    }
  }
  return tallies;
}

/// Orders a block trial by trial; false when that came to a dead end.
bool draw_one_by_one(std::vector<PlannedTrial>& block, Tallies& tallies, RandomStream& stream) {
  for (RuleTally& tally : tallies) {
    tally.begin(block);
  }
  for (std::size_t place = 0; place < block.size(); ++place) {
    bool found = false;
    for (std::size_t end = block.size(); !found && end > place; --end) {
      std::swap(block[place + stream.place_below(end - place)], block[end - 1]);
      if (auto next = after(tallies, block[end - 1])) {
        tallies = std::move(*next);
        std::swap(block[place], block[end - 1]);
        found = true;
      }
    }
    if (!found) {
      return false;
    }
  }
  return true;
}

bool draw_one_by_one(TrialBlocks& blocks, const std::vector<LongestRun>& rules,
                     RandomStream& stream) {
  Tallies tallies(rules.begin(), rules.end());
  return std::all_of(blocks.begin(), blocks.end(), [&](std::vector<PlannedTrial>& block) {
    return draw_one_by_one(block, tallies, stream);
  });
}

}  // namespace

bool keeps_to(const TrialBlocks& blocks, const std::vector<LongestRun>& rules) {
  return std::all_of(rules.begin(), rules.end(), [&](const LongestRun& rule) {
    RunningRun run(rule);
    for (const std::vector<PlannedTrial>& block : blocks) {
      for (const PlannedTrial& trial : block) {
        if (!run.take(trial)) {
          return false;
        }
      }
    }
    return true;
  });
}

void draw_order(TrialBlocks& blocks, const std::vector<LongestRun>& rules, RandomStream& stream) {
  constexpr int kMostShuffles = 100'000;
  constexpr int kMostTries = 1000;
  for (int draw = 0; draw < kMostShuffles; ++draw) {
    for (std::vector<PlannedTrial>& block : blocks) {
      stream.shuffle(block);
    }
    if (keeps_to(blocks, rules)) {
      return;
    }
  }
  for (int draw = 0; draw < kMostTries; ++draw) {
    if (draw_one_by_one(blocks, rules, stream)) {
      return;
    }
  }
  throw std::runtime_error("no order of the trials that keeps to the longest runs was found in " +
                           std::to_string(kMostShuffles) + " draws");
}

}  // namespace impetus::inline design
