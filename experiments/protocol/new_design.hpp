// The design of a study of one's own: factors from what somebody chose to vary, their levels shown
// equally often, or one factor's chosen trial by trial.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/settings/setting_rows.hpp"

namespace impetus::inline protocol {

/// A number to the millionth, whole where it is.
OrderedJson short_number(double number);

/// "a, b, c" of an object's keys.
std::string key_list(const OrderedJson& object);

/// How the levels of the first factor are chosen.
enum class LevelChoice {
  kAll,        ///< each is shown equally often
  kStaircase,  ///< up and down by what was answered (Levitt 1971)
  kQuestPlus   ///< where an answer tells most (Watson 2017)
};

/// "all", "staircase" or "quest". Throws InputError.
LevelChoice level_choice(const std::string& name);

/// The factors of the design, one for each of `vary` ("restitution=0.2,0.8"); the first that is
/// offered where that is empty. A name alone has the levels that `offered` gives it, finer ones
/// where the first factor's are chosen trial by trial. Throws InputError.
OrderedJson factors_from(const std::vector<std::string>& vary, const OrderedJson& offered,
                         LevelChoice choice);

/// The factor's level that is nearest to what the scene itself says; the first of words, and where
/// it says nothing. By it others are judged.
OrderedJson natural_level(const OrderedJson& factor, const OrderedJson& scene);

/// What a design is made for.
struct AskedDesign {
  LevelChoice choice{LevelChoice::kAll};
  bool two_intervals{false};  ///< half of all answers are right by chance
  OrderedJson natural;        ///< of the first factor: natural_level()
};

/// The design of about sixty trials, or of a track for each condition. Of two intervals no practice
/// shows twice the same. Throws InputError where levels cannot be chosen from.
OrderedJson design_of(const OrderedJson& factors, const AskedDesign& asked);

}  // namespace impetus::inline protocol
