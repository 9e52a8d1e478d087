// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/indirect.h"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

/// The description of one input, next to its struct, read by everything that handles inputs:
/// file reader and writer, validation, forms, hints, help page, JSON Schema and tests.
namespace sparkout {

struct Project;
struct StructInfo;
enum class Phrase; // core/issue.h

/// Allowed or usual values in the field's unit. An open end excludes the bound itself.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool lowOpen = false;

    [[nodiscard]] bool contains(double value) const {
        return (lowOpen ? value > low : value >= low) && value <= high;
    }
    [[nodiscard]] bool unbounded() const {
        return low == -std::numeric_limits<double>::infinity()
               && high == std::numeric_limits<double>::infinity();
    }
    friend bool operator==(const Range&, const Range&) = default;
};

/// A value of an enumeration: its name in the file and its label (translated as "Choice").
struct Choice {
    const char* key;
    const char* label;
};

/// A condition on a field: receives the whole project, and the struct with the field.
using Condition = bool (*)(const Project& project, const void* owner);

/// The page of the input form with a struct's field.
enum class Page { part, material, wheel, machine, gauge, cycle, batch, search, none };

// --- value types a member may have beside double, int, bool, string, enum, lists and structs ----

/// A whole number, one of a few words, or neither (null in the file): any type with these members.
/// Readers, writers and the reference use only these members.
template <class T>
concept CountOrWord = requires(T value, std::size_t word, int number) {
    requires std::is_same_v<decltype(T::words()), std::span<const Choice>>;
    requires std::is_same_v<decltype(T::expected()), Phrase>; // the expected value in messages
    requires std::is_same_v<decltype(T::ofNumber(number)), T>;
    requires std::is_same_v<decltype(T::ofWord(word)), T>;
    requires std::is_same_v<decltype(value.number()), int*>; // null if it is not a number
    // Index into words().
    requires std::is_same_v<decltype(value.word()), std::optional<std::size_t>>;
};

/// Given compliance: one value for each zone (traverse) or section (plunge) [mm/N].
struct ZoneCompliance {
    double rz1 = 0, nz = 0, rz2 = 0;
    friend bool operator==(const ZoneCompliance&, const ZoneCompliance&) = default;
};
using GivenCompliance = std::variant<std::monostate, ZoneCompliance, std::vector<double>>;

/// Levels of a grid: listed, or from, to and step.
struct SteppedLevels {
    double from = 0, to = 0, step = 0;
    friend bool operator==(const SteppedLevels&, const SteppedLevels&) = default;
};
using Levels = std::variant<std::monostate, std::vector<double>, SteppedLevels>;

/// Rows of numbers: a matrix, or points of a curve.
using NumberRows = std::optional<std::vector<std::vector<double>>>;

/// A JSON value kept as read (compact text), used by kept runs.
struct JsonText {
    std::string text = "{}";
    friend bool operator==(const JsonText&, const JsonText&) = default;
};

// --- the row ------------------------------------------------------------------------------------

enum class Kind {
    number,
    optionalNumber,
    integer,
    optionalInteger,
    boolean,
    text,
    choice,
    numberList,
    optionalNumberList,
    object,
    optionalObject,
    objectList,
    countOrWord,
    compliance,
    levels,
    numberRows,
    samples,
    jsonText,
};

/// The description of a member; only the label is required.
struct Row {
    const char* label = "";
    const char* symbol = "";
    const char* unit = "";
    Range hard = {};              ///< refused outside; for a text, its number of letters
    Range soft = {};              ///< warned outside
    const char* nullMeaning = ""; ///< meaning of null (not given), for members that may be null
    Condition required = nullptr; ///< required in the file if true; null: never
    Condition relevant = nullptr; ///< used by the model if true; null: always
    std::size_t count = 0;        ///< lists: the exact number of values, 0 for any
    bool whole = false;           ///< lists and levels: only whole numbers
    bool slider = false;          ///< has a slider, for trying values
    Range read = {};              ///< narrower than hard: refused outside it if relevant
    Condition exempt = nullptr;   ///< only the hard range applies if true; null: never
    bool sparse = false;          ///< omitted from files if it has its default
    Page page = Page::none;       ///< the form page that shows it
    bool usual = false;           ///< set for every cycle; the page shows the others on demand
    const char* hint = "";
    const char* formula = ""; ///< where the member enters the model, in the model page's letters
    /// Label at the head of a table's column, where it must be short; translated in "InputBrief".
    const char* column = "";
    const char* source = ""; ///< key of core/SOURCES.md

