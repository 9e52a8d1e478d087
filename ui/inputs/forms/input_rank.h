// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/project/project.h"

#include <optional>
#include <string>
#include <vector>

namespace sparkout {

/// Which inputs of a page are shown: all, or the usual ones and those of the others that matter in
/// this project.
class InputRank {
public:
    bool showsAll = false;
    std::vector<std::string> wanted;    ///< paths requested by a message or by the search
    std::optional<Project> asCatalogue; ///< project with the values of the chosen catalogue entry

    /// Whether the input at a path is shown whatever its rank: it, or something below it, was
    /// requested, is calibrated, or differs from both a new project and the chosen catalogue entry.
    [[nodiscard]] bool isNews(const Project& project, const std::string& path) const;
    [[nodiscard]] bool shows(const Project& project, const Field& field,
                             const std::string& path) const {
        return showsAll || field.usual || isNews(project, path);
    }
};

} // namespace sparkout
