// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/stage_table.h"

#include "ui/inputs/stage_delegate.h"
#include "ui/inputs/stage_model.h"
#include "ui/session/texts.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QRegularExpression>
#include <QTableView>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace sparkout {

namespace {

constexpr int shownRows = 8;
constexpr int headerMargin = 10; ///< of a title, both sides

/// Sums of stocks stay free of last bits such as 0.30000000000000004.
double tidy(double stock_mm) {
    return std::round(stock_mm * 1e9) / 1e9;
}

bool sparksOut(const Stage& stage) {
    return stage.spark_out.mode != SparkOut::Mode::none;
}

void setUpView(QTableView& view) {
    view.setSelectionBehavior(QAbstractItemView::SelectItems);
    view.setSelectionMode(QAbstractItemView::SingleSelection);
    view.setEditTriggers(QAbstractItemView::AnyKeyPressed | QAbstractItemView::DoubleClicked
                         | QAbstractItemView::EditKeyPressed | QAbstractItemView::SelectedClicked);
    view.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    view.setTabKeyNavigation(true);
    view.setWordWrap(false);
    view.horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    view.horizontalHeader()->setMinimumSectionSize(20);
    view.horizontalHeader()->setDefaultAlignment(
        Qt::Alignment(int(Qt::AlignCenter) | int(Qt::TextWordWrap)));
    view.horizontalHeader()->setSectionsClickable(false);
    view.verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    view.verticalHeader()->setDefaultSectionSize(view.fontMetrics().height() + 10);
}

} // namespace

StageTable::StageTable(Document& document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_model(new StageModel(document, this))
    , m_view(new QTableView(this))
    , m_title(new QLabel(this))
    , m_reasons(new QLabel(this)) {
    m_view->setModel(m_model);
    m_view->setItemDelegate(new StageDelegate(document, this));
    m_view->installEventFilter(this);
    m_view->viewport()->installEventFilter(this);
    setUpView(*m_view);
    m_title->setTextFormat(Qt::PlainText);
    m_title->setBuddy(m_view);
    m_reasons->setTextFormat(Qt::PlainText);
    m_reasons->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 4, 0, 4);
    auto* head = new QHBoxLayout;
    head->addWidget(m_title, 1);
    buildButtons(*head);
    layout->addLayout(head);
    layout->addWidget(m_view);
    layout->addWidget(m_reasons);
    connect(&document, &Document::replaced, this, [this] { m_replaced = true; });
    connect(&document, &Document::changed, this, [this] {
        const int stage = m_replaced ? 0 : std::max(0, currentStage());
        m_wanted = m_wanted < 0 ? stage : m_wanted;
        m_model->update(m_replaced);
        m_replaced = false;
        if (currentStage() < 0 || currentStage() != m_wanted) {
            select(m_wanted);
        }
        m_wanted = -1;
        updateButtons();
        fitHeight();
    });
    connect(m_model, &StageModel::refusalsChanged, this, [this] {
        updateReasons();
        emit refusalsChanged();
    });
    connect(m_view->selectionModel(), &QItemSelectionModel::currentChanged, this,
            &StageTable::updateButtons);
    m_wanted = -1;
    select(0);
    retranslate();
}

void StageTable::buildButtons(QHBoxLayout& into) {
    const auto button = [&](const char16_t* icon, auto action) {
        auto* made = new QToolButton(this);
        made->setIcon(QIcon(QStringLiteral(":/icons/%1.svg").arg(QStringView(icon))));
        made->setAutoRaise(true);
        made->setFocusPolicy(Qt::TabFocus);
        into.addWidget(made);
        connect(made, &QToolButton::clicked, this, action);
        return made;
    };
    m_add = button(u"add", [this] { addStage(); });
    m_remove = button(u"remove", [this] { removeStage(); });
    m_up = button(u"up", [this] { moveStage(-1); });
    m_down = button(u"down", [this] { moveStage(1); });
}

int StageTable::currentStage() const {
    return m_view->currentIndex().row();
}

