// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/temporary_file.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <string_view>

namespace sparkout {
namespace {

/// Removes the name. Retries after any error, since a temporary file must not be left.
void removeName(const Folder& folder, const std::string& name) {
    for (int attempt = 0; attempt < 3; ++attempt) {
        const int failed = removeIn(folder, name);
        if (failed == 0 || failed == ENOENT)
            return;
    }
}

std::string hex(std::uint64_t value) {
    std::array<char, 17> text{};
    std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(value));
    return text.data();
}

constexpr std::string_view temporarySuffix = ".tmp";

std::string temporaryName(const std::string& prefix) {
    return prefix + hex(randomNumber()) + std::string(temporarySuffix);
}

bool isTemporaryName(std::string_view name, std::string_view prefix) {
    if (name.size() != prefix.size() + 16 + temporarySuffix.size() || !name.starts_with(prefix)
        || !name.ends_with(temporarySuffix))
        return false;
    const std::string_view random = name.substr(prefix.size(), 16);
    return random.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

/// Removes one leftover: a regular file of ours that no running save has locked.
void removeLeftover(const Folder& folder, const std::string& name) {
    Descriptor file;
    FileFacts opened;
    FileFacts named;
    if (openIn(folder, name, Opening::read, file) == 0 && factsOf(file, opened) == 0
        && opened.kind == FileKind::regular && opened.ofThisUser && lockFile(file) == Locking::taken
        && factsIn(folder, name, named) == 0 && sameFile(opened, named))
        removeName(folder, name);
}

} // namespace

TemporaryName::~TemporaryName() {
    if (!m_name.empty())
        removeName(*m_folder, m_name);
}

std::string temporaryPrefix(const std::string& target) {
    // A hash (FNV-1a) represents the target's name, which may have 255 bytes itself.
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char c : target)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    return ".sparkout-" + hex(hash) + "-";
}

int createTemporary(const Folder& folder, const std::string& prefix, std::uint32_t mode,
                    Descriptor& file, std::string& name) {
    for (int attempt = 0; attempt < 16; ++attempt) {
        name = temporaryName(prefix);
        const int failed = createIn(folder, name, mode, file);
        if (failed == EEXIST)
            continue;
        if (failed != 0)
            return failed;
        const bool locked = lockFile(file) != Locking::heldElsewhere;
        FileFacts made;
        const int error = factsOf(file, made);
        if (error == 0 && locked && made.links > 0)
            return 0;
        removeName(folder, name);
        if (error != 0)
            return error;
        // another save was cleaning up at this moment: take another name
    }
    return EEXIST;
}

void removeLeftovers(const Folder& folder, const std::string& prefix) {
    forEachNameIn(folder, [&](const std::string& name) {
        if (isTemporaryName(name, prefix))
            removeLeftover(folder, name);
    });
}

} // namespace sparkout
