// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/document.h"

#include <QCoreApplication>

#include <cstddef>
#include <string>
#include <vector>

namespace sparkout {

/// Edits of the surfaces of a document, each a step of its history. While there are several each
/// has a name of its own; a surface alone needs none.
class SurfaceEdits {
    Q_DECLARE_TR_FUNCTIONS(SurfaceEdits)

public:
    explicit SurfaceEdits(Document& document) : m_document(document) {}

    [[nodiscard]] bool canAdd() const;
    [[nodiscard]] bool canRemove() const { return m_document.surfaceCount() > 1; }
    [[nodiscard]] bool canMove(int by) const; ///< the one in front
    /// Not empty, and of no other surface.
    [[nodiscard]] bool isFreeName(const QString& name, std::size_t of) const;
    [[nodiscard]] QString freeName() const; ///< for one that is added
    /// As it is shown: its name, else "Surface 1".
    [[nodiscard]] static QString nameOf(const SetupState& state, std::size_t surface);

    /// Behind the one in front, and in front from then on. It keeps no runs; `open`: the numbers of
    /// its drawing that are yet to be given, and whether a starting cycle is made once they are.
    void add(Project project, const QString& name, std::vector<std::string> open = {},
             bool startsWhenDrawn = true, bool isDuplicate = false);
    bool rename(std::size_t surface, const QString& name); ///< false, and nothing done: not free
    void remove();                                         ///< the one in front
    void move(int by); ///< the one in front, in the order of grinding
    void setTimes(const SetupTimes& times, const WheelWear& wear);

private:
    void insert(SurfaceState surface, const EditText& text);

    Document& m_document;
};

} // namespace sparkout
