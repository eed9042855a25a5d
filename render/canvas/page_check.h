// What every file format asks of a scene.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "render/scene/scene.h"

namespace kiri {

/// Errors: BadValue - the page has no size, or one beyond 100 m.
Status checkPage(const Scene& scene);

}  // namespace kiri
