// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/requirement_list.h"

#include "core/quality/result_names.h"

#include <limits>

namespace sparkout::python {

namespace py = pybind11;

py::list requirementList(const std::vector<ConstraintResult>& constraints) {
    using namespace py::literals;
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    py::list list;
    for (const ConstraintResult& each : constraints) {
        const bool isKnown = each.isWhole && isComputed(each);
        list.append(py::dict("name"_a = requirementOf(each.kind).key, "where"_a = whereText(each),
                             "unit"_a = requirementOf(each.kind).unit, "holds"_a = each.holds,
                             "value"_a = isKnown ? each.value : none, "limit"_a = each.limit,
                             "margin"_a = isKnown ? each.margin : none,
                             "machine_known"_a = each.knowsMachine));
    }
    return list;
}

} // namespace sparkout::python
