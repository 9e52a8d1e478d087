// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pack/pack.h"

#include <algorithm>

namespace sparkout {

std::size_t Pack::count() const {
    const std::size_t heads = company.empty() && logo.empty() ? 0 : 1;
    return machines.size() + wheels.size() + materials.size() + lessons.size() + heads;
}

bool isLessonFileName(std::string_view name) {
    constexpr std::string_view ending = ".sparkout-lesson";
    constexpr std::string_view refused = "/\\<>:\"|?*";
    constexpr std::size_t longest = 120;
    return name.size() > ending.size() && name.size() <= longest && name.ends_with(ending)
           && name.front() != '.' && name.front() != ' '
           && std::ranges::none_of(name, [&](char letter) {
                  const auto code = static_cast<unsigned char>(letter);
                  return code < 0x20 || code == 0x7f || refused.find(letter) != refused.npos;
              });
}

} // namespace sparkout