    /// The allowed range in hints and messages.
    [[nodiscard]] const Range& stated() const { return read.unbounded() ? hard : read; }
};

/// A row bound to its member. `member` gives the member's address inside its struct.
struct Field : Row {
    const char* key = "";
    Kind kind = Kind::number;
    void* (*member)(void* owner) = nullptr;
    bool (*same)(const void* a, const void* b) = nullptr; ///< compares two owners; not objects
    int (*getChoice)(const void* owner) = nullptr; ///< choice, or word of a countOrWord; −1: none
    void (*setChoice)(void* owner, int value) = nullptr;  ///< −1: not given
    std::span<const Choice> choices;                      ///< or words
    void (*setNumber)(void* owner, int number) = nullptr; ///< countOrWord
    int* (*number)(void* owner) = nullptr; ///< countOrWord; null if it is not a number
    Phrase (*expected)() = nullptr;        ///< countOrWord: instead of another type
    const StructInfo* nested = nullptr;    ///< object kinds
    void* (*object)(void* owner, bool create) = nullptr;    ///< object kinds; null if not given
    const void* (*readObject)(const void* owner) = nullptr; ///< object kinds, read-only
    void (*reset)(void* owner) = nullptr;                   ///< optional object: not given
    std::size_t (*size)(const void* owner) = nullptr;       ///< objectList
    void* (*at)(void* owner, std::size_t index) = nullptr;  ///< objectList
    void (*resize)(void* owner, std::size_t size) = nullptr;
    /// Inserts a copy of the item before `index`; at the beginning one with its defaults.
    void (*insert)(void* owner, std::size_t index) = nullptr;
    void (*erase)(void* owner, std::size_t index) = nullptr;
    void (*swap)(void* owner, std::size_t one, std::size_t other) = nullptr; ///< two of its items

    template <class T>
    [[nodiscard]] T& as(void* owner) const {
        return *static_cast<T*>(member(owner));
    }
    template <class T>
    [[nodiscard]] const T& as(const void* owner) const {
        return *static_cast<const T*>(member(const_cast<void*>(owner)));
    }
    /// The allowed range in a project.
    [[nodiscard]] const Range& allowed(const Project& project, const void* owner) const {
        const bool only =
            (relevant && !relevant(project, owner)) || (exempt && exempt(project, owner));
        return only ? hard : stated();
    }
    /// The whole number of the member; null if it is of another kind or not given.
    [[nodiscard]] int* wholeNumber(void* owner) const;
    [[nodiscard]] const int* wholeNumber(const void* owner) const {
        return wholeNumber(const_cast<void*>(owner));
    }
    [[nodiscard]] const void* objectIn(const void* owner) const { return readObject(owner); }
    [[nodiscard]] const void* itemIn(const void* owner, std::size_t index) const {
        return at(const_cast<void*>(owner), index);
    }
};

struct StructInfo {
    const char* name; ///< translated in the context "Struct"
    std::span<const Field> fields;
    const void* defaults; ///< a value of the struct with its default initialisers
    [[nodiscard]] const Field* find(std::string_view key) const;
};

/// The table of T; each struct's .cpp specialises it.
template <class T>
const StructInfo& tableOf();

/// The choices of an enumeration; each enum's .cpp specialises it.
template <class E>
std::span<const Choice> choicesOf();

// --- making rows --------------------------------------------------------------------------------

namespace detail {

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};
/// For objects of the struct whose type is only declared.
template <class T>
struct IsIndirect : std::false_type {};
template <class T>
struct IsIndirect<Indirect<T>> : std::true_type {};
template <class T>
struct IsOptionalIndirect : std::false_type {};
template <class T>
struct IsOptionalIndirect<OptionalIndirect<T>> : std::true_type {};
template <class T>
struct IsOptionalShared : std::false_type {};
template <class T>
struct IsOptionalShared<OptionalShared<T>> : std::true_type {};
template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};

template <class T>
concept Comparable = requires(const T& value) {
    value == value;
};
/// Neither an object nor a list of objects.
template <class T>
inline constexpr bool
    isValue = Comparable<T> && (!IsVector<T>::value || std::is_same_v<T, std::vector<double>>);

