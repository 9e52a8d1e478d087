// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/row_helper.h"

#include "core/project/conditions.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/study/batch_edits.h"
#include "core/study/measured_form.h"
#include "core/study/search_edits.h"
#include "ui/inputs/form_metrics.h"
#include "ui/kit/font_size.h"
#include "ui/session/document.h"
#include "ui/text/designation_text.h"
#include "ui/text/number_text.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

QLabel* noteLabel(QWidget* parent, const char* name) {
    auto* label = new QLabel(parent);
    label->setObjectName(QString::fromLatin1(name));
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setWordWrap(true);
    setRelativeFont(*label, noteType);
    return label;
}

/// A labelled text field, aligned with the rows of numbers, and a note below it.
void layOutTyped(RowHelper& helper, QLabel& label, QLineEdit& line, QLabel& note) {
    helper.setFocusProxy(&line);
    setTextWidth(line, metrics::field);
    line.setMaxLength(40);
    label.setTextFormat(Qt::PlainText);
    label.setWordWrap(true);
    label.setBuddy(&line);
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::gap);
    row->addWidget(&label, 1);
    row->addWidget(&line);
    auto* noUnit = new QWidget(&helper); // aligned with the units of the other rows
    setTextWidth(*noUnit, unitColumn);
    row->addWidget(noUnit);
    auto* layout = new QVBoxLayout(&helper);
    layout->setContentsMargins(0, metrics::row, 0, metrics::row);
    layout->setSpacing(metrics::row);
    layout->addLayout(row);
    layout->addWidget(&note);
}

void sayWhatIsDone(QPushButton& button, const QString& text, const QString& tip) {
    button.setText(text);
    button.setToolTip(tip);
    button.setAccessibleName(text);
    button.setAccessibleDescription(tip);
}

const Offer usualBatch{
    "noBatch",
    "addBatch",
    [](const Project& project) { return project.batch.has_value(); },
    withUsualBatch,
    {"Edit", QT_TRANSLATE_NOOP("Edit", "Add a batch")},
    QT_TRANSLATE_NOOP("sparkout::OfferHelper", "Purpose of a batch"),
    QT_TRANSLATE_NOOP("sparkout::OfferHelper",
                      "A batch shows which share of many parts meets the drawing when stock, "
                      "runout, dullness and other factors scatter. The view Batch runs it."),
    QT_TRANSLATE_NOOP("sparkout::OfferHelper", "Add a typical batch"),
    QT_TRANSLATE_NOOP(
        "sparkout::OfferHelper",
        "50 parts whose stock, runout and dullness scatter about the current inputs")};

const Offer searchOffer{
    "noSearch",
    "addSearch",
    [](const Project& project) { return project.optimisation.has_value(); },
    usualSearch,
    {"Edit", QT_TRANSLATE_NOOP("Edit", "Add a search")},
    QT_TRANSLATE_NOOP("sparkout::OfferHelper", "Purpose of a search"),
    QT_TRANSLATE_NOOP("sparkout::OfferHelper",
                      "A search finds the quickest cycle that meets every requirement, among all "
                      "feeds and stocks listed here. The view Optimise runs it."),
    QT_TRANSLATE_NOOP("sparkout::OfferHelper", "Add a typical search"),
    QT_TRANSLATE_NOOP(
        "sparkout::OfferHelper",
        "Levels of each feed about the current cycle in steps of the machine, stocks, spark-out, "
        "and the usual minimum overlap and steps of a stage where none are given; the answer is "
        "fit for the batch, or without one for every stock")};

std::optional<double> estimatedMass_kg(const Project& project) {
    return conditions::external(project, &*project.part) ? steelMass_kg(project.part->shaft)
                                                         : std::nullopt;
}

const Offer estimatedMass{
    "massNote",
    "takeMass",
    [](const Project& project) { return project.card->mass_kg || !estimatedMass_kg(project); },
    [](Project project) {
        project.card->mass_kg = estimatedMass_kg(project);
        return project;
    },
    {"Edit", QT_TRANSLATE_NOOP("Edit", "Mass from the steps of the shaft")},
    QT_TRANSLATE_NOOP("sparkout::OfferHelper", "The mass by the steps of the shaft"),
    QT_TRANSLATE_NOOP(
        "sparkout::OfferHelper",
        "By the steps of the shaft, as solid steel of 7850 kg/m³: about %1 kg. An estimate."),
    QT_TRANSLATE_NOOP("sparkout::OfferHelper", "Apply the estimate"),
    QT_TRANSLATE_NOOP(
        "sparkout::OfferHelper",
        "Without chamfers, keyways and bores; the mass in the drawing takes precedence"),
    [](const Project& project) { return printedNumber(estimatedMass_kg(project).value_or(0)); }};

