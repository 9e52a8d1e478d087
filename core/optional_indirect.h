// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/indirect.h"

#include <optional>
#include <utility>

namespace sparkout {

/// A std::optional<T> that a struct can hold where T is only declared: an Indirect that may be
/// empty. It is a value: copied and const with its owner. What needs the complete T is Indirect's,
/// so that an `extern template class Indirect<T>;` is enough for it.
template <class T>
class OptionalIndirect {
public:
    using value_type = T;

    OptionalIndirect() = default; ///< empty
    OptionalIndirect(const OptionalIndirect& other) = default;
    OptionalIndirect(OptionalIndirect&& other) noexcept ///< which is empty then
        : m_value(std::exchange(other.m_value, std::nullopt)) {}
    OptionalIndirect& operator=(const OptionalIndirect& other) = default;
    OptionalIndirect& operator=(OptionalIndirect&& other) noexcept { ///< which is empty then
        m_value = std::exchange(other.m_value, std::nullopt);
        return *this;
    }
    OptionalIndirect& operator=(T value) {
        (m_value ? **m_value : emplace()) = std::move(value);
        return *this;
    }
    OptionalIndirect& operator=(std::nullopt_t) noexcept {
        reset();
        return *this;
    }
    ~OptionalIndirect() = default;

    /// Instead of what it held, a value as T's initialisers make it.
    T& emplace() { return *m_value.emplace(); }
    void reset() noexcept { m_value.reset(); }

    [[nodiscard]] bool has_value() const { return m_value.has_value(); }
    [[nodiscard]] explicit operator bool() const { return has_value(); }
    [[nodiscard]] T& operator*() & { return **m_value; }
    [[nodiscard]] const T& operator*() const& { return **m_value; }
    [[nodiscard]] T* operator->() & { return &**this; }
    [[nodiscard]] const T* operator->() const& { return &**this; }
    const T& operator*() const&& = delete; // of an owner that is about to go: give it a name
    const T* operator->() const&& = delete;
    [[nodiscard]] T value_or(T other) const { return m_value ? **m_value : std::move(other); }

private:
    std::optional<Indirect<T>> m_value;
};

} // namespace sparkout
