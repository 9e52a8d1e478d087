// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/lesson/goal.h"
#include "ui/report/format/report.h"

#include <QCoreApplication>
#include <QDate>
#include <QString>
#include <QVariantMap>

#include <string>
#include <vector>

namespace sparkout {

namespace report {

/// The place of the works: additional data for their title pages. All may be empty.
struct Institution {
    std::string ministry;
    std::string university;
    std::string faculty; ///< or institute
    std::string department;
    std::string discipline;
    std::string accepted; ///< by whom: post and name
    std::string place;    ///< town

    friend bool operator==(const Institution&, const Institution&) = default;

    /// The form kept in the settings, without empty values.
    [[nodiscard]] QVariantMap kept() const;
    [[nodiscard]] static Institution fromKept(const QVariantMap& kept);
};

} // namespace report

template <>
const StructInfo& tableOf<report::Institution>();

} // namespace sparkout

namespace sparkout::report {

/// Writes a paper of the course block by block: sections, tables, figures and formulas are numbered
/// by ГОСТ 7.32.
class PaperWriter {
    Q_DECLARE_TR_FUNCTIONS(PaperWriter)
public:
    /// `subject` appears in the properties of the file and, on the program's own sheets, at the
    /// top.
    PaperWriter(const QString& title, const QString& subject, const QString& file,
                const QDate& date, PageStyle style);

    void part(const QString& text);       ///< unnumbered
    void section(const QString& text);    ///< "1 …"
    void subsection(const QString& text); ///< "1.1 …"
    void add(Block block) { m_report.blocks.push_back(std::move(block)); }
    void add(std::vector<Block> blocks);
    void say(const QString& text) { add(Paragraph{text}); }
    /// With its name above; omitted without rows.
    void table(Table table, const QString& caption);
    /// With its number in the caption; returns the number.
    int figure(Figure figure);
    /// A text of a lesson in the current language.
    void lesson(const Bilingual& text);
    /// A text of the user, line by line.
    void lines(const std::string& text);

    [[nodiscard]] const Report& report() const { return m_report; }
    [[nodiscard]] Report take() { return std::move(m_report); }

    [[nodiscard]] static bool isRussian(); ///< whether the current language is Russian
    [[nodiscard]] static QString text(const Bilingual& text); ///< its markup

private:
    Report m_report;
    int m_sections = 0, m_subsections = 0, m_tables = 0, m_figures = 0, m_formulas = 0;
};

/// The title of a lesson, "Work 2. Programmed and actual feed", split into number and name.
struct WorkTitle {
    explicit WorkTitle(const Bilingual& title); ///< translated

    QString number; ///< "2"; empty: the title has none
    QString name;

    [[nodiscard]] QString inFull() const; ///< unchanged
private:
    QString m_full;
};

} // namespace sparkout::report
