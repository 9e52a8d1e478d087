// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/search_names.h"

namespace sparkout {

const char* searchMethodName(SearchMethod method) {
    switch (method) {
    case SearchMethod::full: return "full";
    case SearchMethod::pruned: return "search";
    case SearchMethod::published: return "dp";
    case SearchMethod::labels: return "labels";
    }
    return "";
}

std::optional<SearchMethod> searchMethodNamed(std::string_view name) {
    for (const SearchMethod method : {SearchMethod::full, SearchMethod::pruned,
                                      SearchMethod::published, SearchMethod::labels}) {
        if (name == searchMethodName(method)) {
            return method;
        }
    }
    return std::nullopt;
}

const char* searchStatusName(SearchStatus status) {
    switch (status) {
    case SearchStatus::proved: return "proved";
    case SearchStatus::infeasible: return "infeasible";
    case SearchStatus::stopped: return "stopped";
    case SearchStatus::found: return "found";
    case SearchStatus::notFound: return "not_found";
    }
    return "";
}

} // namespace sparkout
