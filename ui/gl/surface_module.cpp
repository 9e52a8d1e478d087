// SPDX-License-Identifier: GPL-3.0-or-later
// The door of the module that draws by OpenGL.
#include "ui/gl/surface_graph.h"

/// Null: there is no context. The caller owns it.
extern "C" Q_DECL_EXPORT sparkout::SurfaceDrawer* sparkout_make_surface_drawer() {
    auto graph = std::make_unique<sparkout::SurfaceGraph>();
    return graph->works() ? graph.release() : nullptr;
}