void StageTable::select(int stage) {
    const int row = std::min(stage, m_model->rowCount() - 1);
    const int column = std::max(0, m_view->currentIndex().column());
    m_view->setCurrentIndex(m_model->index(row, std::min(column, m_model->columnCount() - 1)));
}

void StageTable::apply(std::vector<Stage> stages, EditText text, int selected) {
    Project project = m_document.project();
    project.cycle.stages = std::move(stages);
    m_wanted = selected;
    m_document.edit(std::move(project), text);
    m_wanted = -1;
    m_view->setFocus();
}

void StageTable::addStage() {
    auto stages = m_document.project().cycle.stages;
    if (stages.empty()) {
        apply({Stage{}}, {"Edit", QT_TRANSLATE_NOOP("Edit", "Add a stage")}, 0);
        return;
    }
    // The new stage shares the stock of the one it follows (or, for a spark-out, goes before it).
    auto at = static_cast<std::size_t>(std::max(0, currentStage()));
    const bool beforeSparkOut = sparksOut(stages[at]);
    if (beforeSparkOut && at > 0) {
        --at;
    }
    Stage added = stages[at];
    added.spark_out = {};
    if (sparksOut(stages[at])) {
        const bool traverse = m_document.project().operation == Operation::traverse;
        (traverse ? added.radial_feed_mm : added.radial_feed_mm_min) = traverse ? 0.001 : 0.1;
        stages.insert(stages.begin(), added);
        apply(std::move(stages), {"Edit", QT_TRANSLATE_NOOP("Edit", "Add a stage")}, 0);
        return;
    }
    added.stock_mm = tidy(stages[at].stock_mm / 2);
    stages[at].stock_mm = tidy(stages[at].stock_mm - added.stock_mm);
    stages.insert(stages.begin() + static_cast<std::ptrdiff_t>(at) + 1, added);
    apply(std::move(stages), {"Edit", QT_TRANSLATE_NOOP("Edit", "Add a stage")},
          static_cast<int>(at) + 1);
}

void StageTable::removeStage() {
    auto stages = m_document.project().cycle.stages;
    const int at = currentStage();
    if (at < 0 || stages.size() < 2) {
        return;
    }
    const auto index = static_cast<std::size_t>(at);
    Stage& heir = stages[index > 0 ? index - 1 : 1]; // the sum of the stocks stays
    heir.stock_mm = tidy(heir.stock_mm + stages[index].stock_mm);
    stages.erase(stages.begin() + at);
    apply(std::move(stages), {"Edit", QT_TRANSLATE_NOOP("Edit", "Remove a stage")},
          std::min(at, static_cast<int>(stages.size()) - 1));
}

bool StageTable::canMove(int by) const {
    const auto& stages = m_document.project().cycle.stages;
    const int from = currentStage();
    const int to = from + by;
    const int count = static_cast<int>(stages.size());
    return from >= 0 && to >= 0 && to < count && !sparksOut(stages[std::size_t(from)])
           && !sparksOut(stages[std::size_t(to)]);
}

void StageTable::moveStage(int by) {
    if (!canMove(by)) {
        return;
    }
    auto stages = m_document.project().cycle.stages;
    const int from = currentStage();
    std::swap(stages[std::size_t(from)], stages[std::size_t(from + by)]);
    apply(std::move(stages), {"Edit", QT_TRANSLATE_NOOP("Edit", "Move a stage")}, from + by);
}

void StageTable::updateButtons() {
    m_remove->setEnabled(m_model->rowCount() > 1 && currentStage() >= 0);
    m_up->setEnabled(canMove(-1));
    m_down->setEnabled(canMove(1));
}

void StageTable::setIssues(const Issues& issues) {
    m_issues = issues;
    m_model->setIssues(issues);
    updateReasons();
}

