// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
// glcorearb.h would collide with gl.h, which osmesa.h includes.
#include <GL/glext.h>

#include "peers.h"

namespace shd::bench {
namespace {

[[noreturn]] void die(const char* what, const char* detail = "") {
  std::fprintf(stderr, "llvmpipe: %s %s\n", what, detail);
  std::exit(1);
}

/// Makes the single off-screen context current. LP_NUM_THREADS=0 makes llvmpipe rasterise in the calling thread; 1
/// would create one worker, while the caller would still run the vertex stage.
void make_current() {
  static std::vector<uint8_t> screen(16 * 16 * 4);
  static OSMesaContext context = nullptr;
  if (context) return;
  setenv("LP_NUM_THREADS", "0", 1);
  setenv("GALLIUM_DRIVER", "llvmpipe", 1);
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_DEPTH_BITS,
                            24,
                            OSMESA_PROFILE,
                            OSMESA_CORE_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            3,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            3,
                            0};
  context = OSMesaCreateContextAttribs(attributes, nullptr);
  if (!context || !OSMesaMakeCurrent(context, screen.data(), GL_UNSIGNED_BYTE, 16, 16)) die("no context");
}

GLuint compile(GLenum kind, const char* source) {
  const GLuint shader = glCreateShader(kind);
  GLint ok = 0;
  char log[1024] = "";
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  glGetShaderInfoLog(shader, sizeof log, nullptr, log);
  if (!ok) die("shader:", log);
  return shader;
}

GLuint link(const char* vertex, const char* fragment) {
  const GLuint program = glCreateProgram();
  GLint ok = 0;
  char log[1024] = "";
  glAttachShader(program, compile(GL_VERTEX_SHADER, vertex));
  glAttachShader(program, compile(GL_FRAGMENT_SHADER, fragment));
  glLinkProgram(program);
  glGetProgramiv(program, GL_LINK_STATUS, &ok);
  glGetProgramInfoLog(program, sizeof log, nullptr, log);
  if (!ok) die("program:", log);
  return program;
}

GLint minification(PeerFilter filter) {
  switch (filter) {
    case PeerFilter::kNearest: return GL_NEAREST;
    case PeerFilter::kBilinear: return GL_LINEAR;
    case PeerFilter::kNearestMip: return GL_NEAREST_MIPMAP_NEAREST;
    case PeerFilter::kBilinearMip: return GL_LINEAR_MIPMAP_NEAREST;
    default: return GL_LINEAR_MIPMAP_LINEAR;
  }
}

GLuint make_texture(uint32_t edge, const std::vector<uint8_t>& texels, PeerFilter filter) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  size_t offset = 0;
  for (uint32_t level = 0, size = edge; offset < texels.size(); ++level, size = std::max(size / 2, 1u)) {
    glTexImage2D(GL_TEXTURE_2D, static_cast<GLint>(level), GL_RGBA8, static_cast<GLsizei>(size),
                 static_cast<GLsizei>(size), 0, GL_RGBA, GL_UNSIGNED_BYTE, &texels[offset]);
    offset += size_t{size} * size * 4;
  }
  if (!has_levels(edge, texels)) glGenerateMipmap(GL_TEXTURE_2D);
  const bool nearest = filter == PeerFilter::kNearest || filter == PeerFilter::kNearestMip;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minification(filter));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, nearest ? GL_NEAREST : GL_LINEAR);
  if (filter == PeerFilter::kAnisotropic16) glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 16.0f);
  if (glGetError() != GL_NO_ERROR) die("texture parameters");
  return texture;
}

GLuint make_buffer(GLenum target, const void* data, size_t size) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(target, buffer);
  glBufferData(target, static_cast<GLsizeiptr>(size), data, GL_STATIC_DRAW);
  return buffer;
}

