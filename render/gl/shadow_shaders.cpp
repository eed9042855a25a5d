// How the shadow on the table is made and drawn.
// SPDX-License-Identifier: MIT
#include "render/gl/shaders.h"

namespace kiri {

const char* const kFallVertexShader = R"(
layout(location = 0) in vec3 position;
uniform vec2 light;    // mm aside for each mm that it comes down
uniform vec4 box;      // middle and half size of the picture of the shadow, mm
uniform float table;   // z, mm
uniform float depth;

void main() {
  vec2 fallen = position.xy - light * (position.z - table);
  gl_Position = vec4((fallen - box.xy) / box.zw, depth, 1.0);
}
)";

const char* const kFallFragmentShader = R"(
uniform float share;
out vec4 color;
void main() { color = vec4(share); }
)";

const char* const kTableVertexShader = R"(
uniform mat4 clip;
uniform vec4 box;
uniform float table;
out vec2 place;

void main() {
  vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID / 2));
  place = corner;
  vec4 c = clip * vec4(box.xy + (2.0 * corner - 1.0) * box.zw, table, 1.0);
  gl_Position = vec4(c.xy, 0.0, c.w);
}
)";

const char* const kTableFragmentShader = R"(
in vec2 place;
uniform sampler2D shadow;
uniform float texel;
uniform float darkness;
out vec4 color;

void main() {
  float sum = 0.0;
  for (int i = -1; i <= 1; ++i) {
    for (int j = -1; j <= 1; ++j) {
      sum += texture(shadow, place + vec2(float(i), float(j)) * texel).r;
    }
  }
  color = vec4(0.0, 0.0, 0.0, darkness * sum / 9.0);
}
)";

}  // namespace kiri
