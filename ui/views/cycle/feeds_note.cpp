// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/cycle/feeds_note.h"

#include "core/simulation/progress.h"
#include "ui/text/names.h"
#include "ui/views/cycle/feeds_chart.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace sparkout {

namespace {
constexpr Zone zones[] = {Zone::rz1, Zone::nz, Zone::rz2};
constexpr Step allSteps[] = {Step::e1, Step::e2, Step::e3, Step::e4, Step::e5};
constexpr int noteWidth = 460;
} // namespace

FeedsNote::FeedsNote(QWidget* parent)
    : QDialog(parent)
    , m_steps(new QWidget(this))
    , m_text(new QLabel(this))
    , m_close(new QPushButton(this)) {
    auto* layout = new QVBoxLayout(this);
    auto* grid = new QGridLayout(m_steps);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(2);
    for (int row = 0; row <= int(std::size(allSteps)); ++row) {
        for (int column = 0; column <= int(std::size(zones)); ++column) {
            auto* label = new QLabel(m_steps);
            label->setTextFormat(Qt::PlainText);
            label->setMargin(3);
            label->setAutoFillBackground(true);
            grid->addWidget(label, row, column);
        }
    }
    grid->setColumnStretch(int(std::size(zones)) + 1, 1);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setWordWrap(true);
    m_text->setMinimumWidth(noteWidth);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    connect(m_close, &QPushButton::clicked, this, &QDialog::close);
    layout->addWidget(m_steps);
    layout->addWidget(m_text);
    layout->addWidget(m_close, 0, Qt::AlignRight);
    layout->setSizeConstraint(QLayout::SetFixedSize);
    retranslate();
}

void FeedsNote::setOperation(Operation operation, ReversalInfeed infeed) {
    m_operation = operation;
    m_infeed = infeed;
    retranslate();
}

bool FeedsNote::isGround(Zone zone, Step step) const {
    switch (strokeStep(zone, step)) {
    case StrokeStep::plungeIn: return m_infeed != ReversalInfeed::exit;
    case StrokeStep::exitPlungeIn: return m_infeed != ReversalInfeed::entry;
    case StrokeStep::none: return false;
    default: return true;
    }
}

QLabel* FeedsNote::cell(int row, int column) {
    auto* grid = static_cast<QGridLayout*>(m_steps->layout());
    return static_cast<QLabel*>(grid->itemAtPosition(row, column)->widget());
}

void FeedsNote::paintSteps() {
    for (int row = 0; row < int(std::size(allSteps)); ++row) {
        for (int column = 0; column < int(std::size(zones)); ++column) {
            QLabel* label = cell(row + 1, column + 1);
            QPalette colours;
            colours.setColor(QPalette::Window,
                             isGround(zones[column], allSteps[row])
                                 ? FeedsChart::stepColour(zones[column], allSteps[row], palette())
                                 : QColor(Qt::transparent));
            label->setPalette(colours);
        }
    }
}

void FeedsNote::retranslate() {
    const bool strokes = m_operation->travels;
    setWindowTitle(tr("How to read the feeds"));
    m_steps->setVisible(strokes);
    m_steps->setAccessibleName(tr("Steps of a double stroke in each zone"));
    m_text->setAccessibleName(tr("Explanation"));
    for (int column = 0; column < int(std::size(zones)); ++column) {
        cell(0, column + 1)->setText(Names::zoneFull(zones[column]));
        for (int row = 0; row < int(std::size(allSteps)); ++row) {
            cell(row + 1, column + 1)
                ->setText(isGround(zones[column], allSteps[row])
                              ? Names::stepMeaning(zones[column], allSteps[row])
                              : QStringLiteral("—"));
            cell(row + 1, 0)->setText(Names::step(allSteps[row]));
        }
    }
    QStringList text;
    if (strokes) {
        text << tr("E1…E5 number the steps in which a zone is ground during one double stroke, so "
                   "the same number is another step in another zone. They are shown when a few "
                   "double strokes are shown.");
        if (m_infeed != ReversalInfeed::entry) {
            text << tr("With infeed at the exit, RZ2 is ground in E4 between its E1 and E2.");
        }
        text << tr("A zone is shown as ground during the whole stroke, as in the model: the "
                   "position of the wheel within a stroke is not resolved.")
             << tr("Over the whole cycle a point is a double stroke: feeds are summed over its "
                   "passes, the force is that of its hardest pass. Zoomed in, a point is one pass, "
                   "and within one double stroke it is one radius under the wheel.");
    } else {
        text << tr("All sections are fed alike; they differ by their compliance.")
             << tr("A point is one revolution, in long cycles several of them; zoomed in, it is "
                   "one radius under the wheel.");
    }
    text
        << tr("The spread reaches from the minimum to the maximum value over the radii of a "
              "cross-section, the line is their mean.")
        << tr("The thick vertical line marks the moment of the cycle; the bar below the views or a "
              "click in a plot moves it. Without the line, the plots show the end of the cycle.");
    m_text->setText(text.join(QStringLiteral("\n\n")));
    m_close->setText(tr("C&lose"));
    paintSteps();
}

void FeedsNote::changeEvent(QEvent* event) {
    QDialog::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    } else if (event->type() == QEvent::PaletteChange) {
        paintSteps();
    }
}

} // namespace sparkout
