// SPDX-License-Identifier: GPL-3.0-or-later
// Set-ups of several surfaces for the tests of the window.
#pragma once

#include "core/setup/setup_file.h"
#include "core/study/new_project.h"
#include "tests/whole_project.h"

#include <QByteArray>
#include <QFile>
#include <QString>

namespace sparkout::setup_fixtures {

/// A shaft of three steps, a surface on each of them; the last one turns slower.
inline sparkout::Setup steppedShaft() {
    Setup setup;
    const char* const names[] = {"Journal A", "Seat", "Journal B"};
    Project project = newProject(Operation::traverse);
    const double length_mm = project.part->length_mm;
    const double diameter_mm = project.part->diameter_mm;
    project.part->shaft.segments = {
        {length_mm + 4, diameter_mm}, {length_mm, diameter_mm + 6}, {length_mm, diameter_mm}};
    project.machine->compliance_mm_per_n = {};
    project.machine->stiffness_n_um = Stiffness{};
    for (int i = 0; i < 3; ++i) {
        Project surface = project;
        surface.part->shaft.ground_from_mm = i == 0 ? 0 : 4 + i * length_mm;
        surface.part->diameter_mm = project.part->shaft.segments[std::size_t(i)].diameter_mm;
        if (i == 0) { // the seat between the journals has a shoulder on both sides
            surface.machine->overrun_exit_mm = 4;
        } else if (i == 2) {
            surface.machine->overrun_entry_mm = 0;
        }
        setup.surfaces.push_back({names[i], std::move(surface)});
    }
    setup.surfaces.back().project.machine->work_speed_rpm -= 20;
    setup.wear.dulling_per_mm2 = 1e-4;
    setup.wear.grinding_ratio = 20;
    return setup;
}

/// The same in a file.
inline void writeSetupFile(const sparkout::Setup& setup, const QString& path) {
    QFile file(path);
    if (file.open(QIODevice::WriteOnly)) {
        file.write(QByteArray::fromStdString(sparkout::writeSetup(setup)));
    }
}

} // namespace sparkout::setup_fixtures
