// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/cycle/runs_panel.h"

#include "ui/chart/plot_tools.h"
#include "ui/chart/quantity_colour.h"
#include "ui/kit/font_size.h"
#include "ui/kit/keyboard.h"
#include "ui/kit/metrics.h"
#include "ui/kit/theme_icon.h"
#include "ui/results/run_table.h"
#include "ui/results/verdict_table.h"
#include "ui/text/example_texts.h"
#include "ui/text/judgement_text.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QAction>
#include <QDateTime>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QIcon>
#include <QListView>
#include <QPainter>
#include <QPalette>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace sparkout {

/// An unchanged row keeps a name being typed.
void RunsModel::setRuns(std::vector<Run> runs) {
    const std::vector<Run> before = m_runs;
    const int had = rowCount(), has = static_cast<int>(runs.size());
    if (has > had) {
        beginInsertRows({}, had, has - 1);
        m_runs = std::move(runs);
        endInsertRows();
    } else if (has < had) {
        beginRemoveRows({}, has, had - 1);
        m_runs = std::move(runs);
        endRemoveRows();
    } else {
        m_runs = std::move(runs);
    }
    for (int row = 0; row < std::min(had, has); ++row) {
        const auto i = static_cast<std::size_t>(row);
        if (m_runs[i] != before[i]) {
            emit dataChanged(index(row), index(row));
        }
    }
}

void RunsModel::setPresent(Run run) {
    if (!m_runs.empty() && m_runs.front() != run) {
        m_runs.front() = std::move(run);
        emit dataChanged(index(0), index(0));
    }
}

int RunsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_runs.size());
}

QPixmap RunsModel::markOf(const Run& run, const QColor& text, const QColor& behindLight) {
    const qreal ratio = qApp->devicePixelRatio();
    QPixmap mark =
        runSample(std::max(run.number, 0), run.number < 0 ? Qt::transparent : text, sample, ratio);
    const int side = sample.height();
    QPainter painter(&mark);
    painter.setCompositionMode(QPainter::CompositionMode_Clear);
    painter.fillRect(sample.width() - side - metrics::tight, 0, side + metrics::tight, side,
                     Qt::transparent);
    painter.setCompositionMode(QPainter::CompositionMode_SourceOver);
    if (run.judged || run.light) {
        constexpr int rim = 2, round = 4;
        const QRect box(sample.width() - side, 0, side, side);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        painter.setBrush(behindLight);
        painter.drawRoundedRect(box, round, round);
        const int inside = behindLight.alpha() > 0 ? rim : 0;
        const int size = side - 2 * inside;
        painter.drawPixmap(box.topLeft() + QPoint(inside, inside),
                           run.judged ? judgedPixmap(*run.judged, size, ratio, false)
                                      : lightPixmap(*run.light, size, ratio, false));
    }
    return mark;
}

QVariant RunsModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) {
        return {};
    }
    const Run& run = m_runs.at(static_cast<std::size_t>(index.row()));
    switch (role) {
    case Qt::DisplayRole: return run.name + u'\n' + run.detail;
    case Qt::EditRole: return run.name;
    case Qt::ToolTipRole: return run.description;
    case Qt::AccessibleTextRole: return run.description;
    case Qt::DecorationRole: {
        const QPalette palette = QGuiApplication::palette();
        QIcon marks(markOf(run, palette.color(QPalette::Text), Qt::transparent));
        marks.addPixmap(
            markOf(run, palette.color(QPalette::HighlightedText), palette.color(QPalette::Base)),
            QIcon::Selected);
        return marks;
    }
    case Qt::CheckStateRole: return run.chosen ? Qt::Checked : Qt::Unchecked;
    default: return {};
    }
}

bool RunsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!index.isValid() || index.row() == 0) {
        return false;
    }
    if (role == Qt::CheckStateRole) {
        emit chosen(index.row() - 1, value.toInt() == Qt::Checked);
        return true;
    }
    if (role == Qt::EditRole) {
        if (value.toString() == m_runs[static_cast<std::size_t>(index.row())].name) {
            return false; // unchanged as displayed, possibly in another language than the file
        }
        emit renamed(index.row() - 1, value.toString());
        return true;
    }
    return false;
}

