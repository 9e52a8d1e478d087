// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measured/cli_parameters.h"

#include "app/io/cli_io.h"

#include <algorithm>
#include <charconv>
#include <cstddef>

namespace sparkout::cli {

std::optional<std::vector<FittedParameter>> parametersOf(const std::string& text) {
    std::vector<FittedParameter> found;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t end = std::min(text.find(',', from), text.size());
        std::string key = text.substr(from, end - from);
        from = end + 1;
        FittedParameter parameter;
        bool isKnown = true;
        if (const std::size_t colon = key.find(':'); colon != std::string::npos) {
            int place = -1;
            const char* const last = key.data() + key.size();
            const auto [read, error] = std::from_chars(key.data() + colon + 1, last, place);
            isKnown = error == std::errc() && read == last && place >= 0;
            parameter.place = place;
            key.resize(colon);
        }
        int kind = 0;
        while (kind < static_cast<int>(FittedKind::count_)
               && key != sparkout::keyOf(static_cast<FittedKind>(kind))) {
            ++kind;
        }
        parameter.kind = static_cast<FittedKind>(kind);
        if (!isKnown || parameter.kind == FittedKind::count_) {
            return std::nullopt;
        }
        found.push_back(parameter);
    }
    return found;
}

std::string parameterName(const FittedParameter& parameter) {
    const std::string key = sparkout::keyOf(parameter.kind);
    return parameter.place ? key + ':' + std::to_string(*parameter.place) : key;
}

int refuseParameters(const std::string& option) {
    std::string known;
    for (int kind = 0; kind < static_cast<int>(FittedKind::count_); ++kind) {
        known += (known.empty() ? "" : ", ")
                 + std::string(sparkout::keyOf(static_cast<FittedKind>(kind)));
    }
    return usageError(option + " needs parameters out of " + known
                      + "; compliance:N is of one zone or section");
}

} // namespace sparkout::cli
