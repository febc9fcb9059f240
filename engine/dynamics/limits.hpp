// How far the engine's promises reach: beyond these numbers something else limits what it can do.
//
// Within them every case of `impetus extremes` keeps its promise; README.md says what gives way
// beyond each. Scenes beyond them are refused when they are read. A world that is made by hand is
// refused only what it cannot step at all.
// SPDX-License-Identifier: MIT
#pragma once

namespace impetus::inline dynamics {

/// Any measure of a body: a radius, an edge, a thickness.
inline constexpr double kLeastSize_m = 1e-6;
inline constexpr double kMostSize_m = 1e6;

/// Of a body's centre from the origin, where doubles are 15 nm apart.
inline constexpr double kMostDistance_m = 1e8;

inline constexpr double kMostSpeed_m_s = 1e6;
inline constexpr double kMostSpin_rad_s = 1e4;

/// Of the heaviest body that can move to the lightest.
inline constexpr double kMostMassRatio = 1e12;

/// Of a body's greatest principal moment to its least: 1e6 is a needle a thousand times as long as
/// it is thick.
inline constexpr double kMostInertiaRatio = 1e7;

inline constexpr double kLeastStep_s = 1e-6;
inline constexpr double kMostStep_s = 0.1;

/// A place or momentum beyond this (in SI units) counts as not finite: squares of what is below it
/// are still numbers.
inline constexpr double kMostNumber = 1e100;

}  // namespace impetus::inline dynamics