template <auto Member>
struct MemberOf;
template <class S, class T, T S::*Member>
struct MemberOf<Member> {
    using Struct = S;
    using Type = T;
};

// Probes that count the members of an aggregate: Any converts to every type but an optional,
// AnyOptional to an optional (for which Any would be ambiguous).
struct Any {
    template <class T>
    requires(!IsOptional<T>::value)
    operator T() const; // NOLINT: implicit by purpose, never defined
};
struct AnyOptional {
    template <class T>
    requires(IsOptional<T>::value) operator T() const; // NOLINT: implicit by purpose, never defined
};

template <class S, class... Probes>
consteval std::size_t countMembers() {
    if constexpr (requires { S{Probes{}..., Any{}}; }) {
        return countMembers<S, Probes..., Any>();
    } else if constexpr (requires { S{Probes{}..., AnyOptional{}}; }) {
        return countMembers<S, Probes..., AnyOptional>();
    } else {
        return sizeof...(Probes);
    }
}

template <auto Member, class S, class Item>
void fillList(Field& f) {
    f.kind = Kind::objectList;
    f.nested = &tableOf<Item>();
    f.size = [](const void* owner) { return (static_cast<const S*>(owner)->*Member).size(); };
    f.at = [](void* owner, std::size_t i) -> void* {
        return &(static_cast<S*>(owner)->*Member)[i];
    };
    f.resize = [](void* owner, std::size_t n) { (static_cast<S*>(owner)->*Member).resize(n); };
    f.insert = [](void* owner, std::size_t i) {
        auto& list = static_cast<S*>(owner)->*Member;
        list.insert(list.begin() + static_cast<std::ptrdiff_t>(i), i > 0 ? list[i - 1] : Item{});
    };
    f.erase = [](void* owner, std::size_t i) {
        auto& list = static_cast<S*>(owner)->*Member;
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(i));
    };
    f.swap = [](void* owner, std::size_t i, std::size_t j) {
        auto& list = static_cast<S*>(owner)->*Member;
        std::swap(list[i], list[j]);
    };
}

template <auto Member, class S, class T>
void fillOptionalObject(Field& f) {
    f.kind = Kind::optionalObject;
    f.nested = &tableOf<T>();
    f.object = [](void* owner, bool create) -> void* {
        auto& member = static_cast<S*>(owner)->*Member;
        if (!member && create) {
            member.emplace();
        }
        return member ? &*member : nullptr;
    };
    f.readObject = [](const void* owner) -> const void* {
        const auto& member = static_cast<const S*>(owner)->*Member;
        return member ? &*member : nullptr;
    };
    f.reset = [](void* owner) { (static_cast<S*>(owner)->*Member).reset(); };
}

template <auto Member, class S, class T>
void fillObject(Field& f) {
    f.kind = Kind::object;
    f.nested = &tableOf<T>();
    f.object = [](void* owner, bool) -> void* {
        auto& member = static_cast<S*>(owner)->*Member;
        if constexpr (std::is_same_v<std::remove_reference_t<decltype(member)>, T>) {
            return &member;
        } else {
            return &*member;
        }
    };
    f.readObject = [](const void* owner) -> const void* {
        const auto& member = static_cast<const S*>(owner)->*Member;
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(member)>, T>) {
            return &member;
        } else {
            return &*member;
        }
    };
}

/// A variant of kinds, one for each choice.
template <class T>
concept Kinds = requires(const T& value) {
    T::ofIndex(value.index());
};

template <auto Member, class S, class E>
void fillChoice(Field& f) {
    f.kind = Kind::choice;
    f.choices = choicesOf<E>();
    f.getChoice = [](const void* owner) {
        const E& value = static_cast<const S*>(owner)->*Member;
        if constexpr (Kinds<E>) {
            return static_cast<int>(value.index());
        } else {
            return static_cast<int>(value);
        }
    };
    f.setChoice = [](void* owner, int v) {
        E& value = static_cast<S*>(owner)->*Member;
        if constexpr (Kinds<E>) {
            value = E::ofIndex(static_cast<std::size_t>(v));
        } else {
            value = static_cast<E>(v);
        }
    };
}

