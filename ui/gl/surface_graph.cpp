// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/surface_graph.h"

#include <QPainter>

#include <QtDataVisualization/Q3DCamera>
#include <QtDataVisualization/Q3DScene>
#include <QtDataVisualization/Q3DTheme>
#include <QtDataVisualization/QSurfaceDataProxy>

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

constexpr int textureWidth = 256, textureHeight = 1024;
constexpr int samples = 4;               ///< of a pixel
constexpr double libraryRatio = 1 / 1.6; ///< of a picture, height over width, from which on the
                                         ///< library fits the graph to its width
constexpr double groundBelow = 0.002;    ///< of the height, so that no facet lies in the ground

QVector3D point(double length_mm, double feed_um, double number) {
    return {static_cast<float>(length_mm), static_cast<float>(feed_um), static_cast<float>(number)};
}

/// All pixels alike: a driver that lost its context draws nothing.
bool isBlank(const QImage& picture) {
    const QRgb first = picture.pixel(0, 0);
    for (int y = 0; y < picture.height(); ++y) {
        const auto* line = reinterpret_cast<const QRgb*>(picture.constScanLine(y));
        if (std::any_of(line, line + picture.width(),
                        [first](QRgb pixel) { return pixel != first; })) {
            return false;
        }
    }
    return true;
}

/// Four corners as a series, row by row.
void setFace(QSurface3DSeries& series, const std::array<QVector3D, 4>& corners) {
    auto* rows = new QSurfaceDataArray;
    for (const std::size_t i : {0u, 2u}) {
        rows->append(new QSurfaceDataRow{corners[i], corners[i + 1]});
    }
    series.dataProxy()->resetArray(rows);
}

} // namespace

