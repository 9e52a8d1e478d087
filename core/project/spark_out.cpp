// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/spark_out.h"

#include "core/issue.h"
#include "core/text.h"

#include <array>

namespace sparkout {

static_assert(CountOrWord<SparkOut>);

std::span<const Choice> SparkOut::words() {
    static constexpr std::array words{Choice{"until_size", SPARKOUT_NOOP("Choice", "until size")}};
    return words;
}

Phrase SparkOut::expected() {
    return Phrase::wholeNumberOrUntilSize;
}

} // namespace sparkout
