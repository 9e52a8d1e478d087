// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/indirect.h"

#include <optional>
#include <utility>

namespace sparkout {

/// An optional T on the heap, for a member whose type is only declared: an Indirect that may be
/// empty. It is a value: copied and const with its owner. `extern template class Indirect<T>;` also
/// suffices for it.
template <class T>
class OptionalIndirect {
public:
    using value_type = T;

    OptionalIndirect() = default; ///< empty
    OptionalIndirect(const OptionalIndirect& other) = default;
    OptionalIndirect(OptionalIndirect&& other) noexcept ///< which is empty afterwards
        : m_value(std::exchange(other.m_value, std::nullopt)) {}
    OptionalIndirect& operator=(const OptionalIndirect& other) = default;
    OptionalIndirect& operator=(OptionalIndirect&& other) noexcept { ///< which is empty afterwards
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

    /// Replaces the contents by a value with T's default initialisers.
    T& emplace() { return *m_value.emplace(); }
    void reset() noexcept { m_value.reset(); }

    [[nodiscard]] bool has_value() const { return m_value.has_value(); }
    [[nodiscard]] explicit operator bool() const { return has_value(); }
    [[nodiscard]] T& operator*() & { return **m_value; }
    [[nodiscard]] const T& operator*() const& { return **m_value; }
    [[nodiscard]] T* operator->() & { return &**this; }
    [[nodiscard]] const T* operator->() const& { return &**this; }
    const T& operator*() const&& = delete; // prevents references into a temporary
    const T* operator->() const&& = delete;
    [[nodiscard]] T value_or(T other) const { return m_value ? **m_value : std::move(other); }

private:
    std::optional<Indirect<T>> m_value;
};

} // namespace sparkout
