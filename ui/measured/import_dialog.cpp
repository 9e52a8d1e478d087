// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measured/import_dialog.h"

#include "core/measured/measured_table.h"
#include "core/project/measured.h"
#include "core/project/part.h"
#include "ui/dialogs/copy_table.h"
#include "ui/form/number_field.h"
#include "ui/kit/dialog_parts.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/kit/tool_row.h"
#include "ui/measured/columns_model.h"
#include "ui/measured/measured_text.h"
#include "ui/table/value_table.h"
#include "ui/text/texts.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QProgressBar>
#include <QRadioButton>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

namespace sparkout {

MeasuredReader::MeasuredReader(QObject* parent) : QObject(parent) {}

void MeasuredReader::start(const MeasuredSourcePtr& source, const MeasuredTable& table,
                           const MeasuredContext& context) {
    m_running = true;
    m_job.start(
        [this, source, table, context](const std::stop_token& stop, const NewestJob::Post& post) {
            ReadMeasured read = readMeasured(source->text, table, context, stop);
            if (stop.stop_requested()) {
                return;
            }
            post([this, answer = std::make_shared<const ReadMeasured>(std::move(read))] {
                m_running = false;
                emit finished(answer);
            });
        });
}

void MeasuredReader::stop() {
    m_job.stop();
    m_running = false;
}

namespace {

constexpr std::size_t previewRows = 50;
constexpr std::size_t columnsAtMost = 200;
constexpr std::size_t bytesOfCell = 60;

QString textOf(std::string_view cell) {
    return printableText(QString::fromUtf8(cell.substr(0, bytesOfCell)));
}

/// The cells of a line with their faults.
std::vector<ValueCell> cellsOf(const std::vector<std::string_view>& cells,
                               const CellFaults& ofLine) {
    std::vector<ValueCell> shown;
    for (const std::string_view cell : cells) {
        const std::size_t column = shown.size() + 1;
        if (column > columnsAtMost) {
            break;
        }
        const auto fault = std::ranges::find_if(ofLine, [column](const CellFault& each) {
            return each.column == 0 || each.column == column;
        });
        shown.push_back({.text = textOf(cell),
                         .fault = fault == ofLine.end() ? QString() : MeasuredText::fault(*fault)});
    }
    return shown;
}

CellFaults faultsOf(const CellFaults& faults, std::size_t line) {
    CellFaults of;
    std::ranges::copy_if(faults, std::back_inserter(of),
                         [line](const CellFault& fault) { return fault.line == line; });
    return of;
}

/// The first rows of a table of measurements as split into cells, by their first lines, with the
/// faults of the cells.
ValueTable previewTable(std::string_view text, const MeasuredTable& table,
                        const CellFaults& faults = {}) {
    ValueTable shown;
    TableReader rows(text, table.dialect.delimiter);
    if (!table.isKeyValue && rows.next()) {
        for (ValueCell& head : cellsOf(rows.cells(), {})) {
            shown.columns.push_back({.text = std::move(head.text), .isText = true});
        }
    }
    std::size_t columns = shown.columns.size();
    while (shown.rows.size() < previewRows && rows.next()) {
        std::vector<ValueCell> cells = cellsOf(rows.cells(), faultsOf(faults, rows.line()));
        columns = std::max(columns, cells.size());
        shown.addRow({.text = QString::number(rows.line())}, std::move(cells));
    }
    shown.columns.resize(columns, {.isText = true});
    for (std::size_t i = 0; i < shown.columns.size(); ++i) {
        if (shown.columns[i].text.isEmpty()) {
            shown.columns[i].text = QString::number(i + 1);
        }
    }
    for (std::vector<ValueCell>& cells : shown.cells) {
        cells.resize(shown.columns.size());
    }
    return shown;
}

/// Boxes to choose in, for the cells of a ColumnsModel.
class ColumnsDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model,
                      const QModelIndex& index) const override;

protected:
    bool eventFilter(QObject* editor, QEvent* event) override;
};

QWidget* ColumnsDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                       const QModelIndex& index) const {
    auto* box = new QComboBox(parent);
    box->setObjectName(QStringLiteral("column-%1-%2").arg(index.row()).arg(index.column()));
    box->setAccessibleName(index.data(Qt::AccessibleTextRole).toString());
    auto* self = const_cast<ColumnsDelegate*>(this);
    connect(box, &QComboBox::currentIndexChanged, self,
            [self, box] { emit self->commitData(box); });
    return box;
}

void ColumnsDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
    auto* box = static_cast<QComboBox*>(editor);
    const QSignalBlocker quiet(box);
    box->clear();
    for (const auto& [text, value] :
         static_cast<const ColumnsModel*>(index.model())->choices(index)) {
        box->addItem(text, value);
    }
    box->setCurrentIndex(box->findData(index.data(Qt::EditRole)));
    box->setEnabled(box->count() > 1);
}

void ColumnsDelegate::setModelData(QWidget* editor, QAbstractItemModel* model,
                                   const QModelIndex& index) const {
    model->setData(index, static_cast<QComboBox*>(editor)->currentData(), Qt::EditRole);
}

/// A box passes each choice on at once. At Return the delegate would do so later, when the table
/// may have been read again and the box deleted.
bool ColumnsDelegate::eventFilter(QObject* editor, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Return || key == Qt::Key_Enter) {
            return false;
        }
    }
    return QStyledItemDelegate::eventFilter(editor, event);
}

constexpr int importWidth = 780, importHeight = 640;
constexpr int openedRows = 60; ///< columns with permanent boxes
constexpr int faultLines = 4;
constexpr qsizetype faultsListed = 50;

/// The columns, or keys, of a text in a dialect that was chosen.
std::vector<ColumnMatch> columnsOf(std::string_view text, const MeasuredTable& reading) {
    return reading.isKeyValue ? matchKeys(text) : matchHeadings(text, reading.dialect.delimiter);
}

void setUpTable(QTableView& view, QAbstractItemModel& model, const char* name) {
    view.setObjectName(QLatin1String(name));
    view.setModel(&model);
    view.setTabKeyNavigation(false);
    view.setAlternatingRowColors(true);
    view.setWordWrap(false);
    view.horizontalHeader()->setHighlightSections(false);
    view.horizontalHeader()->setSectionsClickable(false);
}

const Measured& measuredOf(const Project& project) {
    static const Measured none;
    return project.measured ? *project.measured : none;
}

} // namespace

ImportDialog::ImportDialog(MeasuredSource source, const Project& project, QWidget* parent)
    : QDialog(parent)
    , m_source(std::make_shared<const MeasuredSource>(std::move(source)))
    , m_project(project)
    , m_layout(new QComboBox(this))
    , m_delimiter(new QComboBox(this))
    , m_decimal(new QComboBox(this))
    , m_first(new QComboBox(this))
    , m_factor(
          new NumberField(NumberSpec::of(*tableOf<MeasuredTrace>().find("factor_kw_per_a")), this))
    , m_columns(new ColumnsModel(project, this))
    , m_preview(new ValueModel(this))
    , m_columnsView(new QTableView(this))
    , m_previewView(new QTableView(this))
    , m_state(new QLabel(this))
    , m_progress(new QProgressBar(this))
    , m_faults(new QListWidget(this))
    , m_without(new QCheckBox(tr("&Leave out the refused cells and import the rest"), this))
    , m_add(new QRadioButton(tr("&Add to the measurements"), this))
    , m_replace(new QRadioButton(tr("&Replace the measurements"), this))
    , m_reader(new MeasuredReader(this)) {
    setWindowTitle(m_source->name.isEmpty()
                       ? tr("Import measurements: pasted table")
                       : tr("Import measurements: %1").arg(printableText(m_source->name)));
    setHelpTopic(*this, QStringLiteral("measured#import"));
    buildTables();
    auto* column = new QVBoxLayout(this);
    column->setSpacing(metrics::gap);
    column->addWidget(buildDialect());
    column->addWidget(m_columnsView, 3);
    column->addWidget(m_previewView, 3);
    column->addWidget(buildEnd());
    column->addWidget(buildButtons());
    connectParts();
    propose();
    resize(importWidth, importHeight);
}

// --- building -----------------------------------------------------------------------------------

