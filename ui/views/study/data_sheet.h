// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "ui/table/csv_table.h"
#include "ui/table/value_table.h"

#include <QString>
#include <QWidget>

#include <map>
#include <utility>
#include <vector>

class QLabel;
class QPushButton;

namespace sparkout {

class Document;
struct Measured;

/// A list of the project's measured data as a table to edit in place: a row for each item, a column
/// for each member. A refused text is kept, with its reason, beside the unchanged value.
class DataModel : public TableModel {
    Q_OBJECT
public:
    enum class List { parts, summaries, traces };

    DataModel(List list, Document& document, QObject* parent = nullptr);

    void addRow(); ///< adds a copy of the last row
    void takeAway(std::vector<int> rows);
    /// The choices of a cell; empty if it is typed, or cannot be edited.
    using Choices = std::vector<std::pair<QString, int>>;
    [[nodiscard]] Choices choices(const QModelIndex& cell) const;
    [[nodiscard]] CsvTable table() const;

    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

private:
    [[nodiscard]] int rowsShown() const override { return m_rows; }
    [[nodiscard]] int columnsShown() const override { return static_cast<int>(m_columns.size()); }
    [[nodiscard]] QVariant cell(int row, int column, int role) const override;
    [[nodiscard]] QVariant head(int column, int role) const override;

    void follow();
    [[nodiscard]] const Measured& measured() const;
    [[nodiscard]] const void* item(int row) const;
    [[nodiscard]] bool isPlace(const Field& field) const;
    [[nodiscard]] bool isEditable(const Field& field) const;
    [[nodiscard]] QString shown(int row, const Field& field) const;
    /// Puts a text into an item; returns the reason of a refusal.
    [[nodiscard]] QString take(void* item, const Field& field, const QString& text) const;
    [[nodiscard]] QString takeNumber(void* item, const Field& field, const QString& text) const;
    [[nodiscard]] const char* editName() const;

    struct Refused {
        QString text, reason;
    };

    List m_which;
    const Field& m_list;
    Document& m_document;
    OptionalShared<Measured> m_shown;
    int m_rows = 0;
    std::vector<const Field*> m_columns;
    std::map<std::pair<int, const Field*>, Refused> m_refused;
};

class CopyTable;
class Settings;

/// One list of the measured data: a table with buttons to add and remove rows.
class DataSheet : public QWidget {
    Q_OBJECT
public:
    DataSheet(DataModel::List list, Document& document, Settings* settings, QWidget* parent);

    [[nodiscard]] CopyTable* table() const { return m_table; }
    void retranslate();

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void fitRows(); ///< adapts to the font size
    void addRow();
    void removeRows();
    void showButtons();

    DataModel::List m_list;
    DataModel* m_model;
    CopyTable* m_table;
    QLabel* m_note;
    QPushButton *m_add, *m_remove;
};

} // namespace sparkout
