// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dialogs/export_dialog.h"

#include "ui/kit/dialog_parts.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/session/document.h"
#include "ui/session/studies.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <utility>

namespace sparkout {

namespace {

constexpr int exportDialogWidth = 460;
constexpr int noteLines = 3;

struct StudiesShown {
    Q_DECLARE_TR_FUNCTIONS(StudiesShown)
};

/// The reason why it cannot be exported; empty if it can. `view` is the class of its view.
QString hindrance(bool isRunning, bool isStale, const char* view, const char* title) {
    return isRunning ? StudiesShown::tr("It is being run: wait for it, or stop it.")
           : isStale ? StudiesShown::tr("These results are for the inputs before the last edit. "
                                        "Compute them for the current inputs in the view “%1”.")
                           .arg(QCoreApplication::translate(view, title))
                     : QString();
}

} // namespace

ExportDialog::ExportDialog(OutcomePtr outcome, ExportFormat format, QWidget* parent,
                           std::vector<StudyOffer> studies)
    : QDialog(parent)
    , m_outcome(std::move(outcome))
    , m_studies(std::move(studies))
    , m_format(new QComboBox(this))
    , m_content(new QComboBox(this))
    , m_note(plainLabel({}, this)) {
    setWindowTitle(tr("Export results"));
    setHelpTopic(*this, QStringLiteral("reports#results"));
    m_format->setObjectName(QStringLiteral("exportFormat"));
    m_format->addItems({tr("XLSX workbook"),
                        tr("CSV for Russian Excel: semicolons, decimal commas"),
                        tr("English CSV: commas, decimal points"), tr("JSON for programs")});
    m_format->setAccessibleName(tr("Format"));
    m_content->setObjectName(QStringLiteral("exportContent"));
    m_content->setAccessibleName(tr("Content"));
    m_note->setObjectName(QStringLiteral("exportNote"));
    m_note->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_note->setMinimumHeight(m_note->fontMetrics().lineSpacing() * noteLines);
    auto* form = new QFormLayout;
    form->addRow(tr("&Format:"), m_format);
    form->addRow(tr("&Content:"), m_content);
    auto* buttons = new AnswerButtons(tr("Choose the &place…"), tr("C&ancel"), this);
    m_go = buttons->acceptButton();
    m_go->setObjectName(QStringLiteral("exportGo"));
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(metrics::wide);
    layout->addLayout(form);
    layout->addWidget(m_note);
    layout->addWidget(buttons);
    connect(m_format, &QComboBox::currentIndexChanged, this, &ExportDialog::offerContents);
    connect(m_content, &QComboBox::currentIndexChanged, this, &ExportDialog::judge);
    m_format->setCurrentIndex(static_cast<int>(format));
    offerContents();
    resize(exportDialogWidth, sizeHint().height());
}

ExportFormat ExportDialog::format() const {
    return allExportFormats[static_cast<std::size_t>(m_format->currentIndex())];
}

ExportChoice ExportDialog::choice() const {
    const auto at = static_cast<std::size_t>(m_content->currentIndex());
    return {format(), at < m_contents.size() ? m_contents[at] : std::vector<ResultPart>()};
}

const StudyOffer* ExportDialog::offered() const {
    const auto at = static_cast<std::size_t>(m_content->currentIndex());
    return at < m_contents.size() ? nullptr : &m_studies.at(at - m_contents.size());
}

const Study* ExportDialog::study() const {
    const StudyOffer* offer = offered();
    return offer ? &offer->study : nullptr;
}

void ExportDialog::offerContents() {
    const Operation operation = m_outcome->result.project.operation;
    const std::vector<ResultPart> all(allResultParts.begin(), allResultParts.end());
    const std::vector<ResultPart> withoutTrace(all.begin(), all.end() - 1);
    m_contents.clear();
    QStringList names;
    const auto offer = [&](const QString& name, std::vector<ResultPart> parts) {
        names << name;
        m_contents.push_back(std::move(parts));
    };
    switch (format()) {
    case ExportFormat::xlsx:
        offer(tr("Inputs, results, requirements and the trace"), all);
        offer(tr("The same without the trace"), withoutTrace);
        break;
    case ExportFormat::json:
        offer(tr("Results, shop figures and requirements"), withoutTrace);
        break;
    default:
        offer(partName(ResultPart::trace, operation), {ResultPart::trace});
        for (const ResultPart part : withoutTrace) {
            offer(partName(part, operation), {part});
        }
    }
    if (format() != ExportFormat::json) {
        for (const StudyOffer& each : m_studies) {
            names << studyName(each.study.kind());
        }
    }
    const QSignalBlocker quiet(m_content);
    m_content->clear();
    m_content->addItems(names);
    m_content->setEnabled(names.size() > 1);
    judge();
}

QString ExportDialog::note(const ExportChoice& choice) const {
    const QString rows = QLocale().toString(static_cast<qulonglong>(traceRows(*m_outcome)));
    switch (choice.format) {
    case ExportFormat::json:
        return tr("The object that the command line prints for a run; its keys are the same in "
                  "every language.");
    case ExportFormat::xlsx:
        return choice.hasTrace() ? tr("Every part on separate sheets; the trace has %1 rows on %2 "
                                      "sheets, a row for every pass of a radius under the wheel.")
                                       .arg(rows)
                                       .arg(m_outcome->result.sections.size())
                                 : tr("Every part on a separate sheet.");
    default: break;
    }
    return choice.hasTrace()
               ? tr("One table; it has %1 rows, a row for every pass of a radius under the wheel.")
                     .arg(rows)
               : tr("One table.");
}

void ExportDialog::judge() {
    if (const StudyOffer* offer = offered()) {
        m_note->setText(!offer->obstacle.isEmpty()       ? offer->obstacle
                        : format() == ExportFormat::xlsx ? studyNote(offer->study.kind())
                                                         : tr("One table."));
        m_go->setEnabled(offer->obstacle.isEmpty());
        return;
    }
    const ExportChoice chosen = choice();
    const QString obstacle = exportObstacle(m_outcome, chosen);
    m_note->setText(obstacle.isEmpty() ? note(chosen) : obstacle);
    m_go->setEnabled(obstacle.isEmpty());
}

std::vector<StudyOffer> studiesOffered(Studies& studies, const Project& now,
                                       const Document& document) {
    std::vector<StudyOffer> offers;
    if (const BatchOutcomePtr& batch = studies.batch.result()) {
        offers.push_back({{.batch = batch, .indices = studies.indices()},
                          hindrance(studies.batch.running() || studies.indexJob().running(),
                                    !studies.batch.isOf(now), "sparkout::BatchView", "Batch")});
    }
    if (const SweepResultPtr& sweep = studies.sweep.result()) {
        offers.push_back({{.sweep = sweep},
                          hindrance(studies.sweep.running(), !studies.sweep.isOf(now),
                                    "sparkout::SweepView", "Sweep")});
    }
    if (const SearchOutcomePtr& search = studies.search.result()) {
        const bool wearsOtherwise =
            search->wear
            && !sameWear(SurfaceWear(document.setup(), document.surface()), *search->wear);
        offers.push_back(
            {{.search = search, .before_s = search->given.time_s},
             hindrance(studies.search.running(), !studies.search.isOf(now) || wearsOtherwise,
                       "sparkout::OptimiseView", "Optimise")});
    }
    return offers;
}

} // namespace sparkout