Qt::ItemFlags RunsModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) {
        return Qt::NoItemFlags;
    }
    const Qt::ItemFlags all = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    if (index.row() == 0) {
        return all;
    }
    const bool isOwn = m_runs.at(static_cast<std::size_t>(index.row())).isOwn;
    return isOwn ? all | Qt::ItemIsUserCheckable | Qt::ItemIsEditable
                 : all | Qt::ItemIsUserCheckable;
}

namespace {

/// Keeps a name that is being typed, unless the row itself gets another name.
class RunDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override {
        const QVariant name = index.data(Qt::EditRole);
        if (editor->property("runName") != name) {
            editor->setProperty("runName", name);
            QStyledItemDelegate::setEditorData(editor, index);
        }
    }
};

} // namespace

RunsPanel::RunsPanel(KeptRuns& kept, QWidget* parent)
    : QWidget(parent)
    , m_kept(kept)
    , m_list(new QListView(this))
    , m_runs(new RunsModel(this))
    , m_keep(makeAction("compareKeep", u"keep"))
    , m_restore(makeAction("compareRestore", u"restore", Qt::CTRL | Qt::Key_Return))
    , m_rename(makeAction("compareRename", u"rename", Qt::Key_F2))
    , m_delete(makeAction("compareDelete", u"remove", QKeySequence::Delete)) {
    build();
    connectParts();
}

QString RunsPanel::nameOf(int run) const {
    const QString name = runName(m_kept.run(run).name).simplified();
    const QString& surface = m_kept.surfaceOf(run);
    return surface.isEmpty() ? name : QStringLiteral("%1: %2").arg(printableText(surface), name);
}

QAction* RunsPanel::makeAction(const char* name, const char16_t* icon, const QKeySequence& keys) {
    auto* action = new QAction(themeIcon(icon), QString(), this);
    action->setObjectName(QLatin1String(name));
    action->setShortcut(keys);
    action->setShortcutContext(Qt::WidgetShortcut);
    return action;
}

void RunsPanel::build() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(metrics::tight);
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::hair);
    for (QAction* action : {m_keep, m_restore, m_rename, m_delete}) {
        row->addWidget(PlotTools::button(action, this));
    }
    row->addStretch(1);
    column->addLayout(row);
    column->addWidget(m_list, 1);
    m_list->setObjectName(QStringLiteral("compareRuns"));
    m_list->setModel(m_runs);
    m_list->setItemDelegate(new RunDelegate(m_list));
    m_list->setIconSize(RunsModel::sample);
    m_list->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setTextElideMode(Qt::ElideRight);
    m_list->setWordWrap(true);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setLayoutMode(QListView::Batched); // fast for a thousand kept runs
    setTextMinimumWidth(*m_list, 150);
    m_list->addActions({m_restore, m_rename, m_delete});
    m_list->setContextMenuPolicy(Qt::ActionsContextMenu);
}

void RunsPanel::connectParts() {
    connect(m_runs, &RunsModel::chosen, &m_kept, &KeptRuns::choose);
    connect(m_runs, &RunsModel::renamed, &m_kept, &KeptRuns::rename);
    connect(m_rename, &QAction::triggered, this, [this] {
        if (!m_list->isPersistentEditorOpen(m_list->currentIndex())) { // no other editor is open
            m_list->edit(m_list->currentIndex());
        }
    });
    connect(m_delete, &QAction::triggered, this, [this] {
        if (const int run = selected(); run >= 0) {
            m_kept.remove(run);
        }
    });
    connect(m_restore, &QAction::triggered, this, [this] {
        if (const int run = selected(); run >= 0) {
            m_kept.restore(run);
        }
    });
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this,
            &RunsPanel::enableActions);
}

int RunsPanel::selected() const {
    const int run = m_list->currentIndex().row() - 1; // row 0 is the current run
    return run >= 0 && run < m_kept.listed() ? run : -1;
}

void RunsPanel::enableActions() {
    const int run = selected();
    const bool isOwn = run >= 0 && m_kept.surfaceOf(run).isEmpty();
    m_restore->setEnabled(isOwn && m_kept.inputs(run));
    m_rename->setEnabled(isOwn);
    m_delete->setEnabled(isOwn);
}

