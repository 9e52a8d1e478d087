// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

namespace sparkout {

/// A T kept apart from its owner, so that a struct can hold one where T is only declared. It is a
/// value as the T itself would be: copied and const with its owner, made with it, and never empty
/// but after it was moved from, when it may be destroyed, assigned and copied. In the manner of
/// std::indirect of C++26.
///
/// What needs the complete T is neither defined in the class nor inline: a header that only
/// declares T says `extern template class Indirect<T>;`, one source `template class Indirect<T>;`.
template <class T>
class Indirect {
public:
    using value_type = T;

    Indirect(); ///< of a value as T's initialisers make it
    Indirect(const Indirect& other);
    Indirect(Indirect&& other) noexcept;
    Indirect& operator=(const Indirect& other);
    Indirect& operator=(Indirect&& other) noexcept;
    ~Indirect();

    [[nodiscard]] T& operator*() & { return *m_value; }
    [[nodiscard]] const T& operator*() const& { return *m_value; }
    [[nodiscard]] T* operator->() & { return &**this; }
    [[nodiscard]] const T* operator->() const& { return &**this; }
    const T& operator*() const&& = delete; // of an owner that is about to go: give it a name
    const T* operator->() const&& = delete;

private:
    std::unique_ptr<T> m_value; // null after a move from it
};

template <class T>
Indirect<T>::Indirect() : m_value(std::make_unique<T>()) {}

template <class T>
Indirect<T>::Indirect(const Indirect& other)
    : m_value(other.m_value ? std::make_unique<T>(*other.m_value) : nullptr) {}

template <class T>
Indirect<T>::Indirect(Indirect&&) noexcept = default;

template <class T>
Indirect<T>& Indirect<T>::operator=(const Indirect& other) {
    if (m_value && other.m_value) {
        *m_value = *other.m_value; // what it has allocated is used again
    } else {
        *this = Indirect(other);
    }
    return *this;
}

template <class T>
Indirect<T>& Indirect<T>::operator=(Indirect&&) noexcept = default;

template <class T>
Indirect<T>::~Indirect() = default;

} // namespace sparkout
