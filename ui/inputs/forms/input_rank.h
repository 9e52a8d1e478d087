// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/project/project.h"

#include <optional>
#include <string>
#include <vector>

namespace sparkout {

/// Which inputs of a page are to be seen: the usual ones, and of the others those that say
/// something here; or all.
class InputRank {
public:
    bool showsAll = false;
    std::vector<std::string> wanted;    ///< paths that were asked for: by a message, by the search
    std::optional<Project> asCatalogue; ///< the project as the chosen entry of a catalogue makes it

    /// Whether the input at a path of this project is to be seen whatever its rank: it, or
    /// something below it, was asked for, is calibrated, or is neither as a new project nor as the
    /// chosen entry of the catalogue has it.
    [[nodiscard]] bool isNews(const Project& project, const std::string& path) const;
    [[nodiscard]] bool shows(const Project& project, const Field& field,
                             const std::string& path) const {
        return showsAll || field.usual || isNews(project, path);
    }
};

} // namespace sparkout
