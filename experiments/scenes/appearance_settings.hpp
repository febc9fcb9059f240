// What a scene says of its looks ("/appearance"), as structs: ground, lights, shadows, surfaces.
//
// Each member is a row of appearance_settings.cpp (see settings/setting_rows.hpp). A scene that
// says nothing, or only what is so by itself, is painted plainly, pixel by pixel as ever.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "experiments/record/appearance.hpp"
#include "experiments/settings/setting_rows.hpp"

namespace impetus::inline scenes {

/// A light, and where it is seen from the world's origin.
struct LightSettings {
  double azimuth_deg{0.0};
  double elevation_deg{0.0};
  double strength{1.0};
};

/// Whether bodies have the colours that the scene gives them, or each the one of these whose
/// nearest bearer is farthest from it.
enum class ColourRule { kGiven, kApart };

/// How the scene looks beyond shapes and colours.
struct AppearanceSettings {
  GroundPattern ground{GroundPattern::kNone};
  std::optional<double> ground_deg;
  Colour ground_colour{0.62F, 0.62F, 0.60F};
  double check_deg{2.0};
  std::optional<std::vector<LightSettings>> lights;
  double cast_shadows{0.0};
  double contact_shadows{0.0};
  SurfaceTexture texture{SurfaceTexture::kNone};
  double gloss{kUsualGloss};
  double smooth_below_deg{kUsualSmoothing_deg};
  ColourRule colours{ColourRule::kGiven};
};

/// The rows of "/appearance".
Kind<AppearanceSettings> appearance_kind();

/// "#d9813b"
Kind<Colour> colour_kind();

Kind<SurfaceTexture> texture_kind();

}  // namespace impetus::inline scenes
