// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

namespace sparkout {

/// A T on the heap, for a member whose type is only declared. It is a value like T: copied and
/// const with its owner, constructed with it, and empty only after a move, when it may be
/// destroyed, assigned and copied. Modelled on std::indirect of C++26.
///
/// Functions that need the complete T are neither defined in the class nor inline: a header that
/// only declares T has `extern template class Indirect<T>;`, one source `template class
/// Indirect<T>;`.
template <class T>
class Indirect {
public:
    using value_type = T;

    Indirect(); ///< with T's default initialisers
    Indirect(const Indirect& other);
    Indirect(Indirect&& other) noexcept;
    Indirect& operator=(const Indirect& other);
    Indirect& operator=(Indirect&& other) noexcept;
    ~Indirect();

    [[nodiscard]] T& operator*() & { return *m_value; }
    [[nodiscard]] const T& operator*() const& { return *m_value; }
    [[nodiscard]] T* operator->() & { return &**this; }
    [[nodiscard]] const T* operator->() const& { return &**this; }
    const T& operator*() const&& = delete; // prevents references into a temporary
    const T* operator->() const&& = delete;

private:
    std::unique_ptr<T> m_value; // null after a move
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
        *m_value = *other.m_value; // reuses allocated memory
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
