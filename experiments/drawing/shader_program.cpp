// SPDX-License-Identifier: MIT
#include "experiments/drawing/shader_program.hpp"

#include <epoxy/gl.h>

#include <array>
#include <stdexcept>
#include <string>

namespace impetus::inline drawing {
namespace {

/// OpenGL's functions that make and remove what GlName::Kind lists, in its order. The library finds
/// them at their first call, so they are variables.
struct Calls {
  PFNGLGENBUFFERSPROC* make;
  PFNGLDELETEBUFFERSPROC* remove;
};
constexpr std::array<Calls, 4> kCalls{{{&glGenBuffers, &glDeleteBuffers},
                                       {&glGenVertexArrays, &glDeleteVertexArrays},
                                       {&glGenFramebuffers, &glDeleteFramebuffers},
                                       {&glGenRenderbuffers, &glDeleteRenderbuffers}}};

unsigned compiled_shader(GLenum kind, std::initializer_list<const char*> parts) {
  const unsigned shader = glCreateShader(kind);
  glShaderSource(shader, static_cast<GLsizei>(parts.size()), parts.begin(), nullptr);
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

}  // namespace

GlName::GlName(Kind kind) : kind_(kind) {
  (*kCalls[static_cast<std::size_t>(kind)].make)(1, &name_);
}
GlName::~GlName() { (*kCalls[static_cast<std::size_t>(kind_)].remove)(1, &name_); }

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

}  // namespace impetus::inline drawing
