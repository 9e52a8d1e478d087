// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/quality/constraints.h"
#include "core/simulation/progress.h"
#include "core/simulation/result.h"

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
    /// The meaning of a step E1…E5 in a zone: "plunge-in", "entry dwell", "working stroke", …
    static QString stepMeaning(Zone zone, Step step);
    /// A moment of the cycle: "After double stroke 27 of 54", or within it; before the first one.
    static QString moment(Operation operation, int stroke, int count, bool strokeDone);
    /// "RZ1, plunge-in (E1), stage 2, double stroke 27".
    static QString place(const Place& place, Operation operation);
    /// The moment without the zone or section, for a table that names it already.
    static QString moment(const Place& place, Operation operation);
    static QString status(RunStatus status);
    static QString constraint(ConstraintKind kind);      ///< "Maximum diameter"
    static QString constraintBrief(ConstraintKind kind); ///< "Max. diameter"
    /// A name within a sentence, in lower case; a symbol such as Ra is unchanged.
    static QString inSentence(QString name);
    /// A place within a sentence or after a comma: in Russian in lower case.
    static QString within(const QString& place);
    /// The scope of a result: "RZ1", "whole part", "stage 2", "cycle".
    static QString where(const ConstraintResult& constraint);
    /// A value, limit or margin in the unit of its kind, given by its row.
    static QString amount(ConstraintKind kind, double value, bool withSign);
    static QString limit(const ConstraintResult& c); ///< for a range "≥50" or "≤500"
    static bool isRange(ConstraintKind kind);        ///< range of the machine, with two ends
    /// "0.3…0.9": the interval of an estimate.
    static QString estimate(double least, double most);
    /// The value of a result: "0.54"; "≥ 0.54" where the machine's own form is not known; a dash
    /// where a part of the surface was not cut.
    static QString value(const ConstraintResult& c);
    /// The margin: "+1.25"; "≤ 5.46" beside a lower bound; a dash where it is not known. That of a
    /// setting is a ratio without a unit: "2×" is twice the lower end of its range, or half of the
    /// upper one; for an end at 0, whether it is inside.
    static QString margin(const ConstraintResult& c);
    static QString issue(const Issue& issue); ///< the sentence after its place
    /// A remark that strips stay uncut in a traverse cycle; otherwise empty.
    static QString uncutStrips(const Project& project);
    /// A quantity of form, "roundness, machine not known" if the machine's own error is not
    /// included.
    static QString ofMachine(const QString& quantity, bool isKnown);
    /// The value of such a quantity: `amountFixed`, or, without the machine's own error, "≥ 0.54",
    /// at least what the process leaves, and a dash if that rounds to 0.
    static QString formAmount(double value, bool isKnown, int decimals = 2);
    /// The waviness, "waviness, waves not known" if the wheel's runout is not given or not
    /// resolved.
    static QString ofWheel(const QString& quantity, bool isKnown);
    /// The first `most` errors of a refused input, each on its own line.
    static QString refusal(const Issues& issues, int most = 3);
    /// Whether missing inputs are the only errors.
    static bool incomplete(const Issues& issues);
    static QString missingLinks(const Issues& issues); ///< links to their paths, as markup

    /// With this number of decimals, in the current locale, with a typographic minus; never −0.
    static QString fixed(double value, int decimals);
    /// A non-negative amount: "< 0.01" for a small amount that would read 0.00.
    static QString amountFixed(double value, int decimals);
    static QString micrometres(double value_um);              ///< 2 decimals, current locale
    static QString signedMicrometres(double value_um);        ///< with its sign
    static QString millimetres(double value_mm);              ///< 4 decimals
    static QString significant(double value, int digits = 3); ///< never "1e-15"
    /// The time of a cycle with its unit: "24.3 s" below two minutes, otherwise "2.54 min".
    static QString time(double time_s, int digits = 3);
    static QString timeOfMinutes(double time_min, int digits = 3); ///< from minutes
};

} // namespace sparkout
