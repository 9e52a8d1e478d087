// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/requirements/verdict_sections.h"

#include "core/project/machine.h"
#include "ui/dialogs/copy_table.h"
#include "ui/kit/font_size.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/kit/theme_icon.h"
#include "ui/results/result_tables.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QIcon>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollBar>
#include <QStringList>
#include <QStyle>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include <utility>

namespace sparkout {

namespace {

/// Narrow cells, so that three stages and the cycle fit beside their names into 300 px:
/// right-aligned numbers, a mark before them, two pixels of space.
class NarrowCells : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& given,
                                 const QModelIndex& index) const override {
        QStyleOptionViewItem option = given;
        initStyleOption(&option, index);
        const int mark = option.icon.isNull() ? 0 : markSize + air;
        return {option.fontMetrics.horizontalAdvance(option.text) + mark + 2 * air,
                option.fontMetrics.height() + 2};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& given,
               const QModelIndex& index) const override {
        QStyleOptionViewItem option = given;
        initStyleOption(&option, index);
        const QString text = std::exchange(option.text, QString());
        const QIcon icon = std::exchange(option.icon, QIcon());
        const QStyle* style = option.widget->style();
        style->drawControl(QStyle::CE_ItemViewItem, &option, painter, option.widget);
        const QRect inside = option.rect.adjusted(air, 0, -air, 0);
        const bool selected = option.state.testFlag(QStyle::State_Selected);
        style->drawItemText(painter, inside, Qt::AlignRight | Qt::AlignVCenter, option.palette,
                            true, text, selected ? QPalette::HighlightedText : QPalette::Text);
        if (!icon.isNull()) {
            const int end = inside.right() - option.fontMetrics.horizontalAdvance(text) - air;
            icon.paint(painter, QRect(end - markSize, inside.center().y() - markSize / 2, markSize,
                                      markSize));
        }
    }

private:
    static constexpr int markSize = 10;
    static constexpr int air = 2;
};

} // namespace

NarrowTable::NarrowTable(ValueModel& model, QWidget* parent) : CopyTable(model, parent) {
    setItemDelegate(new NarrowCells(this));
    setWordWrap(false);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    setRelativeFont(*verticalHeader(), 0.92);
    verticalHeader()->setSectionsClickable(false);
    verticalHeader()->setHighlightSections(false);
    verticalHeader()->setMinimumSectionSize(10);
    verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    connect(this, &CopyTable::resized, this, &NarrowTable::fit, Qt::QueuedConnection);
}

/// Makes columns as wide as their numbers and shares the remainder; if they need more, a scroll bar
/// appears below.
void NarrowTable::fit() {
    const int count = model() ? model()->columnCount() : 0;
    if (m_fitting || count == 0) {
        return;
    }
    m_fitting = true;
    QHeaderView* header = horizontalHeader();
    resizeColumnsToContents();
    int left = viewport()->width() - header->length();
    const bool wide = left < 0;
    for (int column = 0; left > 0 && column < count; ++column) {
        const int share = left / (count - column);
        header->resizeSection(column, header->sectionSize(column) + share);
        left -= share;
    }
    setHorizontalScrollBarPolicy(wide ? Qt::ScrollBarAlwaysOn : Qt::ScrollBarAlwaysOff);
    const int bar = wide ? horizontalScrollBar()->sizeHint().height() : 0;
    setFixedHeight(header->sizeHint().height() + verticalHeader()->length() + 2 * frameWidth()
                   + bar);
    if (parentWidget()) {
        parentWidget()->updateGeometry();
    }
    m_fitting = false;
}

