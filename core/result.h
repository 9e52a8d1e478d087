// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

/// The description of one output, next to the type that holds it, read by everything that states
/// results: JSON, CSV, workbooks, the command line's text, Python and the tables of the window. An
/// input has its own row (core/field.h).
namespace sparkout {

/// Both ends of an interval.
struct Interval {
    double low = 0, high = 0;
};

/// An estimate with its interval of 95 %.
struct Estimate {
    double value = 0;
    Interval interval;
};

/// A count of parts as a share with its 95 % interval of Clopper and Pearson.
struct Share {
    std::int64_t count = 0;
    double value = 0;
    std::optional<Interval> interval; ///< not for corners
};

/// Where a number lies against its plausible band.
enum class BandSide { none, inside, below, above }; ///< none: there is no number

/// What an output is of one owner; monostate: there is none.
using OutputValue = std::variant<std::monostate, double, std::int64_t, bool, std::string, Interval,
                                 Estimate, Share>;

/// The kinds of outputs, whether there is one or not.
enum class OutputKind {
    number,
    optionalNumber,
    whole,
    optionalWhole,
    truth,
    optionalTruth,
    text,
    optionalText,
    interval,
    estimate,
    share
};

/// What an output says of itself, whoever it is of.
struct OutputRow {
    const char* key = ""; ///< in JSON and Python; empty: it is not stated there
    const char* column =
        nullptr;            ///< at the head of a CSV column; null: as the key; empty: no column
    const char* label = ""; ///< standing alone, without its unit (translated as "Output")
    const char* brief = ""; ///< the same in its place in a table; empty: the label
    const char* ofRevolutions = ""; ///< the label where revolutions are counted, not double strokes
    const char* unit = "";          ///< of its values
    const char* shownUnit = "";     ///< that people read them in; empty: the same
    double shownFactor = 1;         ///< values in shownUnit over values in unit
    const char* hint = "";          ///< what it is, how it is made, what is usual
    bool sparse = false;            ///< window and text leave it out where no owner has it
    bool detail = false; ///< stands in files alone; tables of the window say it otherwise

    [[nodiscard]] const char* columnName() const { return column ? column : key; }
    [[nodiscard]] const char* unitShown() const { return *shownUnit ? shownUnit : unit; }
    [[nodiscard]] const char* labelOf(bool revolutions) const {
        return revolutions && *ofRevolutions ? ofRevolutions : label;
    }
};

/// A row with how the value is taken from its owner.
template <class Owner>
struct Output : OutputRow {
    template <class Value>
    using From = Value (*)(const Owner&);
    /// In the order of OutputKind; what may be missing is optional.
    using Getter = std::variant<From<double>, From<std::optional<double>>, From<std::int64_t>,
                                From<std::optional<std::int64_t>>, From<bool>,
                                From<std::optional<bool>>, From<std::string>,
                                From<std::optional<std::string>>, From<std::optional<Interval>>,
                                From<std::optional<Estimate>>, From<std::optional<Share>>>;

    Getter get;
    BandSide (*band)(const Owner&) = nullptr; ///< null: it has none
    bool (*stated)(const Owner&) = nullptr;   ///< JSON leaves it out where not; null: it never does

    [[nodiscard]] OutputValue of(const Owner& owner) const {
        return std::visit(
            [&owner](auto from) -> OutputValue {
                using Value = decltype(from(owner));
                if constexpr (std::is_constructible_v<OutputValue, Value>) {
                    return OutputValue(from(owner));
                } else {
                    auto value = from(owner);
                    return value ? OutputValue(std::move(*value)) : OutputValue();
                }
            },
            get);
    }
    [[nodiscard]] OutputKind kind() const { return static_cast<OutputKind>(get.index()); }
    [[nodiscard]] BandSide bandOf(const Owner& owner) const {
        return band ? band(owner) : BandSide::none;
    }
};

} // namespace sparkout
