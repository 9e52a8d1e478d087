// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dialogs/examples_dialog.h"

#include "core/setup/setup_run.h"
#include "core/study/outcome.h"
#include "core/study/whole_batch.h"
#include "ui/kit/dialog_parts.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/results/verdict_table.h"
#include "ui/session/document.h"
#include "ui/text/example_texts.h"
#include "ui/text/judgement_text.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"
#include "ui/window/dialogs/part_drawing.h"

#include <QFile>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QScrollArea>
#include <QVBoxLayout>

#include <utility>

namespace sparkout {

namespace {

constexpr QSize thumbnailSize(130, 50);
constexpr int exampleDigits = 3;

} // namespace

QStringList ExamplesDialog::paths() {
    QStringList list;
    for (const QString& name : exampleFiles()) {
        list += QStringLiteral(":/examples/") + name;
    }
    return list;
}

QByteArray ExamplesDialog::textOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

ExamplesDialog::ExamplesDialog(QWidget* parent)
    : QDialog(parent), m_list(new QListWidget(this)), m_notes(new QLabel) {
    setHelpTopic(*this, QStringLiteral("start#examples"));
    setWindowTitle(tr("Example gallery"));
    m_list->setAccessibleName(tr("Examples"));
    m_list->setIconSize(thumbnailSize);
    m_list->setSpacing(metrics::hair);
    m_list->setWordWrap(true);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_notes->setTextFormat(Qt::PlainText);
    m_notes->setWordWrap(true);
    m_notes->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_notes->setMargin(metrics::margin);
    auto* scroll = new QScrollArea(this);
    scroll->setWidget(m_notes);
    scroll->setWidgetResizable(true);
    scroll->setAccessibleName(tr("Notes of the example"));
    auto* hint =
        new QLabel(tr("The example is opened as a copy; the shipped one stays as it is."), this);
    hint->setTextFormat(Qt::PlainText);
    connect(m_list, &QListWidget::itemActivated, this, &QDialog::accept);
    connect(m_list, &QListWidget::currentRowChanged, this, &ExamplesDialog::showNotes);
    auto* body = new QHBoxLayout;
    body->addWidget(m_list, 1);
    body->addWidget(scroll, 1);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(body, 1);
    layout->addWidget(hint);
    layout->addWidget(new AnswerButtons(tr("&Open a copy"), tr("&Cancel"), this));
    resize(960, 520);
    fill();
}

QString ExamplesDialog::kindOf(const Entry& entry) {
    const auto surfaces = static_cast<int>(entry.setup.surfaces.size());
    return surfaces == 1 ? choiceText(entry.first().operation->choice.label)
                         : tr("%n surfaces in one set-up", nullptr, surfaces);
}

QString ExamplesDialog::resultOf(const Entry& entry) {
    if (entry.setup.surfaces.size() == 1) {
        const OutcomePtr outcome = evaluate(entry.first(), {});
        return tr("%1. %2. %3.")
            .arg(verdict::time(outcome->result), verdict::status(outcome->result),
                 JudgementText::headline(judgementOf(*outcome)));
    }
    const SetupRun run = runSetup(entry.setup);
    if (!run.isCompleted(entry.setup)) {
        return tr("Not every cycle ends at size.");
    }
    const auto shown = [](double time_min) {
        return Names::timeOfMinutes(time_min, exampleDigits);
    };
    const QString time = run.time.isPieceEntered
                             ? tr("Main time %1, piece time %2.")
                                   .arg(shown(run.time.main_min), shown(run.time.piece_min))
                             : tr("Main time %1.").arg(shown(run.time.main_min));
    Judgement worst; // verdict of the surface with the worst one
    for (const SurfaceRun& surface : run.surfaces) {
        Judgement one = judge(surface.result, surface.constraints, judgeStocks(surface.result));
        if (&surface == run.surfaces.data() || one.state < worst.state) {
            worst = std::move(one);
        }
    }
    return time + u' ' + JudgementText::headline(worst) + u'.';
}

void ExamplesDialog::fill() {
    PartDrawing drawing;
    drawing.resize(thumbnailSize);
    for (const QString& path : paths()) {
        Document document;
        if (hasErrors(document.openCopy(textOf(path)))) {
            continue;
        }
        const Entry& entry = m_entries.emplace_back(Entry{path, document.setup()});
        drawing.setOutline(PartOutline::of(document.state()));
        new QListWidgetItem(QIcon(drawing.grab()),
                            tr("%1\n%2").arg(exampleTitle(entry.first().title), kindOf(entry)),
                            m_list);
    }
    m_list->setCurrentRow(0);
}

void ExamplesDialog::showNotes() {
    const int row = m_list->currentRow();
    if (row < 0) {
        m_notes->clear();
        return;
    }
    const Entry& entry = m_entries[std::size_t(row)];
    m_notes->setText(tr("%1\n\n%2").arg(resultOf(entry), exampleNotes(entry.first().notes)));
}

QByteArray ExamplesDialog::chosenText() const {
    const int row = m_list->currentRow();
    return row < 0 ? QByteArray() : textOf(m_entries[std::size_t(row)].path);
}

QString ExamplesDialog::chosenTitle() const {
    const int row = m_list->currentRow();
    return row < 0 ? QString() : exampleTitle(m_entries[std::size_t(row)].first().title);
}

} // namespace sparkout
