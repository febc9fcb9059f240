// Rings of round section as closed triangle meshes: the torus, whose axis is z, and the trefoil
// knot.
//
//   ring i     j --- j+1        Both are rings one after the other, the last joined to the first.
//              |  \   |         Corners run counter-clockwise as seen from ahead, the way in which
//   ring i+1   j --- j+1        the rings follow one another.
//
// The knot's curve runs twice round the axis z while it runs three times round the tube of a torus
// R, r:
//
//   p(t) = ((R + r cos 3t) cos 2t, (R + r cos 3t) sin 2t, r sin 3t),  r = 0.45 R
//
// The torus' own normal is across the curve everywhere and closes with it, so the frame along the
// curve closes exactly. It makes −2.58 turns about the curve; three whole turns the other way leave
// less than half a turn, spread evenly.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline shapes {

/// 2 · segments · sides outward triangles about the origin: `segments` sections along the circle of
/// `radius_m`, each a regular polygon of `sides` corners on the circle of `tube_m`. Preconditions:
/// 0 < tube_m < radius_m; segments, sides ≥ 3.
TriangleMesh torus_mesh(double radius_m, double tube_m, int segments, int sides);

/// The greatest tube_m / radius_m. A round tube of 0.308 touches itself; the rest is for facets.
inline constexpr double kThickestKnot = 0.25;

/// 2 · segments · sides outward triangles about the origin: sections of `tube_m` along a curve that
/// reaches `radius_m` = R + r from the axis. Preconditions: 0 < tube_m ≤ kThickestKnot · radius_m;
/// segments ≥ 32, sides ≥ 3.
TriangleMesh knot_mesh(double radius_m, double tube_m, int segments, int sides);

}  // namespace impetus::inline shapes
