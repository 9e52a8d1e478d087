// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sweep/sweep_entries.h"
#include "ui/session/studies.h"

#include <QCoreApplication>
#include <QString>

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

} // namespace sparkout
