// SPDX-License-Identifier: MIT
#include "engine/collision/contact_reduction.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "engine/collision/density_contacts.hpp"
#include "engine/collision/every_contact.hpp"
#include "engine/collision/first_contact.hpp"
#include "engine/collision/grouped_contacts.hpp"
#include "engine/collision/mean_contact.hpp"
#include "engine/collision/weighted_contacts.hpp"

namespace impetus::inline collision {
namespace {

using MakeReduction = std::shared_ptr<const ContactReduction> (*)();

template <class Sums>
std::shared_ptr<const ContactReduction> by() {
  return std::make_shared<const ReductionBy<Sums>>();
}

struct NamedReduction {
  std::string_view name;
  MakeReduction make;
};

constexpr NamedReduction kTable[] = {
    {"none", by<EveryContact>},       {"first", by<FirstContact>},
    {"average", by<MeanContact>},     {"groups", by<GroupedContacts>},
    {"density", by<DensityContacts>}, {"weighted", by<WeightedContacts>},
};

}  // namespace

std::vector<std::string_view> reduction_names() {
  std::vector<std::string_view> names;
  for (const NamedReduction& each : kTable) {
    names.push_back(each.name);
  }
  return names;
}

std::shared_ptr<const ContactReduction> make_reduction(std::string_view name) {
  std::string known;
  for (const NamedReduction& each : kTable) {
    if (each.name == name) {
      return each.make();
    }
    known += (known.empty() ? "" : ", ") + std::string(each.name);
  }
  throw std::invalid_argument("reduction: expected one of " + known + ", got \"" +
                              std::string(name) + "\"");
}

const ContactReduction& reduction_of(const ContactModel& model) {
  static const ReductionBy<MeanContact> average;
  return model.reduction ? *model.reduction : average;
}

std::int64_t most_contacts(const ContactModel& model, std::int64_t node_contacts) {
  return std::min(
      {node_contacts, reduction_of(model).most(), static_cast<std::int64_t>(model.most_per_pair)});
}

}  // namespace impetus::inline collision