FormSection::FormSection(QWidget* parent)
    : QWidget(parent)
    , m_title(new QLabel(this))
    , m_model(new ValueModel(this))
    , m_table(new NarrowTable(*m_model, this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(metrics::tight);
    layout->addWidget(m_title);
    layout->addWidget(m_table);
    QFont bold = font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_title->setTextFormat(Qt::PlainText);
    m_title->setWordWrap(true);
    m_title->setMinimumWidth(1);
    m_table->setObjectName(QStringLiteral("formByZone"));
    retranslate();
}

void FormSection::setOutcome(const OutcomePtr& outcome) {
    m_outcome = outcome;
    showTitle();
    showTable();
    setVisible(m_model->columnCount() > 0);
}

void FormSection::setGreyed(bool grey, const QPalette& palette) {
    m_model->setGreyed(grey);
    m_title->setPalette(palette);
}

void FormSection::retranslate() {
    showTitle();
    m_table->setAccessibleName(tr("Form by zone"));
    m_table->retranslate();
    showTable();
}

void FormSection::showTitle() {
    const bool isKnown = !m_outcome || isRoundnessKnown(*m_outcome->result.project.machine);
    m_title->setText(Names::ofMachine(tr("Form by zone, µm"), isKnown));
}

void FormSection::showTable() {
    m_model->setTable(m_outcome ? formValues(*m_outcome) : ValueTable());
    m_table->fit();
}

namespace {
constexpr int iconSize = 13;
} // namespace

ShopSection::ShopSection(QWidget* parent)
    : QWidget(parent)
    , m_title(new QLabel(this))
    , m_model(new ValueModel(this))
    , m_table(new NarrowTable(*m_model, this))
    , m_remarksLine(new QWidget(this))
    , m_icon(new QLabel(m_remarksLine))
    , m_remarks(new QLabel(m_remarksLine)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(m_title);
    layout->addWidget(m_table);
    layout->addWidget(m_remarksLine);
    auto* line = new QHBoxLayout(m_remarksLine);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(m_icon, 0, Qt::AlignTop);
    line->addWidget(m_remarks, 1);
    QFont bold = font();
    bold.setBold(true);
    m_title->setFont(bold);
    for (QLabel* label : {m_title, m_remarks}) {
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(true);
        label->setMinimumWidth(1);
    }
    m_remarks->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_remarks->setObjectName(QStringLiteral("shopRemarks"));
    m_table->setObjectName(QStringLiteral("shop"));
    retranslate();
}

void ShopSection::setOutcome(const OutcomePtr& outcome) {
    m_outcome = outcome;
    showTable();
}

void ShopSection::setGreyed(bool grey, const QPalette& palette) {
    m_model->setGreyed(grey);
    m_title->setPalette(palette);
    m_remarks->setPalette(palette);
}

void ShopSection::showTable() {
    m_model->setTable(m_outcome ? shopTable(*m_outcome) : ValueTable());
    const QStringList sentences = m_outcome ? shopRemarks(m_outcome->shop) : QStringList();
    m_remarks->setText(sentences.join(QLatin1Char('\n')));
    m_remarksLine->setVisible(!sentences.isEmpty());
    m_icon->setPixmap(themeIcon(u"warning").pixmap(QSize(iconSize, iconSize), devicePixelRatioF()));
    m_table->fit();
}

void ShopSection::retranslate() {
    m_title->setText(tr("Grinding quantities by stage"));
    m_table->setAccessibleName(tr("Grinding quantities by stage"));
    m_remarks->setAccessibleName(tr("Values outside the usual range"));
    m_table->retranslate();
    showTable();
}

namespace {

QLabel* wrapping(QWidget* parent, const QString& name) {
    auto* label = new QLabel(parent);
    label->setObjectName(name);
    label->setWordWrap(true);
    label->setMinimumWidth(1);
    return label;
}

/// Marked up so that a tool tip wraps.
QString paragraph(const std::string& text) {
    return QStringLiteral("<p>%1</p>").arg(withIndices(QString::fromStdString(text)));
}

} // namespace

RemedySection::RemedySection(QWidget* parent)
    : QWidget(parent)
    , m_title(wrapping(this, QStringLiteral("remediesTitle")))
    , m_note(wrapping(this, QStringLiteral("remediesNote")))
    , m_end(new QPushButton(this)) {
    setHelpTopic(*this, QStringLiteral("verdict#remedies"));
    build();
    retranslate();
}

void RemedySection::build() {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(metrics::tight);
    layout->addWidget(m_title);
    QFont bold = font();
    bold.setBold(true);
    m_title->setFont(bold);
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        Line& line = m_lines[i];
        line.line = new QWidget(this);
        line.text = wrapping(line.line, QStringLiteral("remedy%1").arg(i + 1));
        line.text->setTextFormat(Qt::RichText);
        line.text->setTextInteractionFlags(Qt::TextSelectableByMouse);
        line.take = new QPushButton(line.line);
        line.take->setObjectName(QStringLiteral("takeRemedy%1").arg(i + 1));
        auto* row = new QHBoxLayout(line.line);
        row->setContentsMargins(0, 0, 0, 0);
        row->setSpacing(metrics::gap);
        row->addWidget(line.text, 1);
        row->addWidget(line.take, 0, Qt::AlignTop);
        layout->addWidget(line.line);
        connect(line.take, &QPushButton::clicked, this, [this, i] {
            if (m_result && i < m_result->remedies.size()) {
                emit wanted(Remedy(m_result->remedies[i])); // a copy: the result may go
            }
        });
    }
    m_note->setTextFormat(Qt::RichText);
    m_note->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_end->setObjectName(QStringLiteral("endRemedies"));
    auto* foot = new QHBoxLayout;
    foot->setSpacing(metrics::gap);
    foot->addWidget(m_note, 1);
    foot->addWidget(m_end, 0, Qt::AlignTop);
    layout->addLayout(foot);
    connect(m_end, &QPushButton::clicked, this, &RemedySection::endWanted);
}