/// "1.7, 3.71, 2.68 µm", or a remark that it was not measured.
QString measuredText(const std::optional<std::vector<double>>& values_um) {
    QStringList texts;
    for (const double value_um : values_um.value_or(std::vector<double>())) {
        texts << printedNumber(value_um);
    }
    return texts.isEmpty() ? QStringLiteral("–") : texts.join(QStringLiteral("; "));
}

const Offer formOfMachine{
    "measuredFormNote",
    "takeMeasuredForm",
    [](const Project& project) { return project.machine->form || !measuredForm(project); },
    withMeasuredForm,
    {"Edit", QT_TRANSLATE_NOOP("Edit", "Machine's form from the measured parts")},
    QT_TRANSLATE_NOOP("sparkout::OfferHelper", "The machine's form by the measured parts"),
    QT_TRANSLATE_NOOP("sparkout::OfferHelper",
                      "Measured by zone or section, mean in µm: roundness and radial runout %1. "
                      "The number of lobes was not measured."),
    QT_TRANSLATE_NOOP("sparkout::OfferHelper", "Apply it as the machine's form"),
    QT_TRANSLATE_NOOP("sparkout::OfferHelper",
                      "In a cycle with spark-out, the form left by the process itself is small in "
                      "comparison; the number of lobes must be entered"),
    [](const Project& project) {
        const MachineForm form = measuredForm(project).value_or(MachineForm());
        return QStringLiteral("%1 / %2").arg(measuredText(form.roundness_um),
                                             measuredText(form.runout_um));
    }};

} // namespace

RowHelper* makeRowHelper(const std::string& path, Document& document, QWidget* parent) {
    if (path == "/wheel/marking") {
        return new MarkingHelper(document, parent);
    }
    if (path == "/batch") {
        return new OfferHelper(usualBatch, document, parent);
    }
    if (path == "/optimisation") {
        return new OfferHelper(searchOffer, document, parent);
    }
    if (path == "/machine/geometric_runout_um") {
        return new OfferHelper(formOfMachine, document, parent);
    }
    if (path == "/card/mass_kg") {
        return new OfferHelper(estimatedMass, document, parent);
    }
    if (path == "/part/gaps") {
        return new KeywayHelper(document, parent);
    }
    return path == "/part/diameter_mm" ? new SizeHelper(document, parent) : nullptr;
}

MarkingHelper::MarkingHelper(Document& document, QWidget* parent)
    : RowHelper(parent)
    , m_document(document)
    , m_meaning(noteLabel(this, "markingMeaning"))
    , m_fill(new QPushButton(this)) {
    m_fill->setObjectName(QStringLiteral("fillFromMarking"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, metrics::row, 0, metrics::gap);
    layout->setSpacing(metrics::row);
    layout->addWidget(m_meaning);
    layout->addWidget(m_fill);
    connect(m_fill, &QPushButton::clicked, this, &MarkingHelper::fill);
    connect(&document, &Document::changed, this, &MarkingHelper::showMarking);
    retranslate();
}

void MarkingHelper::showMarking() {
    const Project& project = m_document.project();
    const auto marking = readWheelMarking(project.wheel->marking);
    QString text;
    QString changes;
    if (marking) {
        text = markingExplained(*marking) + u'.';
        changes = markingChanges(*marking, *project.wheel);
        if (!changes.isEmpty()) {
            text += u'\n' + tr("To fill in: %1.").arg(changes);
        }
        if (marking->speed_m_s && *marking->speed_m_s < project.machine->wheel_speed_m_s) {
            text += u'\n' + tr("The machine's wheel speed is above what the marking allows.");
        }
    } else if (!project.wheel->marking.empty()) {
        text = tr("This is not a marking. Write it like 500×50×203 25А F60 L 6 V 35 to fill in the "
                  "wheel's values.");
    }
    m_meaning->setText(text);
    m_meaning->setVisible(!text.isEmpty());
    m_fill->setEnabled(!changes.isEmpty());
    m_fill->setVisible(marking.has_value());
}

void MarkingHelper::fill() {
    Project project = m_document.project();
    if (const auto marking = readWheelMarking(project.wheel->marking)) {
        applyMarking(*marking, *project.wheel);
        m_document.endMerge();
        m_document.edit(std::move(project),
                        {"Edit", QT_TRANSLATE_NOOP("Edit", "Wheel from its marking")});
    }
}

void MarkingHelper::retranslate() {
    m_meaning->setAccessibleName(tr("Meaning of the marking"));
    sayWhatIsDone(*m_fill, tr("Fill in from the marking"),
                  tr("Sets grain, grain share and sizes as far as the marking states them"));
    showMarking();
}

OfferHelper::OfferHelper(const Offer& offer, Document& document, QWidget* parent)
    : RowHelper(parent)
    , m_offer(offer)
    , m_document(document)
    , m_note(noteLabel(this, offer.noteName))
    , m_add(new QPushButton(this)) {
    m_add->setObjectName(QLatin1String(offer.buttonName));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, metrics::row, 0, metrics::gap);
    layout->setSpacing(metrics::gap);
    layout->addWidget(m_note);
    layout->addWidget(m_add, 0, Qt::AlignLeft);
    connect(m_add, &QPushButton::clicked, this, [this] {
        m_document.endMerge();
        m_document.edit(m_offer.give(m_document.project()), m_offer.edit);
    });
    connect(&document, &Document::changed, this, &OfferHelper::showOffer);
    retranslate();
}