QWidget* ImportDialog::buildDialect() {
    auto* bar = new QWidget(this);
    auto* row = new ToolRow(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::gap);
    const auto add = [&](const QString& text, QWidget* field, const char* name) {
        auto* pair = new QWidget(bar);
        auto* within = new QHBoxLayout(pair);
        within->setContentsMargins(0, 0, metrics::gap, 0);
        within->setSpacing(metrics::tight);
        auto* label = new QLabel(text, pair);
        label->setBuddy(field);
        within->addWidget(label);
        within->addWidget(field);
        field->setObjectName(QLatin1String(name));
        field->setAccessibleName(QString(text).remove(u'&').remove(u':'));
        row->addWidget(pair);
        return label;
    };
    m_layout->addItems({tr("Headings above columns"), tr("Lines time|key|value")});
    m_delimiter->addItem(tr("comma"), QChar(u','));
    m_delimiter->addItem(tr("semicolon"), QChar(u';'));
    m_delimiter->addItem(tr("tab"), QChar(u'\t'));
    m_delimiter->addItem(tr("vertical bar"), QChar(u'|'));
    m_decimal->addItem(tr("point"), QChar(u'.'));
    m_decimal->addItem(tr("comma"), QChar(u','));
    m_first->addItems({tr("from 0"), tr("from 1")});
    add(tr("La&yout:"), m_layout, "importLayout");
    add(tr("&Delimiter:"), m_delimiter, "importDelimiter");
    add(tr("Deci&mal mark:"), m_decimal, "importDecimal");
    add(tr("&Zones are counted:"), m_first, "importFirst");
    m_factorLabel = add(tr("&Power to current, kW/A:"), m_factor, "importFactor");
    m_factor->setMaximumWidth(metrics::field);
    return bar;
}

void ImportDialog::buildTables() {
    setUpTable(*m_columnsView, *m_columns, "importColumns");
    m_columnsView->setItemDelegate(new ColumnsDelegate(this));
    m_columnsView->setAccessibleName(tr("Columns of the table"));
    m_columnsView->verticalHeader()->hide();
    m_columnsView->setEditTriggers(QAbstractItemView::DoubleClicked
                                   | QAbstractItemView::EditKeyPressed);
    m_columnsView->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    setUpTable(*m_previewView, *m_preview, "importPreview");
    m_previewView->setAccessibleName(tr("First lines of the table"));
    m_previewView->setEditTriggers(QAbstractItemView::NoEditTriggers);
}

QWidget* ImportDialog::buildEnd() {
    auto* end = new QWidget(this);
    auto* column = new QVBoxLayout(end);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(metrics::tight);
    m_state->setObjectName(QStringLiteral("importState"));
    m_state->setTextFormat(Qt::PlainText);
    m_state->setWordWrap(true);
    m_progress->setObjectName(QStringLiteral("importProgress"));
    m_progress->setRange(0, 0); // the progress is not known
    m_progress->setAccessibleName(tr("Reading"));
    m_progress->setTextVisible(false);
    m_faults->setObjectName(QStringLiteral("importFaults"));
    m_faults->setAccessibleName(tr("Refused cells"));
    m_faults->setWordWrap(true);
    m_faults->setFixedHeight(faultLines * m_faults->fontMetrics().lineSpacing() + 2 * metrics::gap);
    m_without->setObjectName(QStringLiteral("importWithout"));
    column->addWidget(m_state);
    column->addWidget(m_progress);
    column->addWidget(m_faults);
    column->addWidget(m_without, 0, Qt::AlignLeft);
    return end;
}

QWidget* ImportDialog::buildButtons() {
    auto* bar = new QWidget(this);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    m_add->setObjectName(QStringLiteral("importAdd"));
    m_replace->setObjectName(QStringLiteral("importReplace"));
    m_add->setChecked(true);
    const Measured& now = measuredOf(m_project);
    const bool has = !now.parts.empty() || !now.traces.empty();
    m_add->setVisible(has);
    m_replace->setVisible(has);
    row->addWidget(m_add);
    row->addWidget(m_replace);
    row->addStretch(1);
    auto* buttons = new AnswerButtons(tr("&Import"), tr("C&ancel"), this);
    m_import = buttons->acceptButton();
    m_import->setObjectName(QStringLiteral("importGo"));
    buttons->rejectButton()->setObjectName(QStringLiteral("importCancel"));
    row->addWidget(buttons);
    return bar;
}

