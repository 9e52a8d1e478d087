// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/study/data_sheet.h"

#include "core/project/measured.h"
#include "core/project/member.h"
#include "ui/dialogs/copy_table.h"
#include "ui/kit/metrics.h"
#include "ui/kit/theme_icon.h"
#include "ui/measured/measured_text.h"
#include "ui/session/document.h"
#include "ui/text/hint_text.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QRegularExpression>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

const char* keyOf(DataModel::List list) {
    switch (list) {
    case DataModel::List::parts: return "parts";
    case DataModel::List::summaries: return "summaries";
    case DataModel::List::traces: break;
    }
    return "traces";
}

bool isPlace(const Field& column) {
    return std::string_view(column.key) == "place";
}

bool isOneOf(const Field& field, std::initializer_list<std::string_view> keys) {
    return std::ranges::find(keys, std::string_view(field.key)) != keys.end();
}

/// Breaks a text into two lines at the space nearest to the middle.
QString onTwoLines(QString text) {
    constexpr qsizetype longLabel = 14;
    if (text.size() <= longLabel) {
        return text;
    }
    const qsizetype middle = text.size() / 2;
    const qsizetype before = text.lastIndexOf(u' ', middle), after = text.indexOf(u' ', middle);
    const qsizetype at =
        after < 0 || (before >= 0 && middle - before < after - middle) ? before : after;
    if (at > 0) {
        text[at] = u'\n';
    }
    return text;
}

} // namespace

DataModel::DataModel(List list, Document& document, QObject* parent)
    : ListModel(std::string("/measured/") + keyOf(list), *tableOf<Measured>().find(keyOf(list)),
                document)
    , m_which(list)
    , m_shown(document.project().measured) {
    setParent(parent);
    update(true); // with the columns of this list
    connect(&document, &Document::changed, this, &DataModel::follow);
}

void DataModel::follow() {
    const Project& project = document().project();
    if (!project.measured.isSharedWith(m_shown)) {
        m_shown = project.measured;
        update(false);
    }
}

bool DataModel::shows(const Field& column) const {
    return !isOneOf(column, {"time_s", "source_sha256"});
}

/// Of a trace only the descriptive members are editable.
bool DataModel::isEditable(const Field& column) const {
    return m_which != List::traces || isOneOf(column, {"place", "factor_kw_per_a", "idle", "note"});
}

// --- displayed data -----------------------------------------------------------------------------

QString DataModel::valueShown(const QModelIndex& index) const {
    const Field& column = field(index);
    const void* const of = item(index);
    if (isPlace(column)) {
        const std::optional<double> place = number(index);
        return place ? MeasuredText::place(document().project(), static_cast<int>(*place))
                     : inputText(column.nullMeaning);
    }
    switch (column.kind) {
    case Kind::choice:
        return choiceText(column.choices[static_cast<std::size_t>(column.getChoice(of))].label);
    case Kind::text:
        return printableText(QString::fromStdString(column.as<std::string>(of)).simplified());
    case Kind::samples:
        return QLocale().toString(static_cast<qulonglong>(column.as<Samples>(of).size()));
    case Kind::numberList: {
        QStringList numbers;
        for (const double number : column.as<std::vector<double>>(of)) {
            numbers << showNumber(number, QLocale());
        }
        return numbers.join(QStringLiteral("; "));
    }
    default: return ListModel::valueShown(index);
    }
}

QVariant DataModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) {
        return {};
    }
    const Field& column = field(index);
    switch (role) {
    case Qt::EditRole: return shown(index);
    case Qt::TextAlignmentRole: {
        const bool isText =
            column.kind == Kind::text || column.kind == Kind::choice || isPlace(column);
        return static_cast<int>((isText ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    }
    case Qt::AccessibleTextRole:
        return tr("Row %1, %2: %3")
            .arg(QString::number(index.row() + 1), inputText(column.label), shown(index));
    default: return ListModel::data(index, role);
    }
}

QVariant DataModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation == Qt::Vertical) {
        return {};
    }
    const Field& column = *columns()[static_cast<std::size_t>(section)];
    return role != Qt::DisplayRole
               ? ListModel::headerData(section, orientation, role)
               : onTwoLines(column.kind == Kind::samples ? tr("Samples") : columnText(column));
}

QStringList DataModel::choices(int row, const Field& column) const {
    QStringList choices;
    if (!isEditable(column)) {
        return choices;
    }
    if (isPlace(column)) {
        const Project& project = document().project();
        if (column.kind == Kind::optionalInteger) {
            choices << inputText(column.nullMeaning);
        }
        const int present = static_cast<int>(numberIn(column, item(index(row, 0))).value_or(0));
        const int count = std::max(placeCount(project), present + 1);
        for (int i = 0; i < count; ++i) {
            choices << MeasuredText::place(project, i);
        }
    } else if (column.kind == Kind::choice) {
        for (const Choice& choice : column.choices) {
            choices << choiceText(choice.label);
        }
    }
    return choices;
}

