// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/hideable.h"

#include "core/project/conditions.h"

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
        Choice{"overview", "Overview"},
        Choice{"feeds", "Feeds by stage"},
        Choice{"profiles", "Profiles"},
        Choice{"constraints", "Constraints"},
        Choice{"compliance", "Compliance"},
        Choice{"layers", "Layers"},
        Choice{"batch", "Batch"},
        Choice{"sweep", "Sweep"},
        Choice{"optimise", "Optimise"},
        Choice{"compare", "Compare"},
        Choice{"measured", "Measurements"},
        Choice{"verdict", "Verdict"},
        Choice{"remedies", "Remedies"},
        Choice{"formulas", "Formulas of the step"},
        Choice{"messages", "Messages"},
        Choice{"kept_runs", "Kept runs"},
        Choice{"calibrate", "Calibrate from measurements"},
        Choice{"examples", "Examples"},
        Choice{"reports", "Reports"},
        Choice{"export_results", "Export results"},
    };
    static_assert(choices.size() == static_cast<std::size_t>(Hideable::count_));
    return choices;
}

template <>
const StructInfo& tableOf<HiddenThing>() {
    static const std::array rows{
        SPARKOUT_FIELD(HiddenThing, name, .label = "Name", .required = conditions::always,
                       .hint = "A view by its name for `--view`, or a panel or command."),
    };
    static const StructInfo info = makeTable<HiddenThing>("What is hidden", rows);
    return info;
}

} // namespace sparkout
