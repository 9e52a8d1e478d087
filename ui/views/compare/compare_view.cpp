// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/compare/compare_view.h"

#include "ui/charts/compare_plot.h"
#include "ui/charts/run_table_model.h"
#include "ui/charts/runs_model.h"
#include "ui/dialogs/copy_table.h"
#include "ui/kit/font_size.h"
#include "ui/plot/cursor_strip.h"
#include "ui/plot/legend_strip.h"
#include "ui/plot/plot_tools.h"
#include "ui/text/example_texts.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QAction>
#include <QComboBox>
#include <QDateTime>
#include <QHeaderView>
#include <QLabel>
#include <QListView>
#include <QLocale>
#include <QPushButton>
#include <QSplitter>

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

constexpr int widestValue = 120, leastName = 200; ///< columns, at the usual size of type
constexpr int mostChanges = 3; ///< named of a run in the notice; the list's tooltip has all

QString runName(const KeptRun& run) {
    return exampleTitle(run.name).simplified();
}

/// Along the ground length, from 0 to 1.
double placeShare(const RunSummary& summary, std::size_t zone, double length_mm) {
    return length_mm > 0 ? summary.zones[zone].position_mm / length_mm : 0;
}

} // namespace

QString CompareView::title() const {
    return tr("Compare");
}

int CompareView::selectedRun() const {
    const int run = m_list->currentIndex().row() - 1; // below the present one
    return run >= 0 && run < m_kept.count() ? run : -1;
}

std::vector<int> CompareView::chosenRuns() const {
    std::vector<int> runs;
    for (int run = 0; run < m_kept.count(); ++run) {
        if (m_kept.isChosen(run)) {
            runs.push_back(run);
        }
    }
    return runs;
}

// --- what is shown ------------------------------------------------------------------------------

void CompareView::showOutcome() {
    const bool ran = latest() && latest()->ran() && !latest()->result.sections.empty();
    if (ran && m_good != latest()) {
        const bool same = m_good
                          && m_good->result.project.operation == latest()->result.project.operation
                          && m_good->result.sections.size() == latest()->result.sections.size();
        m_good = latest();
        m_present =
            ReadSummary{summarise(m_good->result, m_good->accuracy, m_good->constraints), {}};
        if (!same) { // the gauge's zone, or the middle section
            m_wanted = m_good->result.sections.size() / 2;
        }
        fillAxes();
        fillZones();
    }
    m_plot->setDimmed(m_good && !ran);
    showRuns();
    showCurves();
    showTable();
    showMoment();
    showState();
    emit updated();
}

void CompareView::showRuns() {
    const int kept = selectedRun();
    std::vector<RunsModel::Run> rows{{tr("Present run"), detailOf(-1), toldOf(-1), lightOfRun(-1)}};
    int number = 0;
    for (int run = 0; run < m_kept.count(); ++run) {
        const bool chosen = m_kept.isChosen(run);
        rows.push_back({runName(m_kept.all()[static_cast<std::size_t>(run)]), detailOf(run),
                        toldOf(run), lightOfRun(run), chosen ? ++number : -1, chosen});
    }
    m_runs->setRuns(std::move(rows));
    if (!m_list->currentIndex().isValid() || kept >= m_kept.count()) {
        m_list->setCurrentIndex(m_runs->index(m_runs->rowCount() - 1));
    }
}

/// The summary as kept; of the present run for −1, null while there is none.
const RunSummary* CompareView::summaryOf(int run) const {
    const ReadSummary* const read = run >= 0    ? m_kept.summary(run)
                                    : m_present ? &*m_present
                                                : nullptr;
    return read ? &read->summary : nullptr;
}

/// The time, and below it what there is to say.
QString CompareView::detailOf(int run) const {
    const RunSummary* const summary = summaryOf(run);
    if (!summary) {
        return run < 0 ? tr("not computed yet") : tr("results not readable");
    }
    const ReadSummary* const read = run >= 0 ? m_kept.summary(run) : nullptr;
    const QString time = read && read->missing.contains("/cycle_time_min")
                             ? tr("no results kept")
                             : tr("%1 min").arg(Names::significant(summary->cycle_time_min));
    const RecalledRun* const now = run < 0 ? nullptr : m_kept.recalled(run);
    return run < 0                  ? time
           : !now                   ? time + u'\n' + tr("computing…")
           : hasErrors(now->issues) ? time + u'\n' + tr("refused now")
           : m_kept.isChanged(run)  ? time + u'\n' + tr("differs now")
                                    : time;
}

std::optional<Light> CompareView::lightOfRun(int run) const {
    const RunSummary* const summary = summaryOf(run);
    const ReadSummary* const read = run >= 0 ? m_kept.summary(run) : nullptr;
    const bool unknown = !summary || (read && read->missing.contains("/status"));
    return unknown ? std::nullopt : verdictOf(*summary);
}