/// Framebuffer, vertex array and texture of one pass.
class Pass : public Peer {
 public:
  Pass(uint32_t frame, uint32_t edge, const std::vector<uint8_t>& texels, PeerFilter filter)
      : frame_(static_cast<GLsizei>(frame)) {
    make_current();
    glGenFramebuffers(1, &framebuffer_);
    glGenRenderbuffers(2, planes_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glBindRenderbuffer(GL_RENDERBUFFER, planes_[0]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, frame_, frame_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, planes_[0]);
    glBindRenderbuffer(GL_RENDERBUFFER, planes_[1]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, frame_, frame_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, planes_[1]);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) die("incomplete framebuffer");
    glGenVertexArrays(1, &vertex_array_);
    glBindVertexArray(vertex_array_);
    texture_ = make_texture(edge, texels, filter);
  }
  ~Pass() override {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(2, planes_);
    glDeleteVertexArrays(1, &vertex_array_);
    glDeleteTextures(1, &texture_);
    glDeleteProgram(program_);
  }
  Pass(const Pass&) = delete;
  Pass& operator=(const Pass&) = delete;

  std::vector<float> image() override {
    const size_t edge = static_cast<size_t>(frame_), row = edge * 4;
    std::vector<float> upside_down(edge * row), result(edge * row);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glReadPixels(0, 0, frame_, frame_, GL_RGBA, GL_FLOAT, upside_down.data());
    for (size_t y = 0; y < edge; ++y) std::copy_n(&upside_down[(edge - 1 - y) * row], row, &result[y * row]);
    return result;
  }

 protected:
  void begin() {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, frame_, frame_);
    glBindVertexArray(vertex_array_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glUseProgram(program_);
  }

  void attribute(GLuint location, GLint size, const std::vector<float>& values) {
    make_buffer(GL_ARRAY_BUFFER, values.data(), values.size() * sizeof(float));
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, 0, nullptr);
  }

  GLuint program_ = 0;

 private:
  GLsizei frame_ = 0;
  GLuint framebuffer_ = 0, vertex_array_ = 0, texture_ = 0;
  GLuint planes_[2] = {};
};

constexpr char kSurfaceVertex[] = R"(#version 330 core
layout(location = 0) in vec4 position;
layout(location = 1) in vec2 uv;
out vec2 v_uv;
void main() { gl_Position = position; v_uv = uv; }
)";
constexpr char kSurfaceFragment[] = R"(#version 330 core
uniform sampler2D image;
in vec2 v_uv;
out vec4 colour;
void main() { colour = texture(image, v_uv); }
)";

class SurfacePass final : public Pass {
 public:
  SurfacePass(const Surface& surface, uint32_t frame, uint32_t edge, const std::vector<uint8_t>& texels,
              PeerFilter filter)
      : Pass(frame, edge, texels, filter) {
    attribute(0, 4, std::vector<float>(surface.clip[0], surface.clip[0] + 16));
    attribute(1, 2, std::vector<float>(surface.uv[0], surface.uv[0] + 8));
    program_ = link(kSurfaceVertex, kSurfaceFragment);
  }
  void run() override {
    begin();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glFinish();
  }
};

constexpr char kLookupsFragment[] = R"(#version 330 core
uniform sampler2D image, points, steps;
uniform int edge;
in vec2 v_uv;
out vec4 colour;
void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec2 at = ivec2(pixel.x / 2, (2 * edge - 1 - pixel.y) / 2);
  vec4 point = texelFetch(points, at, 0);
  vec2 down = texelFetch(steps, at, 0).xy;
  colour = texture(image, point.xy + float(pixel.x & 1) * point.zw + float(pixel.y & 1) * down);
}
)";

/// A float texture of frame x frame texels at texture unit `unit`.
GLuint make_columns(GLenum unit, uint32_t frame, const std::vector<float>& rgba) {
  GLuint texture = 0;
  const auto edge = static_cast<GLsizei>(frame);
  glGenTextures(1, &texture);
  glActiveTexture(unit);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, edge, edge, 0, GL_RGBA, GL_FLOAT, rgba.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glActiveTexture(GL_TEXTURE0);
  return texture;
}

