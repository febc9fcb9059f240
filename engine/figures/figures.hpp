// The figures of a world, from step to step: they are moved, asked whose parts may meet, asked
// which hinges are folded, and pushed.
//
// A world without figures has none of this.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/dynamics/finite_states.hpp"
#include "engine/figures/hinged_responder.hpp"

namespace impetus::inline figures {

/// What is kept of the figures between steps.
class Figures {
 public:
  /// `figures` and `models` are without a problem (problem_of), and are those of every call below.
  Figures(const std::vector<Figure>& figures, const std::vector<BodyModel>& models);

  /// Whether the body is a part of a figure.
  [[nodiscard]] bool has_part(std::size_t body) const { return figure_of_[body] >= 0; }
  [[nodiscard]] bool has_part(BodyPair bodies) const {
    return has_part(static_cast<std::size_t>(bodies.a)) ||
           (!is_wall(bodies.b) && has_part(static_cast<std::size_t>(bodies.b)));
  }

  /// What leaves all parts of free figures with nothing moving across a hinge: for states that
  /// somebody made.
  void begin(const std::vector<Figure>& figures, std::vector<BodyState>& states);

  /// Moves all parts through a step, as far as `work` is granted: those first that came short in
  /// the step before. A figure of which a part is out is out itself. Returns whether all got where
  /// their own motion takes them.
  bool advance(const std::vector<Figure>& figures, const std::vector<BodyModel>& models,
               const FigureStep& step, PhaseWork& work, FiniteStates& finite,
               std::vector<NotFiniteBody>& not_finite, std::vector<BodyState>& states);

  /// Moves back, as wholes, those of which a centre is beyond a wall (move_back_inside()).
  void move_back_inside(const std::vector<Figure>& figures, const std::vector<BodyModel>& models,
                        const Enclosure& enclosure, const Vector3& gravity_m_s2,
                        const FiniteStates& finite, std::vector<BodyState>& states) const;

  /// Whether the bounds of two bodies are worth a look: not of neighbours, nor of parts of a figure
  /// that does not collide with itself.
  [[nodiscard]] bool may_meet(const std::vector<Figure>& figures, BodyPair bodies) const;

  /// Looks for neighbours that are folded past their threshold.
  void find_folds(const std::vector<Figure>& figures, const FiniteStates& finite,
                  const std::vector<BodyState>& states);

  /// A contact for each pair of neighbours that was found (add_folds()).
  [[nodiscard]] const std::vector<Contact>& folds() const { return folds_; }

  /// As HingedResponder::respond(), with the limits of all hinges.
  const ResponseResult& respond(const std::vector<Figure>& figures,
                                const std::vector<Contact>& contacts,
                                const std::vector<double>& restitutions, const ResponseRules& rules,
                                double dt_s, const std::vector<BodyModel>& models,
                                const FiniteStates& finite, std::vector<BodyState>& states);

 private:
  [[nodiscard]] bool is_out(const Figure& figure, const FiniteStates& finite) const {
    return finite.is_out(static_cast<std::size_t>(figure.first_part));
  }

  double time_s_{0.0};
  std::size_t next_{0};  ///< the figure that asks for work first
  std::vector<FigureMotion> motions_;
  DrivenMotion driven_;
  std::vector<std::int32_t> figure_of_;             ///< by body; −1: none
  std::vector<std::vector<double>> rest_openings_;  ///< by figure and hinge
  std::vector<Contact> folds_;
  std::vector<HingeStop> stops_;
  HingedResponder responder_;
};

}  // namespace impetus::inline figures
