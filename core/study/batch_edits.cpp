// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/batch_edits.h"

#include "core/batch/scenario_source.h"
#include "core/batch/usual_batch.h"
#include "core/file/project_file.h"
#include "core/project/batch.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

constexpr int shownDigits = 6; ///< for a part's numbers

Factor growingFactor(std::vector<double> ends) {
    Factor factor;
    factor.grows = std::move(ends);
    factor.parts_between_dressings = usualPartsBetweenDressings;
    return factor;
}

/// Rounds to readable digits; the part's results change by less than their digits.
void shorten(double& value) {
    if (value != 0 && std::isfinite(value)) {
        const int digits =
            shownDigits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value))));
        const double scale = std::pow(10, std::abs(digits));
        value = digits >= 0 ? std::round(value * scale) / scale : std::round(value / scale) * scale;
    }
}

/// Shortens the numbers that the factors of a batch scale, where they differ from the nominal ones.
Project shortened(Project made, const Project& nominal) {
    const auto tidy = [](double& value, double before) {
        if (value != before) {
            shorten(value);
        }
    };
    Machine& machine = *made.machine;
    tidy(machine.wheel_speed_m_s, nominal.machine->wheel_speed_m_s);
    tidy(machine.geometric_runout_um, nominal.machine->geometric_runout_um);
    tidy(made.gauge->error_um, nominal.gauge->error_um);
    tidy(made.part->shaft.youngs_modulus_gpa, nominal.part->shaft.youngs_modulus_gpa);
    if (made.part->shaft.youngs_modulus_gpa == nominal.part->shaft.youngs_modulus_gpa) {
        return made; // the compliance is the nominal one
    }
    if (auto* zones = std::get_if<ZoneCompliance>(&machine.compliance_mm_per_n)) {
        for (double* gamma : {&zones->rz1, &zones->nz, &zones->rz2}) {
            shorten(*gamma);
        }
    } else if (auto* each = std::get_if<std::vector<double>>(&machine.compliance_mm_per_n)) {
        std::ranges::for_each(*each, shorten);
    }
    if (machine.stiffness_n_um) {
        for (double* stiffness :
             {&machine.stiffness_n_um->headstock, &machine.stiffness_n_um->tailstock,
              &machine.stiffness_n_um->wheel_head}) {
            shorten(*stiffness);
        }
    }
    for (SteadyRest& rest : made.part->shaft.steady_rests) {
        shorten(rest.stiffness_n_um);
    }
    if (machine.wheel_contact && machine.wheel_contact->n_um_at_n) {
        for (std::vector<double>& row : *machine.wheel_contact->n_um_at_n) {
            shorten(row[1]);
        }
    }
    if (made.gauge->compliance_mm_per_n) {
        shorten(*made.gauge->compliance_mm_per_n);
    }
    return made;
}

/// Keeps the entries of the user's project that do not affect a part.
void keepOwn(Project& of, Project from) {
    of.title = std::move(from.title);
    of.author = std::move(from.author);
    of.notes = std::move(from.notes);
    of.batch = std::move(from.batch);
    of.optimisation = std::move(from.optimisation);
    of.sweep = std::move(from.sweep);
    of.measured = std::move(from.measured);
    of.runs = std::move(from.runs);
}

Project batchOnly(Project project) {
    Project names;
    names.batch = std::move(project.batch);
    keepOwn(project, std::move(names));
    return project;
}

/// The law of a factor in the project's batch.
std::optional<Factor>& lawOf(Batch& batch, FactorKind kind) {
    const Field& field = tableOf<Factors>().fields[static_cast<std::size_t>(kind)];
    return field.as<std::optional<Factor>>(&batch.factors);
}

const std::optional<Factor>& lawOf(const Batch& batch, FactorKind kind) {
    const Field& field = tableOf<Factors>().fields[static_cast<std::size_t>(kind)];
    return field.as<std::optional<Factor>>(static_cast<const void*>(&batch.factors));
}

bool isSameLaw(const std::optional<Factor>& a, const std::optional<Factor>& b) {
    return a.has_value() == b.has_value()
           && (!a || std::ranges::all_of(tableOf<Factor>().fields, [&](const Field& field) {
                  return field.same(&*a, &*b);
              }));
}

