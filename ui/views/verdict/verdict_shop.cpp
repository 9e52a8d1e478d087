// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/verdict/verdict_shop.h"
#include "ui/kit/font_size.h"
#include "ui/kit/theme.h"

#include "ui/dialogs/copy_table.h"
#include "ui/kit/theme_icon.h"
#include "ui/views/verdict/verdict_shop_model.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QIcon>
#include <QLabel>
#include <QPainter>
#include <QScrollBar>
#include <QStyle>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include <utility>

namespace sparkout {

namespace {
constexpr int iconSize = 13;

/// Narrow cells, so that three stages and the cycle fit beside their names into 300 px: a number
/// at the right, a mark before it, two pixels of air.
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

ShopSection::ShopSection(QWidget* parent)
    : QWidget(parent)
    , m_title(new QLabel(this))
    , m_model(new ShopModel(this))
    , m_table(new CopyTable([this] { return m_model->asTsv(); }, this))
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
    buildTable();
    retranslate();
}

void ShopSection::buildTable() {
    m_table->setObjectName(QStringLiteral("shop"));
    m_table->setModel(m_model);
    m_table->setItemDelegate(new NarrowCells(m_table));
    m_table->setWordWrap(false);
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    setRelativeFont(*m_table->verticalHeader(), 0.92);
    m_table->verticalHeader()->setSectionsClickable(false);
    m_table->verticalHeader()->setHighlightSections(false);
    m_table->verticalHeader()->setMinimumSectionSize(10);
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    connect(m_table, &CopyTable::resized, this, &ShopSection::fit, Qt::QueuedConnection);
}

void ShopSection::setOutcome(const OutcomePtr& outcome) {
    m_outcome = outcome;
    m_model->setOutcome(outcome);
    showRemarks();
    fit();
}

void ShopSection::setGreyed(bool grey, const QPalette& palette) {
    m_model->setGreyed(grey);
    m_title->setPalette(palette);
    m_remarks->setPalette(palette);
}

void ShopSection::showRemarks() {
    const QStringList sentences = m_outcome ? shop::remarks(m_outcome->shop) : QStringList();
    m_remarks->setText(sentences.join(QLatin1Char('\n')));
    m_remarksLine->setVisible(!sentences.isEmpty());
    m_icon->setPixmap(themeIcon(u"warning").pixmap(QSize(iconSize, iconSize), devicePixelRatioF()));
}

/// Columns are as wide as their numbers and share what is left; when they need more, a scroll bar
/// comes below.
void ShopSection::fit() {
    if (m_fitting || m_model->columnCount() == 0) {
        return;
    }
    m_fitting = true;
    QHeaderView* header = m_table->horizontalHeader();
    const int count = m_model->columnCount();
    m_table->resizeColumnsToContents();
    int left = m_table->viewport()->width() - header->length();
    const bool wide = left < 0;
    for (int column = 0; left > 0 && column < count; ++column) {
        const int share = left / (count - column);
        header->resizeSection(column, header->sectionSize(column) + share);
        left -= share;
    }
    m_table->setHorizontalScrollBarPolicy(wide ? Qt::ScrollBarAlwaysOn : Qt::ScrollBarAlwaysOff);
    const int bar = wide ? m_table->horizontalScrollBar()->sizeHint().height() : 0;
    m_table->setFixedHeight(header->sizeHint().height() + m_table->verticalHeader()->length()
                            + 2 * m_table->frameWidth() + bar);
    updateGeometry();
    m_fitting = false;
}

void ShopSection::retranslate() {
    m_title->setText(tr("Shop's numbers by stage"));
    m_table->setAccessibleName(tr("Shop's numbers by stage"));
    m_remarks->setAccessibleName(tr("What lies outside the usual"));
    m_table->retranslate();
    m_model->retranslate();
    showRemarks();
    fit();
}

} // namespace sparkout
