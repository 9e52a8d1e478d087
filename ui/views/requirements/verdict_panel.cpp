// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/requirements/verdict_panel.h"

#include "ui/dialogs/copy_table.h"
#include "ui/kit/font_size.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/results/result_tables.h"
#include "ui/results/verdict_table.h"
#include "ui/text/judgement_text.h"
#include "ui/text/limit_names.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/views/requirements/verdict_sections.h"

#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

namespace sparkout {

namespace {
using metrics::iconSmall;
constexpr double smallHead = 0.85; ///< relative to the usual font, so that the names fit
} // namespace

VerdictPanel::VerdictPanel(QWidget* parent, Settings* settings) : QWidget(parent) {
    setHelpTopic(*this, QStringLiteral("verdict"));
    build();
    buildTable();
    buildSaving(settings);
    showRequirements();
    retranslate();
}

QLabel* VerdictPanel::addText(QVBoxLayout* layout, const char* name) {
    auto* label = new QLabel(layout->parentWidget());
    label->setObjectName(QString::fromLatin1(name));
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setWordWrap(true);
    label->setMinimumWidth(1);
    layout->addWidget(label);
    return label;
}

/// Notices, time and light are always visible; the rest scrolls as one page.
void VerdictPanel::build() {
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->setSpacing(0);
    m_head = new QWidget(this);
    auto* area = new QScrollArea(this);
    outer->addWidget(m_head);
    outer->addWidget(area, 1);
    buildHead(m_head);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setFocusPolicy(Qt::NoFocus);
    auto* page = new QWidget(area);
    m_page = page;
    area->setWidget(page);
    m_layout = new QVBoxLayout(page);
    m_layout->setContentsMargins(0, metrics::tight, 0, metrics::gap);
    m_layout->setSpacing(metrics::gap);
    m_remedies = new RemedySection(page);
    m_layout->addWidget(m_remedies);
    m_status = addText(m_layout, "status");
    m_off = addText(m_layout, "notChecked");
    m_off->setTextFormat(Qt::RichText);
    m_off->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
    connect(m_off, &QLabel::linkActivated, this,
            [this](const QString& path) { emit pathAsked(path.toStdString()); });
    m_partOnly = addText(m_layout, "partOnly");
    m_model = new ValueModel(this);
    m_table = new CopyTable(*m_model, page);
    m_layout->addWidget(m_table);
    m_form = new FormSection(page);
    m_layout->addWidget(m_form);
    m_shop = new ShopSection(page);
    m_layout->addWidget(m_shop);
    m_layout->addStretch(1);
}

void VerdictPanel::buildHead(QWidget* head) {
    auto* layout = new QVBoxLayout(head);
    layout->setContentsMargins(metrics::gap, metrics::gap, metrics::gap, metrics::hair);
    layout->setSpacing(metrics::tight);
    m_notice = addText(layout, "notice");
    m_refused = addText(layout, "refusedFields");
    m_time = addText(layout, "time");
    m_overall = addText(layout, "overall");
    m_light = new QLabel(head);
    auto* line = new QHBoxLayout;
    line->addWidget(m_light, 0, Qt::AlignTop);
    line->addWidget(m_overall, 1);
    layout->addLayout(line);
    m_stocks = addText(layout, "judgedStocks");
    m_batch = addText(layout, "judgedBatch");
    m_why = addText(layout, "why");
    setRelativeFont(*m_time, metrics::headline);
    QFont bold = font();
    bold.setBold(true);
    m_overall->setFont(bold);
}

void VerdictPanel::buildTable() {
    m_table->setObjectName(QStringLiteral("requirements"));
    m_table->setWordWrap(true);
    m_table->verticalHeader()->hide();
    showRequirements(); // the headings
    QHeaderView* header = m_table->horizontalHeader();
    setRelativeFont(*header, smallHead);
    header->setSectionResizeMode(QHeaderView::ResizeToContents);
    header->setSectionResizeMode(static_cast<int>(VerdictColumn::requirement),
                                 QHeaderView::Stretch);
    connect(m_table, &CopyTable::resized, this, &VerdictPanel::fitTable, Qt::QueuedConnection);
    connect(m_table, &CopyTable::rowChosen, this, [this](int row) {
        if (const ConstraintResult* constraint = verdictRows(*m_good).at(std::size_t(row))) {
            m_chosen = *constraint;
            showTexts();
            emit requirementActivated(*constraint);
        }
    });
}

void VerdictPanel::buildSaving(Settings* settings) {
    const auto project = [this] {
        return m_good ? QString::fromStdString(m_good->result.project.title).simplified()
                      : QString();
    };
    const auto requirements = [this] {
        return m_good ? requirementTable(m_good->constraints, m_good->result.project.operation)
                      : CsvTable();
    };
    m_table->setSaving(requirements, project, settings);
    const auto stages = [this] {
        return m_good ? stageTable(m_good->shop, m_good->result.project.operation) : CsvTable();
    };
    m_shop->table()->setSaving(stages, project, settings);
    const auto form = [this] { return m_good ? formTable(*m_good) : CsvTable(); };
    m_form->table()->setSaving(form, project, settings);
}

void VerdictPanel::setOutcome(OutcomePtr outcome) {
    m_latest = std::move(outcome);
    if (m_queued) {
        return;
    }
    m_queued = true;
    QMetaObject::invokeMethod(
        this,
        [this] {
            m_queued = false;
            showOutcome();
        },
        Qt::QueuedConnection);
}

void VerdictPanel::setJudged(const JudgedRun& judged) {
    if (judged.outcome && judged.outcome->ran()) { // otherwise the last one stays, in grey
        m_judged = judged;
    }
    if (!m_queued) {
        showTexts();
    }
}

void VerdictPanel::forget() {
    m_good.reset();
    m_latest.reset();
    m_judged = {};
    m_chosen.reset();
    showTexts();
}

void VerdictPanel::showOutcome() {
    const bool ran = m_latest && m_latest->ran();
    if (ran) {
        m_good = m_latest;
        m_form->setOutcome(m_good);
        m_shop->setOutcome(m_good);
    }
    grey(m_good && !ran);
    showTexts();
    fitTable();
}

void VerdictPanel::showTexts() {
    const bool refused = m_latest && !m_latest->ran();
    QString notice;
    const bool incomplete = refused && !m_good && Names::incomplete(m_latest->issues);
    if (incomplete) {
        notice = tr("Not checked: requirements or other inputs are missing. Still needed:");
    } else if (refused) {
        notice =
            (m_good ? tr("The inputs are refused; the numbers are those of the last valid inputs.")
                    : tr("The inputs are refused:"))
            + QLatin1Char('\n') + Names::refusal(m_latest->issues);
    } else if (!m_good) {
        notice = tr("No result yet.");
    }
    m_notice->setText(notice);
    m_notice->setVisible(!notice.isEmpty());
    for (QWidget* w : std::initializer_list<QWidget*>{m_time, m_status, m_light, m_overall,
                                                      m_stocks, m_batch, m_partOnly, m_table}) {
        w->setVisible(m_good != nullptr);
    }
    m_off->clear(); // links keep an old palette until the text changes
    m_off->setText(m_good       ? LimitNames::notCheckedLinks(m_good->result.project)
                   : incomplete ? Names::missingLinks(m_latest->issues)
                                : QString());
    m_off->setVisible(!m_off->text().isEmpty());
    m_form->setVisible(m_good && !m_good->accuracy.zones.empty());
    m_shop->setVisible(m_good && !m_good->shop.stages.empty());
    const ConstraintResult* about = m_good ? explained() : nullptr;
    m_why->setText(about ? keptTogether(verdict::why(*m_good, *about)) : QString());
    m_why->setVisible(!m_why->text().isEmpty());
    if (!m_good) {
        return;
    }
    m_time->setText(verdict::time(m_good->result));
    m_status->setText(verdict::status(m_good->result));
    showJudged();
    m_table->setVisible(m_model->rowCount() > 0);
}

JudgedRun VerdictPanel::judgedRun() const {
    if (m_judged.outcome == m_good) {
        return m_judged;
    }
    JudgedRun alone;
    alone.outcome = m_good;
    alone.judgement = judge(m_good->result, m_good->constraints);
    return alone;
}

/// Pending verdicts are grey.
void VerdictPanel::showJudged() {
    const bool isOld = m_latest && !m_latest->ran();
    const JudgedRun judged = judgedRun();
    const Judgement& judgement = judged.judgement;
    const QString headline = JudgementText::headline(judgement);
    m_overall->setText(
        keptTogether(isOld ? tr("%1 (before the last edit)").arg(headline) : headline));
    m_light->setPixmap(judgedPixmap(judgement.state, iconSmall + 3, devicePixelRatioF(), isOld));
    m_stocks->setText(JudgementText::stocks(judgement, judged.areStocksComing));
    m_batch->setText(JudgementText::batch(judgement, judged.isBatchComing));
    m_stocks->setVisible(judgement.stocks || judged.areStocksComing);
    m_batch->setVisible(judged.hasBatch);
    m_stocks->setEnabled(!isOld && !judged.areStocksComing);
    m_batch->setEnabled(!isOld && !judged.isBatchComing);
    m_partOnly->setText(tr("Part as stated:"));
    m_partOnly->setVisible(judgement.isOfMoreParts());
}

const ConstraintResult* VerdictPanel::explained() const {
    for (const ConstraintResult& c : m_good->constraints) {
        if (m_chosen && c.kind == m_chosen->kind && c.section == m_chosen->section
            && c.stage == m_chosen->stage) {
            return &c;
        }
    }
    const ConstraintResult* worst = verdict::worst(*m_good);
    return worst && !worst->holds ? worst : nullptr;
}

void VerdictPanel::setRefusedFields(int n) {
    m_refusedFields = n;
    showRefusedFields();
}

void VerdictPanel::showRefusedFields() {
    m_refused->setText(
        m_refusedFields > 0 ? tr(
            "%n fields contain invalid entries; the verdict is based on their last valid values.",
            nullptr, m_refusedFields)
                            : QString());
    m_refused->setVisible(m_refusedFields > 0);
}

void VerdictPanel::grey(bool on) {
    const QPalette::ColorGroup group = on ? QPalette::Disabled : QPalette::Active;
    const QColor colour = QGuiApplication::palette().color(group, QPalette::WindowText);
    QPalette own;
    if (on) {
        own.setColor(QPalette::WindowText, colour);
    }
    for (QLabel* label : {m_time, m_status, m_overall, m_why, m_off, m_partOnly}) {
        label->setPalette(own);
    }
    QPalette ground;
    if (on) {
        constexpr float faint = 0.15F;
        QColor line = QGuiApplication::palette().color(QPalette::WindowText);
        line.setAlphaF(faint);
        ground.setBrush(QPalette::Window, QBrush(line, Qt::BDiagPattern));
    }
    for (QWidget* each : {m_head, m_page}) {
        each->setPalette(ground);
        each->setAutoFillBackground(on);
    }
    m_model->setGreyed(on);
    m_form->setGreyed(on, own);
    m_shop->setGreyed(on, own);
    showRequirements();
}

void VerdictPanel::showRequirements() {
    const bool isOld = m_good && m_latest && !m_latest->ran();
    m_model->setTable(verdictTable(m_good.get(), lightIcons(*m_table, isOld)));
}

/// The table is as high as its rows, since the panel scrolls.
void VerdictPanel::fitTable() {
    if (m_fitting) {
        return;
    }
    m_fitting = true;
    m_table->clearSpans();
    const int height = m_table->horizontalHeader()->sizeHint().height() + 2 * m_table->frameWidth();
    for (int row = 0; row < m_model->rowCount(); ++row) {
        if (m_model->table().rows[std::size_t(row)].isGroup) {
            m_table->setSpan(row, 0, 1, m_model->columnCount());
        }
    }
    m_table->resizeRowsToContents();
    m_table->setFixedHeight(height + m_table->verticalHeader()->length());
    m_layout->invalidate();
    m_table->parentWidget()->updateGeometry();
    m_fitting = false;
}

void VerdictPanel::copy() const {
    m_table->copy();
}

void VerdictPanel::retranslate() {
    setAccessibleName(tr("Verdict"));
    m_notice->setAccessibleName(tr("State of the verdict"));
    m_time->setAccessibleName(tr("Machining time"));
    m_time->setToolTip(tr("Machining time"));
    m_status->setAccessibleName(tr("End of the cycle"));
    m_overall->setAccessibleName(tr("Verdict on the drawing"));
    m_stocks->setAccessibleName(tr("Verdict over the stocks"));
    m_batch->setAccessibleName(tr("Verdict on the batch"));
    m_partOnly->setAccessibleName(tr("Scope of the table"));
    m_why->setAccessibleName(tr("Where the value comes from"));
    m_off->setAccessibleName(tr("Requirements that are not checked"));
    m_table->setAccessibleName(tr("Requirements of the drawing"));
    m_table->retranslate();
    m_refused->setAccessibleName(tr("Fields with invalid entries"));
    m_remedies->retranslate();
    m_form->retranslate();
    m_shop->retranslate();
    showRequirements();
    showRefusedFields();
    showTexts();
    fitTable();
}

void VerdictPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (!m_model) {
        return;
    }
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    } else if (event->type() == QEvent::PaletteChange) {
        grey(m_good && m_latest && !m_latest->ran());
        showTexts();
    } else if (event->type() == QEvent::FontChange) {
        showRequirements();
    }
}

} // namespace sparkout