void ImportDialog::connectParts() {
    connect(m_layout, &QComboBox::currentIndexChanged, this, &ImportDialog::takeDialect);
    connect(m_delimiter, &QComboBox::currentIndexChanged, this, &ImportDialog::takeDialect);
    connect(m_decimal, &QComboBox::currentIndexChanged, this, &ImportDialog::takeChoices);
    connect(m_first, &QComboBox::currentIndexChanged, this, &ImportDialog::takeChoices);
    connect(m_factor, &NumberField::valueEdited, this, &ImportDialog::takeChoices);
    connect(m_columns, &ColumnsModel::edited, this, &ImportDialog::takeChoices);
    connect(m_reader, &MeasuredReader::finished, this, &ImportDialog::takeRead);
    for (QAbstractButton* button :
         std::initializer_list<QAbstractButton*>{m_without, m_add, m_replace}) {
        connect(button, &QAbstractButton::toggled, this, &ImportDialog::showResult);
    }
    connect(this, &QDialog::rejected, m_reader, &MeasuredReader::stop);
}

// --- format of the table ------------------------------------------------------------------------

void ImportDialog::propose() {
    m_table = proposeTable(m_source->text);
    const auto set = [](QComboBox& box, int index) {
        const QSignalBlocker quiet(&box);
        box.setCurrentIndex(index);
    };
    set(*m_layout, m_table.isKeyValue ? 1 : 0);
    set(*m_delimiter, m_delimiter->findData(QChar(QLatin1Char(m_table.dialect.delimiter))));
    set(*m_decimal, m_table.dialect.decimal == ',' ? 1 : 0);
    set(*m_first, m_table.firstPlace);
    showTable();
}

void ImportDialog::showTable() {
    m_columns->show(m_table.columns);
    m_preview->setTable(previewTable(m_source->text.utf8(), m_table));
    m_previewView->resizeColumnsToContents();
    m_delimiter->setEnabled(!m_table.isKeyValue);
    openBoxes();
    startReading();
}

void ImportDialog::openBoxes() {
    const int rows = std::min(m_columns->rowCount(), openedRows);
    for (int row = 0; row < rows; ++row) {
        for (int column = ColumnsModel::quantity; column < ColumnsModel::columnCount_; ++column) {
            m_columnsView->openPersistentEditor(m_columns->index(row, column));
        }
    }
}

/// The line of headings is split differently, so the columns change.
void ImportDialog::takeDialect() {
    m_table.isKeyValue = m_layout->currentIndex() == 1;
    if (m_table.isKeyValue) {
        const QSignalBlocker quiet(m_delimiter);
        m_delimiter->setCurrentIndex(m_delimiter->findData(QChar(u'|')));
    }
    m_table.dialect.delimiter = m_delimiter->currentData().toChar().toLatin1();
    m_table.dialect.decimal = m_decimal->currentData().toChar().toLatin1();
    m_table.columns = columnsOf(m_source->text.utf8(), m_table);
    showTable();
}

void ImportDialog::takeChoices() {
    m_table.dialect.decimal = m_decimal->currentData().toChar().toLatin1();
    m_table.firstPlace = m_first->currentIndex();
    m_table.columns = m_columns->matches();
    startReading();
}

// --- reading ------------------------------------------------------------------------------------

void ImportDialog::startReading() {
    const bool hasCurrent = std::ranges::any_of(m_table.columns, [](const ColumnMatch& match) {
        return match.quantity == ColumnQuantity::spindle_current;
    });
    m_factor->parentWidget()->setVisible(hasCurrent);
    const MeasuredContext context{m_source->name.toStdString(), m_project.part->diameter_mm,
                                  m_factor->value().value_or(0)};
    m_read.reset();
    m_reader->start(m_source, m_table, context);
    showResult();
}

void ImportDialog::takeRead(const ReadMeasuredPtr& read) {
    m_read = read;
    m_preview->update(previewTable(m_source->text.utf8(), m_table, read->faults));
    m_faults->clear();
    for (const CellFault& fault : read->faults) {
        if (m_faults->count() == faultsListed) {
            m_faults->addItem(tr("… and more"));
            break;
        }
        m_faults->addItem(MeasuredText::fault(fault));
    }
    showResult();
}

