// SPDX-License-Identifier: MIT
#include "engine/figures/figures.hpp"

#include <algorithm>

#include "engine/figures/as_one_body.hpp"
#include "engine/numerics/at.hpp"

namespace impetus::inline figures {
namespace {

std::size_t begin_of(const Figure& figure) { return at(figure.first_part); }
std::size_t end_of(const Figure& figure) { return at(figure.first_part + figure.part_count); }

/// All its parts when one is out; returns whether they are.
bool take_out_as_a_whole(const Figure& figure, FiniteStates& finite,
                         std::vector<BodyState>& states) {
  bool any_out = false;
  for (std::size_t part = begin_of(figure); part < end_of(figure); ++part) {
    any_out = any_out || finite.is_out(part);
  }
  for (std::size_t part = begin_of(figure); any_out && part < end_of(figure); ++part) {
    finite.take_out(part, states[part]);
  }
  return any_out;
}

}  // namespace

Figures::Figures(const std::vector<Figure>& figures, const std::vector<BodyModel>& models) {
  figure_of_.assign(models.size(), -1);
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const Figure& figure = figures[i];
    motions_.emplace_back(figure, models);
    std::fill_n(figure_of_.begin() + figure.first_part, figure.part_count,
                static_cast<std::int32_t>(i));
    std::vector<double>& openings = rest_openings_.emplace_back();
    for (const Hinge& hinge : figure.hinges) {
      openings.push_back(opening_at_rest(hinge));
    }
  }
}

void Figures::begin(const std::vector<Figure>& figures, std::vector<BodyState>& states) {
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    if (!figures[i].driven) {
      motions_[i].stop_across_hinges(
          std::span(states).subspan(begin_of(figures[i]), at(figures[i].part_count)));
    }
  }
}

bool Figures::advance(const std::vector<Figure>& figures, const std::vector<BodyModel>& models,
                      const FigureStep& step, PhaseWork& work, FiniteStates& finite,
                      std::vector<NotFiniteBody>& not_finite, std::vector<BodyState>& states) {
  time_s_ += step.dt_s;
  bool arrived = true;
  const std::size_t first = step.may_go_as_one_body ? next_ : 0;
  for (std::size_t turn = 0; turn < figures.size(); ++turn) {
    const std::size_t i = (first + turn) % figures.size();
    const Figure& figure = figures[i];
    if (take_out_as_a_whole(figure, finite, states)) {
      continue;
    }
    if (figure.driven) {
      driven_.drive(figure, models, time_s_, step.dt_s, states);
    } else {
      const bool was_refused = work.refused();
      arrived &= motions_[i].advance(figure, models, step, work, states);
      next_ = work.refused() && !was_refused ? i : next_;
    }
    for (std::size_t part = begin_of(figure); part < end_of(figure); ++part) {
      finite.check(part, states[part], not_finite);
    }
    take_out_as_a_whole(figure, finite, states);
  }
  return arrived;
}

void Figures::move_back_inside(const std::vector<Figure>& figures,
                               const std::vector<BodyModel>& models, const Enclosure& enclosure,
                               const Vector3& gravity_m_s2, const FiniteStates& finite,
                               std::vector<BodyState>& states) const {
  for (const Figure& figure : figures) {
    if (!figure.driven && !is_out(figure, finite)) {
      const std::size_t first = begin_of(figure);
      const std::size_t count = at(figure.part_count);
      figures::move_back_inside(enclosure, gravity_m_s2, std::span(models).subspan(first, count),
                                std::span(states).subspan(first, count));
    }
  }
}

bool Figures::may_meet(const std::vector<Figure>& figures, BodyPair bodies) const {
  if (is_wall(bodies.b) || figure_of_[at(bodies.a)] < 0 ||
      figure_of_[at(bodies.a)] != figure_of_[at(bodies.b)]) {
    return true;
  }
  const Figure& figure = figures[at(figure_of_[at(bodies.a)])];
  return figure.self_collision.others && hinge_between(figure, bodies) == nullptr;
}

void Figures::find_folds(const std::vector<Figure>& figures, const FiniteStates& finite,
                         const std::vector<BodyState>& states) {
  folds_.clear();
  for (std::size_t i = 0; i < figures.size(); ++i) {
    if (figures[i].self_collision.neighbours && !is_out(figures[i], finite)) {
      add_folds(figures[i], rest_openings_[i], states, folds_);
    }
  }
}

const ResponseResult& Figures::respond(const std::vector<Figure>& figures,
                                       const std::vector<Contact>& contacts,
                                       const std::vector<double>& restitutions,
                                       const ResponseRules& rules, double dt_s,
                                       const std::vector<BodyModel>& models,
                                       const FiniteStates& finite, std::vector<BodyState>& states) {
  stops_.clear();
  for (std::size_t i = 0; i < figures.size(); ++i) {
    if (!figures[i].driven && !is_out(figures[i], finite)) {
      add_stops(figures, i, states, dt_s, stops_);
    }
  }
  return responder_.respond(contacts, stops_, restitutions, rules, models,
                            {figures, motions_, figure_of_}, states);
}

}  // namespace impetus::inline figures