template <auto Member, class S, CountOrWord T>
void fillCountOrWord(Field& f) {
    f.kind = Kind::countOrWord;
    f.choices = T::words();
    f.expected = T::expected;
    f.getChoice = [](const void* owner) {
        const std::optional<std::size_t> word = (static_cast<const S*>(owner)->*Member).word();
        return word ? static_cast<int>(*word) : -1;
    };
    f.setChoice = [](void* owner, int v) {
        static_cast<S*>(owner)->*Member = v < 0 ? T{} : T::ofWord(static_cast<std::size_t>(v));
    };
    f.number = [](void* owner) { return (static_cast<S*>(owner)->*Member).number(); };
    f.setNumber = [](void* owner, int n) { static_cast<S*>(owner)->*Member = T::ofNumber(n); };
}

} // namespace detail

/// Binds a row to a member; the kind follows from the member's type. Use SPARKOUT_FIELD.
template <auto Member>
Field makeField(const char* key, const Row& row) {
    using S = typename detail::MemberOf<Member>::Struct;
    using T = typename detail::MemberOf<Member>::Type;
    Field f;
    static_cast<Row&>(f) = row;
    f.key = key;
    f.member = [](void* owner) -> void* { return &(static_cast<S*>(owner)->*Member); };
    if constexpr (detail::isValue<T>) {
        f.same = [](const void* a, const void* b) {
            return static_cast<const S*>(a)->*Member == static_cast<const S*>(b)->*Member;
        };
    }
    if constexpr (std::is_same_v<T, double>) {
        f.kind = Kind::number;
    } else if constexpr (std::is_same_v<T, std::optional<double>>) {
        f.kind = Kind::optionalNumber;
    } else if constexpr (std::is_same_v<T, int>) {
        f.kind = Kind::integer;
    } else if constexpr (std::is_same_v<T, std::optional<int>>) {
        f.kind = Kind::optionalInteger;
    } else if constexpr (std::is_same_v<T, bool>) {
        f.kind = Kind::boolean;
    } else if constexpr (std::is_same_v<T, std::string>) {
        f.kind = Kind::text;
    } else if constexpr (std::is_enum_v<T> || detail::Kinds<T>) {
        detail::fillChoice<Member, S, T>(f);
    } else if constexpr (std::is_same_v<T, std::vector<double>>) {
        f.kind = Kind::numberList;
    } else if constexpr (std::is_same_v<T, std::optional<std::vector<double>>>) {
        f.kind = Kind::optionalNumberList;
    } else if constexpr (CountOrWord<T>) {
        detail::fillCountOrWord<Member, S, T>(f);
    } else if constexpr (std::is_same_v<T, GivenCompliance>) {
        f.kind = Kind::compliance;
    } else if constexpr (std::is_same_v<T, Levels>) {
        f.kind = Kind::levels;
    } else if constexpr (std::is_same_v<T, NumberRows>) {
        f.kind = Kind::numberRows;
    } else if constexpr (std::is_same_v<T, Samples>) {
        f.kind = Kind::samples;
    } else if constexpr (std::is_same_v<T, JsonText>) {
        f.kind = Kind::jsonText;
    } else if constexpr (detail::IsVector<T>::value) {
        detail::fillList<Member, S, typename T::value_type>(f);
    } else if constexpr (detail::IsOptional<T>::value || detail::IsOptionalIndirect<T>::value
                         || detail::IsOptionalShared<T>::value) {
        detail::fillOptionalObject<Member, S, typename T::value_type>(f);
    } else if constexpr (detail::IsIndirect<T>::value) {
        detail::fillObject<Member, S, typename T::value_type>(f);
    } else {
        detail::fillObject<Member, S, T>(f);
    }
    return f;
}

/// A row whose JSON key is the member's own name.
#define SPARKOUT_FIELD(Struct, member, ...)                                                        \
    ::sparkout::makeField<&Struct::member>(#member, ::sparkout::Row{__VA_ARGS__})

/// Makes the table of T. A member without a row does not compile.
template <class T, std::size_t Rows>
StructInfo makeTable(const char* name, const std::array<Field, Rows>& fields) {
    static_assert(detail::countMembers<T>() == Rows, "every member of the struct needs its row");
    static const T defaults{};
    return {name, fields, &defaults};
}

} // namespace sparkout
