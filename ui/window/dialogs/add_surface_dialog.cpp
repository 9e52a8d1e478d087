// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dialogs/add_surface_dialog.h"

#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/setup/setup.h"
#include "core/study/new_project.h"
#include "core/study/operation.h"
#include "core/study/starting_project.h"
#include "ui/kit/dialog_parts.h"
#include "ui/kit/font_size.h"
#include "ui/kit/help_topic.h"
#include "ui/session/surface_edits.h"
#include "ui/text/designation_text.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"
#include "ui/window/dialogs/part_drawing.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <initializer_list>
#include <utility>
#include <variant>

namespace sparkout {

namespace {

enum class BeginWith { copy, traverse, plunge };

/// Place, length and diameter are those of the step; values for another place are removed.
void putOnStep(Project& project, const PartOutline::Step& step) {
    Part& part = *project.part;
    part.shaft.ground_from_mm = step.from_mm;
    part.length_mm = step.length_mm;
    if (part.surface == Surface::external) {
        part.diameter_mm = step.diameter_mm;
        part.target_diameter_mm.reset();
    }
    if (project.gauge->position_mm) {
        project.gauge->position_mm = step.length_mm / 2;
        project.gauge->compliance_mm_per_n.reset();
    }
}

} // namespace

AddSurfaceDialog::AddSurfaceDialog(const SetupState& state, const QString& name, IsFreeName isFree,
                                   std::optional<std::size_t> step, QWidget* parent)
    : QDialog(parent)
    , m_state(state)
    , m_outline(PartOutline::of(state))
    , m_isFree(std::move(isFree))
    , m_form(new QFormLayout)
    , m_drawing(new PartDrawing(this))
    , m_places(new QListWidget(this))
    , m_begin(new QComboBox(this))
    , m_name(new QLineEdit(name, this))
    , m_wheel(new QLabel(this))
    , m_along(new QWidget(this))
    , m_gaps(new QCheckBox(m_along))
    , m_deviations(new QCheckBox(m_along))
    , m_tolerances(new QCheckBox(m_along))
    , m_buttons(new AnswerButtons(tr("&Add"), tr("&Cancel"), this)) {
    setWindowTitle(tr("Add a surface"));
    setHelpTopic(*this, QStringLiteral("surfaces#add"));
    m_drawing->setAccessibleName(tr("The part with its surfaces"));
    m_drawing->setOutline(m_outline);
    m_drawing->setMinimumHeight(atFontSize(100));
    m_places->setObjectName(QStringLiteral("places"));
    m_places->setAccessibleName(tr("Place on the part"));
    m_begin->setObjectName(QStringLiteral("begin"));
    m_begin->setAccessibleName(tr("Begins with"));
    const QString present = printableText(SurfaceEdits::nameOf(state, state.present));
    m_begin->addItem(tr("the inputs of “%1”").arg(present), int(BeginWith::copy));
    m_begin->addItem(tr("a new traverse cycle"), int(BeginWith::traverse));
    m_begin->addItem(tr("a new plunge cycle"), int(BeginWith::plunge));
    const bool travels = state.inFront().project.operation->travels;
    m_begin->setCurrentIndex( // a drawing of its own, like a new project
        m_begin->findData(int(travels ? BeginWith::traverse : BeginWith::plunge)));
    m_name->setObjectName(QStringLiteral("surfaceName"));
    m_name->setAccessibleName(tr("Name"));
    fillPlaces();
    m_form->addRow(tr("Name"), m_name);
    m_form->addRow(tr("Begins with"), m_begin);
    askWhatComesAlong();
    m_form->addRow(tr("Place"), m_places);
    m_wheel->setObjectName(QStringLiteral("wheelFact"));
    m_wheel->setTextFormat(Qt::PlainText);
    m_wheel->setWordWrap(true);
    m_form->addRow(tr("Wheel"), m_wheel);
    QWidget* before = m_name; // from top to bottom, as one sees them
    for (QWidget* next :
         std::initializer_list<QWidget*>{m_begin, m_gaps, m_deviations, m_tolerances, m_places}) {
        setTabOrder(before, next);
        before = next;
    }
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_drawing, 1);
    layout->addLayout(m_form);
    layout->addWidget(m_buttons);
    connect(m_name, &QLineEdit::textChanged, this, &AddSurfaceDialog::follow);
    connect(m_begin, &QComboBox::currentIndexChanged, this, &AddSurfaceDialog::follow);
    connect(m_begin, &QComboBox::activated, this, [this] { m_isBeginChosen = true; });
    connect(m_places, &QListWidget::currentRowChanged, this, [this] {
        offerOperation();
        follow();
    });
    connect(m_tolerances, &QCheckBox::toggled, this, &AddSurfaceDialog::follow);
    connect(m_drawing, &PartDrawing::stepClicked, this, &AddSurfaceDialog::chooseStep);
    const auto wanted = step ? step : m_outline.firstFreeStep();
    wanted ? chooseStep(*wanted) : m_places->setCurrentRow(m_places->count() - 1);
    m_name->selectAll();
    m_name->setFocus();
    resize(atFontSize(460), atFontSize(420));
    follow();
}

