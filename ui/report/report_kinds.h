// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/dressing_interval.h"
#include "core/setup/setup.h"
#include "core/setup/setup_run.h"
#include "core/study/outcome.h"
#include "ui/report/course_handout.h"
#include "ui/report/format/report.h"
#include "ui/session/settings.h"
#include "ui/session/studies.h"

#include <QByteArray>

#include <functional>
#include <memory>
#include <optional>
#include <span>

/// The kinds of reports, each described once in a table for command line and menus.
namespace sparkout::report {

enum class Kind { card, passport, handout, operationCard, sketch };

/// A set-up that was run.
struct SetupSubject {
    Setup setup;
    SetupRun run;
};

/// A set-up whose wheel wears, and its number of parts between dressings.
struct DressingSubject {
    Setup setup;
    DressingInterval interval;
};
using DressingSubjectPtr = std::shared_ptr<const DressingSubject>;

/// The subject of a report.
struct Subject {
    OutcomePtr outcome;    ///< outcome of a valid run
    BatchOutcomePtr batch; ///< completed, of the same inputs, if the kind uses one; may be null
    BatchOutcomePtr
        predicting;   ///< completed, for the measurements of the outcome's project; may be null
    OutcomePtr worst; ///< run of the batch's worst part, if there is a batch
    QString file;     ///< path of the project; may be empty
    /// The surface of the outcome in a part with several; otherwise empty.
    QString surface;
    /// That surface as the value of --surface.
    QString surfaceOption;
    QByteArray inputs; ///< text of the set-up; empty: the inputs are those of the outcome
    QDate date;
    std::shared_ptr<const SetupSubject> setup; ///< null: the outcome alone
    DressingSubjectPtr dressing;           ///< of the set-up, if the kind uses a batch; may be null
    Company company;                       ///< for the heads
    HandoutOptions handout;                ///< options of the course hand-out
    std::function<void()> breathe = [] {}; ///< called between figures, to keep a window responsive
};

struct KindRow {
    Kind kind;
    const char* key;  ///< key on the command line, described in the manual
    const char* menu; ///< menu text, translated in the context ReportKind
    bool judgesBatch; ///< includes the verdict for the batch and by measured parts, if there are
    bool takesBatch;  ///< covers batches and wheels, if there are any
    bool takesSetup;  ///< covers all surfaces of a set-up
    Report (*make)(const Subject& subject);
};

[[nodiscard]] std::span<const KindRow> kinds(); ///< in the order of the menus
[[nodiscard]] const KindRow& rowOf(Kind kind);
[[nodiscard]] std::optional<Kind> kindOf(const QString& key);
[[nodiscard]] QString menuText(Kind kind); ///< text with its mnemonic

/// Names the reported surface of a set-up with several, all of which become the inputs.
void nameSurface(Subject& subject, const Setup& setup, std::size_t surface);

/// An outcome as a set-up with one surface.
[[nodiscard]] SetupSubject setupOf(const Outcome& outcome);

/// Computes the parts between dressings for the current set-up; null if its wheel does not wear.
[[nodiscard]] DressingSubjectPtr dressingOf(const Setup& setup);

/// Runs the part of the batch with the least margin as a single cycle.
[[nodiscard]] OutcomePtr runWorstPart(const BatchOutcome& batch);

} // namespace sparkout::report
