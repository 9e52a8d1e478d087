// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/balance.h"

#include "core/text.h"

#include <cmath>

namespace sparkout {

FormulaSheet balanceSheet(const Project& project, double b, double gamma, double h) {
    const Cutting cutting = cuttingOf(project);
    const double ks = cutting.law.ks, kr = cutting.law.kr;
    // The root as it is written below: a pass takes a form that is quicker and, with a dull wheel,
    // some hundred roundings less exact.
    const double A = 1 + gamma * (b * ks), C = gamma * (b * kr);
    const double u = h > 0 ? 2 * h / (C + std::sqrt(C * C + 4 * A * h)) : 0;
    const double a = u * u, Py = b * (ks * u * u + kr * u);

    FormulaSheet sheet{SPARKOUT_NOOP("Formula", "Elastic balance"), "MODEL-3", {}};
    stateContact(&sheet, project, cutting);
    stateNormal(&sheet, project, cutting);
    state(&sheet, "{A} = 1 + {γ}·{b}·{k_s}", {"A", A, ""},
          {{"γ", gamma, "mm/N"}, {"b", b, "mm"}, {"k_s", ks, "MPa"}});
    state(&sheet, "{C} = {γ}·{b}·{k_r}", {"C", C, "mm^0.5"},
          {{"γ", gamma, "mm/N"}, {"b", b, "mm"}, {"k_r", kr, "N/mm^1.5"}});
    state(&sheet, "{√a} = 2·{h}/({C} + √({C}² + 4·{A}·{h}))", {"√a", u, "mm^0.5"},
          {{"h", h, "mm"}, {"C", C, "mm^0.5"}, {"A", A, ""}});
    state(&sheet, "{P_y} = {b}·({k_s}·{√a}² + {k_r}·{√a})", {"P_y", Py, "N"},
          {{"b", b, "mm"}, {"k_s", ks, "MPa"}, {"√a", u, "mm^0.5"}, {"k_r", kr, "N/mm^1.5"}});
    state(&sheet, "{a} = {√a}²", {"a", a, "mm"}, {{"√a", u, "mm^0.5"}});
    state(&sheet, "{γ·P_y} = {h} − {a}", {"γ·P_y", h - a, "mm"}, {{"h", h, "mm"}, {"a", a, "mm"}});
    return sheet;
}

} // namespace sparkout