/// Asks which parts of the copied surface's drawing to keep, if it has any.
void AddSurfaceDialog::askWhatComesAlong() {
    const Part& part = *m_state.inFront().project.part;
    const Tolerance& of = part.tolerance;
    const bool hasTolerances = of.radial_runout_um || of.total_runout_um || of.roundness_um
                               || of.cylindricity_um || of.roughness_ra_um;
    const QString size = fieldOf(part);
    m_gaps->setObjectName(QStringLiteral("copyGaps"));
    m_gaps->setText(tr("Keyway and other gaps"));
    m_gaps->setVisible(!part.gaps.empty());
    m_deviations->setObjectName(QStringLiteral("copyDeviations"));
    m_deviations->setText(size.isEmpty() ? tr("Deviations") : tr("Deviations (%1)").arg(size));
    m_deviations->setChecked(true);
    m_tolerances->setObjectName(QStringLiteral("copyTolerances"));
    m_tolerances->setText(tr("Tolerances of form and Ra"));
    m_tolerances->setChecked(true);
    m_tolerances->setVisible(hasTolerances);
    auto* boxes = new QVBoxLayout(m_along);
    boxes->setContentsMargins(0, 0, 0, 0);
    for (QCheckBox* box : {m_gaps, m_deviations, m_tolerances}) {
        boxes->addWidget(box);
    }
    m_form->addRow(tr("From its drawing"), m_along);
}

void AddSurfaceDialog::onlyDuplicate() {
    setWindowTitle(tr("Duplicate the surface"));
    m_buttons->acceptButton()->setText(tr("&Duplicate"));
    m_begin->setCurrentIndex(m_begin->findData(int(BeginWith::copy)));
    m_places->setCurrentRow(m_places->count() - 1); // at the current place
    m_drawing->hide();
    m_form->setRowVisible(m_begin, false);
    m_form->setRowVisible(m_places, false);
    m_form->setRowVisible(m_wheel, false);
    adjustSize();
}

bool AddSurfaceDialog::hasAnythingToAsk() const {
    return !m_gaps->isHidden() || !m_tolerances->isHidden();
}

void AddSurfaceDialog::fillPlaces() {
    for (std::size_t i = 0; m_outline.hasSteps && i < m_outline.steps.size(); ++i) {
        const PartOutline::Step& step = m_outline.steps[i];
        const QString text = tr("Step %1: ⌀%2 × %3 mm, from %4 mm")
                                 .arg(i + 1)
                                 .arg(printedNumber(step.diameter_mm),
                                      printedNumber(step.length_mm), printedNumber(step.from_mm));
        m_places->addItem(m_outline.isFree(i) ? tr("%1 (free)").arg(text) : text);
    }
    m_places->addItem(
        tr("Where “%1” is").arg(printableText(SurfaceEdits::nameOf(m_state, m_state.present))));
}

std::optional<std::size_t> AddSurfaceDialog::step() const {
    const int row = m_places->currentRow();
    const bool isStep = row >= 0 && row < m_places->count() - 1;
    return isStep ? std::optional(static_cast<std::size_t>(row)) : std::nullopt;
}

