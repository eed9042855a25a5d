// The mesh of what the session shows, made beside the window when it takes long.
// SPDX-License-Identifier: MIT
#include "apps/desktop/views/mesh_keeper.h"

#include <optional>
#include <utility>

#include "render/mesh/moved_mesh.h"

namespace kiri::desktop {
namespace {

/// Smaller models are meshed at once: what the hand moves is seen in the same frame.
constexpr std::size_t kAtOnce = 400;
/// So are these while nothing but poses changes, as under a slider.
constexpr std::size_t kMovedAtOnce = 50000;

ShownMesh meshed(const FoldedState& state, std::uint64_t revision, const Progress& progress) {
  return {
      std::make_shared<const PaperMesh>(meshOf(state, progress)), sphereOf(state), revision, {}};
}

}  // namespace

MeshKeeper::MeshKeeper(SessionHub& hub, QObject* parent)
    : QObject(parent), hub_(hub), task_(hub.runner(), LatestTask::Overtaken::MayEnd) {
  connect(&hub, &SessionHub::shownChanged, this, &MeshKeeper::refresh);
  refresh();
}

void MeshKeeper::refresh() {
  const Shown shown = hub_.session().shown();
  if (!shown.state) return;
  if (shown.revision == newest_.revision) {
    takeTints(shown);
    emit changed();
    return;
  }
  if (shown.revision == asked_) return;  // on its way
  asked_ = shown.revision;
  if (tryMoving(shown)) return;
  if (shown.state->pattern.facets.size() < kAtOnce) {
    const ShownMesh made = meshed(*shown.state, shown.revision, {});
    base_ = made.mesh;
    baseState_ = shown.state;
    take(made);
    return;
  }
  auto made = std::make_shared<ShownMesh>();
  task_.ask({{},
             [made, state = shown.state, revision = shown.revision](const Progress& progress) {
               *made = meshed(*state, revision, progress);
             },
             [this, made, state = shown.state] {
               if (!made->mesh) return;
               base_ = made->mesh;
               baseState_ = state;
               // A later one may have been there at once.
               if (newest_.revision != hub_.session().shown().revision) take(*made);
             }});
}

bool MeshKeeper::tryMoving(const Shown& shown) {
  if (!base_ || shown.state->pattern.facets.size() > kMovedAtOnce) return false;
  std::optional<PaperMesh> moved = movedMesh(*base_, *baseState_, *shown.state);
  if (!moved) return false;
  take({std::make_shared<const PaperMesh>(std::move(*moved)),
        sphereOf(*shown.state),
        shown.revision,
        {}});
  return true;
}

void MeshKeeper::take(const ShownMesh& made) {
  newest_ = made;
  takeTints(hub_.session().shown());
  emit changed();
}

void MeshKeeper::takeTints(const Shown& shown) {
  const bool fits = shown.revision == newest_.revision && newest_.mesh &&
                    shown.tints.size() == newest_.mesh->facetCount;
  newest_.tints = fits ? shown.tints : std::vector<FacetTint>();
}

}  // namespace kiri::desktop
