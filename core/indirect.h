// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

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

/// Many numbers that never change: copies share them, so that copying a project with traces of
/// thousands of samples is cheap.
class Samples {
public:
    Samples() = default; ///< none
    explicit Samples(std::vector<double> values)
        : m_values(std::make_shared<const std::vector<double>>(std::move(values))) {}

    [[nodiscard]] const std::vector<double>& values() const {
        static const std::vector<double> none;
        return m_values ? *m_values : none;
    }
    [[nodiscard]] std::size_t size() const { return values().size(); }
    [[nodiscard]] bool empty() const { return values().empty(); }
    [[nodiscard]] double operator[](std::size_t index) const { return values()[index]; }

    friend bool operator==(const Samples& a, const Samples& b) {
        return a.m_values == b.m_values || a.values() == b.values();
    }

private:
    std::shared_ptr<const std::vector<double>> m_values; // null: no values
};

} // namespace sparkout
