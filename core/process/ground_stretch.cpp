// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/ground_stretch.h"

#include "core/process/system_compliance.h"
#include "core/project/machine.h"
#include "core/project/part.h"

namespace sparkout {

std::vector<Stretch> groundStretches(const Project& project) {
    std::vector<Stretch> stretches;
    const double length = project.part->length_mm;
    if (!project.operation->travels) {
        for (int j = 0; j < project.sections; ++j) {
            stretches.push_back(
                {length * j / project.sections, length * (j + 1) / project.sections});
        }
        return stretches;
    }
    const ZoneLengths zones = zoneLengths(project);
    const double bounds[] = {reliefBehind(project, zones.rz1), zones.rz1, length - zones.rz2,
                             length - reliefBehind(project, zones.rz2)};
    const bool mirrored = project.machine->entry_side == EntrySide::tailstock;
    for (int i = 0; i < 3; ++i) {
        stretches.push_back(mirrored ? Stretch{length - bounds[i + 1], length - bounds[i]}
                                     : Stretch{bounds[i], bounds[i + 1]});
    }
    return stretches;
}

} // namespace sparkout
