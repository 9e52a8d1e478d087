// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/surface_grid.h"

#include <memory>

/// Where and how OpenGL draws the surface of the layers. Qt DataVisualization, which does it, is in
/// a module that is loaded when it is first wanted: with Qt Quick behind it, it would slow every
/// start.
namespace sparkout {

/// Found out once, by a context that is made current. Never on a platform without a screen, nor
/// when the environment sets SPARKOUT_NO_OPENGL; of OpenGL in software only when it sets
/// SPARKOUT_SOFTWARE_OPENGL.
[[nodiscard]] bool openGlWorks();

/// Null where OpenGL does not work or the module is missing.
[[nodiscard]] std::unique_ptr<SurfaceDrawer> makeOpenGlDrawer();

} // namespace sparkout