/// One lookup in 2 x 2 pixels: differences between these pixels are the lookup's derivatives. textureGrad is no
/// alternative, because the anisotropic filter of Mesa 22.3 does not use its arguments.
class LookupsPass final : public Pass {
 public:
  LookupsPass(const Lookups& lookups, uint32_t frame, uint32_t edge, const std::vector<uint8_t>& texels,
              PeerFilter filter)
      : Pass(2 * frame, edge, texels, filter), frame_(frame) {
    const Surface surface = quad_surface(1.0f);
    attribute(0, 4, std::vector<float>(surface.clip[0], surface.clip[0] + 16));
    attribute(1, 2, std::vector<float>(surface.uv[0], surface.uv[0] + 8));
    std::vector<float> points, steps;
    for (size_t i = 0; i < lookups.count(); ++i) {
      points.insert(points.end(), {lookups.u[i], lookups.v[i], lookups.dudx[i], lookups.dvdx[i]});
      steps.insert(steps.end(), {lookups.dudy[i], lookups.dvdy[i], 0.0f, 0.0f});
    }
    columns_[0] = make_columns(GL_TEXTURE1, frame, points);
    columns_[1] = make_columns(GL_TEXTURE2, frame, steps);
    program_ = link(kSurfaceVertex, kLookupsFragment);
    glUseProgram(program_);
    glUniform1i(glGetUniformLocation(program_, "points"), 1);
    glUniform1i(glGetUniformLocation(program_, "steps"), 2);
    glUniform1i(glGetUniformLocation(program_, "edge"), static_cast<GLint>(frame));
  }
  ~LookupsPass() override { glDeleteTextures(2, columns_); }
  uint32_t copies() const override { return 4; }
  void run() override {
    begin();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    for (int i = 0; i < 2; ++i) {
      glActiveTexture(GL_TEXTURE1 + static_cast<GLenum>(i));
      glBindTexture(GL_TEXTURE_2D, columns_[i]);
    }
    glActiveTexture(GL_TEXTURE0);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glFinish();
  }
  std::vector<float> image() override {
    const std::vector<float> quads = Pass::image();
    std::vector<float> rgba;
    for (size_t i = 0; i < size_t{frame_} * frame_; ++i) {
      // The pixel at the point itself is the lower left one.
      const float* pixel = &quads[((2 * (i / frame_) + 1) * 2 * frame_ + 2 * (i % frame_)) * 4];
      rgba.insert(rgba.end(), pixel, pixel + 4);
    }
    return rgba;
  }

 private:
  uint32_t frame_;
  GLuint columns_[2] = {};
};

constexpr char kSphereVertex[] = R"(#version 330 core
uniform mat4 object_to_world, world_to_clip;
layout(location = 0) in vec3 position;
layout(location = 1) in vec2 uv;
out vec3 v_position, v_normal;
out vec2 v_uv;
void main() {
  vec4 world = object_to_world * vec4(position, 1.0);
  gl_Position = world_to_clip * world;
  v_position = world.xyz;
  v_normal = position;
  v_uv = uv;
}
)";
constexpr char kSphereFragment[] = R"(#version 330 core
uniform sampler2D image;
uniform vec3 eye, light_position[2], light_intensity[2];
uniform float diffuse, specular, exponent;
in vec3 v_position, v_normal;
in vec2 v_uv;
out vec4 colour;
void main() {
  vec3 n = normalize(v_normal), v = normalize(eye - v_position);
  vec3 kd = diffuse * texture(image, v_uv).rgb;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 2; ++i) {
    vec3 to_light = light_position[i] - v_position;
    float r2 = dot(to_light, to_light);
    vec3 l = to_light * inversesqrt(r2), e = light_intensity[i] / r2;
    float cosine = dot(n, l);
    if (cosine > 0.0) sum += e * (kd * cosine + specular * pow(max(0.0, dot(n, normalize(v + l))), exponent));
  }
  colour = vec4(sum, 1.0);
}
)";

