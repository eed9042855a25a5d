// How paper is drawn.
// SPDX-License-Identifier: MIT
#include "render/gl/shaders.h"

namespace kiri {

const char* const kPaperVertexShader = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 plane;   // normal, height
layout(location = 2) in vec2 paper;
layout(location = 3) in uint facet;
layout(location = 4) in uint isFront;
uniform mat4 clip;         // from the mesh to clip space
uniform mat3 toView;       // from the model frame to the axes of the view
uniform vec4 eye;          // place in the mesh, 1; or direction to it, 0
uniform float shading;     // 0: none
uniform vec2 textureLow;
uniform vec2 textureSize;
out vec2 onPaper;
out vec2 onTexture;        // of the side, from its upper left corner
flat out float brightness;
flat out uint facetNumber;
flat out uint side;

// The lamp stands behind the left shoulder of the viewer, so that all that is seen is in its light.
// 1 where paper is turned straight to the eye, whichever side of it; light comes back from all
// around, so that nothing is black.
float brightnessOf(vec3 n) {
  const vec3 lamp = vec3(-0.42, 0.5, 0.757);
  float light = 0.5 + 0.5 * dot(n, lamp);
  float most = 0.5 + 0.5 * lamp.z;
  float more = 1.3 * (light - most) + 0.06 * n.y;
  return more > 0.0 ? 1.0 + 0.6 * more : 1.0 + more / (1.0 - 0.8 * more);
}

void main() {
  // The same numbers at all corners of a side: it is there as a whole or not at all.
  bool isSeen = dot(plane.xyz, eye.xyz) - plane.w * eye.w > 0.0;
  gl_Position = isSeen ? clip * vec4(position, 1.0) : vec4(0.0, 0.0, 2.0, 1.0);
  onPaper = paper;
  vec2 t = (paper - textureLow) / textureSize;
  onTexture = vec2(isFront == 1u ? t.x : 1.0 - t.x, 1.0 - t.y);
  brightness = mix(1.0, brightnessOf(toView * plane.xyz), shading);
  facetNumber = facet;
  side = isFront;
}
)";

const char* const kPaperFragmentShader = R"(
in vec2 onPaper;
in vec2 onTexture;
flat in float brightness;
flat in uint facetNumber;
flat in uint side;
uniform vec3 frontColor;
uniform vec3 backColor;
uniform bool hasFrontTexture;
uniform bool hasBackTexture;
uniform bool hasTints;
uniform sampler2D frontTexture;  // alpha multiplied in
uniform sampler2D backTexture;
uniform sampler2D tints;         // 1024 facets in a row
uniform float gridSpacing;       // 0: none
uniform float lineScale;
out vec4 color;

// How much of the pixel the lines of the grid cover. They fade before they run together.
float gridCover() {
  vec2 cells = onPaper / gridSpacing;
  vec2 perPixel = max(fwidth(cells), vec2(1e-6));
  vec2 away = abs(fract(cells - 0.5) - 0.5) / perPixel;
  vec2 cover = clamp(0.5 + 0.5 * lineScale - away, 0.0, 1.0);
  vec2 room = smoothstep(3.0 * lineScale, 9.0 * lineScale, 1.0 / perPixel);
  cover *= room;
  return max(cover.x, cover.y);
}

void main() {
  vec3 c = side == 1u ? frontColor : backColor;
  if (hasFrontTexture) {
    vec4 over = texture(frontTexture, onTexture);
    if (side == 1u) c = c * (1.0 - over.a) + over.rgb;
  }
  if (hasBackTexture) {
    vec4 over = texture(backTexture, onTexture);
    if (side == 0u) c = c * (1.0 - over.a) + over.rgb;
  }
  if (gridSpacing > 0.0) {
    float luma = dot(c, vec3(0.3, 0.59, 0.11));
    vec3 ink = luma > 0.35 ? vec3(0.0) : vec3(1.0);
    c = mix(c, ink, 0.16 * gridCover());
  }
  if (hasTints) {
    vec4 tint = texelFetch(tints, ivec2(int(facetNumber % 1024u), int(facetNumber / 1024u)), 0);
    c = mix(c, tint.rgb, tint.a);
  }
  // Shade is a little cool; what is lit is brighter, and hardly paler.
  float dark = 1.0 - brightness;
  c *= brightness + max(dark, 0.0) * vec3(-0.03, 0.0, 0.04);
  c = mix(c, vec3(1.0), 0.25 * max(-dark, 0.0));
  color = vec4(c, 1.0);
}
)";

}  // namespace kiri
