// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace sparkout {

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
