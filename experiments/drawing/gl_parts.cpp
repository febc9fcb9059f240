// SPDX-License-Identifier: MIT
#include "experiments/drawing/gl_parts.hpp"

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/drawing/gl.hpp"

namespace impetus::inline drawing {
namespace {

/// OpenGL's functions that make and remove what GlName::Kind lists, in its order. The library finds
/// them at their first call, so they are looked up in a function each.
struct Calls {
  void (*make)(unsigned* name);
  void (*remove)(unsigned* name);
};
constexpr std::array<Calls, 5> kCalls{{{[](unsigned* name) { glGenBuffers(1, name); },
                                        [](unsigned* name) { glDeleteBuffers(1, name); }},
                                       {[](unsigned* name) { glGenVertexArrays(1, name); },
                                        [](unsigned* name) { glDeleteVertexArrays(1, name); }},
                                       {[](unsigned* name) { glGenFramebuffers(1, name); },
                                        [](unsigned* name) { glDeleteFramebuffers(1, name); }},
                                       {[](unsigned* name) { glGenRenderbuffers(1, name); },
                                        [](unsigned* name) { glDeleteRenderbuffers(1, name); }},
                                       {[](unsigned* name) { glGenTextures(1, name); },
                                        [](unsigned* name) { glDeleteTextures(1, name); }}}};

unsigned compiled_shader(GLenum kind, std::initializer_list<const char*> parts) {
  const unsigned shader = glCreateShader(kind);
  std::vector<const char*> whole{kShaderHead};
  whole.insert(whole.end(), parts.begin(), parts.end());
  glShaderSource(shader, static_cast<GLsizei>(whole.size()), whole.data(), nullptr);
  glCompileShader(shader);
  int good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good == 0) {
    char log[500] = "";
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    throw std::runtime_error(std::string("the driver refused a shader: ") + log);
  }
  return shader;
}

constexpr int kSamples = 4;  // every OpenGL 3.3 has them
constexpr int kUsualBits = 8;

// Drivers may refuse to average into another format than the picture's own.
GLenum format_of_window() {
  int red_bits = 0;
  glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, kBackBuffer,
                                        GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE, &red_bits);
  return red_bits > kUsualBits ? GL_RGB10_A2 : kUsualFormat;
}

void reserve(unsigned buffer, GLenum format, int width, int height) {
  glBindRenderbuffer(GL_RENDERBUFFER, buffer);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, kSamples, format, width, height);
}

}  // namespace

GlName::GlName(Kind kind) : kind_(kind) { kCalls[static_cast<std::size_t>(kind)].make(&name_); }
GlName::~GlName() { kCalls[static_cast<std::size_t>(kind_)].remove(&name_); }

ShaderProgram::ShaderProgram(std::initializer_list<const char*> vertex,
                             std::initializer_list<const char*> fragment)
    : name_(glCreateProgram()) {
  for (const unsigned shader :
       {compiled_shader(GL_VERTEX_SHADER, vertex), compiled_shader(GL_FRAGMENT_SHADER, fragment)}) {
    glAttachShader(name_, shader);
    glDeleteShader(shader);
  }
  glLinkProgram(name_);
  int good = 0;
  glGetProgramiv(name_, GL_LINK_STATUS, &good);
  if (good == 0) {
    char log[500] = "";
    glGetProgramInfoLog(name_, sizeof log, nullptr, log);
    throw std::runtime_error(std::string("the driver refused to link shaders: ") + log);
  }
}

ShaderProgram::~ShaderProgram() { glDeleteProgram(name_); }

void ShaderProgram::use(const Viewer& viewer) const {
  const ScreenGeometry& screen = viewer.screen;
  glUseProgram(name_);
  glUniform3f(uniform("glass"), static_cast<float>(screen.width_m),
              static_cast<float>(screen.height_m), static_cast<float>(screen.viewing_distance_m));
}

int ShaderProgram::uniform(const char* name) const { return glGetUniformLocation(name_, name); }

void describe_records(RecordOf what, std::size_t record_bytes,
                      std::initializer_list<VertexField> fields) {
  for (const VertexField& field : fields) {
    glEnableVertexAttribArray(field.place);
    glVertexAttribPointer(field.place, field.numbers, GL_FLOAT, GL_FALSE,
                          static_cast<GLsizei>(record_bytes),
                          reinterpret_cast<const void*>(field.offset));
    glVertexAttribDivisor(field.place, what == RecordOf::kInstance ? 1 : 0);
  }
}

void fill_buffer(unsigned kind, unsigned buffer, const void* bytes, std::size_t count,
                 unsigned usage) {
  glBindBuffer(kind, buffer);
  glBufferData(kind, static_cast<GLsizeiptr>(count), bytes, usage);
}

void MultisampledTarget::allocate(int width, int height) {
  reserve(colour_, format_of_window(), width, height);
  reserve(depth_, GL_DEPTH_COMPONENT24, width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
  const bool complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  if (!complete) {
    throw std::runtime_error("the driver refused a picture with four samples per pixel");
  }
  width_ = width;
  height_ = height;
}

void MultisampledTarget::begin(int width, int height) {
  if (width != width_ || height != height_) {
    allocate(width, height);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
}

void MultisampledTarget::end_onto(const PixelArea& area, unsigned framebuffer) {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  glBlitFramebuffer(0, 0, width_, height_, area.left, area.bottom, area.left + area.width,
                    area.bottom + area.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace impetus::inline drawing