void RunsPanel::setRuns(const ReadSummary* present, const Project* inputs) {
    m_present = present;
    m_presentLight = present ? verdictOf(present->summary, inputs) : std::nullopt;
    const int kept = selected();
    std::vector<RunsModel::Run> rows{presentRow()};
    int number = 0;
    for (int run = 0; run < m_kept.listed(); ++run) {
        const bool chosen = m_kept.isChosen(run);
        rows.push_back({nameOf(run), detailOf(run), descriptionOf(run), lightOf(run),
                        chosen ? ++number : -1, chosen, m_kept.surfaceOf(run).isEmpty()});
    }
    m_runs->setRuns(std::move(rows));
    if (!m_list->currentIndex().isValid() || kept >= m_kept.listed()) {
        m_list->setCurrentIndex(m_runs->index(m_kept.count()));
    }
    enableActions();
}

void RunsPanel::setJudgement(const Judgement* judgement) {
    m_judgement = judgement;
    m_runs->setPresent(presentRow());
}

RunsModel::Run RunsPanel::presentRow() const {
    RunsModel::Run row{tr("Current run"), detailOf(-1), descriptionOf(-1), lightOf(-1)};
    if (m_judgement) {
        row.judged = m_judgement->state;
    }
    return row;
}

// --- state of a run -----------------------------------------------------------------------------

const ReadSummary* RunsPanel::summaryOf(int run) const {
    return run >= 0 ? m_kept.summary(run) : m_present;
}

/// The time, followed by notes on the run.
QString RunsPanel::detailOf(int run) const {
    const ReadSummary* const read = summaryOf(run);
    if (!read) {
        return run < 0 ? tr("not computed yet") : tr("results not readable");
    }
    const QString time = read->missing.contains("/cycle_time_min")
                             ? tr("no results kept")
                             : Names::timeOfMinutes(read->summary.cycle_time_min);
    const RecalledRun* const now = run < 0 ? nullptr : m_kept.recalled(run);
    const bool isComputed = run >= 0 && (m_kept.isChosen(run) || m_kept.surfaceOf(run).isEmpty());
    return run < 0 || (!now && !isComputed) ? time
           : !now                           ? time + u'\n' + tr("computing…")
           : hasErrors(now->issues)         ? time + u'\n' + tr("refused by this version")
           : m_kept.isChanged(run)          ? time + u'\n' + tr("results differ")
                                            : time;
}

std::optional<Light> RunsPanel::lightOf(int run) const {
    if (run < 0) {
        return m_presentLight;
    }
    const ReadSummary* const read = m_kept.summary(run);
    return read && !read->missing.contains("/status") ? verdictOf(read->summary, m_kept.inputs(run))
                                                      : std::nullopt;
}

QString RunsPanel::descriptionOf(int run) const {
    QStringList lines{run < 0 ? tr("Current run, always drawn") : nameOf(run)};
    lines << detailOf(run).split(u'\n');
    if (run < 0 && m_judgement) {
        lines << JudgementText::headline(*m_judgement);
    } else if (const std::optional<Light> light = lightOf(run)) {
        lines << lightName(*light);
    }
    if (run < 0) {
        return lines.join(u'\n');
    }
    const KeptRun& kept = m_kept.run(run);
    const QDateTime when = QDateTime::fromString(QString::fromStdString(kept.when), Qt::ISODate);
    lines << tr("Kept %1 by version %2")
                 .arg(when.isValid() ? momentText(when.toLocalTime())
                                     : QString::fromStdString(kept.when),
                      QString::fromStdString(kept.engine_version));
    const RecalledRun* const now = m_kept.recalled(run);
    if (now && now->summary && m_kept.summary(run)) {
        lines << changesShown(*m_kept.summary(run), *now->summary);
    }
    return lines.join(u'\n');
}

void RunsPanel::retranslate() {
    m_list->setAccessibleName(tr("Runs; a check mark draws a run over the current one"));
    const auto name = [](QAction* action, const QString& text, const QString& tip) {
        action->setText(text);
        action->setToolTip(tip);
        nameShortcut(*action);
    };
    name(m_keep, tr("Keep the current run"),
         tr("Keep the inputs and results of the current run for comparison"));
    name(m_restore, tr("Restore the inputs"),
         tr("Replace the current inputs with those of the selected run; the kept runs remain"));
    name(m_rename, tr("Rename"), tr("Rename the selected run"));
    name(m_delete, tr("Delete"), tr("Delete the selected run"));
}

} // namespace sparkout
