// SPDX-License-Identifier: MIT
#include "engine/collision/contact_reduction.hpp"

#include <stdexcept>
#include <string>

namespace impetus {

std::vector<std::string_view> reduction_names() {
  return {"none", "first", "average", "groups", "density", "weighted"};
}

std::shared_ptr<const ContactReduction> make_reduction(std::string_view name) {
  std::string known;
  for (const std::string_view each : reduction_names()) {
    if (each == name) {
      return nullptr;
    }
    known += (known.empty() ? "" : ", ") + std::string(each);
  }
  throw std::invalid_argument("reduction: expected one of " + known + ", got \"" +
                              std::string(name) + "\"");
}

}  // namespace impetus
