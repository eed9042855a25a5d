// How paper darkens in valleys and beside layers: one instance of four corners for each piece.
// SPDX-License-Identifier: MIT
#include "render/gl/shaders.h"

namespace kiri {

const char* const kShadeVertexShader = R"(
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec3 normal;
layout(location = 3) in vec3 form;  // mm before, mm behind, strength
uniform mat4 clip;
uniform vec4 eye;
uniform float reach;  // mm
uniform float bias;
out vec2 place;       // along the whole line and across it, in widths of the shade
flat out float whole; // length of the line in widths
flat out float strength;

void main() {
  vec3 run = to - from;
  float own = length(run);
  float total = form.x + own + form.y;
  float width = min(reach, 0.3 * total);
  bool isSeen = dot(normal, eye.xyz - from * eye.w) > 0.0;
  if (!isSeen || own <= 0.0) {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
    return;
  }
  bool isEnd = (gl_VertexID & 1) == 1;
  float across = gl_VertexID > 1 ? 1.0 : 0.0;
  vec3 inside = cross(normal, run / own);
  vec4 c = clip * vec4((isEnd ? to : from) + inside * (width * across), 1.0);
  c.z -= bias * c.w;
  gl_Position = c;
  place = vec2((form.x + (isEnd ? own : 0.0)) / width, across);
  whole = total / width;
  // Narrow shades are hardly there: they would make many small facets dull.
  strength = form.z * width / reach;
}
)";

const char* const kShadeFragmentShader = R"(
in vec2 place;
flat in float whole;
flat in float strength;
out vec4 color;

void main() {
  float away = 1.0 - clamp(place.y, 0.0, 1.0);
  float end = smoothstep(0.0, 1.0, min(place.x, whole - place.x));
  color = vec4(0.0, 0.0, 0.0, 0.34 * strength * away * away * end);
}
)";

}  // namespace kiri
