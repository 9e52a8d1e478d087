// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pack/pack.h"
#include "ui/packs/pack_parts.h"

#include <QByteArray>
#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace sparkout {

class Settings;

/// What taking in a pack does, line by line, before it is done: each part is held against what the
/// user has. Nothing of his is replaced unless he chooses it.
class PackPlan {
    Q_DECLARE_TR_FUNCTIONS(PackPlan)

public:
    enum class State {
        fresh,    ///< he has nothing of that name
        shipped,  ///< the program comes with one of that name, which his then stands before
        same,     ///< he has the same
        different ///< he has another of that name
    };
    enum class Choice { leave, take, takeBeside }; ///< the last under a name of its own

    struct Line {
        PackPart part;
        std::size_t index; ///< among its kind in the pack
        QString name;
        QString note;
        State state;
        Choice choice;
    };
    /// A value that he has, and the pack's.
    struct Difference {
        QString what, yours, packs;
    };

    PackPlan(Pack pack, const Settings& settings);

    [[nodiscard]] const Pack& pack() const { return m_pack; }
    /// Why the logo of the pack is left out, and the user's stays; empty: it is not.
    [[nodiscard]] QString logoFault() const { return PackParts::logoFault(m_pack); }
    [[nodiscard]] const std::vector<Line>& lines() const { return m_lines; }
    [[nodiscard]] std::vector<Choice> choices(std::size_t line) const; ///< that there are
    void choose(std::size_t line, Choice choice) { m_lines[line].choice = choice; }
    [[nodiscard]] int chosen() const; ///< lines of which something is taken
    [[nodiscard]] std::vector<Difference> differences(std::size_t line) const;

    /// Does it. What could not be kept is said, a sentence a fault; the rest is done all the same.
    [[nodiscard]] QStringList carryOut(Settings& settings);

private:
    void addEntries(PackPart part);
    void addCompany();
    [[nodiscard]] Company packsCompany() const;
    [[nodiscard]] QString keepCompany(Settings& settings) const;
    void addLessons();
    [[nodiscard]] CatalogueStore& store(PackPart part) const;
    [[nodiscard]] QString lessonPath(const std::string& file) const;
    [[nodiscard]] QString keepEntries(PackPart part);
    [[nodiscard]] QString keepLesson(const Line& line) const;

    Pack m_pack;
    Company m_company; ///< the user's
    QString m_lessons; ///< the folder of his lessons; empty: he has none
    std::array<std::unique_ptr<CatalogueStore>, 3> m_stores;
    std::vector<Line> m_lines;
    /// Hashes of the user's files of the same names as the pack's lessons, in their order; empty:
    /// there is none.
    std::vector<QByteArray> m_known;
};

} // namespace sparkout
