// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/visit_sheet.h"

#include "core/process/coupled_sections.h"
#include "core/process/force.h"
#include "core/process/profile.h"
#include "core/process/system_compliance.h"
#include "core/project/part.h"
#include "core/simulation/progress.h"
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

void append(FormulaSheet& sheet, const FormulaSheet& more) {
    sheet.steps.insert(sheet.steps.end(), more.steps.begin(), more.steps.end());
}

/// The coefficients of the force as named in the sources: K_1 and K_2 with axial feed, K_3 and K_4
/// in plunge [MODEL-2].
void stateCoefficients(FormulaSheet& sheet, const Project& project, const Pass& pass) {
    const ForceLaw law = forceLaw(project);
    if (law.threshold) {
        return; // the sources give none
    }
    const double b = pass.effectiveWidth_mm;
    const bool isPlunge = pass.axialFeed_mm_min == 0;
    const FormulaTerm width{"b", b, "mm"};
    const char* const shear = isPlunge ? "K_3" : "K_1";
    const char* const friction = isPlunge ? "K_4" : "K_2";
    state(&sheet, isPlunge ? "{K_3} = {b}·{k_s}" : "{K_1} = {b}·{k_s}", {shear, b * law.ks, "N/mm"},
          {width, {"k_s", law.ks, "MPa"}});
    state(&sheet, isPlunge ? "{K_4} = {b}·{k_r}" : "{K_2} = {b}·{k_r}",
          {friction, b * law.kr, "N/mm^0.5"}, {width, {"k_r", law.kr, "N/mm^1.5"}});
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

FormulaSheet visitSheet(const SimulationResult& result, const Trajectory& trajectory,
                        std::size_t pass, int radius) {
    const Project& project = result.project;
    const Pass& of = trajectory.passes[pass];
    const Visit& visit = trajectory.visits[of.firstVisit + static_cast<std::size_t>(radius)];
    const bool external = project.part->surface == Surface::external;
    const double side = external ? 1 : -1;
    const double first = makeBlank(*project.part).firstTouchRadius_mm;
    // The wheel cuts in the machine's frame.
    const double a = visit.actual_mm, after = visit.radius_mm + side * visit.printed_mm;
    const double before = after + side * a;
    const double h = visit.programmed_mm + visit.wave_mm - side * (first - before);
    const double b = of.effectiveWidth_mm;

    FormulaSheet sheet{SPARKOUT_NOOP("Formula", "Elastic balance of one radius"), "MODEL-3", {}};
    if (visit.isGap()) { // a gap: no surface
        state(&sheet, "{a}", {"a", 0, "mm"}, {});
        return sheet;
    }
    const FormulaTerm infeed{"t_П", visit.programmed_mm, "mm"};
    const FormulaTerm touch{external ? "R_max0" : "R_min0", first, "mm"};
    const FormulaTerm R{"R_k", before, "mm"};
    if (visit.wave_mm == 0) {
        state(&sheet,
              external ? "{h} = {t_П} − ({R_max0} − {R_k})" : "{h} = {t_П} − ({R_k} − {R_min0})",
              {"h", h, "mm"}, {infeed, touch, R});
    } else {
        state(&sheet,
              external ? "{h} = {t_П} + {w} − ({R_max0} − {R_k})"
                       : "{h} = {t_П} + {w} − ({R_k} − {R_min0})",
              {"h", h, "mm"}, {infeed, {"w", visit.wave_mm, "mm"}, touch, R});
    }
    const bool touches = hasThreshold(project) && visit.normalForce_n > 0;
    if (!(a > 0) && !touches) {
        state(&sheet, "{a}", {"a", 0, "mm"}, {}); // the wheel does not touch it
    } else if (!(a > 0) && (isCoupled(project) || wheelContact(project))) {
        state(&sheet, "{P_y}", {"P_y", visit.normalForce_n, "N"}, {}); // it touches without cutting
        state(&sheet, "{a}", {"a", 0, "mm"}, {});
        state(&sheet, "{y} = {h}", {"y", h, "mm"}, {{"h", h, "mm"}});
    } else if (isCoupled(project) || wheelContact(project)) {
        state(&sheet, "{a}", {"a", a, "mm"}, {});
        append(sheet, normalForceSheet(project, b, a));
        stateCoefficients(sheet, project, of);
        state(&sheet, "{y} = {h} − {a}", {"y", h - a, "mm"}, {{"h", h, "mm"}, {"a", a, "mm"}});
    } else {
        const double gamma = compliantPoints(project)[sectionOf(of.place)].gamma_mm_n;
        append(sheet, balanceSheet(project, b, gamma, h));
        stateCoefficients(sheet, project, of);
    }
    const FormulaTerm cut{"a", a, "mm"}, left{"R_k′", after, "mm"};
    const FormulaTerm target{"R_t", targetRadius(*project.part), "mm"};
    state(&sheet, external ? "{R_k′} = {R_k} − {a}" : "{R_k′} = {R_k} + {a}", left, {R, cut});
    if (visit.printed_mm == 0) {
        state(&sheet, external ? "{Π_k} = {R_k′} − {R_t}" : "{Π_k} = {R_t} − {R_k′}",
              {"Π_k", side * (after - target.value), "mm"}, {left, target});
        return sheet;
    }
    const FormulaTerm printed{"c", visit.printed_mm, "mm"}, part{"R", visit.radius_mm, "mm"};
    state(&sheet, external ? "{R} = {R_k′} − {c}" : "{R} = {R_k′} + {c}", part, {left, printed});
    state(&sheet, external ? "{Π_k} = {R} − {R_t}" : "{Π_k} = {R_t} − {R}",
          {"Π_k", side * (visit.radius_mm - target.value), "mm"}, {part, target});
    return sheet;
}

} // namespace sparkout
