// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "ui/inputs/list_model.h"
#include "ui/table/csv_table.h"

#include <QString>
#include <QStringList>
#include <QWidget>

#include <functional>
#include <set>

class QLabel;
class QPushButton;

namespace sparkout {

class Document;
struct Measured;

/// A list of the project's measured data, with its words, places and several numbers in a cell.
class DataModel : public ListModel {
    Q_OBJECT
public:
    enum class List { parts, summaries, traces };

    DataModel(List list, Document& document, QObject* parent = nullptr);

    void addRow(); ///< adds a copy of the last row; of a part only its place
    void takeAway(const std::set<int, std::greater<>>& rows);
    /// The words to choose from in a cell; empty if it is typed, or cannot be edited.
    [[nodiscard]] QStringList choices(int row, const Field& column) const;
    [[nodiscard]] CsvTable table() const;

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    /// Accepts what is displayed.
    [[nodiscard]] QString takeText(Project& project, int row, const Field& column,
                                   const QString& text) const override;

protected:
    [[nodiscard]] bool shows(const Field& column) const override;
    [[nodiscard]] QString valueShown(const QModelIndex& index) const override;

private:
    void follow();
    void edit(Project project, const Field& of);
    [[nodiscard]] bool isEditable(const Field& column) const;

    List m_which;
    OptionalShared<Measured> m_shown;
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
