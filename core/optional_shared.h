// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

namespace sparkout {

/// An optional T whose copies share one T until one of them is modified: for large, rarely changed
/// values. It is a value: const with its owner, and a change of one copy does not affect another.
/// Non-const access counts as modification, so read through a const object; a pointer obtained for
/// writing is valid until the next copy.
///
/// Like Indirect, T may be only declared, with `extern template class OptionalShared<T>;`.
template <class T>
class OptionalShared {
public:
    using value_type = T;

    OptionalShared() = default; ///< empty

    /// Replaces the contents by a value with T's default initialisers.
    T& emplace();
    void reset() noexcept { m_value.reset(); }

    [[nodiscard]] bool has_value() const { return m_value != nullptr; }
    [[nodiscard]] explicit operator bool() const { return has_value(); }
    [[nodiscard]] T& operator*() &;
    [[nodiscard]] const T& operator*() const& { return *m_value; }
    [[nodiscard]] T* operator->() & { return &**this; }
    [[nodiscard]] const T* operator->() const& { return m_value.get(); }
    const T& operator*() const&& = delete; // prevents references into a temporary
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