Qt::ItemFlags DataModel::flags(const QModelIndex& index) const {
    Qt::ItemFlags flags = ListModel::flags(index);
    if (index.isValid() && !isEditable(field(index))) {
        flags.setFlag(Qt::ItemIsEditable, false);
    }
    return flags;
}

CsvTable DataModel::table() const {
    CsvTable table;
    for (int column = 0; column < columnCount(); ++column) {
        table.header
            << headerData(column, Qt::Horizontal, Qt::DisplayRole).toString().replace(u'\n', u' ');
    }
    for (int row = 0; row < rowCount(); ++row) {
        std::vector<CsvCell>& cells = table.rows.emplace_back();
        for (int column = 0; column < columnCount(); ++column) {
            const QModelIndex cell = index(row, column);
            const Kind kind = field(cell).kind;
            const bool isNumber = kind == Kind::number || kind == Kind::optionalNumber
                                  || (kind == Kind::integer && !isPlace(field(cell)));
            const std::optional<double> value = isNumber ? number(cell) : std::nullopt;
            cells.push_back(value      ? CsvCell(*value)
                            : isNumber ? CsvCell()
                                       : CsvCell(valueShown(cell)));
        }
    }
    return table;
}

// --- edits --------------------------------------------------------------------------------------

QString DataModel::takeText(Project& project, int row, const Field& column,
                            const QString& text) const {
    void* const to = findMember(project, rowPath(row)).owner;
    if (const QStringList words = choices(row, column); !words.isEmpty()) {
        const int chosen = static_cast<int>(words.indexOf(text));
        if (chosen < 0) {
            return tr("“%1” is not one of the choices").arg(text);
        }
        if (column.kind == Kind::choice) {
            column.setChoice(to, chosen);
        } else {
            const int place = column.kind == Kind::optionalInteger ? chosen - 1 : chosen;
            setNumberIn(column, to, place < 0 ? std::nullopt : std::optional<double>(place));
        }
    } else if (column.kind == Kind::text) {
        column.as<std::string>(to) = text.toStdString();
    } else if (column.kind == Kind::optionalNumber && text.isEmpty()) {
        setNumberIn(column, to, std::nullopt);
    } else if (column.kind != Kind::numberList) {
        return ListModel::takeText(project, row, column, text);
    } else {
        static const QRegularExpression gap(QStringLiteral("[;\\s]+"));
        std::vector<double> numbers;
        for (const QString& part : text.split(gap, Qt::SkipEmptyParts)) {
            const std::optional<double> value = parseNumber(part);
            if (!value || !column.hard.contains(*value)) {
                return tr("“%1” is not a number from %2; separate several by semicolons")
                    .arg(part, rangeShown(column.hard, column.unit));
            }
            numbers.push_back(*value);
        }
        column.as<std::vector<double>>(to) = std::move(numbers);
    }
    return {};
}

bool DataModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !(flags(index) & Qt::ItemIsEditable)) {
        return false;
    }
    if (value == data(index, Qt::EditRole)) {
        return true;
    }
    const QString text = value.toString().trimmed();
    Project project = document().project();
    const QString reason = takeText(project, index.row(), field(index), text);
    if (!reason.isEmpty()) {
        refuse(index, text, reason);
        return false;
    }
    accept(index);
    edit(std::move(project), field(index));
    return true;
}

void DataModel::edit(Project project, const Field& of) {
    document().endMerge();
    document().edit(std::move(project), {"Input", of.label});
}

void DataModel::addRow() {
    Project project = document().project();
    Measured& changed = project.measured ? *project.measured : project.measured.emplace();
    if (m_which == List::parts) {
        MeasuredPart part;
        part.part = std::to_string(changed.parts.size() + 1);
        part.place = changed.parts.empty() ? 0 : changed.parts.back().place;
        changed.parts.push_back(std::move(part));
    } else {
        list().insert(&changed, list().size(&changed));
    }
    edit(std::move(project), list());
}

void DataModel::takeAway(const std::set<int, std::greater<>>& rows) {
    if (rows.empty()) {
        return;
    }
    Project project = document().project();
    Measured& changed = *project.measured;
    for (const int row : rows) {
        list().erase(&changed, static_cast<std::size_t>(row));
    }
    if (changed.parts.empty() && changed.summaries.empty() && changed.traces.empty()
        && changed.calibrations.empty()) {
        project.measured.reset();
    }
    edit(std::move(project), list());
}

namespace {

/// Editors for the cells of a DataModel: a combo box for choices, otherwise a line.
class DataDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
};

