// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/placed_text.h"

#include <cstddef>

namespace sparkout {

std::string placedText(const std::string& sentence, TextPlaces places) {
    std::string out;
    for (std::size_t i = 0; i < sentence.size();) {
        std::size_t taken = 0;
        for (const auto& [name, value] : places) {
            const std::string place = '{' + std::string(name) + '}';
            if (taken == 0 && sentence.compare(i, place.size(), place) == 0) {
                out += value;
                taken = place.size();
            }
        }
        if (taken == 0) {
            out += sentence[i];
            taken = 1;
        }
        i += taken;
    }
    return out;
}

} // namespace sparkout
