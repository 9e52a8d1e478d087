// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

/// When a field of the tables is required or relevant.
namespace sparkout::conditions {

inline bool always(const Project&, const void*) {
    return true;
}
inline bool traverse(const Project& p, const void*) {
    return p.operation == Operation::traverse;
}
inline bool plunge(const Project& p, const void*) {
    return p.operation == Operation::plunge;
}
inline bool external(const Project& p, const void*) {
    return p.part.surface == Surface::external;
}
inline bool internal(const Project& p, const void*) {
    return p.part.surface == Surface::internal;
}

} // namespace sparkout::conditions
