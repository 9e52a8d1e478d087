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

int* Field::wholeNumber(void* owner) const {
    switch (kind) {
    case Kind::integer: return &as<int>(owner);
    case Kind::optionalInteger: {
        auto& value = as<std::optional<int>>(owner);
        return value ? &*value : nullptr;
    }
    case Kind::countOrWord: return number(owner);
    default: return nullptr;
    }
}

} // namespace sparkout
