// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/editors/factor_lines.h"

#include "core/project/batch.h"
#include "core/project/member.h"
#include "ui/text/texts.h"

#include <QCoreApplication>

#include <limits>
#include <utility>

namespace sparkout {

namespace {

using Values = std::optional<std::vector<double>>;

const Factor* lawIn(const Field& field, const Project& project) {
    return project.batch ? static_cast<const Factor*>(field.objectIn(&project.batch->factors))
                         : nullptr;
}

Factor* lawIn(const Field& field, Project& project) {
    return const_cast<Factor*>(lawIn(field, std::as_const(project)));
}

class FactorLines {
    Q_DECLARE_TR_FUNCTIONS(FactorLines)

    using Line = NumberLines::Line;

public:
    FactorLines(const std::string& path, const Field& field, const GivenFactor& factor)
        : m_path(path), m_field(field), m_allowed(factor.allowed) {}

    std::vector<Line> of(FactorForm form, bool truncated) {
        switch (form) {
        case FactorForm::constant: addConstant(); break;
        case FactorForm::uniform:
            add(&Factor::uniform, "uniform", 0, QT_TR_NOOP("Minimum"));
            add(&Factor::uniform, "uniform", 1, QT_TR_NOOP("Maximum"));
            break;
        case FactorForm::normal:
            add(&Factor::normal, "normal", 0, QT_TR_NOOP("Mean"));
            add(&Factor::normal, "normal", 1, QT_TR_NOOP("Standard deviation"));
            m_lines.back().spec.hard = {0, std::numeric_limits<double>::infinity()};
            if (truncated) {
                add(&Factor::within, "within", 0, QT_TR_NOOP("Minimum"));
                add(&Factor::within, "within", 1, QT_TR_NOOP("Maximum"));
            }
            break;
        case FactorForm::triangular:
            add(&Factor::triangular, "triangular", 0, QT_TR_NOOP("Minimum"));
            add(&Factor::triangular, "triangular", 1, QT_TR_NOOP("Most frequent"));
            add(&Factor::triangular, "triangular", 2, QT_TR_NOOP("Maximum"));
            break;
        case FactorForm::measured: break;
        case FactorForm::grows:
            add(&Factor::grows, "grows", 0, QT_TR_NOOP("First part"));
            add(&Factor::grows, "grows", 1, QT_TR_NOOP("Last part"));
            addBetweenDressings();
            break;
        }
        return std::move(m_lines);
    }

private:
    Line& addLine(const std::string& key, const char* label, const char* hintRow) {
        Line line;
        line.path = m_path + "/" + key;
        line.spec.hard = m_allowed;
        line.spec.unit = m_field.unit;
        line.label = [label] { return tr(label); };
        const Field* row = tableOf<Factor>().find(hintRow);
        line.hint = [row, range = m_allowed, unit = m_field.unit] {
            return inputText(row->hint) + QStringLiteral(" ")
                   + tr("Allowed: %1.").arg(rangeBrief(range, unit));
        };
        m_lines.push_back(std::move(line));
        return m_lines.back();
    }

    void add(Values Factor::*values, const char* key, std::size_t index, const char* label) {
        Line& line = addLine(std::string(key) + "/" + std::to_string(index), label, key);
        line.get = [&field = m_field, values,
                    index](const Project& project) -> std::optional<double> {
            const Factor* law = lawIn(field, project);
            return law && law->*values && index < (law->*values)->size()
                       ? std::optional((*(law->*values))[index])
                       : std::nullopt;
        };
        line.set = [&field = m_field, values, index](Project& project,
                                                     std::optional<double> value) {
            Factor* law = lawIn(field, project);
            if (law && law->*values && index < (law->*values)->size() && value) {
                (*(law->*values))[index] = *value;
            }
        };
    }

    void addConstant() {
        add(&Factor::uniform, "uniform", 0, QT_TR_NOOP("Value"));
        m_lines.back().set = [&field = m_field](Project& project, std::optional<double> value) {
            if (Factor* law = lawIn(field, project); law && value) {
                law->uniform = {*value, *value};
            }
        };
    }

    void addBetweenDressings() {
        const Field& row = *tableOf<Factor>().find("parts_between_dressings");
        Line& line = addLine(row.key, "", row.key);
        line.spec = NumberSpec::of(row);
        line.label = [&row] { return inputText(row.label); };
        line.hint = [&row] {
            return inputText(row.hint) + u' ' + tr("Empty: %1.").arg(inputText(row.nullMeaning));
        };
        line.get = [&field = m_field, &row](const Project& project) {
            const Factor* law = lawIn(field, project);
            return law ? numberIn(row, law) : std::nullopt;
        };
        line.set = [&field = m_field, &row](Project& project, std::optional<double> value) {
            if (Factor* law = lawIn(field, project)) {
                setNumberIn(row, law, value);
            }
        };
    }

    std::string m_path;
    const Field& m_field;
    Range m_allowed;
    std::vector<Line> m_lines;
};

} // namespace

std::vector<NumberLines::Line> factorLines(const std::string& path, const Field& field,
                                           const GivenFactor& factor, FactorForm form) {
    return FactorLines(path, field, factor).of(form, factor.law.within.has_value());
}

} // namespace sparkout
