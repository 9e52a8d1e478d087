// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace sparkout {

/// The unit of all times of one chart or table: seconds where the longest is below two minutes,
/// otherwise minutes.
class TimeUnit {
public:
    explicit TimeUnit(double longest_s = 0);

    [[nodiscard]] double of(double time_s) const { return time_s / m_seconds; }
    [[nodiscard]] QString text() const;                      ///< "s", "min"
    [[nodiscard]] QString titled(const QString& name) const; ///< "Time, s"

private:
    double m_seconds;
};

} // namespace sparkout
