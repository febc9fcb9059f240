// Where to cut a part of the surface in two so that the volumes round the halves fit best.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include "engine/trees/builders/volume_fits.hpp"

namespace impetus::inline trees {

/// Fits a volume to the part that `shape` is of.
using QuickFit = std::function<Fit(const PartShape& shape)>;

/// Of planes across the axes of `frame` - at five places along each, and in the largest facets that
/// lie across it, and in its own largest facets - the one that leaves the least sum over both
/// halves of area × (reach + 0.3 extent)², measured on at most 600 facets of the part. None when no
/// plane leaves surface on both sides.
std::optional<HalfSpace> best_halving(const SurfacePart& part, const PartShape& shape,
                                      const Matrix3& frame, double size_m, const QuickFit& fit);

/// Of cuts made by builders: what lies nearer to a plane than this share of the size lies in it.
inline constexpr double kSnapShare = 1e-13;

}  // namespace impetus::inline trees
