// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/hatch.h"
#include "ui/plot/quantity_colour.h"
#include "ui/plot/read_curves.h"
#include "ui/tables/csv_table.h"

#include <QPalette>
#include <QPen>
#include <QSharedPointer>
#include <QStringList>

#include <functional>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

class QCPAxisTicker;

namespace sparkout {

/// A colour by the palette that is drawn with: of a thing, of a tone, else that of texts.
using ChartColour = std::variant<std::monostate, style::Drawn, Tone>;
[[nodiscard]] QColor chartColour(const ChartColour& colour, const QPalette& palette);

/// The least and the greatest of some values; what is not finite does not count.
struct ChartSpan {
    double low = std::numeric_limits<double>::infinity(), high = -low;

    void add(double value);
    [[nodiscard]] bool empty() const { return low > high; }
    [[nodiscard]] double size() const { return high - low; }
};

/// Whether something is in sight where all of a chart is shown.
enum class InSight {
    always,
    nearby, ///< where it does not squeeze what is always in sight
    never,
};

/// An axis, and what of it is shown at first, with room at both ends: a share of the range, and of
/// the values themselves at least.
struct ChartAxis {
    QString label = {};   ///< with its unit
    ChartSpan range = {}; ///< empty: of what is drawn
    double room = 0.05, leastRoom = 0;
    bool isSymmetric = false;                  ///< about 0
    bool isCounted = false;                    ///< whole numbers alone
    std::optional<QStringList> names = {};     ///< in place of numbers, at 0, 1, …
    QSharedPointer<QCPAxisTicker> ticker = {}; ///< in place of the usual ones
};

/// Points over places, which rise but for loose points; a value that is no number is a gap.
struct ChartSeries {
    enum class Kind {
        bars,
        stack, ///< an area on those of this kind before it, as far as they are shown
        band,  ///< an area from `points` down to `lower`
        line,
        steps,    ///< a value stands to the next place
        points,   ///< loose
        impulses, ///< lines from 0
    };
    enum class Mark { none, disc, square, diamond, triangle, ring, cross };

    int key = -1;      ///< of the legend; several may share it
    QString name = {}; ///< in the legend; empty: it has no entry
    Kind kind = Kind::line;
    ChartColour colour = {};
    QPen pen = QPen(Qt::black, 1.5); ///< but for its colour
    std::vector<XY> points = {}, lower = {};
    Mark mark = Mark::none;
    double markSize = 0; ///< [px]
    double barWidth = 1;
    int alpha = 255; ///< of an area
    bool onSecond = false;
    InSight sight = InSight::always;

    [[nodiscard]] bool isArea() const { return kind <= Kind::band; }
    [[nodiscard]] bool isLine() const { return kind == Kind::line || kind == Kind::steps; }
};

/// A line through the cell at a value of one axis.
struct ChartRule {
    double at = 0;
    bool isUpright = true;
    int key = -1;
    QString name = {};
    ChartColour colour = {};
    QPen pen = QPen(Qt::black, 1.5);
    InSight sight = InSight::nearby;
};

/// Ranges of one axis, shaded through the cell, and never narrower than a line where they have
/// edges.
struct ChartZone {
    std::vector<ChartSpan> ranges = {};
    bool isUpright = true;
    int key = -1;
    QString name = {};
    ChartColour colour = {};
    int alpha = 60;
    bool hasEdges = true;
    Hatch hatch = Hatch::none;
    InSight sight = InSight::never;
};

/// A curve that the cursors read, while its key is shown.
struct ChartReading {
    int key = -1;
    ReadCurve curve = {};
};

/// The table of a chart, and where each row of it is drawn; a row without a place is always shown.
struct ChartTable {
    struct Place {
        ChartSpan across = {}, up = {}; ///< empty: anywhere
        int key = -1;                   ///< of what it is drawn as
    };
    CsvTable cells = {};
    std::vector<Place> places = {};
};

/// A chart over one axis as a value: what is drawn, named in the legend, read and tabulated.
struct LineChart {
    ChartAxis across = {}, up = {}, second = {};
    bool isLying = false;  ///< places from the top down, values to the right, the second axis above
    bool isFramed = false; ///< lines above and to the right, too
    std::vector<ChartSeries> series = {};
    std::vector<ChartZone> zones = {}; ///< behind the series, in the legend after them
    std::vector<ChartRule> rules = {}; ///< in the legend the last
    std::vector<ChartReading> readings = {};
    ChartSpan readSpan = {};                       ///< where the cursors can be put
    std::function<ChartTable()> table = {};        ///< none: there is nothing to copy
    std::function<QString(double)> placeText = {}; ///< what the mouse reads at a place …
    /// … or at the nearest point of the first series, if it is so near [px].
    std::function<QString(std::size_t series, std::size_t point)> pointText = {};
    std::size_t pointed = 0;
    double reach = 8;

    /// A series as it is drawn, straight from point to point, is read under a name.
    void read(const ChartSeries& of, const QString& name, Digits digits);
    /// What a key of the legend is drawn as, if it is drawn; for one series.
    [[nodiscard]] const ChartSeries* find(int key) const;
    [[nodiscard]] ChartSpan places() const; ///< in sight where all is shown
    [[nodiscard]] ChartSpan values(bool onSecond = false) const;
};

} // namespace sparkout
