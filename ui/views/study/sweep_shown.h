// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/sweep_run.h"
#include "ui/chart/line_chart.h"
#include "ui/chart/view_plot.h"
#include "ui/session/studies.h"
#include "ui/text/shown_scale.h"

#include <QCoreApplication>
#include <QString>

#include <cmath>
#include <functional>
#include <optional>
#include <qcustomplot.h>
#include <string>
#include <vector>

namespace sparkout {

/// Texts of the sweep view about inputs, quantities and points.
class SweepText {
    Q_DECLARE_TR_FUNCTIONS(SweepText)
public:
    static QString input(const std::string& path);      ///< "Wheel › Dullness"
    static QString inputBrief(const std::string& path); ///< "Dullness", "Stage 2 › Spark-out"
    static QString inputAxis(const SweptInput& input);  ///< "Stock per side, mm"
    static QString inputValue(double value, const SweptInput& input); ///< "0.15 mm"

    static QString name(const SweepQuantity& quantity);  ///< "Radial runout"
    static QString where(const SweepQuantity& quantity); ///< "RZ1", "whole part"
    static QString entry(const SweepResult& sweep,
                         const SweepEntry& entry); ///< "Radial runout, RZ1"
    static QString axis(const SweepResult& sweep, const SweepEntry& entry, bool margins);
    static QString column(const SweepQuantity& quantity); ///< with name, place and unit
    static QString status(const SweepPoint& point);       ///< "refused", "does not reach size"

    static QString progress(qint64 done, qint64 points, double left_s);
    static QString run(const SweepResult& sweep); ///< number of points, and their results
    /// The inputs of a point: "Dullness 0.02, Dwell at the entry 0.3 s".
    static QString inputs(const SweepResult& sweep, std::size_t point);
    /// The values of the entry at a point, its time and whether it is fit.
    static QString point(const SweepResult& sweep, std::size_t point, const SweepEntry& entry);

private:
    static QString verdict(const SweepResult& sweep, const SweepPoint& point);
};

/// The position of a value on an axis with equal steps or equal ratios: the axes themselves stay
/// linear, since QCustomPlot's colour maps require that.
struct SweepScale {
    bool ratios = false;
    ShownScale shown = {}; ///< from the value to the displayed number

    [[nodiscard]] double at(double value) const { return ratios ? std::log10(value) : value; }
    [[nodiscard]] double valueAt(double place) const {
        return ratios ? std::pow(10.0, place) : place;
    }
};

/// Ticks at round values of such an axis.
class SweepTicker : public NumberTicker {
public:
    explicit SweepTicker(SweepScale scale) : m_scale(scale) {}

protected:
    QVector<double> createTickVector(double step, const QCPRange& range) override;
    QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override;

private:
    SweepScale m_scale;
};

/// The content of the curves or the map of a sweep: a result over the varied inputs, and the marked
/// points.
struct SweepShown {
    Q_DECLARE_TR_FUNCTIONS(SweepShown)
public:
    /// Keys of the legends; smaller ones are curves.
    enum Key { presentKey = 1000, chosenKey, limitKey, holdsKey, refusedKey, notReachedKey };

    SweepResultPtr result = {};
    SweepEntry entry = {};
    bool margins = false;                            ///< false: values
    std::vector<std::optional<double>> present = {}; ///< current values of the inputs, if given
    std::optional<std::size_t> chosen = {};          ///< index of a point

    [[nodiscard]] bool empty() const { return !result || entry.quantities.empty(); }
    [[nodiscard]] bool isMap() const { return result && result->inputs.size() > 1; }
    [[nodiscard]] SweepScale scaleOf(std::size_t input) const;
    /// The positions of an input's values on the axis, and that of a point.
    [[nodiscard]] std::vector<double> placesOf(std::size_t input) const;
    [[nodiscard]] double placeOf(std::size_t point, std::size_t input) const;
    /// The position of the current value; empty if it is not given, or not positive on an axis of
    /// equal ratios.
    [[nodiscard]] std::optional<double> presentPlace(std::size_t input) const;
    /// Value or margin of a quantity at a point; NaN without a value.
    [[nodiscard]] double shownAt(std::size_t point, std::size_t quantity) const;
    [[nodiscard]] std::size_t pointNear(double across, double up = 0) const; ///< to this position
    [[nodiscard]] QString textOf(std::size_t point) const;

    /// Marks for the points without values, at a given height.
    [[nodiscard]] std::vector<ChartSeries>
    statusMarks(double size, const std::function<double(std::size_t point)>& height) const;

    /// A row for each point that was run: its inputs, its state, the quantities.
    [[nodiscard]] static CsvTable tableOf(const SweepResult& sweep,
                                          const std::vector<std::size_t>& quantities);
    [[nodiscard]] ChartTable table() const; ///< of the shown quantities
};

} // namespace sparkout
