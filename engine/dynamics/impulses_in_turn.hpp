// Impulses one after the other, without looking twice at a contact whose bodies nobody touched.
//
//   awake: contacts to be looked at        asleep: found not approaching, or pushed, and
//          ^                                       nobody pushed their bodies since
//          '---- a push wakes every contact of the bodies it moved
//
// What a contact does depends on the momenta of its two bodies alone, so one that sleeps would be
// found as it was: passes over the awake, in the order of the contacts, give the bits of passes
// over all. A pass over n contacts of which k are awake costs n / 64 + k.
//
// Where the passes are interrupted, the awake are kept by how visible they are, and the most
// visible of them is always the next.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/dynamics/contact_bodies.hpp"
#include "engine/dynamics/impulse.hpp"

namespace impetus::inline dynamics {

/// What is known of the contacts of `bodies` before any impulse, the approaches of the first
/// `reported` alone; returns no impulses yet.
template <typename Bodies>
void note_incoming(const Bodies& bodies, std::size_t reported, ResponseResult& result) {
  result.impulse_Ns.assign(bodies.contact_count(), 0.0);
  result.approach_m_s.clear();
  result.fastest_m_s = 0.0;
  for (std::size_t i = 0; i < bodies.contact_count(); ++i) {
    result.fastest_m_s = std::max(result.fastest_m_s, bodies.incoming_speed(i));
    if (i < reported) {
      result.approach_m_s.push_back(std::max(0.0, -bodies.separation_speed(i)));
    }
  }
}

/// What the impulses have left.
template <typename Bodies>
void note_residual(const Bodies& bodies, ResponseResult& result) {
  result.residual_approach_m_s = 0.0;
  for (std::size_t i = 0; i < bodies.contact_count(); ++i) {
    result.residual_approach_m_s =
        std::max(result.residual_approach_m_s, -bodies.separation_speed(i));
  }
  if (result.residual_approach_m_s <= kNegligibleApproach * result.fastest_m_s) {
    result.residual_approach_m_s = 0.0;
  }
}

/// `Bodies` are the bodies at the contacts: as ContactBodies, of whose members it uses those named
/// here. Keeps its arrays from one step to the next.
template <typename Bodies>
class ImpulsesInTurn {
 public:
  /// Prepares for the contacts of `bodies`, which must live while this responds.
  void look_at(const Bodies& bodies);

  /// As respond_in_turn() (impulse.hpp): `members` rise, and no other contact touches a body of
  /// theirs that moves. `bodies` are those looked at.
  /// False when the passes were interrupted, and the rest is for finish().
  bool respond(std::span<const std::size_t> members, const std::vector<double>& restitutions,
               const ResponseRules& rules, Bodies& bodies, std::vector<BodyState>& states,
               std::vector<double>& impulse_Ns);

  /// Contacts that nobody has looked at yet, for finish().
  void wake_all(std::span<const std::size_t> members) {
    std::for_each(members.begin(), members.end(), [this](std::size_t i) { wake(i); });
  }

  /// After respond() of the last members: what ResponseWork says of contacts that were left.
  void finish(const std::vector<double>& restitutions, const ResponseRules& rules, Bodies& bodies,
              std::vector<BodyState>& states, std::vector<double>& impulse_Ns);

 private:
  static constexpr double kUnknown = -1.0;
  static constexpr std::int32_t kNoPlace = ContactArms::kNone;

  [[nodiscard]] std::size_t next_awake(std::size_t from, std::size_t end) const;
  void wake(std::size_t contact) {
    const std::size_t place = by_rank_ ? rank_[contact] : contact;
    awake_[place / 64] |= std::uint64_t{1} << (place % 64);
  }
  void wake_contacts_of(std::int32_t place, const Bodies& bodies);
  void sleep(std::size_t place) { awake_[place / 64] &= ~(std::uint64_t{1} << (place % 64)); }
  void rank_awake(std::span<const std::size_t> most_visible_first, std::size_t count);
  void push_walls(const std::vector<double>& restitutions, const ResponseRules& rules,
                  Bodies& bodies, std::vector<BodyState>& states, std::vector<double>& impulse_Ns);
  double push_if_approaching(std::size_t contact, double restitution, double resting_m_s,
                             Bodies& bodies, std::vector<BodyState>& states);

