// How lines are drawn: one instance of six corners for each segment.
// SPDX-License-Identifier: MIT
#include "render/gl/shaders.h"

namespace kiri {

// A line has a wing on its left and one on its right. Where there is paper under a wing that is
// turned to the eye, the wing lies along it, a little nearer; elsewhere it faces the eye. So a line
// has its full width in a valley, too, and shines through nothing.
const char* const kLineVertexShader = R"(
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec3 normal;       // of the paper on the left
layout(location = 3) in vec3 otherNormal;  // of that on the right, or zero
layout(location = 4) in float along;       // mm
layout(location = 5) in uvec4 form;        // kind, thin, joined before, joined behind
layout(location = 6) in uint isCovered;
uniform mat4 clip;
uniform vec4 eye;           // place in the mesh, 1; or direction to it, 0
uniform vec2 halfSize;      // of the picture, pixels
uniform float pixelsPerMm;
uniform float bias;         // of depth in clip space
uniform float flatSlope;    // depth in clip space by pixels of paper turned away by 45 degrees
uniform float widths[12];   // pixels; 0: not drawn
uniform float lineScale;
flat out float halfWidth;
flat out float strength;
flat out float segment;     // pixels
flat out vec2 rounds;       // 1 where the end is round
flat out uint look;
flat out float before;      // pixels from where the line begins
out vec2 place;             // pixels: along the segment, and to the left of it

float facing(vec3 n) { return dot(n, normalize(eye.xyz - from * eye.w)); }

vec3 seen(vec3 p) {
  vec4 c = clip * vec4(p, 1.0);
  return vec3(c.xy / c.w * halfSize, c.z / c.w);
}

// Depth by pixels across the line, to the left, in the plane that holds the line and `inside`.
float slopeOf(vec3 inside, vec3 a, vec2 ahead, float rise, float most) {
  vec3 d = seen(from + inside * (4.0 / pixelsPerMm)) - a;
  float across = dot(d.xy, vec2(-ahead.y, ahead.x));
  float up = d.z - rise * dot(d.xy, ahead);
  if (abs(across) * most <= abs(up)) return across * up > 0.0 ? most : -most;
  return up / across;
}

void main() {
  look = form.x + 6u * form.y;
  float width = widths[look];
  float left = facing(normal);
  bool hasOther = isCovered == 0u && dot(otherNormal, otherNormal) > 0.5;
  float right = hasOther ? facing(otherNormal) : -1.0;
  // Paper seen edge-on is a line, too.
  const float edgeOn = -1e-3;
  bool isHidden = isCovered == 1u && facing(otherNormal) > edgeOn;
  if (isHidden || width <= 0.0 || (left <= edgeOn && right <= edgeOn)) {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
    return;
  }
  vec3 a = seen(from);
  vec3 b = seen(to);
  segment = distance(a.xy, b.xy);
  vec2 ahead = segment > 1e-4 ? (b.xy - a.xy) / segment : vec2(1.0, 0.0);
  float most = 400.0 * flatSlope;
  float rise = segment > 1e-4 ? clamp((b.z - a.z) / segment, -most, most) : 0.0;

  halfWidth = 0.5 * width;
  // Many small facets would drown in their folds.
  bool isFold = form.x == 1u || form.x == 2u;
  bool isShort = isFold && form.z == 0u && form.w == 0u;
  strength = isShort ? mix(0.45, 1.0, smoothstep(5.0, 26.0, segment / lineScale)) : 1.0;
  float reach = halfWidth + 1.0;
  float slope = 0.0;
  float wing = float(gl_VertexID / 2) - 1.0;  // -1, 0, 1
  vec3 run = normalize(to - from);
  if (wing > 0.0 && left > 0.0) slope = slopeOf(cross(normal, run), a, ahead, rise, most);
  if (wing < 0.0 && right > 0.0) slope = slopeOf(cross(otherNormal, -run), a, ahead, rise, most);

  bool isEnd = (gl_VertexID & 1) == 1;
  rounds = vec2(form.z == 0u ? 1.0 : 0.0, form.w == 0u ? 1.0 : 0.0);
  float beyond = isEnd ? reach * rounds.y : -reach * rounds.x;
  place = vec2((isEnd ? segment : 0.0) + beyond, wing * reach);
  vec2 at = a.xy + ahead * place.x + vec2(-ahead.y, ahead.x) * place.y;
  float depth = (isEnd ? b.z : a.z) + rise * beyond + slope * place.y;
  depth -= bias + 0.25 * min(abs(slope) + abs(rise), 4.0 * flatSlope);
  before = along * pixelsPerMm;
  gl_Position = vec4(at / halfSize, clamp(depth, -1.0, 1.0), 1.0);
}
)";

const char* const kLineFragmentShader = R"(
flat in float halfWidth;
flat in float strength;
flat in float segment;
flat in vec2 rounds;
flat in uint look;
flat in float before;
in vec2 place;
uniform vec3 colors[12];
uniform float dashes[72];       // six for each look, pixels
uniform float dashLengths[12];  // their sum; 0: solid
out vec4 color;

// How much of a pixel at this distance from the middle a band covers.
float coverOf(float away, float half_) {
  return clamp(min(away + 0.5, half_) - max(away - 0.5, -half_), 0.0, 1.0);
}

float dashCover() {
  float total = dashLengths[look];
  if (total <= 0.0) return 1.0;
  float x = mod(before + place.x, total);
  float start = 0.0;
  float cover = 0.0;
  for (int i = 0; i < 6; i += 2) {
    float drawn = dashes[int(look) * 6 + i];
    float middle = start + 0.5 * drawn;
    float away = abs(x - middle);
    cover = max(cover, coverOf(min(away, total - away), 0.5 * drawn));
    start += drawn + dashes[int(look) * 6 + i + 1];
  }
  return cover;
}

void main() {
  float beyond = max(max(-place.x * rounds.x, (place.x - segment) * rounds.y), 0.0);
  float alpha = coverOf(length(vec2(beyond, place.y)), halfWidth) * dashCover() * strength;
  color = vec4(colors[look] * alpha, alpha);
}
)";

}  // namespace kiri