class SpherePass final : public Pass {
 public:
  SpherePass(const Spheres& spheres, const std::vector<uint8_t>& texels)
      : Pass(kFrameEdge, kFrameTextureEdge, texels, PeerFilter::kTrilinear), spheres_(spheres) {
    std::vector<float> position, uv;
    for (size_t i = 0; i < spheres.position[0].size(); ++i) {
      for (const std::vector<float>& column : spheres.position) position.push_back(column[i]);
      for (const std::vector<float>& column : spheres.uv) uv.push_back(column[i]);
    }
    attribute(0, 3, position);
    attribute(1, 2, uv);
    make_buffer(GL_ELEMENT_ARRAY_BUFFER, spheres.indices.data(), spheres.indices.size() * sizeof(uint32_t));
    program_ = link(kSphereVertex, kSphereFragment);
    set_uniforms();
    object_to_world_ = glGetUniformLocation(program_, "object_to_world");
  }
  void run() override {
    begin();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glEnable(GL_CULL_FACE);
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (size_t i = 0; i < spheres_.sphere_count(); ++i) {
      glUniformMatrix4fv(object_to_world_, 1, GL_FALSE, &spheres_.object_to_world[16 * i]);
      glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(spheres_.indices.size()), GL_UNSIGNED_INT, nullptr);
    }
    glFinish();
  }

 private:
  void set_uniforms() {
    const shd_view& view = spheres_.view;
    float clip[16];
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 4; ++row) {
        float sum = 0.0f;
        for (int k = 0; k < 4; ++k) sum += view.view_to_clip[4 * k + row] * view.world_to_view[4 * column + k];
        clip[4 * column + row] = sum;
      }
      clip[4 * column + 2] = 2.0f * clip[4 * column + 2] - clip[4 * column + 3];  // depth 0..1 to -1..1
    }
    glUseProgram(program_);
    glUniformMatrix4fv(glGetUniformLocation(program_, "world_to_clip"), 1, GL_FALSE, clip);
    glUniform3fv(glGetUniformLocation(program_, "eye"), 1, view.eye);
    for (int i = 0; i < 2; ++i) {
      const std::string index = "[" + std::to_string(i) + "]";
      glUniform3fv(glGetUniformLocation(program_, ("light_position" + index).c_str()), 1, kLights[i].position);
      glUniform3fv(glGetUniformLocation(program_, ("light_intensity" + index).c_str()), 1, kLights[i].intensity);
    }
    glUniform1f(glGetUniformLocation(program_, "diffuse"), kDiffuse);
    glUniform1f(glGetUniformLocation(program_, "specular"), kSpecular);
    glUniform1f(glGetUniformLocation(program_, "exponent"), kExponent);
  }

  const Spheres& spheres_;
  GLint object_to_world_ = -1;
};

}  // namespace

std::string llvmpipe_description() {
  make_current();
  return std::string(reinterpret_cast<const char*>(glGetString(GL_RENDERER))) + ", " +
         reinterpret_cast<const char*>(glGetString(GL_VERSION)) + ", LP_NUM_THREADS=0";
}

std::unique_ptr<Peer> make_llvmpipe_spheres(const Spheres& spheres, const std::vector<uint8_t>& texels) {
  return std::make_unique<SpherePass>(spheres, texels);
}

std::unique_ptr<Peer> make_llvmpipe_surface(const Surface& surface, uint32_t frame, uint32_t edge,
                                            const std::vector<uint8_t>& texels, PeerFilter filter) {
  return std::make_unique<SurfacePass>(surface, frame, edge, texels, filter);
}

std::unique_ptr<Peer> make_llvmpipe_lookups(const Lookups& lookups, uint32_t edge, const std::vector<uint8_t>& texels,
                                            PeerFilter filter) {
  const auto frame = static_cast<uint32_t>(std::lround(std::sqrt(static_cast<double>(lookups.count()))));
  if (size_t{frame} * frame != lookups.count()) die("the number of lookups is not a square");
  return std::make_unique<LookupsPass>(lookups, frame, edge, texels, filter);
}

}  // namespace shd::bench