  std::vector<std::uint64_t> awake_;  ///< a bit for each contact, or for each rank
  bool by_rank_{false};
  std::vector<std::uint32_t> rank_;           ///< of each contact; means nothing but by_rank_
  std::vector<std::size_t> ranked_;           ///< contacts by rank
  std::vector<std::uint64_t> by_rank_awake_;  ///< means nothing between calls
  std::vector<double> gives_;                 ///< of each contact, once it was needed
  std::vector<std::uint32_t> first_of_body_;  ///< where each body's contacts begin
  std::vector<std::uint32_t> contacts_of_body_;
};

template <typename Bodies>
void ImpulsesInTurn<Bodies>::look_at(const Bodies& bodies) {
  const std::size_t count = bodies.contact_count();
  awake_.assign(count / 64 + 1, 0);
  gives_.assign(count, kUnknown);
  first_of_body_.assign(bodies.body_count() + 2, 0);
  // Counted two places on, so that filling the lists moves each beginning to its own place.
  const auto each_side = [&](const auto& visit) {
    for (std::size_t i = 0; i < count; ++i) {
      for (const std::int32_t place : {bodies.contact(i).a, bodies.contact(i).b}) {
        if (place != kNoPlace) {
          visit(static_cast<std::size_t>(place), static_cast<std::uint32_t>(i));
        }
      }
    }
  };
  each_side([&](std::size_t place, std::uint32_t /*contact*/) { ++first_of_body_[place + 2]; });
  for (std::size_t i = 2; i < first_of_body_.size(); ++i) {
    first_of_body_[i] += first_of_body_[i - 1];
  }
  contacts_of_body_.resize(first_of_body_.back());
  each_side([&](std::size_t place, std::uint32_t contact) {
    contacts_of_body_[first_of_body_[place + 1]++] = contact;
  });
}

template <typename Bodies>
std::size_t ImpulsesInTurn<Bodies>::next_awake(std::size_t from, std::size_t end) const {
  if (from >= end) {
    return end;
  }
  std::size_t word = from / 64;
  std::uint64_t bits = awake_[word] & (~std::uint64_t{0} << (from % 64));
  while (bits == 0) {
    if (++word * 64 >= end) {
      return end;
    }
    bits = awake_[word];
  }
  return std::min(end, word * 64 + static_cast<std::size_t>(std::countr_zero(bits)));
}

template <typename Bodies>
void ImpulsesInTurn<Bodies>::wake_contacts_of(std::int32_t place, const Bodies& bodies) {
  if (!bodies.moves(place)) {
    return;
  }
  const auto body = static_cast<std::size_t>(place);
  for (std::uint32_t i = first_of_body_[body]; i < first_of_body_[body + 1]; ++i) {
    wake(contacts_of_body_[i]);
  }
}

/// Applies the single-contact impulse (eq. 3.1) if the contact approaches; returns its size.
template <typename Bodies>
double ImpulsesInTurn<Bodies>::push_if_approaching(std::size_t contact, double restitution,
                                                   double resting_m_s, Bodies& bodies,
                                                   std::vector<BodyState>& states) {
  const double speed = bodies.separation_speed(contact);
  if (!(speed < 0.0)) {
    return 0.0;
  }
  double& give = gives_[contact];
  if (give == kUnknown) {
    give = bodies.give(contact);
  }
  if (!(give > 0.0)) {
    return 0.0;
  }
  const double given_back = speed > -resting_m_s ? 0.0 : restitution;
  const double impulse_Ns = -(1.0 + given_back) * speed / give;
  bodies.push(contact, impulse_Ns, states);
  wake(contact);
  wake_contacts_of(bodies.contact(contact).a, bodies);
  wake_contacts_of(bodies.contact(contact).b, bodies);
  return impulse_Ns;
}

template <typename Bodies>
bool ImpulsesInTurn<Bodies>::respond(std::span<const std::size_t> members,
                                     const std::vector<double>& restitutions,
                                     const ResponseRules& rules, Bodies& bodies,
                                     std::vector<BodyState>& states,
                                     std::vector<double>& impulse_Ns) {
  if (members.empty()) {
    return true;
  }
  wake_all(members);
  const std::size_t first = members.front();
  const std::size_t end = members.back() + 1;
  bool refused = false;
  const auto pass = [&](bool plastic) {
    bool changed = false;
    for (std::size_t i = next_awake(first, end); i < end; i = next_awake(i + 1, end)) {
      if (rules.work != nullptr && !rules.work->passes.spend(1)) {
        refused = true;
        return false;
      }
      sleep(i);
      const double added = push_if_approaching(i, plastic ? 0.0 : restitutions[i],
                                               rules.resting_m_s, bodies, states);
      impulse_Ns[i] += added;
      changed = changed || added > 0.0;
    }
    return changed;
  };
  const std::size_t enough = 2 * members.size();
  const std::size_t passes = std::min(enough, static_cast<std::size_t>(rules.most_passes));
  bool changed = true;
  for (std::size_t done = 0; done < passes && changed; ++done) {
    changed = pass(/*plastic=*/false);
  }
  if (changed && passes == enough) {
    pass(/*plastic=*/true);
  }
  if (refused) {
    return false;
  }
  for (std::size_t i = next_awake(first, end); i < end; i = next_awake(i + 1, end)) {
    sleep(i);
  }
  return true;
}

template <typename Bodies>
void ImpulsesInTurn<Bodies>::finish(const std::vector<double>& restitutions,
                                    const ResponseRules& rules, Bodies& bodies,
                                    std::vector<BodyState>& states,
                                    std::vector<double>& impulse_Ns) {
  constexpr std::size_t kMostVisits = 16;  // of each contact, on average
  const std::size_t count = bodies.contact_count();
  if (rules.work->visible.spend(static_cast<std::int64_t>(count))) {
    rank_awake(rules.work->most_visible_first(), count);
    std::size_t visits = 0;
    for (std::size_t rank = next_awake(0, count);
         rank < count && visits < kMostVisits * count && rules.work->visible.spend(1);
         rank = next_awake(0, count), ++visits) {
      sleep(rank);
      const std::size_t contact = ranked_[rank];
      impulse_Ns[contact] +=
          push_if_approaching(contact, restitutions[contact], rules.resting_m_s, bodies, states);
    }
    by_rank_ = false;
  }
  std::fill(awake_.begin(), awake_.end(), 0);
  push_walls(restitutions, rules, bodies, states, impulse_Ns);
  std::fill(awake_.begin(), awake_.end(), 0);
}

/// Ranks all contacts, those that are not named last, and keeps the awake by rank.
template <typename Bodies>
void ImpulsesInTurn<Bodies>::rank_awake(std::span<const std::size_t> most_visible_first,
                                        std::size_t count) {
  ranked_.assign(most_visible_first.begin(), most_visible_first.end());
  for (std::size_t contact = ranked_.size(); contact < count; ++contact) {
    ranked_.push_back(contact);
  }
  rank_.resize(count);
  const std::vector<std::uint64_t>& by_contact = awake_;
  by_rank_awake_.assign(awake_.size(), 0);
  for (std::size_t rank = 0; rank < count; ++rank) {
    const std::size_t contact = ranked_[rank];
    rank_[contact] = static_cast<std::uint32_t>(rank);
    if ((by_contact[contact / 64] >> (contact % 64) & 1) != 0) {
      by_rank_awake_[rank / 64] |= std::uint64_t{1} << (rank % 64);
    }
  }
  awake_.swap(by_rank_awake_);
  by_rank_ = true;
}

/// So that no body ends a step on its way through a wall that it touches: first as ever, then
/// giving nothing back, where a push woke them.
template <typename Bodies>
void ImpulsesInTurn<Bodies>::push_walls(const std::vector<double>& restitutions,
                                        const ResponseRules& rules, Bodies& bodies,
                                        std::vector<BodyState>& states,
                                        std::vector<double>& impulse_Ns) {
  constexpr int kPasses = 4;
  const std::size_t end = bodies.contact_count();
  for (std::size_t i = 0; i < end; ++i) {
    if (bodies.contact(i).b == kNoPlace) {
      wake(i);
    }
  }
  for (int pass = 0; pass < kPasses; ++pass) {
    for (std::size_t i = next_awake(0, end); i < end; i = next_awake(i + 1, end)) {
      sleep(i);
      if (bodies.contact(i).b == kNoPlace) {
        impulse_Ns[i] += push_if_approaching(i, pass == 0 ? restitutions[i] : 0.0,
                                             rules.resting_m_s, bodies, states);
      }
    }
  }
}

}  // namespace impetus::inline dynamics
