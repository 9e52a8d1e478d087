// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/forms/correlation_box.h"

#include "core/project/batch.h"
#include "core/project/given_factors.h"
#include "core/study/batch_edits.h"
#include "ui/fields/mark.h"
#include "ui/inputs/forms/page_columns.h"
#include "ui/session/document.h"
#include "ui/tables/pasted_cells.h"
#include "ui/text/hint_text.h"
#include "ui/text/texts.h"

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

double correlationOf(const Project& project, std::size_t i, std::size_t j) {
    const NumberRows& matrix = project.batch ? project.batch->correlation : std::nullopt;
    return matrix && i < matrix->size() && j < (*matrix)[i].size() ? (*matrix)[i][j] : 0;
}

} // namespace

CorrelationBox::CorrelationBox(std::string path, const Field& field, int depth, Document& document,
                               QWidget* parent)
    : InputBox(std::move(path), field, depth, document, parent) {
    setObjectName(QString::fromStdString(this->path()));
    rows().addWidget(&numbers());
    rows().addWidget(&reason());
    numbers().setOrder(
        [this](const PastedCells& cells, QString& fault) { return orderOf(cells, fault); });
}

void CorrelationBox::showProject(bool replaced) {
    std::vector<NumberLines::Line> lines;
    const std::vector<GivenFactor> given = givenFactors(document().project());
    for (std::size_t i = 0; i < given.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (given[i].isLaw() || given[j].isLaw()) {
                continue;
            }
            NumberLines::Line line;
            line.path = path() + "/" + std::to_string(i) + "/" + std::to_string(j);
            line.spec.hard = field().hard;
            line.get = [i, j](const Project& project) {
                return std::optional(correlationOf(project, i, j));
            };
            line.set = [i, j](Project& project, std::optional<double> value) {
                if (value) {
                    project = withCorrelation(std::move(project), j, i, *value);
                }
            };
            line.label = [a = given[j].kind, b = given[i].kind] {
                return tr("%1 – %2", "two factors")
                    .arg(inputText(factorLabel(a)), inputText(factorLabel(b)));
            };
            line.hint = [] {
                return tr("Between −1 and 1; 0: independent. Of normal factors Pearson's "
                          "coefficient, of others nearly Spearman's.");
            };
            lines.push_back(std::move(line));
        }
    }
    setVisible(!lines.empty());
    numbers().setLines(std::move(lines));
    numbers().showProject(replaced);
}

/// The cells of a whole matrix below its diagonal, in the order of the lines; of any other block
/// all cells.
std::vector<QString> CorrelationBox::orderOf(const PastedCells& cells, QString& fault) const {
    const std::vector<GivenFactor> given = givenFactors(document().project());
    const auto size = static_cast<qsizetype>(given.size());
    const bool square = size > 1 && cells.rows.size() == given.size()
                        && std::ranges::all_of(cells.rows, [size](const QStringList& row) {
                               return row.size() == size;
                           });
    if (!square) {
        return cells.inOrder();
    }
    std::vector<QString> ordered;
    for (qsizetype i = 0; i < size; ++i) {
        const auto row = static_cast<std::size_t>(i);
        if (pastedNumber(cells.rows[row][i]).value_or(1) != 1) {
            fault = tr("row %1, column %1: “%2” is not 1").arg(i + 1).arg(cells.rows[row][i]);
            return {};
        }
        for (qsizetype j = 0; j < i; ++j) {
            const QString below = cells.rows[row][j];
            const QString above = cells.rows[static_cast<std::size_t>(j)][i];
            if (!above.trimmed().isEmpty() && pastedNumber(above) != pastedNumber(below)) {
                fault = tr("row %1, column %2: “%3” differs from “%4” across the diagonal")
                            .arg(QString::number(j + 1), QString::number(i + 1), above, below);
                return {};
            }
            if (!given[row].isLaw() && !given[static_cast<std::size_t>(j)].isLaw()) {
                ordered.push_back(below);
            }
        }
    }
    return ordered;
}

void CorrelationBox::setOutcome(const OutcomePtr& outcome) {
    reason().showRemark(remarkAt(outcome->issues, path()));
    numbers().setIssues(outcome->issues);
}

void CorrelationBox::retranslate() {
    setTitle(inputText(field().label));
    setAccessibleName(title());
    setToolTip(hintMarkup(field()));
    numbers().retranslate();
}

} // namespace sparkout