QString CompareView::toldOf(int run) const {
    QStringList lines{run < 0 ? tr("Present run, always drawn")
                              : runName(m_kept.all()[static_cast<std::size_t>(run)])};
    lines << detailOf(run).split(u'\n');
    if (const std::optional<Light> light = lightOfRun(run)) {
        lines << lightName(*light);
    }
    if (run < 0) {
        return lines.join(u'\n');
    }
    const KeptRun& kept = m_kept.all()[static_cast<std::size_t>(run)];
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

/// Of the zone or section the user chose: of an alike run the same one, of another the nearest
/// along the part. Nothing while it is not computed or when it was not recorded.
std::optional<ComparedFeeds> CompareView::feedsOf(int run) const {
    const RecalledRun* const now = m_kept.recalled(run);
    const Project* const inputs = m_kept.inputs(run);
    if (!now || !now->feeds || now->feeds->columns.empty() || !now->summary || !inputs) {
        return std::nullopt;
    }
    const std::vector<ZoneSummary>& zones = now->summary->zones;
    ComparedFeeds feeds{runName(m_kept.all()[static_cast<std::size_t>(run)]), now->feeds, m_wanted};
    if (now->feeds->operation != m_good->feeds.operation
        || zones.size() != m_present->summary.zones.size()) {
        const double wanted =
            placeShare(m_present->summary, m_wanted, m_good->result.project.part.length_mm);
        const auto distance = [&](std::size_t zone) {
            return std::abs(placeShare(*now->summary, zone, inputs->part.length_mm) - wanted);
        };
        feeds.column = 0;
        for (std::size_t zone = 1; zone < zones.size(); ++zone) {
            feeds.column = distance(zone) < distance(feeds.column) ? zone : feeds.column;
        }
        const FeedColumn& column = now->feeds->columns[feeds.column];
        feeds.name = tr("%1: %2").arg(feeds.name, Names::zone(column.zone, column.section));
    }
    return feeds;
}

void CompareView::showCurves() {
    std::vector<ComparedFeeds> runs;
    if (m_good && m_wanted < m_good->feeds.columns.size()) {
        runs.push_back({tr("Present run"), {m_good, &m_good->feeds}, m_wanted});
        int number = 0;
        for (const int run : chosenRuns()) {
            ++number; // also of one that is not drawn yet
            if (auto feeds = feedsOf(run)) {
                feeds->number = number;
                runs.push_back(std::move(*feeds));
            }
        }
    }
    m_plot->setRuns(std::move(runs));
    m_plot->replot(QCustomPlot::rpQueuedReplot);
    m_tools->navigation().amendView();
}

/// A run that comes out differently now stands there as it was kept and as it is computed.
void CompareView::showTable() {
    std::vector<ComparedValues> runs;
    std::vector<ReadSummary> computed;
    const std::vector<int> chosen = chosenRuns();
    computed.reserve(chosen.size());
    if (m_present && !chosen.empty()) {
        runs.push_back({tr("Present run"), &m_good->result.project, &*m_present});
        for (const int run : chosen) {
            const QString name = runName(m_kept.all()[static_cast<std::size_t>(run)]);
            runs.push_back({name, m_kept.inputs(run), m_kept.summary(run)});
            const RecalledRun* const now = m_kept.recalled(run);
            if (m_kept.isChanged(run) && now && now->summary) {
                computed.push_back({*now->summary, {}});
                runs.push_back({tr("now: %1").arg(name), m_kept.inputs(run), &computed.back()});
            }
        }
    }
    QStringList names;
    for (const ComparedValues& run : runs) {
        names << run.name;
    }
    m_tableModel->setRows(differingRows(runs), names);
}

void CompareView::showMoment() {
    const CycleCursor* const at = cycleIn(m_good);
    m_plot->setMoment(at && !at->atEnd() ? std::optional(at->time_s()) : std::nullopt);
}

void CompareView::followCycle() {
    showMoment();
}

void CompareView::showLegend() {
    m_legend->setEntries(m_plot->legendEntries());
}

/// Without a table the curves have its room.
void CompareView::shareHeight(bool withTable) {
    const bool had = !m_table->isHidden();
    m_table->setVisible(withTable);
    m_table->parentWidget()->setSizePolicy(
        QSizePolicy::Preferred, withTable ? QSizePolicy::Preferred : QSizePolicy::Maximum);
    if (withTable && !had) {
        m_halves->setSizes(m_heights);
    } else if (!withTable) {
        m_heights = had ? m_halves->sizes() : m_heights;
        m_halves->setSizes({m_halves->height(), 0});
    }
}

void CompareView::fitTable() {
    const QAbstractItemView& table = *m_table; // where it is public
    QHeaderView* const head = m_table->horizontalHeader();
    int values = 0;
    for (int column = 1; column < m_tableModel->columnCount(); ++column) {
        const int wanted = std::max(table.sizeHintForColumn(column), head->sectionSizeHint(column));
        const int width = std::min(wanted, atFontSize(widestValue));
        head->resizeSection(column, width);
        values += width;
    }
    const int rest = m_table->viewport()->width() - values;
    head->resizeSection(0, std::max(rest, atFontSize(leastName)));
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents); // measures
}

