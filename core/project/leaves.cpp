// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/leaves.h"

namespace sparkout {

namespace {

void collectLeaves(const StructInfo& table, const void* owner, const std::string& path,
                   std::vector<Leaf>& leaves) {
    for (const Field& field : table.fields) {
        const std::string here = path + "/" + field.key;
        if (field.kind == Kind::objectList) {
            leaves.push_back({here, &field, owner});
            for (std::size_t i = 0; i < field.size(owner); ++i) {
                collectLeaves(*field.nested, field.itemIn(owner, i), here + "/" + std::to_string(i),
                              leaves);
            }
        } else if (const void* const object = field.nested ? field.objectIn(owner) : nullptr) {
            collectLeaves(*field.nested, object, here, leaves);
        } else {
            leaves.push_back({here, &field, owner});
        }
    }
}

} // namespace

std::vector<Leaf> leavesOf(const StructInfo& table, const void* owner) {
    std::vector<Leaf> leaves;
    collectLeaves(table, owner, {}, leaves);
    return leaves;
}

} // namespace sparkout
