// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report_kinds.h"

#include "core/batch/scenario_source.h"
#include "core/project/part.h"
#include "core/units.h"
#include "ui/report/card_rows.h"
#include "ui/report/cycle_card.h"
#include "ui/report/operation_card_report.h"
#include "ui/report/passport.h"
#include "ui/session/kept_texts.h"
#include "ui/session/project_io.h"
#include "ui/text/texts.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace sparkout::report {

namespace {

/// Puts the company before the other facts of a report's head.
Report withCompany(Report report, const Company& company) {
    const auto head = std::ranges::find_if(
        report.blocks, [](const Block& block) { return std::holds_alternative<Facts>(block); });
    if (head != report.blocks.end()) {
        std::vector<std::pair<QString, QString>> facts;
        const CompanyTexts& texts = company;
        for (const Field& field : tableOf<CompanyTexts>().fields) {
            if (const QString text = textIn(field, &texts); !text.isEmpty()) {
                facts.emplace_back(inputText(field.label), text);
            }
        }
        auto& all = std::get<Facts>(*head).facts;
        all.insert(all.begin(), facts.begin(), facts.end());
    }
    return report;
}

/// The report of one surface with the set-up as its inputs.
Report withInputs(Report report, const Subject& subject) {
    if (!subject.inputs.isEmpty()) {
        report.inputs = subject.inputs;
    }
    return report;
}

/// Puts the surface first in the head of a report and in the line at the top of pages.
Report withSurface(Report report, const Subject& subject) {
    const auto head = std::ranges::find_if(
        report.blocks, [](const Block& block) { return std::holds_alternative<Facts>(block); });
    if (subject.surface.isEmpty() || head == report.blocks.end()) {
        return report;
    }
    auto& all = std::get<Facts>(*head).facts;
    all.insert(all.begin(),
               {QCoreApplication::translate("Report", "Surface of the part"), subject.surface});
    report.subject += (report.subject.isEmpty() ? QString() : QStringLiteral(" · "))
                      + QCoreApplication::translate("Report", "surface %1").arg(subject.surface);
    return report;
}

/// The company with the project's own numbers.
Company companyOf(const Subject& subject) {
    return subject.company.with(*subject.outcome->result.project.card);
}

Report makeCard(const Subject& subject) {
    Report card = CycleCard::write(subject.outcome, subject.file, subject.date, subject.batch,
                                   subject.predicting);
    return withCompany(withSurface(withInputs(std::move(card), subject), subject),
                       companyOf(subject));
}

Report makePassport(const Subject& subject) {
    return withCompany(withSurface(withInputs(passport(subject), subject), subject),
                       companyOf(subject));
}

Report makeHandout(const Subject& subject) {
    return withInputs(courseHandout(subject.outcome, subject.file, subject.date, subject.handout,
                                    subject.breathe),
                      subject);
}

Report makeOperationCard(const Subject& subject) {
    const SetupSubject of = subject.setup ? *subject.setup : setupOf(*subject.outcome);
    return OperationCardReport::write(of.setup, of.run, subject.company, subject.file,
                                      subject.date);
}

Report makeSketch(const Subject& subject) {
    const SetupSubject of = subject.setup ? *subject.setup : setupOf(*subject.outcome);
    return OperationCardReport::sketch(of.setup, subject.company, subject.file, subject.date);
}

constexpr std::array allKinds{
    KindRow{Kind::card, "card", QT_TRANSLATE_NOOP("ReportKind", "Cycle car&d"), true, false, false,
            makeCard},
    KindRow{Kind::passport, "passport", QT_TRANSLATE_NOOP("ReportKind", "Accuracy &passport"), true,
            true, false, makePassport},
    KindRow{Kind::handout, "handout", QT_TRANSLATE_NOOP("ReportKind", "Course &hand-out"), false,
            false, false, makeHandout},
    KindRow{Kind::operationCard, "operation-card",
            QT_TRANSLATE_NOOP("ReportKind", "&Operation card"), false, false, true,
            makeOperationCard},
    KindRow{Kind::sketch, "sketch-sheet", QT_TRANSLATE_NOOP("ReportKind", "S&ketch sheet"), false,
            false, true, makeSketch},
};

} // namespace

std::span<const KindRow> kinds() {
    return allKinds;
}

const KindRow& rowOf(Kind kind) {
    return *std::ranges::find(allKinds, kind, &KindRow::kind);
}

std::optional<Kind> kindOf(const QString& key) {
    const auto row = std::ranges::find_if(
        allKinds, [&key](const KindRow& r) { return key == QLatin1StringView(r.key); });
    return row == allKinds.end() ? std::nullopt : std::optional(row->kind);
}

QString menuText(Kind kind) {
    return QCoreApplication::translate("ReportKind", rowOf(kind).menu);
}

void nameSurface(Subject& subject, const Setup& setup, std::size_t surface) {
    subject.inputs = inputsText(setup);
    if (setup.surfaces.size() < 2) {
        return;
    }
    subject.surface = CardRows::surfaceName(setup, surface);
    const std::string number = std::to_string(surface + 1);
    // A number is the simplest option for a shell; the name is used only if another surface has
    // that number as its name.
    subject.surfaceOption =
        setup.find(number) == surface
            ? QString::fromStdString(number)
            : u'"' + QString::fromStdString(setup.surfaces[surface].name) + u'"';
}

SetupSubject setupOf(const Outcome& outcome) {
    SetupSubject of;
    of.setup.surfaces = {GroundSurface{{}, outcome.result.project}};
    of.run.surfaces = {
        SurfaceRun{{}, outcome.result, outcome.constraints, outcome.shop.cycle.removedVolume_mm3}};
    if (of.run.isCompleted(of.setup)) {
        of.run.time = pieceTime(of.setup.times, 1, outcome.result.time_s / units::secondsPerMinute);
    }
    return of;
}

OutcomePtr runWorstPart(const BatchOutcome& batch) {
    const ScenarioSource source(batch.result.project);
    return evaluate(source.project(batch.summary.worstPart), {});
}

DressingSubjectPtr dressingOf(const Setup& setup) {
    if (!setup.wear.isGiven()) {
        return nullptr;
    }
    DressingOptions options;
    options.most = 2000; // keeps the report quick
    return std::make_shared<DressingSubject>(
        DressingSubject{setup, dressingInterval(setup, options)});
}

} // namespace sparkout::report
