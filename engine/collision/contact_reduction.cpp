// SPDX-License-Identifier: MIT
#include "engine/collision/contact_reduction.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "engine/collision/contact_patches.hpp"
#include "engine/scheduling/named_kinds.hpp"

namespace impetus::inline collision {
namespace {

// No reduction: the contact of every pair of overlapping nodes.

/// Sums of the reduction `none`.
class EveryContact final : public ContactSums {
 public:
  static constexpr unsigned kTerms = 0;

  void begin(const Vector3& /*fallback*/) override { contacts_.clear(); }
  void add(const NodeContact& contact) override { contacts_.push_back(contact.touch); }
  void add_touches(std::span<const TouchPoint> touches) override {
    contacts_.insert(contacts_.end(), touches.begin(), touches.end());
  }
  void reduce_to(std::vector<TouchPoint>& contacts) const override {
    contacts.insert(contacts.end(), contacts_.begin(), contacts_.end());
  }

 private:
  std::vector<TouchPoint> contacts_;
};

// The contact that was entered first, by the time since its nodes met.
//
// The thesis compares κ instead, which is relative to the smaller node and so depends on its size.
// A contact that parts gives the response nothing to do, so it counts only when none approaches;
// of equal times the deeper counts, of equals the first to come.
// (Dingliana 2002, sec. 4.2.1, corrected)

/// Sums of the reduction `first`.
class FirstContact final : public ContactSums {
 public:
  static constexpr std::int64_t kMost = 1;
  static constexpr unsigned kTerms = kEntryTerm;

  void begin(const Vector3& /*fallback*/) override { first_.clear(); }

  void add(const NodeContact& contact) override {
    if (first_.empty() || was_before(contact, first_.front())) {
      first_.assign(1, contact);
    }
  }

  void reduce_to(std::vector<TouchPoint>& contacts) const override {
    for (const NodeContact& first : first_) {
      contacts.push_back(first.touch);
    }
  }

 private:
  static bool was_before(const NodeContact& x, const NodeContact& y) {
    return std::tuple(x.approach_m_s > 0.0, x.since_entry_s, x.touch.depth_m) >
           std::tuple(y.approach_m_s > 0.0, y.since_entry_s, y.touch.depth_m);
  }

  std::vector<NodeContact> first_;  ///< none or one
};

// The average: mean point, mean normal made unit, greatest depth.
//
// Right where the contacts lie on one surface; of surfaces that face different ways it makes one
// contact that is on neither. (Dingliana 2002, sec. 4.2.2, eq. 4.4 and 4.5)

/// Sums of the reduction `average`.
class MeanContact final : public ContactSums {
 public:
  static constexpr std::int64_t kMost = 1;
  static constexpr unsigned kTerms = 0;

  void begin(const Vector3& fallback) override {
    *this = MeanContact();
    fallback_ = fallback;
  }

  void add(const NodeContact& contact) override { add_touches({&contact.touch, 1}); }

  void add_touches(std::span<const TouchPoint> touches) override {
    for (const TouchPoint& touch : touches) {
      points_ += touch.point;
      normals_ += touch.normal;
      depth_m_ = std::max(depth_m_, touch.depth_m);
    }
    count_ += static_cast<std::int64_t>(touches.size());
  }

  void reduce_to(std::vector<TouchPoint>& contacts) const override {
    if (count_ == 0) {
      return;
    }
    const double length = normals_.norm();
    contacts.push_back({points_ / static_cast<double>(count_),
                        length > 0.0 ? Vector3(normals_ / length) : fallback_, depth_m_});
  }

 private:
  Vector3 fallback_{Vector3::UnitX()};
  Vector3 points_{Vector3::Zero()};
  Vector3 normals_{Vector3::Zero()};
  double depth_m_{0.0};
  std::int64_t count_{0};
};

template <class Sums>
std::shared_ptr<const ContactReduction> by() {
  return std::make_shared<const ReductionBy<Sums>>();
}

const NamedKinds<ContactReduction>& all_reductions() {
  static const NamedKinds<ContactReduction> all("reduction",
                                                {
                                                    {"none", by<EveryContact>()},
                                                    {"first", by<FirstContact>()},
                                                    {"average", by<MeanContact>()},
                                                    {"groups", by<GroupedContacts>()},
                                                    {"density", by<DensityContacts>()},
                                                    {"weighted", by<WeightedContacts>()},
                                                });
  return all;
}

}  // namespace

double time_since_entry_s(double reach_m, double depth_m, double approach_m_s, double speed_m_s) {
  const double way = (reach_m - depth_m) * approach_m_s;
  const double left = std::max(0.0, depth_m * (2.0 * reach_m - depth_m));
  const double divisor = way + std::sqrt(way * way + speed_m_s * speed_m_s * left);
  return divisor > 0.0 ? left / divisor : 0.0;
}

std::vector<std::string_view> reduction_names() { return all_reductions().names(); }

std::shared_ptr<const ContactReduction> make_reduction(std::string_view name) {
  return all_reductions().called(name);
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
