// From the contacts of overlapping nodes to the few that the response needs.
//
//   none      every one of them
//   first     the one that was entered first
//   average   their mean
//   groups    a mean for each pair of surface groups
//   density   as groups, with normals from the density gradients
//   weighted  as groups, weighted by interpenetration and occupancy
//
// (Dingliana 2002, sec. 4.2)
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string_view>
#include <vector>

namespace impetus {

class ContactReduction;

/// The reduction called `name`. Throws std::invalid_argument that lists the names there are.
std::shared_ptr<const ContactReduction> make_reduction(std::string_view name);

/// The names make_reduction() takes, in the order of the list above.
std::vector<std::string_view> reduction_names();

/// How a pair's contacts are reduced.
struct ContactModel {
  std::shared_ptr<const ContactReduction> reduction;  ///< none: average
  int most_per_pair{4};  ///< of what the reduction leaves, those that span most torque; 1 or more
};

}  // namespace impetus
