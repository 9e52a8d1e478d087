// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/balance.h"

#include "core/text.h"

#include <cmath>

namespace sparkout {

namespace {

/// Shows the one of the three states that follows from the lag.
FormulaSheet thresholdSheet(const Project& project, const Cutting& cutting, double b, double gamma,
                            double h) {
    const double K = cutting.law.ks, F0 = cutting.law.kr;
    const double A = 1 + gamma * (b * K), C = gamma * (b * F0);
    FormulaSheet sheet{SPARKOUT_NOOP("Formula", "Elastic balance"), "MODEL-3", {}};
    stateContact(&sheet, project, cutting);
    stateNormal(&sheet, project, cutting);
    const FormulaTerm lag{"h", h, "mm"}, most{"h_0", C, "mm"};
    state(&sheet, "{h_0} = {γ}·{b}·{F′_0}", most,
          {{"γ", gamma, "mm/N"}, {"b", b, "mm"}, {"F′_0", F0, "N/mm"}});
    if (!(h > C)) {
        state(&sheet, "{P_y} = {h}/{γ}", {"P_y", gamma > 0 ? h / gamma : 0, "N"},
              {lag, {"γ", gamma, "mm/N"}});
        state(&sheet, "{a}", {"a", 0, "mm"}, {});
        state(&sheet, "{γ·P_y} = {h}", {"γ·P_y", h, "mm"}, {lag});
        return sheet;
    }
    const double a = (h - C) / A;
    state(&sheet, "{A} = 1 + {γ}·{b}·{K}", {"A", A, ""},
          {{"γ", gamma, "mm/N"}, {"b", b, "mm"}, {"K", K, "MPa"}});
    state(&sheet, "{P_y} = {b}·({F′_0} + {K}·({h} − {h_0})/{A})", {"P_y", b * (F0 + K * a), "N"},
          {{"b", b, "mm"}, {"F′_0", F0, "N/mm"}, {"K", K, "MPa"}, lag, most, {"A", A, ""}});
    state(&sheet, "{a} = ({h} − {h_0})/{A}", {"a", a, "mm"}, {lag, most, {"A", A, ""}});
    state(&sheet, "{γ·P_y} = {h} − {a}", {"γ·P_y", h - a, "mm"}, {lag, {"a", a, "mm"}});
    return sheet;
}

} // namespace

FormulaSheet balanceSheet(const Project& project, double b, double gamma, double h) {
    const Cutting cutting = cuttingOf(project);
    if (cutting.law.threshold) {
        return thresholdSheet(project, cutting, b, gamma, h);
    }
    const double ks = cutting.law.ks, kr = cutting.law.kr;
    // The root in the form printed below: a pass uses a quicker form which, with a dull wheel, has
    // an error of some hundred roundings.
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
