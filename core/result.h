// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

/// The description of an output, next to its type, used wherever results are stated: JSON, CSV,
/// workbooks, the command line's text, Python and the tables of the window. An input has its own
/// row (core/field.h).
namespace sparkout {

struct Machine;

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
    std::optional<Interval> interval; ///< empty for corners
};

/// The position of a number relative to its plausible band.
enum class BandSide { none, inside, below, above }; ///< none: there is no number

/// The value of an output for an owner; monostate if there is none.
using OutputValue = std::variant<std::monostate, double, std::int64_t, bool, std::string, Interval,
                                 Estimate, Share>;

/// The kinds of outputs, whether they may be missing or not.
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

/// The properties of an output, for any owner.
struct OutputRow {
    const char* key = "";           ///< in JSON and Python; empty: it is not stated there
    const char* column = nullptr;   ///< heading of a CSV column; null: the key; empty: no column
    const char* label = "";         ///< standing alone, without its unit (translated as "Output")
    const char* brief = "";         ///< the same in its place in a table; empty: the label
    const char* ofRevolutions = ""; ///< the label where revolutions are counted, not double strokes
    const char* unit = "";          ///< of its values
    const char* shownUnit = "";     ///< that people read them in; empty: the same
    double shownFactor = 1;         ///< values in shownUnit over values in unit
    const char* hint = "";          ///< its meaning, its derivation and usual values
    bool sparse = false;            ///< omitted by window and text if no owner has it
    bool detail = false;            ///< only in files; tables of the window show it differently
    /// Whether the machine's own form, which is in it, is known; null: no machine's form is in it.
    bool (*knowsMachine)(const Machine&) = nullptr;

    [[nodiscard]] const char* columnName() const { return column ? column : key; }
    [[nodiscard]] const char* unitShown() const { return *shownUnit ? shownUnit : unit; }
    [[nodiscard]] const char* labelOf(bool revolutions) const {
        return revolutions && *ofRevolutions ? ofRevolutions : label;
    }
};

/// A row with access to the value of its owner.
template <class Owner>
struct Output : OutputRow {
    template <class Value>
    using From = Value (*)(const Owner&);
    /// In the order of OutputKind; a value that may be missing is optional.
    using Getter = std::variant<From<double>, From<std::optional<double>>, From<std::int64_t>,
                                From<std::optional<std::int64_t>>, From<bool>,
                                From<std::optional<bool>>, From<std::string>,
                                From<std::optional<std::string>>, From<std::optional<Interval>>,
                                From<std::optional<Estimate>>, From<std::optional<Share>>>;

    Getter get;
    BandSide (*band)(const Owner&) = nullptr; ///< null: no band
    bool (*stated)(const Owner&) = nullptr;   ///< JSON omits it if false; null: never

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
    [[nodiscard]] bool isStated(const Owner& owner) const { return !stated || stated(owner); }
    [[nodiscard]] OutputKind kind() const { return static_cast<OutputKind>(get.index()); }
    [[nodiscard]] BandSide bandOf(const Owner& owner) const {
        return band ? band(owner) : BandSide::none;
    }
};

} // namespace sparkout