/// The law with all its values scaled, then shifted.
Factor withValuesMoved(Factor law, double scale, double shift) {
    const auto scaled = [scale](double value, double by) {
        constexpr double digits = 1e9; // removes binary rounding
        double moved = std::round((scale * value + by) * digits) / digits;
        shorten(moved);
        return moved;
    };
    for (auto* values : {&law.uniform, &law.within, &law.triangular, &law.measured, &law.grows}) {
        for (std::size_t i = 0; *values && i < (*values)->size(); ++i) {
            (**values)[i] = scaled((**values)[i], shift);
        }
    }
    for (std::size_t i = 0; law.normal && i < law.normal->size(); ++i) {
        (*law.normal)[i] = scaled((*law.normal)[i], i == 0 ? shift : 0); // then the deviation
    }
    return law;
}

bool hasValuesIn(const Factor& law, const Range& allowed) {
    const auto isAllowed = [&allowed](double value) { return allowed.contains(value); };
    const auto hasAll = [&](const std::optional<std::vector<double>>& values) {
        return !values || std::ranges::all_of(*values, isAllowed);
    };
    return hasAll(law.uniform) && hasAll(law.within) && hasAll(law.triangular)
           && hasAll(law.measured) && hasAll(law.grows)
           && (!law.normal || law.normal->empty() || isAllowed(law.normal->front()));
}

/// The law after a change of the input that it replaces; unchanged if no other one is allowed.
Factor lawMoved(const Factor& law, const GivenFactor& factor, double before, double after) {
    if (factor.kind == FactorKind::stock || factor.kind == FactorKind::partWarmer) {
        Factor shifted = withValuesMoved(law, 1, after - before);
        if (hasValuesIn(shifted, factor.allowed)) {
            return shifted;
        }
    }
    if (before > 0 && after > 0) {
        Factor scaled = withValuesMoved(law, after / before, 0);
        if (hasValuesIn(scaled, factor.allowed)) {
            return scaled;
        }
    }
    return law;
}

/// The position of a kind among the given factors, or where it would be inserted.
std::size_t placeOf(FactorKind kind, const std::vector<GivenFactor>& given) {
    return static_cast<std::size_t>(
        std::ranges::count_if(given, [kind](const GivenFactor& f) { return f.kind < kind; }));
}

/// Whether the matrix has this size; a file may have another one.
bool isMatrixOf(const NumberRows& matrix, std::size_t count) {
    return matrix && matrix->size() == count
           && std::ranges::all_of(
               *matrix, [count](const std::vector<double>& row) { return row.size() == count; });
}

/// Removes the correlations of laws over the batch, which have none; all of them if they are 0.
void tidyCorrelation(Project& project) {
    NumberRows& matrix = project.batch->correlation;
    if (!matrix) {
        return;
    }
    const std::vector<GivenFactor> given = givenFactors(project);
    bool correlated = false;
    for (std::size_t i = 0; i < matrix->size(); ++i) {
        for (std::size_t j = 0; j < (*matrix)[i].size(); ++j) {
            const bool law =
                i < given.size() && j < given.size() && (given[i].isLaw() || given[j].isLaw());
            double& value = (*matrix)[i][j];
            value = i != j && law ? 0 : value;
            correlated = correlated || (i != j && value != 0);
        }
    }
    if (!correlated) {
        matrix.reset();
    }
}

/// Whether a law has a form with all its values; that in a file may be incomplete.
bool isWhole(const Factor& law) {
    const auto holds = [](const std::optional<std::vector<double>>& values, std::size_t count) {
        return values && values->size() == count;
    };
    return holds(law.uniform, 2) || holds(law.normal, 2) || holds(law.triangular, 3)
           || holds(law.grows, 2) || (law.measured && !law.measured->empty());
}

/// A given factor of the batch, with a usual law in place of an incomplete one.
GivenFactor factorOf(const Project& project, FactorKind kind) {
    const std::vector<GivenFactor> given = givenFactors(project);
    GivenFactor found = *std::ranges::find(given, kind, &GivenFactor::kind);
    if (!isWhole(found.law)) {
        found.law = usualFactor(kind, project);
    }
    return found;
}

} // namespace

FactorForm formOf(const Factor& factor) {
    if (factor.normal) {
        return FactorForm::normal;
    }
    if (factor.triangular) {
        return FactorForm::triangular;
    }
    if (factor.measured) {
        return FactorForm::measured;
    }
    if (factor.grows) {
        return FactorForm::grows;
    }
    const auto& ends = factor.uniform;
    return ends && ends->size() == 2 && (*ends)[0] == (*ends)[1] ? FactorForm::constant
                                                                 : FactorForm::uniform;
}

