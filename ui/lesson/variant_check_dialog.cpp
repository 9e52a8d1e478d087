// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/variant_check_dialog.h"

#include "core/project/member.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/lesson/lesson_desk.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_scale.h"
#include "ui/text/texts.h"
#include "words/lesson_words.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QVBoxLayout>

#include <utility>

namespace sparkout {

namespace {

constexpr int usuallyChecked = 5, mostChecked = 100;

QString faultSentence(const char* words) {
    const QString text = QCoreApplication::translate("Variants", words);
    return text.left(1).toUpper() + text.mid(1) + u'.';
}

/// The heading of a varied input's column: its place, without the page.
QString checkHeading(const VariedInput& input, const Project& project) {
    if (!input.sets.empty()) {
        return structText(tableOf<ValueSet>().name);
    }
    const QString place = inputLocation(input.path).section(QStringLiteral(" › "), 1);
    const Field* const field = nearestField(project, input.path);
    const QString unit = field ? unitText(field->unit) : QString();
    return unit.isEmpty() ? place : place + QStringLiteral(", ") + unit;
}

} // namespace

VariantCheckDialog::VariantCheckDialog(const Lesson& lesson, QWidget* parent)
    : QDialog(parent)
    , m_lesson(lesson)
    , m_count(new QSpinBox(this))
    , m_start(new QPushButton(tr("&Make"), this))
    , m_stop(new QPushButton(tr("&Stop"), this))
    , m_progress(new QProgressBar(this))
    , m_table(new QTableWidget(this))
    , m_state(new QLabel(this)) {
    setHelpTopic(*this, QStringLiteral("lessons#edit"));
    setObjectName(QStringLiteral("variantCheck"));
    setWindowTitle(tr("Check variants"));
    build();
    resize(1100, 480);
    start();
}

VariantCheckDialog::~VariantCheckDialog() {
    m_job.stop();
}

void VariantCheckDialog::build() {
    m_count->setObjectName(QStringLiteral("checkCount"));
    m_count->setRange(1, mostChecked);
    m_count->setValue(usuallyChecked);
    m_start->setObjectName(QStringLiteral("checkStart"));
    m_stop->setObjectName(QStringLiteral("checkStop"));
    m_start->setDefault(true);
    m_table->setObjectName(QStringLiteral("checkTable"));
    m_table->setAccessibleName(tr("Variants and refused tries"));
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setTabKeyNavigation(false);
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setStretchLastSection(true);
    QStringList heads{tr("Variant")};
    const Project& project = m_lesson.base.surfaces[variedSurface(m_lesson)].project;
    for (const VariedInput& input : m_lesson.variants->inputs) {
        heads += checkHeading(input, project);
    }
    heads += {tr("Best time, min"), tr("Margin, %"), tr("Reason for refusal")};
    m_table->setColumnCount(static_cast<int>(heads.size()));
    m_table->setHorizontalHeaderLabels(heads);
    m_state->setObjectName(QStringLiteral("checkState"));
    m_state->setWordWrap(true);
    auto* count = new QLabel(tr("&Number of variants"), this);
    count->setBuddy(m_count);
    auto* close = new QPushButton(tr("&Close"), this);
    auto* line = new QHBoxLayout;
    for (QWidget* each :
         std::initializer_list<QWidget*>{count, m_count, m_start, m_stop, m_progress}) {
        line->addWidget(each);
    }
    line->addStretch(1);
    line->addWidget(close);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(metrics::margin);
    layout->addLayout(line);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_state);
    connect(m_start, &QPushButton::clicked, this, &VariantCheckDialog::start);
    connect(m_stop, &QPushButton::clicked, this, &VariantCheckDialog::stop);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
}

void VariantCheckDialog::setBusy(bool busy) {
    m_isBusy = busy;
    m_count->setEnabled(!busy);
    m_start->setVisible(!busy);
    m_stop->setVisible(busy);
    m_progress->setVisible(busy);
}

void VariantCheckDialog::start() {
    m_table->setRowCount(0);
    m_state->setText(tr("Searching for the best answer of the original work…"));
    m_progress->setRange(0, 0);
    setBusy(true);
    m_stop->setFocus();
    m_job.start([this, lesson = m_lesson, count = static_cast<std::size_t>(m_count->value())](
                    const std::stop_token& stop, const NewestJob::Post& post) {
        MadeVariants made =
            makeVariants(lesson, count, LessonDesk::seedByNumber, stop,
                         [&](const VariantTry& tried) { post([this, tried] { add(tried); }); });
        if (!stop.stop_requested()) {
            post([this, all = std::move(made)] { finish(all); });
        }
    });
}

void VariantCheckDialog::stop() {
    m_job.stop();
    setBusy(false);
    m_state->setText(tr("Stopped."));
    m_start->setFocus();
}

QString VariantCheckDialog::levelText(std::size_t input, std::size_t level) const {
    const VariedInput& varied = m_lesson.variants->inputs[input];
    if (!varied.sets.empty()) {
        return printableText(QString::fromStdString(varied.sets[level].name));
    }
    const double number = *varied.valuesAt(level).front().number;
    const Field* const field =
        nearestField(m_lesson.base.surfaces[variedSurface(m_lesson)].project, varied.path);
    return printedNumber(field ? ShownScale::ofInput(*field).shown(number) : number);
}

void VariantCheckDialog::add(const VariantTry& tried) {
    constexpr int timeDigits = 3, marginDigits = 1;
    const int row = m_table->rowCount();
    m_table->insertRow(row);
    int column = 0;
    const auto put = [&](const QString& text, bool isNumber) {
        auto* item = new QTableWidgetItem(text);
        item->setTextAlignment((isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
        item->setToolTip(text);
        m_table->setItem(row, column++, item);
    };
    put(tried.found.fault ? QStringLiteral("–") : QString::number(tried.made), true);
    for (std::size_t i = 0; i < tried.levels.size(); ++i) {
        put(levelText(i, tried.levels[i]), m_lesson.variants->inputs[i].sets.empty());
    }
    const auto& best = tried.found.best;
    const auto amount = [&best](double value, int digits) {
        return best ? QLocale().toString(value, 'f', digits) : QStringLiteral("–");
    };
    put(amount(best ? best->time_min : 0, timeDigits), true);
    put(amount(best ? best->margin_percent : 0, marginDigits), true);
    put(tried.found.fault
            ? QCoreApplication::translate("Variants", variantFaultText(*tried.found.fault))
            : QString(),
        false);
    m_progress->setRange(0, m_count->value());
    m_progress->setValue(static_cast<int>(tried.made));
    m_state->setText(tr("Tried: %1, variants: %2").arg(row + 1).arg(tried.made));
    if (row == 0) {
        m_table->resizeColumnsToContents();
    }
}

void VariantCheckDialog::finish(const MadeVariants& made) {
    setBusy(false);
    m_start->setFocus();
    m_table->resizeColumnsToContents();
    if (made.fault != LessonFault::none) {
        m_state->setText(faultSentence(lessonFaultText(made.fault)));
        return;
    }
    QString text = tr("Tried: %1, variants: %2").arg(made.tries).arg(made.variants.size());
    if (made.reference) {
        text += QStringLiteral(". ")
                + tr("The original work: best time %1 min, margin %2 %")
                      .arg(QLocale().toString(made.reference->time_min, 'f', 3),
                           QLocale().toString(made.reference->margin_percent, 'f', 1));
    }
    m_state->setText(text + u'.');
}

} // namespace sparkout
