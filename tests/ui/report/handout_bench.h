// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/support/languages.h"
#include "tests/ui/support/view_fixtures.h"
#include "ui/report/course_handout.h"
#include "ui/report/format/report_text.h"
#include "ui/session/document.h"
#include "ui/text/language.h"
#include "ui/window/dialogs/examples_dialog.h"

#include <QDate>
#include <QFileInfo>
#include <QTest>

#include <variant>
#include <vector>

/// The course hand-out of the examples, and what stands in it.
namespace sparkout::handout_bench {

using report::Format;
using report::Formula;
using report::HandoutOptions;
using report::HandoutView;
using report::Report;

inline const QDate today(2026, 11, 22);

inline OutcomePtr exampleOutcome(const QString& path) {
    Document document;
    return hasErrors(document.openCopy(ExamplesDialog::textOf(path)))
               ? nullptr
               : evaluate(document.project(), {});
}

/// With everything that limits the feed.
inline Project fullProject(Project project) {
    project.part->tolerance.roughness_ra_um = 0.4;
    project.wheel->roughness_factor = 2;
    project.material->burn_rise_k = 700;
    project.machine->wheel_drive_kw = 7.5;
    project.machine->work_drive_kw = 1;
    project.wheel->grain_surface_energy_j_m2 = 18;
    project.wheel->grain_modulus_gpa = 390;
    project.wheel->bond_surface_energy_j_m2 = 4;
    project.wheel->bond_modulus_gpa = 65;
    return project;
}

inline Report handout(const OutcomePtr& outcome, const HandoutOptions& options = {}) {
    return report::courseHandout(outcome, QStringLiteral("/tmp/part.sparkout"), today, options);
}

inline std::vector<Formula> formulasOf(const Report& report) {
    std::vector<Formula> formulas;
    for (const report::Block& block : report.blocks) {
        if (const auto* formula = std::get_if<Formula>(&block)) {
            formulas.push_back(*formula);
        }
    }
    return formulas;
}

inline void addCases(const std::vector<const char*>& languages = {"en", "ru"}) {
    addFilesAndLanguages(ExamplesDialog::paths(), languages);
}

/// The visit of a radius at a place.
inline const Visit* visitOf(const Trajectory& trajectory, const Place& place, int radius) {
    for (const Pass& pass : trajectory.passes) {
        const Place& at = pass.place;
        if (at.zone == place.zone && at.section == place.section && at.stage == place.stage
            && at.step == place.step && at.cycleCount == place.cycleCount
            && at.revolution == place.revolution) {
            return &trajectory.visits[pass.firstVisit + static_cast<std::size_t>(radius)];
        }
    }
    return nullptr;
}

} // namespace sparkout::handout_bench
