// The impulses that keep a figure's hinges together, whatever is done to its parts.
//
//   M u = f + Jᵀ λ,  J u = b      u: change of the parts' velocities, f: impulses on the parts,
//                                 λ: impulses of the hinges, five for each, b: asked change of the
//                                 velocities across the hinges
//
// Solved exactly, in time proportional to the parts: from the leaves to the root, each part as
// heavy as what hangs from it makes it, then back. (Featherstone 1983; Baraff 1996)
//
// A hinge pushes its two parts by opposite impulses at one point, so momentum is kept to rounding.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "engine/figures/figure.hpp"
#include "engine/numerics/vector.hpp"

namespace impetus::inline figures {

/// The Cholesky factor of a small symmetric positive definite matrix, in an order of sums of its
/// own: the same bits with whatever version of the matrix library.
template <int N>
class SmallCholesky {
 public:
  using Matrix = Eigen::Matrix<double, N, N>;
  using Vector = Eigen::Matrix<double, N, 1>;

  /// Precondition: `matrix` is symmetric and positive definite; its lower half is read.
  void factor(const Matrix& matrix) {
    for (int row = 0; row < N; ++row) {
      for (int column = 0; column <= row; ++column) {
        double rest = matrix(row, column);
        for (int k = 0; k < column; ++k) {
          rest -= lower_(row, k) * lower_(column, k);
        }
        if (column < row) {
          lower_(row, column) = rest * inverse_diagonal_(column);
        } else {
          lower_(row, row) = std::sqrt(rest);
          inverse_diagonal_(row) = 1.0 / lower_(row, row);
        }
      }
    }
  }

  /// x of `matrix` x = b.
  [[nodiscard]] Vector solve(Vector b) const {
    for (int row = 0; row < N; ++row) {
      for (int k = 0; k < row; ++k) {
        b(row) -= lower_(row, k) * b(k);
      }
      b(row) *= inverse_diagonal_(row);
    }
    for (int row = N; row-- > 0;) {
      for (int k = row + 1; k < N; ++k) {
        b(row) -= lower_(k, row) * b(k);
      }
      b(row) *= inverse_diagonal_(row);
    }
    return b;
  }

 private:
  Matrix lower_{Matrix::Zero()};
  Vector inverse_diagonal_{Vector::Zero()};
};

using Vector5 = Eigen::Matrix<double, 5, 1>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// An impulse on a part, or its momentum: linear (N s), angular about its centre of mass (N m s).
struct PartImpulse {
  Vector3 linear{Vector3::Zero()};
  Vector3 angular{Vector3::Zero()};
};

/// The parts of a figure as they stand in the world, by number, root first.
class HingeSolver {
 public:
  HingeSolver(const Figure& figure, const std::vector<BodyModel>& models);

  /// Takes the poses of the parts. Does nothing when they are those of the last time.
  void look_at(std::span<const BodyState> parts);

  /// Adds the impulses of the hinges to `impulses`, one for each part, such that nothing changes in
  /// the velocities across hinges.
  void add_hinge_impulses(std::vector<PartImpulse>& impulses);

  /// The impulses of the hinges that change the velocities across them by `asked`, where nothing
  /// else pushes: the anchor of the child against that of the parent in world (m/s, N s), then its
  /// turn about the two directions across the axis (rad/s, N m s).
  void find_hinge_impulses(std::span<const Vector5> asked, std::vector<Vector5>& of_hinges);

  /// Adds to `impulses` what hinges with these impulses do to the parts.
  void add_impulses_of(std::span<const Vector5> of_hinges,
                       std::vector<PartImpulse>& impulses) const;

  /// How fast the parts move across a hinge, in the same terms.
  [[nodiscard]] Vector5 speed_across(std::size_t hinge, std::span<const BodyState> parts) const;

  /// Whether nothing moves across any hinge by more than this share of how fast its sides move.
  [[nodiscard]] bool nothing_moves_across(double share, std::span<const BodyState> parts) const;

  /// Adds the impulses to the momenta of the parts that can move.
  void push_parts(std::span<const PartImpulse> impulses, std::span<BodyState> parts) const;

 private:
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  using Matrix56 = Eigen::Matrix<double, 5, 6>;

  /// A part as it stands, and as heavy as what hangs from it makes it.
  struct Part {
    double inverse_mass{0.0};
    Matrix3 own_inertia{Matrix3::Zero()};      ///< body frame
    Matrix3 inverse_inertia{Matrix3::Zero()};  ///< in world
    Pose pose;
    Matrix6 inertia{Matrix6::Zero()};  ///< with what hangs from it
    SmallCholesky<6> factor;
    Vector6 impulse;
    Vector6 change;
  };
  /// Of the part after it in number, to its parent.
  struct Joint {
    std::size_t parent{0};
    Matrix56 of_child;           ///< rows of J
    Matrix56 of_parent;          ///< with its sign
    Matrix56 child_response;     ///< J_c M̂⁻¹
    Matrix56 parent_share;       ///< S⁻¹ J_p
    SmallCholesky<5> stiffness;  ///< S = J_c M̂⁻¹ J_cᵀ
    Vector5 impulse;
  };

  void place(std::span<const BodyState> parts);
  void factor();
  void solve(std::span<const Vector5> asked);
  /// Linear (m/s), angular (rad/s).
  [[nodiscard]] Vector6 velocity_of(std::size_t part, std::span<const BodyState> parts) const;
  void add_impulse_of(std::size_t hinge, const Vector5& impulse,
                      std::vector<PartImpulse>& impulses) const;

  std::vector<HingeSide> child_sides_;
  std::vector<HingeSide> parent_sides_;
  std::vector<Part> parts_;
  std::vector<Joint> joints_;
  std::vector<Vector5> nothing_;
  bool is_placed_{false};
  bool is_factored_{false};
};

}  // namespace impetus::inline figures
