// The programs that run on the graphics processor, for both kinds of OpenGL.
// SPDX-License-Identifier: MIT
#pragma once

namespace kiri {

/// Places of the attributes of vertices and instances.
enum class PaperAttribute : unsigned { Position, Plane, Paper, Facet, IsFront };
enum class LineAttribute : unsigned { From, To, Normal, OtherNormal, Along, Form, IsCovered };
enum class ShadeAttribute : unsigned { From, To, Normal, Form };

/// GLSL without the line that names the version.
extern const char* const kPaperVertexShader;
extern const char* const kPaperFragmentShader;
extern const char* const kFallVertexShader;
extern const char* const kFallFragmentShader;
extern const char* const kTableVertexShader;
extern const char* const kTableFragmentShader;
extern const char* const kShadeVertexShader;
extern const char* const kShadeFragmentShader;
extern const char* const kLineVertexShader;
extern const char* const kLineFragmentShader;

}  // namespace kiri
