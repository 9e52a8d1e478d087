// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <utility>

namespace sparkout {

/// A std::optional<T> that a struct can hold where T is only declared: an Indirect that may be
/// empty. It is a value: copied and const with its owner. Which members are instantiated where is
/// as with Indirect.
template <class T>
class OptionalIndirect {
public:
    using value_type = T;

    OptionalIndirect(); ///< empty
    OptionalIndirect(const OptionalIndirect& other);
    OptionalIndirect(OptionalIndirect&& other) noexcept; ///< which is empty then
    OptionalIndirect& operator=(const OptionalIndirect& other);
    OptionalIndirect& operator=(OptionalIndirect&& other) noexcept; ///< which is empty then
    OptionalIndirect& operator=(T value);
    OptionalIndirect& operator=(std::nullopt_t) noexcept;
    ~OptionalIndirect();

    /// Instead of what it held, a value as T's initialisers make it.
    T& emplace();
    void reset() noexcept;

    [[nodiscard]] bool has_value() const { return m_value != nullptr; }
    [[nodiscard]] explicit operator bool() const { return has_value(); }
    [[nodiscard]] T& operator*() & { return *m_value; }
    [[nodiscard]] const T& operator*() const& { return *m_value; }
    [[nodiscard]] T* operator->() & { return &**this; }
    [[nodiscard]] const T* operator->() const& { return &**this; }
    const T& operator*() const&& = delete; // of an owner that is about to go: give it a name
    const T* operator->() const&& = delete;
    [[nodiscard]] T value_or(T other) const;

private:
    std::unique_ptr<T> m_value;
};

template <class T>
OptionalIndirect<T>::OptionalIndirect() = default;

template <class T>
OptionalIndirect<T>::OptionalIndirect(const OptionalIndirect& other)
    : m_value(other.m_value ? std::make_unique<T>(*other.m_value) : nullptr) {}

template <class T>
OptionalIndirect<T>::OptionalIndirect(OptionalIndirect&&) noexcept = default;

template <class T>
OptionalIndirect<T>& OptionalIndirect<T>::operator=(const OptionalIndirect& other) {
    if (m_value && other.m_value) {
        *m_value = *other.m_value; // what it has allocated is used again
    } else {
        *this = OptionalIndirect(other);
    }
    return *this;
}

template <class T>
OptionalIndirect<T>& OptionalIndirect<T>::operator=(OptionalIndirect&&) noexcept = default;

template <class T>
OptionalIndirect<T>& OptionalIndirect<T>::operator=(T value) {
    if (m_value) {
        *m_value = std::move(value);
    } else {
        m_value = std::make_unique<T>(std::move(value));
    }
    return *this;
}

template <class T>
OptionalIndirect<T>& OptionalIndirect<T>::operator=(std::nullopt_t) noexcept {
    reset();
    return *this;
}

template <class T>
OptionalIndirect<T>::~OptionalIndirect() = default;

template <class T>
T& OptionalIndirect<T>::emplace() {
    m_value = std::make_unique<T>();
    return *m_value;
}

template <class T>
void OptionalIndirect<T>::reset() noexcept {
    m_value.reset();
}

template <class T>
T OptionalIndirect<T>::value_or(T other) const {
    return m_value ? *m_value : std::move(other);
}

} // namespace sparkout