void OfferHelper::showOffer() {
    const Project& project = m_document.project();
    setVisible(!m_offer.isGiven(project));
    m_note->setText(m_offer.value ? tr(m_offer.note).arg(m_offer.value(project))
                                  : tr(m_offer.note));
}

void OfferHelper::retranslate() {
    m_note->setAccessibleName(tr(m_offer.purpose));
    showOffer();
    sayWhatIsDone(*m_add, tr(m_offer.button), tr(m_offer.tip));
}

SizeHelper::SizeHelper(Document& document, QWidget* parent)
    : RowHelper(parent)
    , m_document(document)
    , m_label(new QLabel(this))
    , m_size(new QLineEdit(this))
    , m_meaning(noteLabel(this, "sizeMeaning")) {
    m_size->setObjectName(QStringLiteral("sizeField"));
    layOutTyped(*this, *m_label, *m_size, *m_meaning);
    connect(m_size, &QLineEdit::textChanged, this, &SizeHelper::showTyped);
    connect(m_size, &QLineEdit::editingFinished, this, &SizeHelper::fill);
    connect(&document, &Document::projectReplaced, this, [this] { m_size->clear(); });
    connect(&document, &Document::changed, this, &SizeHelper::showPart);
    retranslate();
}

/// Keeps text being typed, and a refused text as long as it is refused; otherwise shows the part's
/// field.
void SizeHelper::showPart() {
    const auto typed = toFill();
    const bool unfinished = m_size->isModified() && !m_size->text().trimmed().isEmpty() && typed
                            && (m_size->hasFocus() || !typed->size);
    if (!unfinished) {
        m_size->setText(fieldOf(*m_document.project().part));
    }
    showTyped();
}

/// The typed size, unless the part already has it.
std::optional<TypedSize> SizeHelper::toFill() const {
    const Part& part = *m_document.project().part;
    const TypedSize typed = readSize(m_size->text(), part);
    const bool same = typed.size && typed.size->nominal_mm == part.diameter_mm
                      && typed.deviations.upper_um == part.upper_deviation_um
                      && typed.deviations.lower_um == part.lower_deviation_um;
    return same ? std::nullopt : std::optional(typed);
}

void SizeHelper::showTyped() {
    const auto typed = toFill();
    m_meaning->setText(typed ? typed->text : QString());
    m_meaning->setVisible(!m_meaning->text().isEmpty());
}

bool SizeHelper::take(const QString& text) {
    if (!readSize(text, *m_document.project().part).size) {
        return false;
    }
    m_size->setText(text);
    fill();
    return true;
}

void SizeHelper::fill() {
    const auto typed = toFill();
    if (!typed || !typed->size) {
        showPart();
        return;
    }
    Project project = m_document.project();
    project.part->diameter_mm = typed->size->nominal_mm;
    project.part->upper_deviation_um = typed->deviations.upper_um;
    project.part->lower_deviation_um = typed->deviations.lower_um;
    m_size->setModified(false);
    m_document.endMerge();
    m_document.edit(std::move(project),
                    {"Edit", QT_TRANSLATE_NOOP("Edit", "Limits from the tolerance class")});
}

