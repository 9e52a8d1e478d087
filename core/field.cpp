// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/field.h"

namespace sparkout {

const Field* StructInfo::find(std::string_view key) const {
    for (const Field& field : fields) {
        if (key == field.key) {
            return &field;
        }
    }
    return nullptr;
}

} // namespace sparkout