void StageTable::updateReasons() {
    QStringList lines;
    Mark worst = Mark::none;
    for (const Refusal& refusal : m_model->refusals()) {
        lines += tr("%1: %2").arg(locationText(refusal.path), refusal.reason);
        worst = Mark::error;
    }
    for (const Issue& issue : m_issues) {
        if (issue.path.starts_with("/cycle/stages")) {
            lines += tr("%1: %2").arg(locationText(issue.path), issueText(issue));
            worst = std::max(worst, markOf(issue.severity));
        }
    }
    QPalette colors = m_title->palette();
    colors.setColor(QPalette::WindowText, markColor(worst, colors));
    m_reasons->setPalette(colors);
    m_reasons->setText(lines.join(u'\n'));
    m_reasons->setVisible(!lines.isEmpty());
}

void StageTable::retranslate() {
    m_title->setText(tr("Stages"));
    m_view->setAccessibleName(tr("Stages of the cycle"));
    const auto name = [](QToolButton& button, const QString& text, const QString& keys) {
        button.setToolTip(tr("%1 (%2)").arg(text, keys));
        button.setAccessibleName(text);
    };
    name(*m_add, tr("Add a stage"), tr("Ins"));
    name(*m_remove, tr("Remove the stage"), tr("Del"));
    name(*m_up, tr("Move the stage up"), tr("Ctrl+Up"));
    name(*m_down, tr("Move the stage down"), tr("Ctrl+Down"));
    m_model->retranslate();
    updateReasons();
    updateButtons();
    fitHeight();
}

std::vector<Refusal> StageTable::refusals() const {
    return m_model->refusals();
}

bool StageTable::focusPath(const std::string& path) {
    const QModelIndex index = m_model->indexAt(path);
    if (!index.isValid()) {
        return false;
    }
    m_view->setFocus(Qt::OtherFocusReason);
    m_view->setCurrentIndex(index);
    return true;
}

/// Each column gets the width of the longest word of its title and a share of what is left.
void StageTable::fitColumns() {
    QHeaderView& header = *m_view->horizontalHeader();
    const int count = m_model->columnCount();
    std::vector<int> widths(std::size_t(count), 0);
    for (int column = 0; column < count; ++column) {
        const QString text =
            m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
        for (const QString& word : text.split(QRegularExpression(QStringLiteral("\\s")))) {
            widths[std::size_t(column)] =
                std::max(widths[std::size_t(column)], header.fontMetrics().horizontalAdvance(word));
        }
        widths[std::size_t(column)] += headerMargin;
    }
    const int used = std::accumulate(widths.begin(), widths.end(), 0);
    const int spare = std::max(0, m_view->viewport()->width() - used);
    for (int column = 0; column < count; ++column) {
        header.resizeSection(column, widths[std::size_t(column)] + spare * (column + 1) / count
                                         - spare * column / count);
    }
}

void StageTable::fitHeight() {
    fitColumns();
    QHeaderView& header = *m_view->horizontalHeader();
    int height = 0;
    for (int column = 0; column < m_model->columnCount(); ++column) {
        const QRect room(0, 0, header.sectionSize(column) - 10, 1000);
        const QString text =
            m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
        height = std::max(height,
                          header.fontMetrics().boundingRect(room, Qt::TextWordWrap, text).height());
    }
    header.setFixedHeight(height + 8);
    const int rows = std::clamp(m_model->rowCount(), 1, shownRows);
    m_view->setFixedHeight(height + 8 + rows * m_view->verticalHeader()->defaultSectionSize()
                           + 2 * m_view->frameWidth() + 2);
}

bool StageTable::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_view->viewport() && event->type() == QEvent::Resize) {
        const auto* resize = static_cast<const QResizeEvent*>(event);
        if (resize->size().width() != resize->oldSize().width()) {
            fitHeight();
        }
    }
    if (watched == m_view && event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool control = key->modifiers() & Qt::ControlModifier;
        switch (key->key()) {
        case Qt::Key_Insert: addStage(); return true;
        case Qt::Key_Delete: removeStage(); return true;
        case Qt::Key_Up:
        case Qt::Key_Down:
            if (control) {
                moveStage(key->key() == Qt::Key_Up ? -1 : 1);
                return true;
            }
            break;
        default: break;
        }
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace sparkout