Factor withForm(const Project& project, FactorKind kind, FactorForm form) {
    const FactorEnds ends = cornerEnds(factorOf(project, kind));
    double low = std::min(ends.low, ends.high), high = std::max(ends.low, ends.high);
    const double middle = std::clamp(toTwoDigits((low + high) / 2), low, high);
    if (low == high && form != FactorForm::constant) {
        low *= leastUsualShare;
        high *= mostUsualShare;
    }
    Factor made;
    switch (form) {
    case FactorForm::constant: made.uniform = {middle, middle}; break;
    case FactorForm::uniform: made.uniform = {low, high}; break;
    case FactorForm::normal:
        made.normal = {middle, toTwoDigits((high - low) / 6)};
        made.within = {low, high};
        break;
    case FactorForm::triangular: made.triangular = {low, middle, high}; break;
    case FactorForm::measured: made.measured = {{middle}}; break;
    case FactorForm::grows: made = growingFactor({low, high}); break;
    }
    return made;
}

Factor withTruncation(const Project& project, FactorKind kind, bool truncated) {
    GivenFactor factor = factorOf(project, kind);
    factor.law.within.reset();
    if (truncated) {
        const FactorEnds ends = cornerEnds(factor);
        factor.law.within = {ends.low, ends.high};
    }
    return factor.law;
}

Project withFactor(Project project, FactorKind kind, std::optional<Factor> law) {
    const std::vector<GivenFactor> before = givenFactors(project);
    const bool was = lawOf(*project.batch, kind).has_value(), is = law.has_value();
    lawOf(*project.batch, kind) = std::move(law);
    NumberRows& matrix = project.batch->correlation;
    if (was != is && isMatrixOf(matrix, before.size())) {
        const auto at = static_cast<std::ptrdiff_t>(placeOf(kind, before));
        if (is) {
            for (std::vector<double>& row : *matrix) {
                row.insert(row.begin() + at, 0);
            }
            std::vector<double> own(before.size() + 1);
            own[static_cast<std::size_t>(at)] = 1;
            matrix->insert(matrix->begin() + at, std::move(own));
        } else {
            matrix->erase(matrix->begin() + at);
            for (std::vector<double>& row : *matrix) {
                row.erase(row.begin() + at);
            }
        }
    }
    tidyCorrelation(project);
    return project;
}

std::vector<FactorKind> moveLaws(Project& changed, const Project& present, const Project& base) {
    std::vector<FactorKind> moved;
    if (!changed.batch || !present.batch || !base.batch || changed.operation != present.operation
        || changed.operation != base.operation) {
        return moved; // the width of contact is another input under another operation
    }
    for (const GivenFactor& factor : givenFactors(base)) {
        const auto [before, now, after] =
            std::array{replacedValue(factor.kind, base), replacedValue(factor.kind, present),
                       replacedValue(factor.kind, changed)};
        const std::optional<Factor>& law = lawOf(*present.batch, factor.kind);
        if (!isWhole(factor.law) || !before || !now || !after || *now == *after
            || !isSameLaw(law, lawOf(std::as_const(*changed.batch), factor.kind))) {
            continue;
        }
        const Factor& given = *lawOf(*base.batch, factor.kind);
        Factor made = *before == *after ? given : lawMoved(given, factor, *before, *after);
        if (!isSameLaw(made, law)) {
            lawOf(*changed.batch, factor.kind) = std::move(made);
            moved.push_back(factor.kind);
        }
    }
    return moved;
}

Project withCorrelation(Project project, std::size_t first, std::size_t second, double value) {
    const std::size_t count = givenFactors(project).size();
    NumberRows& matrix = project.batch->correlation;
    if (!isMatrixOf(matrix, count)) {
        matrix.emplace(count, std::vector<double>(count));
    }
    for (std::size_t i = 0; i < count; ++i) {
        (*matrix)[i][i] = 1;
    }
    (*matrix)[first][second] = (*matrix)[second][first] = value;
    tidyCorrelation(project);
    return project;
}

Project withPart(Project project, const BatchResult& batch, std::int64_t part) {
    const ScenarioSource source(batch.project);
    std::vector<double> values = source.values(part);
    std::ranges::for_each(values, shorten);
    Project made = shortened(source.projectWith(values), source.nominal());
    keepOwn(made, std::move(project));
    return made;
}

bool sameBatch(const Project& a, const Project& b) {
    return sameProject(batchOnly(a), batchOnly(b));
}

} // namespace sparkout
