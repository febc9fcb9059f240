// SPDX-License-Identifier: MIT
#include "experiments/drawing/shader_program.hpp"

#include <epoxy/gl.h>

#include <stdexcept>
#include <string>

namespace impetus::inline drawing {
namespace {

unsigned compiled(GLenum kind, std::initializer_list<const char*> parts) {
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

unsigned link_program(std::initializer_list<const char*> vertex,
                      std::initializer_list<const char*> fragment) {
  const unsigned program = glCreateProgram();
  for (const unsigned shader :
       {compiled(GL_VERTEX_SHADER, vertex), compiled(GL_FRAGMENT_SHADER, fragment)}) {
    glAttachShader(program, shader);
    glDeleteShader(shader);
  }
  glLinkProgram(program);
  int good = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &good);
  if (good == 0) {
    char log[500] = "";
    glGetProgramInfoLog(program, sizeof log, nullptr, log);
    throw std::runtime_error(std::string("the driver refused to link shaders: ") + log);
  }
  return program;
}

}  // namespace impetus::inline drawing
