// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/quality/constraints.h"
#include "core/simulation/result.h"
#include "core/simulation/stroke_step.h"

#include <QCoreApplication>
#include <QString>

#include <cstdint>

namespace sparkout {

/// The translated names and number forms that every view uses, in one place.
class Names {
    Q_DECLARE_TR_FUNCTIONS(Names)
public:
    static QString zone(Zone zone,
                        int section = 0);                ///< "RZ1", or "Section 1" for section 0
    static QString zoneFull(Zone zone, int section = 0); ///< "Entry reversal zone RZ1"
    /// The number of a part of a batch, "1" for part 0.
    static QString part(std::int64_t part);
    static QString step(Step step); ///< "E1"; empty for none
    /// What a step E1…E5 is in a zone: "plunge-in", "entry dwell", "working stroke", …
    static QString stepMeaning(Zone zone, Step step);
    /// Of the cycle: "After double stroke 27 of 54", or within it; before the first one.
    static QString moment(Operation operation, int stroke, int count, bool strokeDone);
    static QString place(const Place& place, Operation operation);
    /// The same without the zone or section, for a table that names it already.
    static QString moment(const Place& place, Operation operation);
    static QString status(RunStatus status);
    static QString constraint(ConstraintKind kind);      ///< "Maximum diameter"
    static QString constraintBrief(ConstraintKind kind); ///< "Max. diameter"
    /// A name as it stands within a sentence; a symbol, as Ra, stays.
    static QString inSentence(QString name);
    /// A place within a sentence or after a comma: Russian has a small letter there.
    static QString within(const QString& place);
    /// What it is held against: "RZ1", "whole part", "stage 2", "cycle".
    static QString where(const ConstraintResult& constraint);
    /// A value, limit or margin in the unit of its kind, which its row names.
    static QString amount(ConstraintKind kind, double value, bool withSign);
    static QString limit(const ConstraintResult& c); ///< of a range "≥50" or "≤500"
    static bool isRange(ConstraintKind kind);        ///< of the machine: with two ends
    /// A setting against the nearer end of its range: "2 × lower limit"; brief "2× min". Of a
    /// range from 0, whose end is no measure, whether it is inside.
    static QString inRange(const ConstraintResult& c, bool brief);
    /// "0.3…0.9": what an estimate lies between.
    static QString estimate(double least, double most);
    /// Of a result: "0.54", "≥ 0.54" where the machine's own form is not known; a dash where it is
    /// not of the whole surface.
    static QString value(const ConstraintResult& c);
    /// "+1.25", "≤ 5.46" beside a lower bound, of a range as inRange(); a dash where it is not
    /// known.
    static QString margin(const ConstraintResult& c);
    /// The margin in a column next to that of the limit, which says the end of a range: "2×",
    /// as many times a lower limit, or as far from an upper one.
    static QString besideLimit(const ConstraintResult& c);
    static QString issue(const Issue& issue); ///< the sentence after its place in words
    /// That the cut surface of a traverse cycle is not whole, as strips stay uncut; else empty.
    static QString uncutStrips(const Project& project);
    /// A quantity of the form, "roundness, machine not known" where the machine's own is not in it.
    static QString ofMachine(const QString& quantity, bool isKnown);
    /// The first errors of a refused input, at most `most` of them, one a line.
    static QString refusal(const Issues& issues, int most = 3);
    /// Whether nothing is wrong but that inputs are missing.
    static bool incomplete(const Issues& issues);
    static QString missingLinks(const Issues& issues); ///< to their paths, with markup

    /// Of so many decimals, in the current locale, with a true minus; never −0.
    static QString fixed(double value, int decimals);
    /// The same of an amount that is not negative: "< 0.01" for a little that would read 0.00.
    static QString amountFixed(double value, int decimals);
    static QString micrometres(double value_um);              ///< 2 decimals, current locale
    static QString signedMicrometres(double value_um);        ///< the same, with its sign
    static QString millimetres(double value_mm);              ///< 4 decimals
    static QString significant(double value, int digits = 3); ///< never "1e-15"
    /// Of a cycle, with its unit: "24.3 s" below two minutes, else "2.54 min".
    static QString time(double time_s, int digits = 3);
    static QString timeOfMinutes(double time_min, int digits = 3); ///< the same
};

} // namespace sparkout
