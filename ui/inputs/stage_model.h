// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/project/cycle.h"
#include "ui/inputs/form_page.h"
#include "ui/inputs/mark.h"

#include <QAbstractTableModel>
#include <QMap>

#include <vector>

namespace sparkout {

class Document;

/// The stages of the document's cycle as a table: a row a stage, a column a number that the
/// operation reads. A text that was refused is kept beside the value it did not replace.
class StageModel : public QAbstractTableModel {
    Q_OBJECT

public:
    explicit StageModel(Document& document, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

    [[nodiscard]] const Field& field(const QModelIndex& index) const;
    [[nodiscard]] const Stage& stage(const QModelIndex& index) const;
    [[nodiscard]] std::optional<double> number(const QModelIndex& index) const;
    void setNumber(const QModelIndex& index, std::optional<double> value);
    void setSparkOut(const QModelIndex& index, SparkOut sparkOut);

    void refuse(const QModelIndex& index, const QString& text, const QString& reason);
    void accept(const QModelIndex& index);
    [[nodiscard]] QString refusedText(const QModelIndex& index) const;
    [[nodiscard]] std::vector<Refusal> refusals() const;
    [[nodiscard]] Remark remark(const QModelIndex& index) const;
    [[nodiscard]] std::string path(const QModelIndex& index) const;
    [[nodiscard]] QModelIndex indexAt(const std::string& path) const;

    void setIssues(const Issues& issues);
    void update(bool replaced); ///< takes the document's stages
    void retranslate();

signals:
    void refusalsChanged();

private:
    struct Refused {
        QString text;
        QString reason;
    };
    using Cell = std::pair<int, const Field*>;

    [[nodiscard]] std::vector<const Field*> relevantColumns() const;
    [[nodiscard]] bool relevant(const QModelIndex& index) const;
    [[nodiscard]] QString shown(const QModelIndex& index) const;
    [[nodiscard]] QString sparkOutShown(const QModelIndex& index) const;

    Document& m_document;
    std::vector<const Field*> m_columns;
    int m_rows = 0;
    QMap<Cell, Refused> m_refused;
    Issues m_issues;
};

} // namespace sparkout
