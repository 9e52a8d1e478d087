// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/hideable.h"

#include "core/project/conditions.h"
#include "core/text.h"

namespace sparkout {

bool isView(Hideable thing) {
    return thing < Hideable::verdict;
}

std::optional<Hideable> viewNamed(std::string_view key) {
    const auto choices = choicesOf<Hideable>();
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (key == choices[i].key && isView(static_cast<Hideable>(i))) {
            return static_cast<Hideable>(i);
        }
    }
    return std::nullopt;
}

template <>
std::span<const Choice> choicesOf<Hideable>() {
    static constexpr std::array choices{
        Choice{"overview", SPARKOUT_NOOP("Choice", "Overview")},
        Choice{"feeds", SPARKOUT_NOOP("Choice", "Feeds by stage")},
        Choice{"profiles", SPARKOUT_NOOP("Choice", "Profiles")},
        Choice{"constraints", SPARKOUT_NOOP("Choice", "Constraints")},
        Choice{"compliance", SPARKOUT_NOOP("Choice", "Compliance")},
        Choice{"layers", SPARKOUT_NOOP("Choice", "Layers")},
        Choice{"batch", SPARKOUT_NOOP("Choice", "Batch")},
        Choice{"sweep", SPARKOUT_NOOP("Choice", "Sweep")},
        Choice{"optimise", SPARKOUT_NOOP("Choice", "Optimise")},
        Choice{"compare", SPARKOUT_NOOP("Choice", "Compare")},
        Choice{"measured", SPARKOUT_NOOP("Choice", "Measurements")},
        Choice{"verdict", SPARKOUT_NOOP("Choice", "Verdict")},
        Choice{"remedies", SPARKOUT_NOOP("Choice", "Remedies")},
        Choice{"formulas", SPARKOUT_NOOP("Choice", "Formulas of the step")},
        Choice{"messages", SPARKOUT_NOOP("Choice", "Messages")},
        Choice{"kept_runs", SPARKOUT_NOOP("Choice", "Kept runs")},
        Choice{"calibrate", SPARKOUT_NOOP("Choice", "Calibrate from measurements")},
        Choice{"examples", SPARKOUT_NOOP("Choice", "Examples")},
        Choice{"reports", SPARKOUT_NOOP("Choice", "Reports")},
        Choice{"export_results", SPARKOUT_NOOP("Choice", "Export results")},
        Choice{"batch_indices", SPARKOUT_NOOP("Choice", "Interval and indices of the batch")},
    };
    static_assert(choices.size() == static_cast<std::size_t>(Hideable::count_));
    return choices;
}

template <>
const StructInfo& tableOf<HiddenThing>() {
    static const std::array rows{
        SPARKOUT_FIELD(HiddenThing, name, .label = SPARKOUT_NOOP("Input", "Name"),
                       .required = conditions::always,
                       .hint = SPARKOUT_NOOP(
                           "Input", "A view by its name for `--view`, or a panel or command.")),
    };
    static const StructInfo info =
        makeTable<HiddenThing>(SPARKOUT_NOOP("Struct", "Hidden parts"), rows);
    return info;
}

} // namespace sparkout
