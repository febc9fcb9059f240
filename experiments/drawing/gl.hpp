// OpenGL as the painters call it: 3.3 in a window, and in a browser WebGL 2, which lacks little of
// it.
// SPDX-License-Identifier: MIT
#pragma once

#ifdef __EMSCRIPTEN__
#include <GLES3/gl3.h>
#else
#include <epoxy/gl.h>
#endif

namespace impetus::inline drawing {

#ifdef __EMSCRIPTEN__

/// What every shader begins with: the version of the language, and how exact numbers are.
inline constexpr const char* kShaderHead = R"(#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler2DArrayShadow;
)";
inline constexpr GLenum kBackBuffer = GL_BACK;
/// Of the picture that is shown: a page's has no holes through which the page is seen.
inline constexpr GLenum kUsualFormat = GL_RGB8;
inline constexpr GLenum kGreyFormat = GL_R16F;  ///< of one number a pixel, filtered

inline void draw_to(GLenum attachment) { glDrawBuffers(1, &attachment); }

/// Does nothing: what casts a shadow from outside its light's map is left out in a page.
inline void clamp_depths(bool /*on*/) {}

#else

inline constexpr const char* kShaderHead = "#version 330 core\n";
inline constexpr GLenum kBackBuffer = GL_BACK_LEFT;
inline constexpr GLenum kUsualFormat = GL_RGBA8;
inline constexpr GLenum kGreyFormat = GL_R16;

inline void draw_to(GLenum attachment) { glDrawBuffer(attachment); }

/// Whether depths beyond the picture's are kept at its ends, in place of being left out.
inline void clamp_depths(bool on) { on ? glEnable(GL_DEPTH_CLAMP) : glDisable(GL_DEPTH_CLAMP); }

#endif

}  // namespace impetus::inline drawing
