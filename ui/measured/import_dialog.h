// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/file/text_encoding.h"
#include "core/measured/measured_table.h"
#include "core/project/project.h"
#include "ui/session/job.h"

#include <QDialog>
#include <QObject>
#include <QString>

#include <memory>

class QCheckBox;
class QComboBox;
class QLabel;
class QListWidget;
class QProgressBar;
class QPushButton;
class QRadioButton;
class QTableView;

namespace sparkout {

/// The text of a table of measurements, and its origin.
struct MeasuredSource {
    QString name; ///< name of the file; empty: pasted
    TableText text;
};

using MeasuredSourcePtr = std::shared_ptr<const MeasuredSource>;

using ReadMeasuredPtr = std::shared_ptr<const ReadMeasured>;

/// Reads a table of measurements off the window's thread; a newer reading drops the older one.
class MeasuredReader : public QObject {
    Q_OBJECT
public:
    explicit MeasuredReader(QObject* parent = nullptr);

    void start(const MeasuredSourcePtr& source, const MeasuredTable& table,
               const MeasuredContext& context);
    void stop();
    [[nodiscard]] bool running() const { return m_running; }

signals:
    void finished(sparkout::ReadMeasuredPtr read);

private:
    bool m_running = false;
    NewestJob m_job; ///< last member: destroyed before the objects its work uses
};

class ColumnsModel;
class NumberField;
class ValueModel;

/// Options for reading a table of measurements: its dialect and the contents of its columns, with
/// the result below. The whole table is read in the background after every change, so that all
/// faults are found.
class ImportDialog : public QDialog {
    Q_OBJECT

public:
    ImportDialog(MeasuredSource source, const Project& project, QWidget* parent);

    /// Once accepted: the data without the refused cells.
    [[nodiscard]] const ReadMeasured& read() const { return *m_read; }
    [[nodiscard]] bool replaces() const; ///< replaces the project's data of the same kind

    /// A project with the read data.
    [[nodiscard]] static Project withMeasured(Project project, const ReadMeasured& read,
                                              bool replaces);

private:
    QWidget* buildDialect();
    void buildTables();
    QWidget* buildEnd();
    QWidget* buildButtons();
    void connectParts();
    void propose(); ///< from the text
    void showTable();
    void openBoxes(); ///< of the columns
    void takeDialect();
    void takeChoices();
    void startReading();
    void takeRead(const ReadMeasuredPtr& read);
    void showResult();
    [[nodiscard]] QString resultText() const;
    [[nodiscard]] QString obstacle() const; ///< why it cannot be imported; empty if it can

    MeasuredSourcePtr m_source;
    Project m_project;
    MeasuredTable m_table;
    ReadMeasuredPtr m_read; ///< null while reading
    QComboBox *m_layout, *m_delimiter, *m_decimal, *m_first;
    QLabel* m_factorLabel = nullptr;
    NumberField* m_factor; ///< kW to an ampere
    ColumnsModel* m_columns;
    ValueModel* m_preview;
    QTableView *m_columnsView, *m_previewView;
    QLabel* m_state;
    QProgressBar* m_progress;
    QListWidget* m_faults;
    QCheckBox* m_without; ///< the refused cells
    QRadioButton *m_add, *m_replace;
    QPushButton* m_import = nullptr;
    MeasuredReader* m_reader;
};

} // namespace sparkout
