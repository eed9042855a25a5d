// The mesh of what the session shows, made beside the window when it takes long.
// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <cstdint>
#include <memory>
#include <vector>

#include "apps/desktop/services/session_hub.h"
#include "editor/base/task.h"
#include "render/mesh/paper_mesh.h"
#include "render/scene/view_spec.h"

namespace kiri::desktop {

/// A mesh, where it is, and the tints that go with its facets.
struct ShownMesh {
  std::shared_ptr<const PaperMesh> mesh;
  Sphere ball;  ///< holds it, model frame
  std::uint64_t revision = 0;
  std::vector<FacetTint> tints;  ///< one for each facet of the mesh, or empty
};

class MeshKeeper final : public QObject {
  Q_OBJECT
 public:
  explicit MeshKeeper(SessionHub& hub, QObject* parent = nullptr);
  /// The newest mesh that is ready; until the first one is there, without a mesh.
  const ShownMesh& newest() const { return newest_; }

 signals:
  void changed();

 private:
  void refresh();
  /// What has changed since the last mesh that was made anew may be poses only.
  bool tryMoving(const Shown& shown);
  void take(const ShownMesh& made);
  void takeTints(const Shown& shown);

  SessionHub& hub_;
  ShownMesh newest_;
  std::shared_ptr<const PaperMesh> base_;  ///< the last that was made anew
  std::shared_ptr<const FoldedState> baseState_;
  std::uint64_t asked_ = 0;
  LatestTask task_;
};

}  // namespace kiri::desktop
