// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/verdict_panel.h"

#include "ui/metrics.h"
#include "ui/views/light_icon.h"
#include "ui/views/names.h"
#include "ui/views/verdict_text.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QScrollArea>
#include <QTableView>
#include <QVBoxLayout>

namespace sparkout {

namespace {
using metrics::iconSmall;
} // namespace

VerdictPanel::VerdictPanel(QWidget* parent) : QWidget(parent) {
    build();
    buildTable();
    drawIcons();
    retranslate();
}

void VerdictPanel::build() {
    auto* area = new QScrollArea(this);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setFocusPolicy(Qt::NoFocus);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(area);
    auto* page = new QWidget(area);
    area->setWidget(page);
    m_layout = new QVBoxLayout(page);
    m_layout->setContentsMargins(metrics::margin, metrics::gap, metrics::margin, metrics::gap);
    m_layout->setSpacing(metrics::gap);
    for (QLabel** label :
         {&m_notice, &m_time, &m_status, &m_overall, &m_unchecked, &m_stages, &m_peaks}) {
        *label = new QLabel(page);
        (*label)->setTextFormat(Qt::PlainText);
        (*label)->setTextInteractionFlags(Qt::TextSelectableByMouse);
        (*label)->setWordWrap(true);
        (*label)->setMinimumWidth(1);
    }
    m_light = new QLabel(page);
    m_table = new QTableView(page);
    auto* line = new QHBoxLayout;
    line->addWidget(m_light, 0, Qt::AlignTop);
    line->addWidget(m_overall, 1);
    for (QWidget* w : std::initializer_list<QWidget*>{m_notice, m_time, m_status}) {
        m_layout->addWidget(w);
    }
    m_layout->addLayout(line);
    for (QWidget* w : std::initializer_list<QWidget*>{m_table, m_unchecked, m_stages, m_peaks}) {
        m_layout->addWidget(w);
    }
    m_layout->addStretch(1);
    setUpFonts();
}

void VerdictPanel::setUpFonts() {
    QFont big = font();
    big.setPointSizeF(big.pointSizeF() * metrics::headline);
    m_time->setFont(big);
    QFont bold = font();
    bold.setBold(true);
    m_overall->setFont(bold);
    m_notice->setObjectName(QStringLiteral("notice"));
    m_overall->setObjectName(QStringLiteral("overall"));
    m_time->setObjectName(QStringLiteral("time"));
    m_status->setObjectName(QStringLiteral("status"));
    m_stages->setObjectName(QStringLiteral("stages"));
    m_peaks->setObjectName(QStringLiteral("peaks"));
    m_unchecked->setObjectName(QStringLiteral("unchecked"));
}

void VerdictPanel::buildTable() {
    m_model = new VerdictModel(this);
    m_table->setModel(m_model);
    m_table->setIconSize(QSize(iconSmall, iconSmall));
    m_table->setWordWrap(true);
    m_table->setShowGrid(false);
    m_table->setAlternatingRowColors(true);
    m_table->setCornerButtonEnabled(false);
    m_table->setTabKeyNavigation(false);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->verticalHeader()->hide();
    QHeaderView* header = m_table->horizontalHeader();
    header->setHighlightSections(false);
    header->setMinimumSectionSize(20);
    header->setSectionResizeMode(QHeaderView::ResizeToContents);
    header->setSectionResizeMode(VerdictModel::requirement, QHeaderView::Stretch);
    header->setSectionsClickable(false);
    m_table->installEventFilter(this);
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

void VerdictPanel::showOutcome() {
    const bool ran = m_latest && m_latest->ran();
    if (ran) {
        m_good = m_latest;
        m_model->setOutcome(m_good);
    }
    grey(m_good && !ran);
    showTexts();
    fitTable();
}

void VerdictPanel::showTexts() {
    const bool refused = m_latest && !m_latest->ran();
    QString notice;
    if (refused) {
        notice = (m_good ? tr("The inputs are refused; the numbers are those of the last "
                              "accepted ones.")
                         : tr("The inputs are refused:"))
                 + QLatin1Char('\n') + Names::refusal(m_latest->issues);
    } else if (!m_good) {
        notice = tr("No result yet.");
    }
    m_notice->setText(notice);
    m_notice->setVisible(!notice.isEmpty());
    for (QWidget* w : std::initializer_list<QWidget*>{m_time, m_status, m_light, m_overall, m_table,
                                                      m_stages, m_peaks}) {
        w->setVisible(m_good != nullptr);
    }
    if (!m_good) {
        return;
    }
    m_time->setText(verdict::time(m_good->result));
    m_status->setText(verdict::status(m_good->result));
    m_overall->setText(verdict::overall(*m_good));
    m_stages->setText(verdict::stages(m_good->result));
    m_peaks->setText(verdict::peaks(m_good->result));
    m_light->setPixmap(
        lightPixmap(verdict::overallLight(*m_good), iconSmall + 3, devicePixelRatioF(), refused));
    m_table->setVisible(m_model->rowCount() > 0);
    const QString unchecked = verdict::unchecked(m_good->result);
    m_unchecked->setText(unchecked);
    m_unchecked->setVisible(!unchecked.isEmpty());
}

void VerdictPanel::grey(bool on) {
    const QPalette::ColorGroup group = on ? QPalette::Disabled : QPalette::Active;
    const QColor colour = QGuiApplication::palette().color(group, QPalette::WindowText);
    for (QLabel* label : {m_time, m_status, m_overall, m_unchecked, m_stages, m_peaks}) {
        QPalette own;
        if (on) {
            own.setColor(QPalette::WindowText, colour);
        }
        label->setPalette(own);
    }
    m_model->setGreyed(on);
    drawIcons();
}

void VerdictPanel::drawIcons() {
    const bool grey = m_good && m_latest && !m_latest->ran();
    const auto icon = [&](Light light) {
        return QIcon(lightPixmap(light, iconSmall, devicePixelRatioF(), grey));
    };
    m_model->setIcons({icon(Light::holds), icon(Light::close), icon(Light::fails)});
}

/// The table is as high as its rows; the panel scrolls as one.
void VerdictPanel::fitTable() {
    if (m_fitting) {
        return;
    }
    m_fitting = true;
    m_table->clearSpans();
    const int height = m_table->horizontalHeader()->sizeHint().height() + 2 * m_table->frameWidth();
    for (int row = 0; row < m_model->rowCount(); ++row) {
        if (m_model->isZoneRow(row)) {
            m_table->setSpan(row, 0, 1, m_model->columnCount());
        }
    }
    m_table->resizeRowsToContents();
    m_table->setFixedHeight(height + m_table->verticalHeader()->length());
    m_layout->invalidate();
    m_table->parentWidget()->updateGeometry();
    m_fitting = false;
}

bool VerdictPanel::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_table && event->type() == QEvent::Resize) {
        QMetaObject::invokeMethod(
            this, [this] { fitTable(); }, Qt::QueuedConnection);
    }
    if (watched == m_table && event->type() == QEvent::KeyPress
        && static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) {
        copy();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void VerdictPanel::copy() const {
    QGuiApplication::clipboard()->setText(m_model->asTsv());
}

void VerdictPanel::retranslate() {
    setAccessibleName(tr("Verdict"));
    m_notice->setAccessibleName(tr("State of the verdict"));
    m_time->setAccessibleName(tr("Machining time"));
    m_time->setToolTip(tr("Machining time"));
    m_status->setAccessibleName(tr("End of the cycle"));
    m_overall->setAccessibleName(tr("Verdict on the drawing"));
    m_table->setAccessibleName(tr("Requirements of the drawing"));
    m_table->setToolTip(tr("Ctrl+C copies the table"));
    m_unchecked->setAccessibleName(tr("Requirements that are not checked"));
    m_stages->setAccessibleName(tr("Stages"));
    m_peaks->setAccessibleName(tr("Largest force and power"));
    m_model->retranslate();
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
    }
}

} // namespace sparkout
