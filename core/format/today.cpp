// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/format/today.h"

#include <chrono>

namespace sparkout {

std::string today() {
    using namespace std::chrono;
    const year_month_day date(floor<days>(system_clock::now()));
    const auto twoDigits = [](unsigned number) {
        return (number < 10 ? "-0" : "-") + std::to_string(number);
    };
    return std::to_string(int(date.year())) + twoDigits(unsigned(date.month()))
           + twoDigits(unsigned(date.day()));
}

} // namespace sparkout
