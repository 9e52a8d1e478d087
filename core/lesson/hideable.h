// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <string_view>

namespace sparkout {

/// The elements of the window that a step may hide. The keys of the views are those of `--view`; a
/// test of the window compares them with its views.
enum class Hideable {
    overview,
    feeds,
    profiles,
    constraints,
    compliance,
    layers,
    batch,
    sweep,
    optimise,
    compare,
    measured,
    // panels and commands
    verdict,
    remedies,
    formulas,
    messages,
    keptRuns,
    calibrate,
    examples,
    reports,
    exportResults,
    batchIndices, ///< parts of a view: interval of the mean, Pp and Ppk
    count_
};

/// Whether it is a view; otherwise it is a panel or a command.
[[nodiscard]] bool isView(Hideable thing);
/// The view with a name of `--view`; empty if there is none.
[[nodiscard]] std::optional<Hideable> viewNamed(std::string_view key);

/// A view, panel or command that a step hides.
struct HiddenThing {
    Hideable name = Hideable::optimise;
    friend bool operator==(const HiddenThing&, const HiddenThing&) = default;
};

template <>
std::span<const Choice> choicesOf<Hideable>();
template <>
const StructInfo& tableOf<HiddenThing>();

} // namespace sparkout
