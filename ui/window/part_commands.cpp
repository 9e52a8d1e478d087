// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/part_commands.h"

#include "core/setup/setup.h"
#include "core/setup/wheel_wear.h"
#include "core/units.h"
#include "ui/form/struct_form.h"
#include "ui/kit/dialog_parts.h"
#include "ui/kit/font_size.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/name_dialog.h"
#include "ui/session/part_runs.h"
#include "ui/text/texts.h"
#include "ui/window/dialogs/add_surface_dialog.h"
#include "ui/window/dialogs/dressing_dialog.h"
#include "ui/window/dialogs/part_drawing.h"

#include <QCoreApplication>
#include <QDialog>
#include <QGroupBox>
#include <QLabel>
#include <QScrollArea>
#include <QStyle>
#include <QTimer>
#include <QVBoxLayout>

#include <utility>

namespace sparkout {

namespace {

/// The standard times of the set-up and how the wheel wears from surface to surface, with what
/// they come to.
class TimesDialog : public QDialog {
    Q_DECLARE_TR_FUNCTIONS(sparkout::TimesDialog)

public:
    /// `cycles_min` is the time of all cycles together; empty: not all of them end at size.
    TimesDialog(const SetupTimes& times, const WheelWear& wear, std::size_t surfaces,
                std::optional<double> cycles_min, QWidget* parent = nullptr);

    [[nodiscard]] const SetupTimes& times() const { return m_times; }
    [[nodiscard]] const WheelWear& wear() const { return m_wear; }

private:
    void follow();

    SetupTimes m_times;
    WheelWear m_wear;
    std::size_t m_surfaces;
    std::optional<double> m_cycles_min;
    QLabel* m_result;
    QPushButton* m_apply = nullptr;
};

TimesDialog::TimesDialog(const SetupTimes& times, const WheelWear& wear, std::size_t surfaces,
                         std::optional<double> cycles_min, QWidget* parent)
    : QDialog(parent)
    , m_times(times)
    , m_wear(wear)
    , m_surfaces(surfaces)
    , m_cycles_min(cycles_min)
    , m_result(new QLabel(this)) {
    setWindowTitle(tr("Standard times and wheel wear"));
    setHelpTopic(*this, QStringLiteral("surfaces#times"));
    m_result->setObjectName(QStringLiteral("pieceTime"));
    m_result->setTextFormat(Qt::RichText);
    m_result->setWordWrap(true);
    auto* page = new QWidget(this);
    auto* column = new QVBoxLayout(page);
    const auto addBox = [&]<class T>(T& value) {
        auto* box = new QGroupBox(structText(tableOf<T>().name), page);
        auto* form = StructForm::over(value, box);
        (new QVBoxLayout(box))->addWidget(form);
        column->addWidget(box);
        connect(form, &StructForm::edited, this, &TimesDialog::follow);
    };
    addBox(m_times);
    addBox(m_wear);
    auto* area = new QScrollArea(this);
    area->setWidget(page);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus);
    auto* buttons = new AnswerButtons(tr("&Apply"), tr("&Cancel"), this);
    m_apply = buttons->acceptButton();
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(area, 1);
    layout->addWidget(m_result);
    layout->addWidget(buttons);
    area->setMinimumWidth(page->minimumSizeHint().width()
                          + style()->pixelMetric(QStyle::PM_ScrollBarExtent));
    resize(atFontSize(520), atFontSize(600));
    follow();
}

void TimesDialog::follow() {
    m_result->setText(withIndices(pieceTimeText(m_times, m_surfaces, m_cycles_min))
                          .replace(u'\n', QStringLiteral("<br>")));
    m_apply->setEnabled(StructForm::refusals(*this).empty());
}

} // namespace

PartCommands::PartCommands(Document& document, const PartRuns& runs, std::function<bool()> mayLeave,
                           QWidget* window)
    : QObject(window)
    , m_document(document)
    , m_runs(runs)
    , m_edits(document)
    , m_mayLeave(std::move(mayLeave))
    , m_window(window) {}

void PartCommands::show(std::size_t surface) {
    if (surface == m_document.surface()) {
        return;
    }
    if (m_mayLeave() && surface < m_document.surfaceCount()) {
        m_document.showSurface(surface);
    } else {
        emit stayed();
    }
}

void PartCommands::showNext(int by) {
    if (m_edits.canMove(by)) {
        show(static_cast<std::size_t>(static_cast<std::ptrdiff_t>(m_document.surface()) + by));
    }
}

void PartCommands::add(std::optional<std::size_t> step) {
    addAsked(step, false);
}

void PartCommands::duplicate() {
    addAsked({}, true);
}

/// A duplicate that leaves nothing behind needs no question.
void PartCommands::addAsked(std::optional<std::size_t> step, bool isDuplicate) {
    if (!m_edits.canAdd() || !m_mayLeave()) {
        return;
    }
    const auto isFree = [this](const QString& name) {
        return m_edits.isFreeName(name, m_document.surfaceCount());
    };
    AddSurfaceDialog dialog(m_document.state(), m_edits.freeName(), isFree, step, m_window);
    if (isDuplicate) {
        dialog.onlyDuplicate();
    }
    const bool isAsked = !isDuplicate || dialog.hasAnythingToAsk();
    if (!isAsked || dialog.exec() == QDialog::Accepted) {
        const std::vector<std::string> open = dialog.openInputs();
        m_edits.add(dialog.project(), dialog.name(), open, dialog.startsWhenDrawn(), isDuplicate);
        if (!open.empty()) {
            emit begun(open.front());
        }
    }
}

void PartCommands::rename() {
    const std::size_t surface = m_document.surface();
    NameDialog dialog(
        tr("Rename the surface"), tr("&Rename"), SurfaceEdits::nameOf(m_document.state(), surface),
        [this, surface](const QString& name) -> NameDialog::Answer {
            const bool isFree = m_edits.isFreeName(name, surface);
            return {isFree ? QString() : tr("Each surface needs its own name."), isFree};
        },
        m_window);
    setHelpTopic(dialog, QStringLiteral("surfaces"));
    if (dialog.exec() == QDialog::Accepted) {
        m_edits.rename(surface, dialog.name());
    }
}

void PartCommands::move(int by) {
    m_edits.move(by);
}

void PartCommands::remove() {
    if (m_mayLeave()) {
        m_edits.remove();
    }
}

void PartCommands::editTimes() {
    std::optional<double> cycles_min = 0;
    for (const SurfaceStatus& status : m_runs.statuses()) {
        cycles_min = cycles_min && status.isCompleted()
                         ? std::optional(*cycles_min + status.time_s / units::secondsPerMinute)
                         : std::nullopt;
    }
    const SetupState& state = m_document.state();
    TimesDialog dialog(state.times, state.wear, state.surfaces.size(), cycles_min, m_window);
    if (dialog.exec() == QDialog::Accepted) {
        m_edits.setTimes(dialog.times(), dialog.wear());
    }
}

void PartCommands::showDressing() {
    bool again = m_mayLeave();
    while (again) {
        DressingDialog dialog(m_document.state().setup(), m_window);
        QTimer::singleShot(0, &dialog, &DressingDialog::find); // when it is visible
        dialog.exec();
        again = dialog.wantsWear();
        if (again) {
            editTimes();
        }
    }
}

} // namespace sparkout
