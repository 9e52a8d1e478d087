// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dressing/dressing_interval.h"
#include "core/setup/setup.h"
#include "core/setup/setup_run.h"
#include "core/study/outcome.h"
#include "ui/report/format/report.h"
#include "ui/report/handout/course_handout.h"
#include "ui/session/company.h"
#include "ui/session/studies.h"

#include <functional>
#include <memory>
#include <optional>
#include <span>

/// The kinds of reports, each described once: command line and menus go by this table.
namespace sparkout::report {

enum class Kind { card, passport, handout, operationCard, sketch };

/// A set-up that was run.
struct SetupSubject {
    Setup setup;
    SetupRun run;
};

/// A set-up whose wheel wears, and how many parts it grinds.
struct DressingSubject {
    Setup setup;
    DressingInterval interval;
};
using DressingSubjectPtr = std::shared_ptr<const DressingSubject>;

/// What is reported.
struct Subject {
    OutcomePtr outcome;    ///< of a run that ran
    BatchOutcomePtr batch; ///< of the same inputs, run whole, for a kind that takes one; or null
    BatchOutcomePtr
        predicting;   ///< run whole, of what was measured of the outcome's project; or null
    OutcomePtr worst; ///< run of the batch's worst part, beside a batch
    QString file;     ///< path of the project, or empty
    /// Of a part of several surfaces: the one of the outcome; empty: there is no other.
    QString surface;
    /// That surface, as the option --surface names it.
    QString surfaceOption;
    QDate date;
    std::shared_ptr<const SetupSubject> setup; ///< null: the outcome alone
    DressingSubjectPtr dressing; ///< of the set-up, for a kind that takes a batch; or null
    Company company;             ///< of the heads
    HandoutOptions handout;      ///< what the course hand-out is to have
    std::function<void()> breathe = [] {}; ///< called between figures, so that a window may live
};

struct KindRow {
    Kind kind;
    const char* key;  ///< on the command line, whose manual says what it is
    const char* menu; ///< its menu, to be translated in the context ReportKind
    bool judgesBatch; ///< it says how the cycle stands for the batch, where there is one
    bool takesBatch;  ///< it is about batches and wheels, where there are such
    bool takesSetup;  ///< it is about all surfaces of a set-up
    Report (*make)(const Subject& subject);
};

[[nodiscard]] std::span<const KindRow> kinds(); ///< in the order of the menus
[[nodiscard]] const KindRow& rowOf(Kind kind);
[[nodiscard]] std::optional<Kind> kindOf(const QString& key);
[[nodiscard]] QString menuText(Kind kind); ///< with its mnemonic

/// States which of the surfaces of a set-up is reported, where there are several.
void nameSurface(Subject& subject, const Setup& setup, std::size_t surface);

/// An outcome as the set-up of its one surface.
[[nodiscard]] SetupSubject setupOf(const Outcome& outcome);

/// Runs the parts between dressings of a set-up, as they stand; null: its wheel does not wear.
[[nodiscard]] DressingSubjectPtr dressingOf(const Setup& setup);

/// Runs the part of the batch with the least margin as a cycle of its own.
[[nodiscard]] OutcomePtr runWorstPart(const BatchOutcome& batch);

} // namespace sparkout::report
