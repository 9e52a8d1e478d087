// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/surface_grid.h"

#include <QtDataVisualization/Q3DSurface>
#include <QtDataVisualization/QSurface3DSeries>
#include <QtDataVisualization/QValue3DAxis>

#include <memory>
#include <optional>

namespace sparkout {

/// The surface of the layers by Qt DataVisualization, with the colours and the projection of the
/// painted one. The graph is a window that is never shown: it draws into pictures, so the plot
/// stays a widget that can be torn off, covered by a menu and reached by the keyboard.
class SurfaceGraph : public SurfaceDrawer {
public:
    SurfaceGraph();
    ~SurfaceGraph() override;

    [[nodiscard]] bool works() const; ///< it has a context
    [[nodiscard]] QImage draw(const SurfaceGrid& grid, const SurfaceSight& sight,
                              const QSize& pixels) override;

    [[nodiscard]] Q3DSurface& graph() { return *m_graph; }

    // What makes a grid into a graph; none of it needs a window.
    static void setScale(QValue3DAxis& axis, const SurfaceScale& scale);
    /// Length to the right, numbers away from the eye, feed upwards; the colours as a texture.
    static void fill(QSurface3DSeries& series, const SurfaceSheet& sheet,
                     const std::array<SurfaceScale, 3>& scales);
    /// The facets' colours seen from above, the first row below.
    [[nodiscard]] static QImage texture(const SurfaceSheet& sheet);
    /// The camera's zoom, in percent, that makes the box as large as it is painted.
    [[nodiscard]] static double zoomLevel(const SurfaceSight& sight, const QSize& pixels);

private:
    void setLook(const SurfaceGrid& grid);
    void setSheets(const SurfaceGrid& grid);
    void setBox(const SurfaceGrid& grid, const SurfaceSight& sight);
    void setEye(const SurfaceSight& sight, const QSize& pixels);

    std::unique_ptr<Q3DSurface> m_graph;
    std::vector<QSurface3DSeries*> m_sheets;              ///< of the graph
    std::vector<std::unique_ptr<QSurface3DSeries>> m_old; ///< no longer of the graph
    std::array<QSurface3DSeries*, 3> m_box{};             ///< ground and the two walls at the back
    std::optional<SurfaceGrid> m_shown;
};

} // namespace sparkout
