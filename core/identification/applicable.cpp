// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/applicable.h"

#include "core/identification/scaled_project.h"
#include "core/process/force.h"
#include "core/project/machine.h"
#include "core/project/part.h"

#include <algorithm>
#include <cstddef>

namespace sparkout {

bool areApplicable(const Project& project, const std::vector<FittedParameter>& list) {
    for (std::size_t i = 0; i < list.size(); ++i) {
        const bool twice =
            std::any_of(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(i),
                        [&](const FittedParameter& other) {
                            return other.kind == list[i].kind && other.place == list[i].place;
                        });
        const bool noPlace =
            list[i].place.has_value()
            && (list[i].kind != FittedKind::compliance || !hasPlaceCompliances(project)
                || *list[i].place < 0 || *list[i].place >= placeCount(project));
        const bool measuredForm = list[i].kind == FittedKind::blank_runout
                                  && project.part->profile == ProfileForm::measured;
        const bool threshold = hasThreshold(project);
        const bool notLinear =
            (list[i].kind == FittedKind::alpha || list[i].kind == FittedKind::beta)
            && project.machine->wheel_contact && !threshold;
        const bool notInForce =
            threshold
            && (list[i].kind == FittedKind::flow_stress || list[i].kind == FittedKind::dullness);
        if (twice || noPlace || measuredForm || notLinear || notInForce) {
            return false;
        }
    }
    return true;
}

} // namespace sparkout