void AddSurfaceDialog::chooseStep(std::size_t step) {
    if (m_outline.hasSteps && step < m_outline.steps.size()) {
        m_places->setCurrentRow(static_cast<int>(step));
    }
}

/// Proposes plunge for a step that the wheel covers and traverse for a longer one, unless the user
/// has chosen.
void AddSurfaceDialog::offerOperation() {
    if (const auto at = step(); at && !m_isBeginChosen && !isCopy()) {
        const bool isCovered =
            m_outline.steps[*at].length_mm <= m_state.inFront().project.wheel->width_mm;
        const auto begin = isCovered ? BeginWith::plunge : BeginWith::traverse;
        m_begin->setCurrentIndex(m_begin->findData(int(begin)));
    }
}

void AddSurfaceDialog::follow() {
    m_along->setEnabled(isCopy());
    m_drawing->setChosenStep(step());
    m_wheel->setText(wheelText());
    const bool isFree = m_isFree(m_name->text());
    m_buttons->acceptButton()->setEnabled(isFree);
    m_name->setToolTip(isFree ? QString() : tr("Each surface needs its own name."));
}

/// The part's wheel and, if the required Ra is known, which one would suit it better.
QString AddSurfaceDialog::wheelText() const {
    const Wheel& wheel = *m_state.inFront().project.wheel;
    QString text = tr("%1, %2 mm wide; it stays the wheel of all surfaces.")
                       .arg(printableText(QString::fromStdString(wheel.marking)),
                            printedNumber(wheel.width_mm));
    if (openInputs().empty()) {
        for (const Issue& advice : wheelAdvice(project())) {
            text += u' ' + tr("But %1.").arg(issueText(advice));
        }
    }
    return text;
}

bool AddSurfaceDialog::isCopy() const {
    return static_cast<BeginWith>(m_begin->currentData().toInt()) == BeginWith::copy;
}

QString AddSurfaceDialog::name() const {
    return m_name->text().simplified();
}

std::vector<std::string> AddSurfaceDialog::openInputs() const {
    std::vector<std::string> open;
    if (isCopy()) {
        open = m_state.inFront().open;
        for (const char* path : {"/part/upper_deviation_um", "/part/lower_deviation_um"}) {
            if (!m_deviations->isChecked() && std::ranges::find(open, path) == open.end()) {
                open.emplace_back(path);
            }
        }
        return open;
    }
    const bool isShaft = m_state.inFront().project.part->surface == Surface::external;
    for (const std::string& path : drawingInputs()) {
        const bool isOfStep = path == "/part/length_mm" || (isShaft && path == "/part/diameter_mm");
        if (!(step() && isOfStep)) {
            open.push_back(path);
        }
    }
    return open;
}

/// A copy of a surface that is yet to be drawn has no cycle of its own yet.
bool AddSurfaceDialog::startsWhenDrawn() const {
    const SurfaceState& present = m_state.inFront();
    return !isCopy() || (!present.open.empty() && present.startsWhenDrawn);
}

Project AddSurfaceDialog::project() const {
    const Project& present = m_state.inFront().project;
    Project made = present;
    const auto begin = static_cast<BeginWith>(m_begin->currentData().toInt());
    if (begin != BeginWith::copy) {
        made =
            undrawnProject(begin == BeginWith::traverse ? Operation::traverse : Operation::plunge);
        if (std::holds_alternative<std::monostate>(present.machine->compliance_mm_per_n)) {
            made = withGivenCompliance(std::move(made), false);
        }
        copyShared(present, made);
        made.part->surface = present.part->surface;
        made.part->shaft.ground_from_mm = present.part->shaft.ground_from_mm;
    } else {
        if (!m_gaps->isChecked()) {
            made.part->gaps.clear();
        }
        if (!m_tolerances->isChecked()) {
            made.part->tolerance = {};
        }
        if (!m_deviations->isChecked()) {
            made = withoutDeviations(std::move(made));
        }
    }
    if (const auto at = step()) {
        putOnStep(made, m_outline.steps[*at]);
    }
    return made;
}

} // namespace sparkout
