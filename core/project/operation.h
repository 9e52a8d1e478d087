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

/// A feed that stages set, and where machine and search speak of it.
struct StageFeed {
    const char* key; ///< of its rows in Stage and Optimisation
    std::optional<double> Stage::*value;
    std::optional<std::vector<double>> MachineLimits::*range;
    Levels Optimisation::*levels;
    NumberRows Optimisation::*byStage; ///< least and most of each stage
};

/// What the rest of the program asks of a kind of operation.
struct OperationTraits {
    Choice choice;                    ///< its key in the file and its label
    std::span<const StageFeed> feeds; ///< of its stages: the radial one, and an axial one if any
    /// In whose place a stage may be fed all the time; null: there is none.
    const StageFeed* continuous = nullptr;
    double usualRadial = 0;  ///< of a stage that is added
    int usualLeastSteps = 0; ///< that a stage with stock is to make
    bool perMinute = false;  ///< the radial feed is one of time [mm/min], else one of a step [mm]
    bool countsStrokes = false; ///< a step of the cycle is a double stroke, else a revolution
    /// The wheel travels along the part, from reversal to reversal with overruns and dwells; else
    /// it covers the whole ground length.
    bool travels = false;
    /// The ground length has the zones РЗ1, НЗ, РЗ2, with the gauge in the middle of НЗ; else any
    /// number of sections, with the gauge where one likes.
    bool hasZones = false;
    bool mayRetract = false; ///< stages between others may draw the wheel head back

    [[nodiscard]] const StageFeed& radial() const { return feeds.front(); }
    /// All that a search may have levels of.
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

/// The kind of operation, in the order of the choices. Most of the program asks for what is in its
/// traits; what each kind does in its own way is asked by match().
class Operation : public std::variant<Traverse, Plunge> {
public:
    using variant::variant;
    static const Operation traverse, plunge;

    /// Calls the case of the kind; a kind without its case does not compile.
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
    /// What a step feeds [mm] at a radial feed of the operation.
    [[nodiscard]] double infeed_mm(double radialFeed, double workSpeed_rpm) const {
        return (*this)->perMinute ? radialFeed / workSpeed_rpm : radialFeed;
    }
};

inline constexpr Operation Operation::traverse{Traverse{}};
inline constexpr Operation Operation::plunge{Plunge{}};

template <>
std::span<const Choice> choicesOf<Operation>();

} // namespace sparkout