void SizeHelper::retranslate() {
    m_label->setText(tr("Tolerance class"));
    m_size->setPlaceholderText(tr("e.g. %1").arg(
        m_document.project().part->surface == Surface::internal ? QStringLiteral("30H7")
                                                                : QStringLiteral("30h6")));
    m_size->setAccessibleName(tr("Size with its tolerance class"));
    m_size->setToolTip(tr("ISO 286: 30h6 fills diameter and limits; h6 keeps the diameter"));
    m_meaning->setAccessibleName(tr("Meaning of the tolerance class"));
    showPart();
}

KeywayHelper::KeywayHelper(Document& document, QWidget* parent)
    : RowHelper(parent)
    , m_document(document)
    , m_label(new QLabel(this))
    , m_keyway(new QLineEdit(this))
    , m_meaning(noteLabel(this, "keywayMeaning")) {
    m_keyway->setObjectName(QStringLiteral("keywayField"));
    layOutTyped(*this, *m_label, *m_keyway, *m_meaning);
    connect(m_keyway, &QLineEdit::textChanged, this, &KeywayHelper::showTyped);
    connect(m_keyway, &QLineEdit::editingFinished, this, &KeywayHelper::fill);
    connect(&document, &Document::projectReplaced, this, [this] { m_keyway->clear(); });
    connect(&document, &Document::changed, this, &KeywayHelper::showTyped);
    retranslate();
}

KeywayHelper::Typed KeywayHelper::typed() const {
    const Part& part = *m_document.project().part;
    const QString text = m_keyway->text().trimmed();
    if (text.isEmpty()) {
        return {};
    }
    const auto keyway = parseKeyway(text.toStdString());
    if (!keyway) {
        return {{},
                tr("This is not a keyway with width and length; write it like 12P9 × 45, or with "
                   "the angle of its first edge like 12P9 × 45, 90°.")};
    }
    if (m_document.isOpen("/part/diameter_mm")) {
        return {{}, tr("The diameter is needed first.")};
    }
    const auto angle_deg = keywayAngle(keyway->width_mm, part.diameter_mm);
    if (!angle_deg) {
        return {{},
                tr("A keyway of %1 mm is not narrower than the diameter of %2 mm.")
                    .arg(printedNumber(keyway->width_mm), printedNumber(part.diameter_mm))};
    }
    constexpr double perDegree = 100; // two decimals, finer than any radius
    const SurfaceGap gap{keyway->at_deg.value_or(0),
                         std::round(*angle_deg * perDegree) / perDegree};
    QString words = tr("%1 mm on ∅%2 mm: a gap of %3°, from %4° on.")
                        .arg(printedNumber(keyway->width_mm), printedNumber(part.diameter_mm),
                             printedNumber(gap.width_deg), printedNumber(gap.from_deg));
    if (keyway->length_mm && *keyway->length_mm < part.length_mm) {
        words +=
            u' '
            + tr("It is %1 mm long; in the model it extends over the whole ground length of %2 mm.")
                  .arg(printedNumber(*keyway->length_mm), printedNumber(part.length_mm));
    }
    return {gap, words};
}

void KeywayHelper::showTyped() {
    m_meaning->setText(typed().text);
    m_meaning->setVisible(!m_meaning->text().isEmpty());
}

void KeywayHelper::fill() {
    const std::optional<SurfaceGap> gap = typed().gap;
    if (!gap || !m_keyway->isModified()) {
        return;
    }
    m_keyway->setModified(false);
    Project project = m_document.project();
    std::vector<SurfaceGap>& gaps = project.part->gaps;
    const auto same = std::ranges::find_if(gaps, [&gap](const SurfaceGap& each) {
        return each.from_deg <= gap->from_deg && gap->from_deg <= each.from_deg + each.width_deg;
    });
    same == gaps.end() ? gaps.push_back(*gap) : static_cast<void>(*same = *gap);
    m_document.endMerge();
    m_document.edit(std::move(project), {"Edit", QT_TRANSLATE_NOOP("Edit", "Gap from a keyway")});
}

void KeywayHelper::retranslate() {
    m_label->setText(tr("Keyway, width × length"));
    m_keyway->setPlaceholderText(QStringLiteral("12P9 × 45")); // “e.g.” has no room beside it
    m_keyway->setAccessibleName(m_label->text());
    m_keyway->setToolTip(tr("12P9 × 45 makes a gap of the surface; 12P9 × 45, 90° also sets the "
                            "angle of its first edge"));
    m_meaning->setAccessibleName(tr("Keyway in the model"));
    showTyped();
}

} // namespace sparkout
