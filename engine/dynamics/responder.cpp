// SPDX-License-Identifier: MIT
#include "engine/dynamics/responder.hpp"

#include <limits>
#include <numeric>
#include <utility>

namespace impetus::inline dynamics {
namespace {

constexpr auto kNoIsland = std::numeric_limits<std::size_t>::max();

/// Of an island whose impulses are found together, in contacts looked at: the active ones are held
/// against each other.
std::int64_t units_together(std::size_t contacts) {
  const auto count = static_cast<std::int64_t>(contacts);
  return 4 * count + count * count / 8;
}

}  // namespace

/// Numbered as they come.
std::size_t Islands::island_of(const ContactArms& contact, const ContactBodies& bodies) {
  const std::int32_t mover = bodies.moves(contact.a) ? contact.a : contact.b;
  if (!bodies.moves(mover)) {
    return kNoIsland;
  }
  std::size_t& island = island_of_set_[sets_.name_of(static_cast<std::size_t>(mover))];
  if (island == kNoIsland) {
    island = count();
    first_.push_back(0);
  }
  return island;
}

void Islands::find(const ContactBodies& bodies) {
  sets_.separate(bodies.body_count());
  for (std::size_t i = 0; i < bodies.contact_count(); ++i) {
    const auto [a, b] = std::pair(bodies.contact(i).a, bodies.contact(i).b);
    if (!bodies.is_like_the_last(i) && bodies.moves(a) && bodies.moves(b)) {
      sets_.join(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
    }
  }
  island_of_set_.assign(bodies.body_count(), kNoIsland);
  island_of_contact_.clear();
  first_.assign(1, 0);
  for (std::size_t i = 0; i < bodies.contact_count(); ++i) {
    const std::size_t island = bodies.is_like_the_last(i) ? island_of_contact_.back()
                                                          : island_of(bodies.contact(i), bodies);
    island_of_contact_.push_back(island);
    if (island != kNoIsland) {
      ++first_[island + 1];
    }
  }
  for (std::size_t island = 0; island < count(); ++island) {
    first_[island + 1] += first_[island];
  }
  members_.resize(first_.back());
  next_ = first_;
  for (std::size_t i = 0; i < island_of_contact_.size(); ++i) {
    if (island_of_contact_[i] != kNoIsland) {
      members_[next_[island_of_contact_[i]]++] = i;
    }
  }
}

const ResponseResult& Responder::respond(const std::vector<Contact>& contacts,
                                         const std::vector<double>& restitutions,
                                         const ResponseRules& rules,
                                         const std::vector<BodyModel>& models,
                                         std::vector<BodyState>& states) {
  bodies_.gather(contacts, models, states);
  note_incoming(bodies_, contacts.size(), result_);
  const bool done = rules.method == ResponseMethod::kInTurn
                        ? respond_in_turn(restitutions, rules, states)
                        : respond_together(contacts, restitutions, rules, states);
  if (!done) {
    in_turn_.finish(restitutions, rules, bodies_, states, result_.impulse_Ns);
  }
  note_residual(bodies_, result_);
  return result_;
}

bool Responder::respond_in_turn(const std::vector<double>& restitutions, const ResponseRules& rules,
                                std::vector<BodyState>& states) {
  all_.resize(bodies_.contact_count());
  std::iota(all_.begin(), all_.end(), std::size_t{0});
  in_turn_.look_at(bodies_);
  return in_turn_.respond(all_, restitutions, rules, bodies_, states, result_.impulse_Ns);
}

bool Responder::respond_together(const std::vector<Contact>& contacts,
                                 const std::vector<double>& restitutions,
                                 const ResponseRules& rules, std::vector<BodyState>& states) {
  islands_.find(bodies_);
  bool looked_at = false;
  bool refused = false;
  for (std::size_t island = 0; island < islands_.count(); ++island) {
    const std::span<const std::size_t> members = islands_.members(island);
    refused = refused ||
              (rules.work != nullptr && !rules.work->passes.spend(units_together(members.size())));
    if (refused) {
      if (!looked_at) {
        in_turn_.look_at(bodies_);
        looked_at = true;
      }
      in_turn_.wake_all(members);
      continue;
    }
    if (together_.respond(contacts, members, restitutions, rules, result_.fastest_m_s, bodies_,
                          states, result_.impulse_Ns)) {
      continue;
    }
    if (!looked_at) {
      in_turn_.look_at(bodies_);
      looked_at = true;
    }
    refused = !in_turn_.respond(members, restitutions, rules, bodies_, states, result_.impulse_Ns);
  }
  return !refused;
}

}  // namespace impetus::inline dynamics
