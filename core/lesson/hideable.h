// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <string_view>

namespace sparkout {

/// What a step of a lesson may hide of the window. The keys of the views are those of `--view`; a
/// test of the window holds them against the views there are.
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
    batchIndices, ///< of a view that stays: interval of the mean, Pp and Ppk
    count_
};

/// Whether it is one of the views; else a panel or a command.
[[nodiscard]] bool isView(Hideable thing);
/// The view of a name of `--view`; nothing: there is none.
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
