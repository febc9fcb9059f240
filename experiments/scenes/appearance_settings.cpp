// SPDX-License-Identifier: MIT
#include "experiments/scenes/appearance_settings.hpp"

#include <cstdlib>

namespace impetus::inline scenes {
namespace {

using nlohmann::json;

Colour parse_colour(const json& text) {
  const auto number = static_cast<unsigned>(
      std::strtoul(text.get_ref<const std::string&>().c_str() + 1, nullptr, 16));
  const auto channel = [number](unsigned shift) {
    return static_cast<float>((number >> shift) & 0xffU) / 255.0F;
  };
  return {channel(16), channel(8), channel(0)};
}

Kind<LightSettings> light_kind() {
  using L = LightSettings;
  return object<L>(
      "", {required("azimuth_deg", &L::azimuth_deg, number({-180, 180}),
                    "0: from the side of the viewer at azimuth 0; 90: from the right."),
           required("elevation_deg", &L::elevation_deg, number({0, 90}),
                    "0: from the horizon; 90: from straight above."),
           row("strength", &L::strength, number({0, 4}),
               "1, when left out: as bright as the light of a scene that names none; 0: it is "
               "off.")});
}

}  // namespace

Kind<Colour> colour_kind() {
  return defined("colour", Kind<Colour>{described("sRGB, #rrggbb", text_like("^#[0-9a-fA-F]{6}$")),
                                        parse_colour});
}

Kind<SurfaceTexture> texture_kind() {
  return defined("texture", choice<SurfaceTexture>({{"none", SurfaceTexture::kNone},
                                                    {"wood", SurfaceTexture::kWood},
                                                    {"marble", SurfaceTexture::kMarble},
                                                    {"speckles", SurfaceTexture::kSpeckles}}));
}

Kind<AppearanceSettings> appearance_kind() {
  using A = AppearanceSettings;
  return object<A>(
      "How the scene is painted: no step of the world looks at it. Left out, and where all is as "
      "it is when left out, bodies are lit by one light and cast no shadows.",
      {row("ground", &A::ground,
           choice<GroundPattern>({{"none", GroundPattern::kNone},
                                  {"plain", GroundPattern::kPlain},
                                  {"checks", GroundPattern::kChecks}}),
           "A level ground that is seen, but that nothing rests on; none when left out. Beside an "
           "enclosure only none: a cube's floor is its ground. A viewer's elevation_deg shows it."),
       row("ground_deg", &A::ground_deg, number({-90, 90}),
           "How high the ground lies. Left out: the lowest body touches it at the start."),
       row("ground_colour", &A::ground_colour, colour_kind()),
       row("check_deg", &A::check_deg, number({0.1, 45}),
           "Of checks: the side of a field; 2 when left out."),
       row("lights", &A::lights, list(light_kind(), {1, static_cast<int>(kMostLights)}),
           "Distant lights, fixed to the world, in place of one from the viewer's upper left."),
       row("cast_shadows", &A::cast_shadows, number({0, 1}),
           "The share of a light that a body takes from bodies, ground and walls behind it; 0, "
           "when left out: none."),
       row("contact_shadows", &A::contact_shadows, number({0, 1}),
           "The share of all light that a body takes from the ground, or a cube's floor, where it "
           "touches it: the nearer, the more; 0, when left out: none."),
       row("texture", &A::texture, texture_kind(),
           "What surfaces show beside the bodies' colours; none when left out."),
       row("gloss", &A::gloss, number({0, 1}),
           "The share of a light that surfaces mirror: 0 is matt, 0.1 when left out."),
       row("smooth_below_deg", &A::smooth_below_deg, number({0, 180}),
           "Faces that meet at a smaller angle are shaded as one round surface; 30 when left out, "
           "0 shades each face by itself."),
       row("colours", &A::colours,
           choice<ColourRule>({{"given", ColourRule::kGiven}, {"apart", ColourRule::kApart}}),
           "given, when left out: as bodies and crowds say. apart: of the scene's colours (six at "
           "least, others are added) each body takes the one whose nearest bearer at the start is "
           "farthest, so that none are alike side by side; parts of named figures keep theirs.")});
}

}  // namespace impetus::inline scenes
