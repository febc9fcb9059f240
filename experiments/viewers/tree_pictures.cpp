// SPDX-License-Identifier: MIT
#include "experiments/viewers/tree_pictures.hpp"

#include "experiments/drawing/tree_painter.hpp"
#include "experiments/window/gl_window.hpp"
#include "experiments/window/readable_target.hpp"

namespace impetus::inline viewers {
namespace {

constexpr float kWhite = 1.0F;

}  // namespace

std::vector<Pixels> pictures_of(const ShownTree& shown, const std::vector<TreeLook>& looks,
                                const PictureSize& size) {
  const GlWindow window(unseen_window({64, 64}));
  TreePainter painter(shown);
  MultisampledTarget drawn;
  const ReadableTarget averaged(size);
  std::vector<Pixels> pictures;
  for (const TreeLook& look : looks) {
    drawn.begin(size.width_px, size.height_px);
    painter.paint_here(look, Orbit(), size.width_px, size.height_px, kWhite);
    drawn.end_onto({0, 0, size.width_px, size.height_px}, averaged.framebuffer());
    pictures.push_back(averaged.read());
  }
  return pictures;
}

}  // namespace impetus::inline viewers
