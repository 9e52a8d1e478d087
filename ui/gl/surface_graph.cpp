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
constexpr double hair =
    0.0004; ///< of the box: no facet lies in the ground, no wall is quite upright
constexpr double leastScale = 1e-6;
constexpr double lineShare =
    0.3; ///< of a line's colour: as strong as a painted one of half a pixel

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

/// A line of the sheet, as pale as if it were painted thin.
QColor thinned(const SurfaceSheet& sheet) {
    const QColor& under = sheet.colours[sheet.colours.size() / 2];
    const auto part = [](float line, float facet) {
        return static_cast<float>(lineShare * line + (1 - lineShare) * facet);
    };
    return QColor::fromRgbF(part(sheet.line.redF(), under.redF()),
                            part(sheet.line.greenF(), under.greenF()),
                            part(sheet.line.blueF(), under.blueF()));
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
        face->setDrawMode(QSurface3DSeries::DrawSurfaceAndWireframe);
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
    if (m_shown != grid) {
        setLook(grid);
        setSheets(grid);
        m_shown = grid;
    }
    setBox(grid, sight);
    setEye(sight, pixels);
    QImage picture = m_graph->renderToImage(samples, pixels);
    m_old.clear();
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
    axis.setRange(0, static_cast<float>(std::max(scale.most, leastScale)));
}

// --- surface ------------------------------------------------------------------------------------

/// New series each time: the library mixes old and new points of one whose size changes. The old
/// ones live until the new ones are drawn: it knows series by their addresses.
void SurfaceGraph::setSheets(const SurfaceGrid& grid) {
    for (QSurface3DSeries* series : m_sheets) {
        m_graph->removeSeries(series);
        m_old.emplace_back(series);
    }
    m_sheets.clear();
    for (const SurfaceSheet& sheet : grid.sheets) {
        m_sheets.push_back(new QSurface3DSeries);
        fill(*m_sheets.back(), sheet, grid.scales);
        m_graph->addSeries(m_sheets.back());
    }
}

/// A point beyond a scale by a rounding would take its whole row or column out of the picture.
void SurfaceGraph::fill(QSurface3DSeries& series, const SurfaceSheet& sheet,
                        const std::array<SurfaceScale, 3>& scales) {
    auto* rows = new QSurfaceDataArray;
    for (std::size_t i = 0; i < sheet.numbers.size(); ++i) {
        auto* row = new QSurfaceDataRow;
        for (std::size_t j = 0; j < sheet.columns(); ++j) {
            row->append(point(std::clamp(sheet.lengths_mm[j], 0.0, scales[0].most),
                              sheet.feed_um(i, j),
                              std::clamp(sheet.numbers[i], 0.0, scales[1].most)));
        }
        rows->append(row);
    }
    series.dataProxy()->resetArray(rows);
    series.setFlatShadingEnabled(false);
    series.setDrawMode(QSurface3DSeries::DrawSurfaceAndWireframe);
    series.setWireframeColor(sheet.newest ? sheet.line : thinned(sheet));
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
    const double top = std::max(grid.scales[2].most, leastScale), under = -hair * top;
    setFace(*m_box[0], {point(0, under, 0), point(length, under, 0), point(0, under, number),
                        point(length, under, number)});
    // The library wants lengths and numbers to rise.
    const double x0 = sight.lengthZeroBehind ? 0 : length * (1 - hair), x1 = x0 + length * hair;
    setFace(*m_box[1], {point(x0, under, 0), point(x1, top, 0), point(x0, under, number),
                        point(x1, top, number)});
    const double y0 = sight.numberZeroBehind ? 0 : number * (1 - hair), y1 = y0 + number * hair;
    setFace(*m_box[2], {point(0, under, y0), point(length, under, y0), point(0, top, y1),
                        point(length, top, y1)});
    for (QSurface3DSeries* face : m_box) {
        face->setBaseColor(grid.wall);
        face->setWireframeColor(grid.edge);
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
