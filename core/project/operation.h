// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace sparkout {

struct MachineLimits;
struct Optimisation;
struct Stage;

/// A feed set by stages, with its members in machine and search.
struct StageFeed {
    const char* key; ///< key of its rows in Stage and Optimisation
    std::optional<double> Stage::*value;
    std::optional<std::vector<double>> MachineLimits::*range;
    Levels Optimisation::*levels;
    NumberRows Optimisation::*byStage; ///< lower and upper bound for each stage
};

/// Properties of a kind of operation.
struct OperationTraits {
    Choice choice;                    ///< its key in the file and its label
    std::span<const StageFeed> feeds; ///< the radial one, and an axial one if any
    /// The continuous feed, which may replace the radial one of a stage; null if there is none.
    const StageFeed* continuous = nullptr;
    double usualRadial = 0;  ///< usual radial feed of an added stage
    int usualLeastSteps = 0; ///< usual least number of steps of a stage with stock
    /// The wheel travels along the part between reversals with overruns and dwells: a step of the
    /// cycle is a double stroke, the radial feed is in mm per step, and the ground length has the
    /// zones РЗ1, НЗ, РЗ2 with the gauge in the middle of НЗ. Otherwise the wheel covers the ground
    /// length: a step is a revolution, the radial feed is in mm/min, there are any number of
    /// sections with a gauge at any position, and a stage between others may retract the wheel
    /// head.
    bool travels = false;

    [[nodiscard]] const StageFeed& radial() const { return feeds.front(); }
    /// All feeds for which a search may have levels.
    [[nodiscard]] std::vector<const StageFeed*> searchedFeeds() const;
    /// Null where stages set no axial feed.
    [[nodiscard]] const StageFeed* axial() const { return feeds.size() > 1 ? &feeds[1] : nullptr; }
};

/// The table strokes along the part, which is fed at the reversals [MODEL-5].
struct Traverse {
    static const OperationTraits traits;
    friend bool operator==(const Traverse&, const Traverse&) = default;
};

/// The wheel covers the ground length and is fed radially [MODEL-6].
struct Plunge {
    static const OperationTraits traits;
    friend bool operator==(const Plunge&, const Plunge&) = default;
};

/// The kind of operation, in the order of the choices. Most of the program uses its traits; match()
/// selects behaviour specific to a kind.
class Operation : public std::variant<Traverse, Plunge> {
public:
    using variant::variant;
    static const Operation traverse, plunge;

    /// Calls the case of the kind; a missing case does not compile.
    template <class... Cases>
    decltype(auto) match(Cases... cases) const {
        struct All : Cases... {
            using Cases::operator()...;
        };
        return std::visit(All{std::move(cases)...}, static_cast<const variant&>(*this));
    }
    [[nodiscard]] static Operation ofIndex(std::size_t index);
    [[nodiscard]] const OperationTraits* operator->() const {
        return match([](const auto& kind) { return &kind.traits; });
    }
    /// The infeed of a step [mm] at a radial feed of the operation.
    [[nodiscard]] double infeed_mm(double radialFeed, double workSpeed_rpm) const {
        return (*this)->travels ? radialFeed : radialFeed / workSpeed_rpm;
    }
};

inline constexpr Operation Operation::traverse{Traverse{}};
inline constexpr Operation Operation::plunge{Plunge{}};

template <>
std::span<const Choice> choicesOf<Operation>();

} // namespace sparkout
