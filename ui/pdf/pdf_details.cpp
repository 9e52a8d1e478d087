// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pdf/pdf_details.h"

#include "ui/pdf/pdf_tags.h"

#define POINTERHOLDER_TRANSITION 4 // libqpdf with std::shared_ptr only
#include <qpdf/Buffer.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFExc.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFWriter.hh>

#include <algorithm>
#include <exception>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>

namespace sparkout {

namespace {

QPDFObjectHandle pdfText(const QString& text) {
    return QPDFObjectHandle::newUnicodeString(text.toStdString());
}

void putProperties(QPDF& document, const PdfDetails& details) {
    QPDFObjectHandle info = document.getTrailer().getKey("/Info");
    const auto put = [&info](const char* key, const QString& text) {
        if (text.isEmpty()) {
            info.removeKey(key);
        } else {
            info.replaceKey(key, pdfText(text));
        }
    };
    put("/Title", details.title);
    put("/Author", details.author);
    put("/Subject", details.subject);
    put("/Creator", details.creator);
    info.replaceKey("/CreationDate",
                    QPDFObjectHandle::newString(
                        "D:" + details.date.toString(QStringLiteral("yyyyMMdd")).toStdString()));
}

/// Sets the language for reading aloud, and the title as the window's name.
void putLanguage(QPDF& document, const QString& language) {
    QPDFObjectHandle root = document.getRoot();
    if (!language.isEmpty()) {
        root.replaceKey("/Lang", pdfText(language));
    }
    root.replaceKey("/ViewerPreferences", QPDFObjectHandle::parse("<< /DisplayDocTitle true >>"));
}

/// Entries below one root, each a linked list's member [ISO 32000-1, 12.3.3].
void putOutline(QPDF& document, const std::vector<Bookmark>& bookmarks) {
    const std::vector<QPDFPageObjectHelper> pages = QPDFPageDocumentHelper(document).getAllPages();
    std::vector<QPDFObjectHandle> items;
    QPDFObjectHandle root =
        document.makeIndirectObject(QPDFObjectHandle::parse("<< /Type /Outlines >>"));
    for (const Bookmark& bookmark : bookmarks) {
        QPDFObjectHandle page = pages.at(static_cast<std::size_t>(bookmark.page)).getObjectHandle();
        const double height =
            page.getKey("/MediaBox").getArrayItem(3).getNumericValue(); // of an upright page
        QPDFObjectHandle place = QPDFObjectHandle::newArray();
        place.appendItem(page);
        place.appendItem(QPDFObjectHandle::newName("/XYZ"));
        place.appendItem(QPDFObjectHandle::newNull()); // the left edge and the zoom are unchanged
        place.appendItem(QPDFObjectHandle::newReal(std::max(0.0, height - bookmark.y_pt), 2));
        place.appendItem(QPDFObjectHandle::newNull());
        QPDFObjectHandle item = QPDFObjectHandle::newDictionary();
        item.replaceKey("/Title", pdfText(bookmark.text));
        item.replaceKey("/Parent", root);
        item.replaceKey("/Dest", place);
        items.push_back(document.makeIndirectObject(item));
        if (items.size() > 1) {
            QPDFObjectHandle& before = items[items.size() - 2];
            before.replaceKey("/Next", items.back());
            items.back().replaceKey("/Prev", before);
        }
    }
    if (items.empty()) {
        return;
    }
    root.replaceKey("/First", items.front());
    root.replaceKey("/Last", items.back());
    root.replaceKey("/Count", QPDFObjectHandle::newInteger(static_cast<long long>(items.size())));
    document.getRoot().replaceKey("/Outlines", root);
    document.getRoot().replaceKey("/PageMode", QPDFObjectHandle::newName("/UseOutlines"));
}

/// Qt maps the glyph of the space to the tabulator, which shares it and comes first in the table.
/// This corrects copied and spoken text.
void putSpaces(QPDF& document) {
    for (QPDFObjectHandle& object : document.getAllObjects()) {
        if (!object.isDictionary() || !object.hasKey("/ToUnicode")) {
            continue;
        }
        QPDFObjectHandle map = object.getKey("/ToUnicode");
        const auto data = map.getStreamData();
        std::string text(reinterpret_cast<const char*>(data->getBuffer()), data->getSize());
        std::size_t place = std::string::npos;
        // Lists of characters, each in brackets.
        for (auto from = text.find('['); from != std::string::npos && place == std::string::npos;
             from = text.find('[', from + 1)) {
            const auto found = text.find("<0009>", from);
            place = found < text.find(']', from) ? found : std::string::npos;
        }
        if (place != std::string::npos) {
            text.replace(place, 6, "<0020>");
            map.replaceStreamData(text, QPDFObjectHandle::newNull(), QPDFObjectHandle::newNull());
        }
    }
}

/// Six letters before the name of a font mark an embedded subset [ISO 32000-1, 9.6.4]. Qt derives
/// them from the number of an object, which differs between starts of the program.
void putFontMarks(QPDF& document) {
    std::multimap<std::string, QPDFObjectHandle> fonts; // by their names
    for (QPDFObjectHandle& object : document.getAllObjects()) {
        if (object.isDictionaryOfType("/FontDescriptor") && object.getKey("/FontName").isName()) {
            const std::string marked = object.getKey("/FontName").getName();
            if (const auto plus = marked.find('+'); plus != std::string::npos) {
                fonts.emplace(marked.substr(plus + 1), object);
            }
        }
    }
    std::size_t number = 0;
    for (auto& [name, font] : fonts) {
        constexpr std::size_t letters = 26;
        std::string mark = "/AAAAAA+";
        std::size_t rest = number++;
        for (std::size_t at = mark.size() - 2; rest > 0; --at, rest /= letters) {
            mark[at] = static_cast<char>('A' + rest % letters);
        }
        font.replaceKey("/FontName", QPDFObjectHandle::newName(mark + name));
    }
}

class Stopped : public std::exception {};

std::shared_ptr<Buffer> written(QPDF& document, qpdf_object_stream_e mode,
                                const std::function<void()>& stopIfAsked) {
    QPDFWriter writer(document);
    writer.setOutputMemory();
    writer.setDeterministicID(true);
    writer.setObjectStreamMode(mode);
    writer.registerProgressReporter(std::make_shared<QPDFWriter::FunctionProgressReporter>(
        [&stopIfAsked](int) { stopIfAsked(); }));
    writer.write();
    return writer.getBufferSharedPointer();
}

} // namespace

QByteArray withDetails(const QByteArray& pdf, const PdfDetails& details,
                       const std::function<bool()>& goesOn) {
    const auto stopIfAsked = [&goesOn] {
        if (goesOn && !goesOn()) {
            throw Stopped();
        }
    };
    try {
        QPDF document;
        document.setSuppressWarnings(true);
        document.setAttemptRecovery(false);
        document.processMemoryFile("report", pdf.constData(), static_cast<std::size_t>(pdf.size()));
        putProperties(document, details);
        putLanguage(document, details.language);
        putOutline(document, details.outline);
        putSpaces(document);
        putFontMarks(document);
        if (details.attachment) {
            putAttachment(document, *details.attachment);
        }
        if (!details.structure.isEmpty()) {
            putTags(document, details.structure, stopIfAsked);
        }
        // Unpacked objects are numbered from the root on, whatever numbers Qt gave them.
        const auto numbered = written(document, qpdf_o_disable, stopIfAsked);
        QPDF ordered;
        ordered.setSuppressWarnings(true);
        ordered.processMemoryFile("report", reinterpret_cast<const char*>(numbered->getBuffer()),
                                  numbered->getSize());
        // An element is a small object: packed.
        const auto bytes = written(ordered, qpdf_o_generate, stopIfAsked);
        return {reinterpret_cast<const char*>(bytes->getBuffer()),
                static_cast<qsizetype>(bytes->getSize())};
    } catch (const std::exception&) { // by libqpdf, for unreadable files; Stopped
        return {};
    }
}

} // namespace sparkout
