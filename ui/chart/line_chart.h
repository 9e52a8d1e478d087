// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/chart/legend.h"
#include "ui/chart/quantity_colour.h"
#include "ui/chart/read_curves.h"
#include "ui/kit/theme.h"
#include "ui/table/csv_table.h"

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

/// A pen of a chart, with the colour of its quantity.
inline QPen linePen(double width, Qt::PenStyle style = Qt::SolidLine) {
    QPen pen(style);
    pen.setWidthF(width);
    return pen;
}

/// A colour taken from the current palette, that of a drawn object, a tone or that of texts; or a
/// fixed colour.
using ChartColour = std::variant<std::monostate, style::Drawn, Tone, QColor>;
[[nodiscard]] QColor chartColour(const ChartColour& colour, const QPalette& palette);

/// The least and the greatest of some values; non-finite values are ignored.
struct ChartSpan {
    double low = std::numeric_limits<double>::infinity(), high = -low;

    void add(double value);
    [[nodiscard]] bool empty() const { return low > high; }
    [[nodiscard]] double size() const { return high - low; }
};

/// Whether an object is included in the range when a whole chart is shown.
enum class InSight {
    always,
    nearby, ///< if it does not shrink the objects that are always included
    never,
};

/// An axis and its initial range, with room at both ends: the share `room` of the range, at least
/// the share `leastRoom` of the values.
struct ChartAxis {
    QString label = {};   ///< with the unit
    ChartSpan range = {}; ///< empty: the range of the drawn data
    double room = 0.05, leastRoom = 0;
    bool isSymmetric = false;   ///< symmetric about 0
    bool isCounted = false;     ///< only whole numbers
    bool isLogarithmic = false; ///< of values above 0
    bool isReversed = false;    ///< falls in the usual direction
    bool hasGrid = true;
    QStringList shorter = {};                  ///< labels for less room, the last is the unit
    std::optional<QStringList> names = {};     ///< replace the numbers 0, 1, …
    QSharedPointer<QCPAxisTicker> ticker = {}; ///< replaces the usual ticker
    ChartColour colour = {};                   ///< of the numbers and the label
};

/// Points in the order of their places, except for separate points; a NaN value is a gap.
struct ChartSeries {
    enum class Kind {
        bars,
        stack, ///< an area on top of the visible earlier ones of this kind
        band,  ///< an area from `points` down to `lower`
        line,
        steps,    ///< a value applies up to the next place
        points,   ///< separate points
        impulses, ///< lines from 0
        path,     ///< a line through the points in their order, whatever their places
        ribbon,   ///< a wide, translucent path behind everything
    };
    enum class Mark { none, disc, square, diamond, triangle, ring, cross, frame };

    int key = -1;      ///< key of the legend; several series may share it
    QString name = {}; ///< name in the legend; empty: no entry
    Kind kind = Kind::line;
    ChartColour colour = {};
    QPen pen = linePen(1.5); ///< without its colour
    std::vector<XY> points = {}, lower = {};
    Mark mark = Mark::none;
    double markSize = 0; ///< [px]
    double barWidth = 1;
    int alpha = 255; ///< opacity of an area or a ribbon
    bool onSecond = false;
    InSight sight = InSight::always;
    QColor outline = {};          ///< around a line or mark on a map
    Swatch swatch = Swatch::area; ///< of a mark in the legend; with an outline in the text colour

    [[nodiscard]] bool isArea() const { return kind <= Kind::band; }
    [[nodiscard]] bool isLine() const {
        return kind == Kind::line || kind == Kind::steps || kind == Kind::path;
    }
};

/// A line through the cell at a value of one axis.
struct ChartRule {
    double at = 0;
    bool isUpright = true;
    int key = -1;
    QString name = {};
    ChartColour colour = {};
    QPen pen = linePen(1.5);
    InSight sight = InSight::nearby;
};

/// Shaded ranges of one axis through the cell; with edges they are never narrower than a line.
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

/// A coloured interval of the horizontal axis with its name.
struct Band {
    double from = 0, to = 0;                       ///< in the unit of the axis
    std::function<QColor(const QPalette&)> colour; ///< by the palette it is drawn with
    QString name;                                  ///< "stage 1", drawn above the axis rect
    QString brief;   ///< "st. 1", used if names are too long; may be empty
    QString meaning; ///< "E1: plunge-in", for tooltips
};

/// A curve that the cursors can read while its key is shown.
struct ChartReading {
    int key = -1;
    ReadCurve curve = {};
};

/// The table of a chart, with the place of each row; a row without a place is always included.
struct ChartTable {
    struct Place {
        ChartSpan across = {}, up = {}; ///< empty: anywhere
        int key = -1;                   ///< key of the drawn object
    };
    CsvTable cells = {};
    std::vector<Place> places = {};
};

/// A map behind the series: coloured fields of equal size in rows and columns, with a scale of the
/// colours.
struct ChartMap {
    QString label = {};              ///< label of the scale
    ChartSpan across = {}, up = {};  ///< middles of the first and the last fields
    std::size_t columns = 1;         ///< number of fields in a row
    std::vector<double> values = {}; ///< row by row, the lowest first; NaN: no colour
    std::function<QString(double place, double value)> text = {}; ///< text for the mouse
};

/// A chart over one axis as a value: its drawn objects, legend, readings and table.
struct LineChart {
    ChartAxis across = {}, up = {}, second = {};
    bool isLying = false;  ///< places downwards, values to the right, the second axis at the top
    bool isFramed = false; ///< also lines at the top and on the right
    QStringList headings = {}; ///< above the cell: the usual one, then shorter ones for less room
    std::vector<Band> bands = {}; ///< behind everything
    bool namesBands = false;      ///< above the cell, if it has bands
    std::vector<ChartSeries> series = {};
    std::vector<ChartZone> zones = {}; ///< drawn behind the series, listed after them in the legend
    std::vector<ChartRule> rules = {}; ///< last in the legend
    std::vector<ChartReading> readings = {};
    ChartSpan readSpan = {};                       ///< range of the cursors
    std::function<ChartTable()> table = {};        ///< empty: nothing to copy
    std::function<QString(double)> placeText = {}; ///< text for the mouse at a place …
    /// … or for the nearest point of the first series, if it is within `reach` [px].
    std::function<QString(std::size_t series, std::size_t point)> pointText = {};
    std::size_t pointed = 0;
    double reach = 8;
    std::optional<ChartMap> map = {};
    double perValue = 0; ///< the second axis has the values times this; 0: its own range

    /// Makes a series readable under a name, along straight lines between its points.
    void read(const ChartSeries& of, const QString& name, Digits digits);
    /// The series with a key of the legend, if it is drawn; for a key of one series.
    [[nodiscard]] const ChartSeries* find(int key) const;
    [[nodiscard]] ChartSpan places() const; ///< range of the places when all is shown
    [[nodiscard]] ChartSpan values(bool onSecond = false) const;
};

/// Charts in cells, row by row, that share the range of their places. One legend and one set of
/// cursors are for all; the first chart has the table of all.
struct ChartGrid {
    std::vector<LineChart> cells = {};
    std::size_t columns = 1;
    QString caption = {};      ///< below all cells
    bool sharesValues = false; ///< a row shares its values, and only outer axes have numbers
};

} // namespace sparkout
