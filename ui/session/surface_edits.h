// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/document.h"

#include <QCoreApplication>

#include <cstddef>
#include <string>
#include <vector>

namespace sparkout {

/// Edits of the surfaces of a document, each one step of its history. Several surfaces have
/// different names; a single surface needs none.
class SurfaceEdits {
    Q_DECLARE_TR_FUNCTIONS(SurfaceEdits)

public:
    explicit SurfaceEdits(Document& document) : m_document(document) {}

    [[nodiscard]] bool canAdd() const;
    [[nodiscard]] bool canRemove() const { return m_document.surfaceCount() > 1; }
    [[nodiscard]] bool canMove(int by) const; ///< the current surface
    /// Returns whether a name is not empty and belongs to no other surface.
    [[nodiscard]] bool isFreeName(const QString& name, std::size_t of) const;
    [[nodiscard]] QString freeName() const; ///< name for an added surface
    /// Returns the displayed name of a surface: its name, otherwise "Surface 1".
    [[nodiscard]] static QString nameOf(const SetupState& state, std::size_t surface);

    /// Adds a surface after the current one and makes it current. It has no kept runs; `open`: the
    /// numbers of its drawing that are still to be entered; `startsWhenDrawn`: a starting cycle is
    /// made once they are.
    void add(Project project, const QString& name, std::vector<std::string> open = {},
             bool startsWhenDrawn = true, bool isDuplicate = false);
    bool rename(std::size_t surface,
                const QString& name); ///< returns false without a change if the name is not free
    void remove();                    ///< the current surface
    void move(int by);                ///< moves the current surface in the order of grinding
    void setTimes(const SetupTimes& times, const WheelWear& wear);

private:
    void insert(SurfaceState surface, const EditText& text);

    Document& m_document;
};

} // namespace sparkout
