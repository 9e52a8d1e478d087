// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/requirement_outputs.h"

#include "core/quality/result_names.h"

namespace sparkout {

namespace {

/// Empty where strips stay uncut.
std::optional<double> ofWhole(const ConstraintResult& c, double value) {
    return c.isWhole ? std::optional(value) : std::nullopt;
}

constexpr Output<ConstraintResult> requirementTable[] = {
    {{.key = "name"},
     [](const ConstraintResult& c) { return std::string(requirementOf(c.kind).key); }},
    {{.key = "unit", .hint = "of limit, value and margin; empty for a plain number"},
     [](const ConstraintResult& c) { return std::string(requirementOf(c.kind).unit); }},
    {{.key = "limit"}, [](const ConstraintResult& c) { return c.limit; }},
    {{.key = "value", .hint = "null where strips stay uncut"},
     [](const ConstraintResult& c) { return ofWhole(c, c.value); }},
    {{.key = "value_most",
      .hint = "of an estimate, which lies between the value and this; else it is not there"},
     [](const ConstraintResult& c) { return ofWhole(c, c.mostValue.value_or(c.value)); },
     nullptr,
     [](const ConstraintResult& c) { return c.mostValue.has_value(); }},
    {{.key = "margin", .hint = "positive when it holds; null where strips stay uncut"},
     [](const ConstraintResult& c) { return ofWhole(c, c.margin); }},
    {{.key = "relative_margin",
      .hint = "the margin over the width of the field or range, or over the limit"},
     [](const ConstraintResult& c) { return ofWhole(c, c.relativeMargin); }},
    {{.key = "where"}, [](const ConstraintResult& c) { return whereText(c); }},
    {{.key = "ok"}, [](const ConstraintResult& c) { return c.holds; }},
    {{.key = "machine_known",
      .hint = "of roundness, cylindricity and runouts: whether the machine's own form is in the "
              "value, of the waviness whether the wheel's runout is; else it is the model's alone"},
     [](const ConstraintResult& c) { return c.knowsMachine; },
     nullptr,
     [](const ConstraintResult& c) { return isPrinted(c.kind); }},
};

} // namespace

std::span<const Output<ConstraintResult>> requirementOutputs() {
    return requirementTable;
}

} // namespace sparkout
