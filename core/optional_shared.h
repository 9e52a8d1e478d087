// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

namespace sparkout {

/// A std::optional<T> whose copies share one T until one of them is written to: for what is large
/// and hardly ever changed. It is a value: const with its owner, and a change of one copy is not
/// seen in another. What is reached through a non-const one counts as written to, so that reading
/// goes by way of a const one; a pointer into it is good for writing until the next copy is made.
///
/// As with Indirect, T may be only declared where `extern template class OptionalShared<T>;`
/// stands.
template <class T>
class OptionalShared {
public:
    using value_type = T;

    OptionalShared() = default; ///< empty

    /// Instead of what it held, a value as T's initialisers make it.
    T& emplace();
    void reset() noexcept { m_value.reset(); }

    [[nodiscard]] bool has_value() const { return m_value != nullptr; }
    [[nodiscard]] explicit operator bool() const { return has_value(); }
    [[nodiscard]] T& operator*() &;
    [[nodiscard]] const T& operator*() const& { return *m_value; }
    [[nodiscard]] T* operator->() & { return &**this; }
    [[nodiscard]] const T* operator->() const& { return m_value.get(); }
    const T& operator*() const&& = delete; // of an owner that is about to go: give it a name
    const T* operator->() const&& = delete;

    /// Whether both are empty, or share one value.
    [[nodiscard]] bool isSharedWith(const OptionalShared& other) const {
        return m_value == other.m_value;
    }

private:
    std::shared_ptr<T> m_value; // null: empty
};

template <class T>
T& OptionalShared<T>::emplace() {
    m_value = std::make_shared<T>();
    return *m_value;
}

template <class T>
T& OptionalShared<T>::operator*() & {
    if (m_value.use_count() > 1) {
        m_value = std::make_shared<T>(*m_value);
    }
    return *m_value;
}

} // namespace sparkout