QString ImportDialog::resultText() const {
    const Measured& have = m_read->data;
    QStringList found;
    if (!have.parts.empty()) {
        QStringList names;
        int beyond = 0;
        for (const MeasuredPart& part : have.parts) {
            names << QString::fromStdString(part.part);
            beyond += part.place >= placeCount(m_project) ? 1 : 0;
        }
        names.sort();
        names.removeDuplicates();
        found << tr("%n part(s)", nullptr, static_cast<int>(names.size()));
        if (beyond > 0) {
            found << tr("%n row(s) of zones or sections that the project does not have", nullptr,
                        beyond);
        }
        if (!m_table.isKeyValue && placeCount(m_project) > 1
            && std::ranges::none_of(m_table.columns, [](const ColumnMatch& column) {
                   return column.quantity == ColumnQuantity::place || column.place;
               })) {
            found << tr("no column names a zone or section: all values are taken as those of %1")
                         .arg(MeasuredText::place(m_project, 0));
        }
    }
    for (const MeasuredTrace& trace : have.traces) {
        const QLocale locale;
        const QString name = MeasuredText::trace(trace.quantity);
        const auto kept = static_cast<int>(trace.values.size());
        found << (trace.source_samples > kept
                      ? tr("%1: %2 of %3 samples, as means")
                            .arg(name, locale.toString(kept), locale.toString(trace.source_samples))
                      : tr("%1: %2 samples").arg(name, locale.toString(kept)));
    }
    const QString lines = tr("%n line(s) read", nullptr, static_cast<int>(m_read->rows));
    return found.isEmpty() ? lines + u'.'
                           : tr("%1: %2.", "lines, what is found in them")
                                 .arg(lines, found.join(QStringLiteral("; ")));
}

QString ImportDialog::obstacle() const {
    const Measured& have = m_read->data;
    if (have.parts.empty() && have.traces.empty()) {
        return tr("There is nothing to import.");
    }
    const Measured& now = measuredOf(m_project);
    const std::size_t parts = have.parts.size() + (replaces() ? 0 : now.parts.size());
    const std::size_t traces = have.traces.size() + (replaces() ? 0 : now.traces.size());
    if (parts > static_cast<std::size_t>(limits::measuredParts)) {
        return tr("A project holds at most %1 rows of parts; with these it would be %2.")
            .arg(limits::measuredParts)
            .arg(parts);
    }
    if (traces > static_cast<std::size_t>(limits::traces)) {
        return tr("A project holds at most %1 traces; with these it would be %2.")
            .arg(limits::traces)
            .arg(traces);
    }
    return {};
}

void ImportDialog::showResult() {
    const bool isRead = m_read != nullptr;
    const bool hasFaults = isRead && !m_read->faults.empty();
    const bool isWhole = hasFaults && m_read->faults.size() < limits::issues;
    m_progress->setVisible(!isRead);
    m_faults->setVisible(hasFaults);
    const bool hasData = isRead && (!m_read->data.parts.empty() || !m_read->data.traces.empty());
    m_without->setVisible(isWhole && hasData);
    if (!isRead) {
        m_state->setText(tr("Reading all lines. A change or Cancel stops it."));
        m_import->setEnabled(false);
        return;
    }
    const QString against = obstacle();
    QStringList texts{resultText()};
    if (hasFaults) {
        texts << (isWhole ? tr("%n cell(s) are refused:", nullptr,
                               static_cast<int>(m_read->faults.size()))
                          : tr("Reading stopped early because too many cells are refused. Check "
                               "the delimiter, the decimal mark and the columns."));
    } else if (!against.isEmpty()) {
        texts << against;
    }
    m_state->setText(texts.join(u' '));
    m_import->setEnabled(against.isEmpty()
                         && (!hasFaults || (isWhole && hasData && m_without->isChecked())));
}

bool ImportDialog::replaces() const {
    return m_replace->isChecked();
}

Project ImportDialog::withMeasured(Project project, const ReadMeasured& read, bool replaces) {
    Measured& measured = project.measured ? *project.measured : project.measured.emplace();
    if (replaces) { // a table of parts keeps the traces, and the other way round
        if (!read.data.parts.empty()) {
            measured.parts.clear();
        }
        if (!read.data.traces.empty()) {
            measured.traces.clear();
        }
    }
    std::ranges::copy(read.data.parts, std::back_inserter(measured.parts));
    std::ranges::copy(read.data.traces, std::back_inserter(measured.traces));
    return project;
}

} // namespace sparkout
