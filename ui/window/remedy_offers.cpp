// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/remedy_offers.h"

#include "core/project/member.h"
#include "ui/session/document.h"
#include "ui/views/requirements/verdict_sections.h"

#include <utility>

namespace sparkout {

namespace {

/// Named after the changed input, like an edit of it.
EditText editText(const Project& project, const RemedySetting& setting) {
    if (setting.isWholeCycle()) {
        return {"Edit", QT_TRANSLATE_NOOP("Edit", "Starting cycle")};
    }
    if (setting.addsStage()) {
        return {"Edit", QT_TRANSLATE_NOOP("Edit", "Add a stage")};
    }
    return {"Input", findMember(project, setting.path(project)).field->label};
}

} // namespace

RemedyOffers::RemedyOffers(Document& document, RemedySection& section,
                           std::function<void(const std::string& path)> reveal, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_section(section)
    , m_reveal(std::move(reveal))
    , m_finder(new RemedyFinder(this)) {
    connect(&m_document, &Document::changed, this, [this] {
        m_finder->drop();
        m_section.setStale();
    });
    connect(&m_document, &Document::projectReplaced, this, [this] { m_section.clear(); });
    connect(m_finder, &RemedyFinder::found, this,
            [this](const OutcomePtr& outcome, const RemedyResultPtr& result) {
                m_section.setRemedies(outcome, result, m_finder->running());
            });
    connect(&m_section, &RemedySection::wanted, this, &RemedyOffers::take);
    connect(&m_section, &RemedySection::endWanted, m_finder, &RemedyFinder::end);
}

void RemedyOffers::setOutcome(const OutcomePtr& outcome) {
    if (m_isOffered && outcome->ran()) { // a fit cycle may fail for other stocks or the batch
        m_finder->request(outcome);
    } else {
        m_finder->drop();
        m_section.clear();
    }
}

void RemedyOffers::offer(bool offered) {
    m_isOffered = offered;
    if (!offered) {
        m_finder->drop();
        m_section.clear();
    }
}

void RemedyOffers::take(const Remedy& remedy) {
    const Project& project = m_document.project();
    const EditText text = editText(project, remedy.setting);
    m_document.endMerge();
    m_document.edit(remedy.applied(project), text);
    m_reveal(remedy.setting.path(m_document.project()));
}

} // namespace sparkout