QWidget* DataDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                    const QModelIndex& index) const {
    const auto& model = static_cast<const DataModel&>(*index.model());
    const QStringList choices = model.choices(index.row(), model.field(index));
    const QString name = index.data(Qt::AccessibleTextRole).toString();
    if (choices.isEmpty()) {
        auto* line = new QLineEdit(parent);
        line->setFrame(false);
        line->setAccessibleName(name);
        return line;
    }
    auto* box = new QComboBox(parent);
    box->addItems(choices);
    box->setAccessibleName(name);
    auto* self = const_cast<DataDelegate*>(this);
    connect(box, &QComboBox::activated, self, [self, box] {
        emit self->commitData(box);
        emit self->closeEditor(box);
    });
    return box;
}

constexpr int rowsMeasured = 50; ///< number used for column widths: a list may have thousands

} // namespace

DataSheet::DataSheet(DataModel::List list, Document& document, Settings* settings, QWidget* parent)
    : QWidget(parent)
    , m_list(list)
    , m_model(new DataModel(list, document, this))
    , m_table(new CopyTable([this] { return tabSeparated(m_model->table(), QLocale()); }, this))
    , m_note(new QLabel(this))
    , m_add(new QPushButton(this))
    , m_remove(new QPushButton(this)) {
    static constexpr std::array tables{"measuredParts", "measuredSummaries", "measuredTraces"};
    const QString name = QLatin1String(tables.at(static_cast<std::size_t>(list)));
    m_table->setObjectName(name);
    m_add->setObjectName(name + QStringLiteral("Add"));
    m_remove->setObjectName(name + QStringLiteral("Remove"));
    m_add->setIcon(themeIcon(u"add"));
    m_remove->setIcon(themeIcon(u"remove"));
    m_table->setModel(m_model);
    m_table->setItemDelegate(new DataDelegate(this));
    m_table->setSaving(
        [this] { return m_model->table(); },
        [&document] { return QString::fromStdString(document.project().title).simplified(); },
        settings);
    m_table->setSelectionBehavior(QAbstractItemView::SelectItems);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setShowGrid(true);
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setResizeContentsPrecision(rowsMeasured);
    m_note->setTextFormat(Qt::PlainText);
    m_note->setWordWrap(true);
    auto* row = new QHBoxLayout;
    row->addWidget(m_note, 1);
    row->addWidget(m_add);
    row->addWidget(m_remove);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(metrics::tight);
    column->addLayout(row);
    column->addWidget(m_table, 1);
    m_add->setVisible(list != DataModel::List::traces);
    connect(m_add, &QPushButton::clicked, this, &DataSheet::addRow);
    connect(m_remove, &QPushButton::clicked, this, &DataSheet::removeRows);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &DataSheet::showButtons);
    connect(m_model, &QAbstractItemModel::modelReset, this, &DataSheet::showButtons);
    retranslate();
}

void DataSheet::fitRows() {
    m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height()
                                                     + 2 * metrics::tight);
}

void DataSheet::addRow() {
    m_model->addRow();
    const QModelIndex added = m_model->index(m_model->rowCount() - 1, 0);
    m_table->setCurrentIndex(added);
    m_table->scrollTo(added);
    m_table->setFocus();
}

void DataSheet::removeRows() {
    std::set<int, std::greater<>> rows; // from the last one
    for (const QModelIndex& cell : m_table->selectionModel()->selectedIndexes()) {
        rows.insert(cell.row());
    }
    m_model->takeAway(rows);
}

void DataSheet::keyPressEvent(QKeyEvent* event) {
    if (event->keyCombination() == QKeyCombination(Qt::ControlModifier, Qt::Key_Delete)) {
        removeRows();
    } else {
        QWidget::keyPressEvent(event);
    }
}

void DataSheet::showButtons() {
    m_remove->setEnabled(m_table->selectionModel()->hasSelection());
}

void DataSheet::retranslate() {
    const auto tell = [](QPushButton& button, const QString& text, const QString& tip) {
        button.setText(text);
        button.setAccessibleName(text);
        button.setToolTip(tip);
    };
    switch (m_list) {
    case DataModel::List::parts:
        m_table->setAccessibleName(tr("Measured parts"));
        m_note->setText(tr("A row for each zone or section of a part. Double click or F2 edits a "
                           "cell; separate several diameters by semicolons."));
        break;
    case DataModel::List::summaries:
        m_table->setAccessibleName(tr("Measured statistics"));
        m_note->setText(tr("Statistics of parts that are not listed one by one, as in a printed "
                           "table: the mean with the value after ±, and the number of parts."));
        break;
    case DataModel::List::traces:
        m_table->setAccessibleName(tr("Measured traces"));
        m_note->setText(tr("Quantities over the time of one cycle, as they were imported. Place, "
                           "power to current, idle value and note can be edited."));
        break;
    }
    tell(*m_add, tr("Add a row"), tr("Add a row at the end"));
    tell(*m_remove, tr("Remove"), tr("Remove the rows of the selected cells (Ctrl+Del)"));
    fitRows();
    m_model->retranslate();
    m_table->retranslate();
    showButtons();
}

} // namespace sparkout
