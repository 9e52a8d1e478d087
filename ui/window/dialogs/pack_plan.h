// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/pack.h"
#include "ui/session/catalogue_store.h"
#include "ui/session/settings.h"

#include <QByteArray>
#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace sparkout {

/// The parts of a pack, as texts and types of the window.
enum class PackPart { machine, wheel, material, company, lesson };

class PackParts {
    Q_DECLARE_TR_FUNCTIONS(PackParts)

public:
    [[nodiscard]] static QString name(PackPart part); ///< "Machine"

    [[nodiscard]] static std::vector<CatalogueEntry> entries(const Pack& pack, PackPart part);
    static void add(const CatalogueEntry& entry, Pack& pack);

    /// The document heads of a pack, without unknown keys and without a refused logo. Its picture
    /// is not decoded.
    [[nodiscard]] static Company company(const Pack& pack);
    [[nodiscard]] static QString logoFault(const Pack& pack);   ///< empty: its logo is valid
    static void setCompany(const Company& company, Pack& pack); ///< without a refused logo

    /// The title of a lesson in the window's language.
    [[nodiscard]] static QString title(const Lesson& lesson);
};

/// The kind of catalogue of a part that is an entry of one.
[[nodiscard]] CatalogueKind kindOf(PackPart part);

class Settings;

/// The effects of importing a pack, line by line, before it is done: each part is compared with the
/// user's data, which are replaced only by choice.
class PackPlan {
    Q_DECLARE_TR_FUNCTIONS(PackPlan)

public:
    enum class State {
        fresh,    ///< the user has none with that name
        shipped,  ///< a shipped one has that name; the user's own has priority
        same,     ///< the user has the same
        different ///< the user has another one with that name
    };
    enum class Choice { leave, take, takeBeside }; ///< the last under a new name

    struct Line {
        PackPart part;
        std::size_t index; ///< index among its kind in the pack
        QString name;
        QString note;
        State state;
        Choice choice;
    };
    /// A value of the user's and that of the pack.
    struct Difference {
        QString what, yours, packs;
    };

    PackPlan(Pack pack, const Settings& settings);

    [[nodiscard]] const Pack& pack() const { return m_pack; }
    /// Why the pack's logo is left out and the user's is kept; empty if it is valid.
    [[nodiscard]] QString logoFault() const { return PackParts::logoFault(m_pack); }
    [[nodiscard]] const std::vector<Line>& lines() const { return m_lines; }
    [[nodiscard]] std::vector<Choice> choices(std::size_t line) const; ///< the available ones
    void choose(std::size_t line, Choice choice) { m_lines[line].choice = choice; }
    [[nodiscard]] int chosen() const; ///< number of lines to apply
    [[nodiscard]] std::vector<Difference> differences(std::size_t line) const;

    /// Applies the choices. Returns a sentence for each failure, and continues after it.
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
    QString m_lessons; ///< folder of the user's lessons; may be empty
    std::array<std::unique_ptr<CatalogueStore>, 3> m_stores;
    std::vector<Line> m_lines;
    /// Hashes of the user's files with the names of the pack's lessons, in their order; empty if
    /// there is none.
    std::vector<QByteArray> m_known;
};

} // namespace sparkout