void RemedySection::setRemedies(OutcomePtr outcome, std::shared_ptr<const RemedyResult> result,
                                bool running) {
    m_outcome = std::move(outcome);
    m_result = std::move(result);
    m_running = running;
    setEnabled(true);
    showResult();
}

void RemedySection::setStale() {
    m_running = false;
    setEnabled(false);
    showResult();
}

void RemedySection::clear() {
    m_outcome.reset();
    m_result.reset();
    m_running = false;
    showResult();
}

void RemedySection::showResult() {
    const bool says = m_result && m_result->goal != RemedyGoal::none;
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        const bool shown = says && i < m_result->remedies.size();
        m_lines[i].line->setVisible(shown);
        if (shown) {
            showLine(i);
        }
    }
    m_title->setText(says && m_result->goal == RemedyGoal::room ? tr("Ways to a larger margin")
                                                                : tr("Possible remedies"));
    m_note->setText(says ? withIndices(note()) : QString());
    m_note->setVisible(!m_note->text().isEmpty());
    m_end->setVisible(says && m_running);
    setVisible(says);
}

void RemedySection::showLine(std::size_t index) {
    const RemedyText words;
    const Remedy& remedy = m_result->remedies[index];
    const QString line = QString::fromStdString(words.line(project(), remedy));
    const QString proof = paragraph(words.proof(project(), m_result->goal, remedy));
    const Line& shown = m_lines[index];
    shown.text->setText(withIndices(keptTogether(line)));
    shown.text->setToolTip(proof);
    shown.take->setText(tr("Apply"));
    shown.take->setToolTip(proof);
    shown.take->setAccessibleName(tr("Apply the change: %1").arg(line));
}

QString RemedySection::note() const {
    const RemedyText words;
    if (m_running) {
        return tr("%1 of %2 settings tried.").arg(m_result->tried).arg(m_result->settings);
    }
    QStringList sentences;
    if (m_result->found > m_result->remedies.size()) {
        sentences +=
            tr("Settings that help: %1; shown are those that cost least.").arg(m_result->found);
    }
    sentences += QString::fromStdString(words.scope(*m_result));
    sentences += QString::fromStdString(words.extent(*m_result));
    if (m_result->conflict) {
        sentences +=
            QString::fromStdString(words.conflict(project(), m_result->goal, *m_result->conflict));
    }
    sentences.removeAll(QString());
    return sentences.join(u' ');
}

void RemedySection::retranslate() {
    for (const Line& line : m_lines) {
        line.text->setAccessibleName(tr("Change that helps"));
        line.take->setAccessibleName(tr("Apply the change"));
    }
    m_note->setAccessibleName(tr("Settings tried"));
    m_end->setText(tr("Stop"));
    m_end->setAccessibleName(tr("Stop looking for changes that help"));
    showResult();
}

std::string RemedyText::translated(const char* text) const {
    return QCoreApplication::translate("Remedy", text).toStdString();
}

std::string RemedyText::number(double value) const {
    return printedNumber(value).toStdString();
}

std::string RemedyText::unit(const char* unit) const {
    return unitText(unit).toStdString();
}

std::string RemedyText::input(const char* label, const char* symbol) const {
    return QStringLiteral("%1 %2").arg(inputText(label), QString::fromUtf8(symbol)).toStdString();
}

std::string RemedyText::requirement(ConstraintKind kind) const {
    return Names::constraint(kind).toStdString();
}

} // namespace sparkout
