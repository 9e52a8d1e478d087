// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>

#include <array>
#include <cstddef>
#include <vector>

class QPalette;

/// The surface of the layers as plain values.
namespace sparkout {

class CurveChoice;
struct LayerSeries;
struct LayersDone;

/// A piece of the surface with lines of one colour: a stage, or the newest layer at the moment of
/// the cycle. Its points lie in rows, one over each of `numbers`; a step up or down has two points
/// at one length.
struct SurfaceSheet {
    int stage = 1;
    bool newest = false;
    std::vector<double> lengths_mm; ///< lengths of the points of a row, never falling
    std::vector<double> numbers;    ///< numbers of the rows, rising
    std::vector<double> feeds_um;   ///< accumulated actual feeds, row by row
    std::vector<QColor> colours;    ///< colours of the facets between the points, row by row
    QColor line;                    ///< about the facets

    bool operator==(const SurfaceSheet&) const = default;
    [[nodiscard]] std::size_t columns() const { return lengths_mm.size(); }
    [[nodiscard]] double feed_um(std::size_t row, std::size_t column) const {
        return feeds_um[row * columns() + column];
    }
    [[nodiscard]] const QColor& colour(std::size_t row, std::size_t column) const {
        return colours[row * (columns() - 1) + column];
    }
};

struct SurfaceScale {
    QString title;
    double most = 1; ///< beginning at 0
    bool operator==(const SurfaceScale&) const = default;
};

struct SurfaceGrid {
    std::vector<SurfaceSheet> sheets;
    std::array<SurfaceScale, 3> scales; ///< length, number, feed
    QColor wall, edge;                  ///< colours of the box; opaque
    bool operator==(const SurfaceGrid&) const = default;
};

[[nodiscard]] SurfaceGrid makeSurfaceGrid(const LayerSeries& series, const LayersDone& done,
                                          const CurveChoice& choice, const QPalette& palette,
                                          bool dim);

} // namespace sparkout