SurfaceGraph::SurfaceGraph() {
    QSurfaceFormat format;
    format.setDepthBufferSize(24);
    m_graph = std::make_unique<Q3DSurface>(&format);
    m_graph->setActiveInputHandler(nullptr);
    m_graph->setSelectionMode(QAbstract3DGraph::SelectionNone);
    m_graph->setShadowQuality(QAbstract3DGraph::ShadowQualityNone);
    m_graph->setOrthoProjection(true);
    m_graph->setAspectRatio(1 / SurfaceSight::flatness);
    m_graph->setHorizontalAspectRatio(1);
    m_graph->setMargin(0);
    m_graph->setAxisX(new QValue3DAxis);
    m_graph->setAxisY(new QValue3DAxis);
    m_graph->setAxisZ(new QValue3DAxis);
    Q3DCamera& camera = *m_graph->scene()->activeCamera();
    camera.setMinZoomLevel(1);
    camera.setMaxZoomLevel(100'000);
    for (QSurface3DSeries*& face : m_box) {
        face = new QSurface3DSeries;
        face->setFlatShadingEnabled(false);
        face->setColorStyle(Q3DTheme::ColorStyleUniform);
        m_graph->addSeries(face);
    }
}

SurfaceGraph::~SurfaceGraph() = default;

bool SurfaceGraph::works() const {
    return m_graph->hasContext();
}

QImage SurfaceGraph::draw(const SurfaceGrid& grid, const SurfaceSight& sight, const QSize& pixels) {
    if (!works() || pixels.isEmpty()) {
        return {};
    }
    setLook(grid);
    setSheets(grid);
    setBox(grid, sight);
    setEye(sight, pixels);
    QImage picture = m_graph->renderToImage(samples, pixels);
    return picture.isNull() || isBlank(picture) ? QImage() : picture;
}

// --- look ---------------------------------------------------------------------------------------

/// Colours as they are, without light; no numbers, which the plot writes.
void SurfaceGraph::setLook(const SurfaceGrid& grid) {
    Q3DTheme& theme = *m_graph->activeTheme();
    theme.setLightStrength(0);
    theme.setHighlightLightStrength(0);
    theme.setAmbientLightStrength(1);
    theme.setBackgroundEnabled(false);
    theme.setGridEnabled(false);
    theme.setLabelBackgroundEnabled(false);
    theme.setLabelBorderEnabled(false);
    theme.setLabelTextColor(Qt::transparent);
    theme.setWindowColor(grid.background);
    QValue3DAxis* const axes[] = {m_graph->axisX(), m_graph->axisZ(), m_graph->axisY()};
    for (std::size_t i = 0; i < grid.scales.size(); ++i) {
        setScale(*axes[i], grid.scales[i]);
    }
}

void SurfaceGraph::setScale(QValue3DAxis& axis, const SurfaceScale& scale) {
    axis.setTitle(scale.title);
    axis.setSegmentCount(1);
    axis.setRange(0, static_cast<float>(std::max(scale.most, 1e-6)));
}

// --- surface ------------------------------------------------------------------------------------

void SurfaceGraph::setSheets(const SurfaceGrid& grid) {
    while (m_sheets.size() < grid.sheets.size()) {
        m_sheets.push_back(new QSurface3DSeries);
        m_graph->addSeries(m_sheets.back());
    }
    for (std::size_t i = 0; i < m_sheets.size(); ++i) {
        const bool used = i < grid.sheets.size();
        m_sheets[i]->setVisible(used);
        if (used) {
            fill(*m_sheets[i], grid.sheets[i]);
        }
    }
}

void SurfaceGraph::fill(QSurface3DSeries& series, const SurfaceSheet& sheet) {
    auto* rows = new QSurfaceDataArray;
    for (std::size_t i = 0; i < sheet.numbers.size(); ++i) {
        auto* row = new QSurfaceDataRow;
        for (std::size_t j = 0; j < sheet.columns(); ++j) {
            row->append(point(sheet.lengths_mm[j], sheet.feed_um(i, j), sheet.numbers[i]));
        }
        rows->append(row);
    }
    series.dataProxy()->resetArray(rows);
    series.setFlatShadingEnabled(false);
    series.setDrawMode(QSurface3DSeries::DrawSurfaceAndWireframe);
    series.setWireframeColor(sheet.line);
    series.setTexture(texture(sheet));
}

QImage SurfaceGraph::texture(const SurfaceSheet& sheet) {
    QImage texture(textureWidth, textureHeight, QImage::Format_RGB32);
    QPainter painter(&texture);
    const auto at = [](const std::vector<double>& along, std::size_t i, int size) {
        const double all = std::max(along.back() - along.front(), 1e-9);
        return static_cast<int>(std::lround((along[i] - along.front()) / all * size));
    };
    for (std::size_t i = 0; i + 1 < sheet.numbers.size(); ++i) {
        const int below = at(sheet.numbers, i, textureHeight);
        const int above = at(sheet.numbers, i + 1, textureHeight);
        int left = 0;
        for (std::size_t j = 0; j + 1 < sheet.columns(); ++j) {
            // A step is seen edge on: its colour is that of the next pixels.
            const int right = at(sheet.lengths_mm, j + 1, textureWidth)
                              + (sheet.lengths_mm[j] == sheet.lengths_mm[j + 1] ? 1 : 0);
            painter.fillRect(left, textureHeight - above, right - left, above - below,
                             sheet.colour(i, j));
            left = right;
        }
    }
    return texture;
}

// --- box ----------------------------------------------------------------------------------------

void SurfaceGraph::setBox(const SurfaceGrid& grid, const SurfaceSight& sight) {
    const double length = grid.scales[0].most, number = grid.scales[1].most;
    const double top = std::max(grid.scales[2].most, 1e-6), under = -groundBelow * top;
    setFace(*m_box[0], {point(0, under, 0), point(length, under, 0), point(0, under, number),
                        point(length, under, number)});
    for (const bool opposite : {false, true}) {
        const double x = opposite ? length : 0, y = opposite ? number : 0;
        setFace(*m_box[opposite ? 3 : 1], {point(x, under, 0), point(x, top, 0),
                                           point(x, under, number), point(x, top, number)});
        setFace(*m_box[opposite ? 4 : 2], {point(0, under, y), point(length, under, y),
                                           point(0, top, y), point(length, top, y)});
    }
    const bool seen[] = {true, sight.lengthZeroBehind, sight.numberZeroBehind,
                         !sight.lengthZeroBehind, !sight.numberZeroBehind};
    for (std::size_t i = 0; i < m_box.size(); ++i) {
        m_box[i]->setVisible(seen[i]);
        m_box[i]->setBaseColor(grid.wall);
        m_box[i]->setDrawMode(QSurface3DSeries::DrawSurfaceAndWireframe);
        m_box[i]->setWireframeColor(grid.edge);
    }
}

// --- eye ----------------------------------------------------------------------------------------

/// Without zoom an edge of the box is aspect/2 of the picture's height, or less in a picture that
/// is narrower than 1.6 : 1.
double SurfaceGraph::zoomLevel(const SurfaceSight& sight, const QSize& pixels) {
    const double width = pixels.width(), height = pixels.height();
    const double fitted =
        height / (2 * SurfaceSight::flatness) * std::min(libraryRatio * width / height, 1.0);
    return 100 * sight.edge / fitted;
}

void SurfaceGraph::setEye(const SurfaceSight& sight, const QSize& pixels) {
    m_graph->scene()->activeCamera()->setCameraPosition(
        static_cast<float>(std::remainder(sight.azimuth, 360)), static_cast<float>(sight.elevation),
        static_cast<float>(zoomLevel(sight, pixels)));
}

} // namespace sparkout