void CompareView::showState() {
    const bool drawn = !m_plot->runs().empty();
    m_notice->setText(notice());
    m_notice->setVisible(!m_notice->text().isEmpty());
    for (QWidget* part : std::initializer_list<QWidget*>{m_plot, m_legend, m_values}) {
        part->setVisible(drawn);
    }
    m_zone->setEnabled(drawn);
    m_axis->setEnabled(drawn);
    m_tools->setEnabled(drawn);
    m_keepHere->setVisible(m_kept.count() == 0);
    const QString empty = emptyText();
    m_empty->setText(empty);
    m_empty->setVisible(!empty.isEmpty());
    shareHeight(empty.isEmpty());
    const int run = selectedRun();
    m_restore->setEnabled(run >= 0 && m_kept.inputs(run));
    m_rename->setEnabled(run >= 0);
    m_delete->setEnabled(run >= 0);
    readOut();
}

// --- texts --------------------------------------------------------------------------------------

QString CompareView::hint() const {
    return tr("Point at a curve to read its values beside those of the present run.");
}

QString CompareView::emptyText() const {
    if (m_kept.count() == 0) {
        return tr("No run is kept yet. Keep the present one, change the inputs, and see here what "
                  "it did: the curves of both, and the inputs and results that differ.");
    }
    if (chosenRuns().empty()) {
        return tr("Check a run in the list to lay it over the present one.");
    }
    return m_tableModel->rows().empty()
               ? tr("The chosen runs have the inputs and results of the present one.")
               : QString();
}

QString CompareView::notice() const {
    QStringList lines;
    if (latest() && !latest()->ran()) {
        lines << (m_good ? tr("The inputs are refused; the present run is that of the last "
                              "accepted ones.")
                         : tr("The inputs are refused:"))
                     + u'\n' + Names::refusal(latest()->issues, 2);
    } else if (!m_good) {
        lines << tr("No result yet.");
    } else if (m_good->feeds.columns.empty()) {
        lines << tr("The cycle is too long to be recorded: its curves are not drawn. Fewer radii "
                    "or sections help.");
    }
    for (const int run : chosenRuns()) {
        const KeptRun& kept = m_kept.all()[static_cast<std::size_t>(run)];
        const RecalledRun* const now = m_kept.recalled(run);
        if (now && hasErrors(now->issues)) {
            lines << tr("“%1” can no longer be run: %2")
                         .arg(runName(kept), Names::refusal(now->issues, 1));
        } else if (now && now->summary && m_kept.isChanged(run)) {
            const QStringList all = m_kept.summary(run)
                                        ? changesShown(*m_kept.summary(run), *now->summary)
                                        : QStringList{tr("its results cannot be read")};
            QString named = all.mid(0, mostChanges).join(QStringLiteral("; "));
            if (all.size() > mostChanges) {
                named += tr("; and %n more", nullptr, static_cast<int>(all.size()) - mostChanges);
            }
            lines << tr("“%1” was kept by version %2 of the program and comes out differently "
                        "now: %3")
                         .arg(runName(kept), QString::fromStdString(kept.engine_version), named);
        } else if (now && now->feeds && now->feeds->columns.empty()) {
            lines << tr("“%1” is too long to be recorded: its curves are not drawn.")
                         .arg(runName(kept));
        }
    }
    return lines.join(u'\n');
}

QStringList CompareView::heading() const {
    QStringList heading{title()};
    if (m_good) {
        heading << QString::fromStdString(m_good->result.project.title).simplified()
                << m_zone->currentText();
    }
    heading.removeAll(QString());
    return heading;
}

void CompareView::fillAxes() {
    const bool strokes = !m_good || m_good->feeds.operation->countsStrokes;
    const int before = m_axis->currentIndex() < 0 ? 0 : m_axis->currentData().toInt();
    m_axis->clear();
    m_axis->addItem(tr("Time, min"), static_cast<int>(CycleAxis::minutes));
    m_axis->addItem(tr("Time, s"), static_cast<int>(CycleAxis::seconds));
    m_axis->addItem(strokes ? tr("Double strokes") : tr("Revolutions"),
                    static_cast<int>(CycleAxis::strokes));
    m_axis->setCurrentIndex(std::max(m_axis->findData(before), 0));
}

void CompareView::fillZones() {
    m_zone->clear();
    if (m_good) {
        for (const FeedColumn& column : m_good->feeds.columns) {
            m_zone->addItem(Names::zoneFull(column.zone, column.section));
        }
        m_zone->setCurrentIndex(static_cast<int>(m_wanted));
    }
}

void CompareView::retranslate() {
    nameParts();
    fillAxes();
    fillZones();
    m_legend->retranslate();
    m_plot->retranslate();
    m_table->retranslate();
    m_tools->retranslate();
    m_strip->retranslate();
    showRuns();
    showCurves();
    showTable();
    showState();
}

void CompareView::recolour() {
    showLegend();
}

} // namespace sparkout
