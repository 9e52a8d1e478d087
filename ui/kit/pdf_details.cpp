// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/pdf_details.h"

#include <QPainter>

#include <cmath>

#define POINTERHOLDER_TRANSITION 4 // libqpdf with std::shared_ptr only
#include <qpdf/Buffer.hh>
#include <qpdf/Pipeline.hh>
#include <qpdf/Pl_Buffer.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFEFStreamObjectHelper.hh>
#include <qpdf/QPDFEmbeddedFileDocumentHelper.hh>
#include <qpdf/QPDFExc.hh>
#include <qpdf/QPDFFileSpecObjectHelper.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFTokenizer.hh>
#include <qpdf/QPDFWriter.hh>

#include <QCoreApplication>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>

namespace sparkout {

namespace {

constexpr double markPlace = -30'000; ///< in dots of the device, beyond any paper
}

void PdfStructure::placeBoxes(double scale, const QPointF& origin_pt) {
    for (Element& element : m_elements) {
        if (element.box) {
            element.box =
                QRectF(element.box->topLeft() * scale + origin_pt, element.box->size() * scale);
        }
    }
}

/// Without a transform and a clip, so that the following content begins with its own state.
void PdfStructure::mark(QPainter& painter, Id id) {
    painter.save();
    painter.resetTransform();
    painter.setClipping(false);
    painter.setPen(Qt::NoPen);
    painter.setBrush(Qt::SolidPattern);
    painter.drawRect(QRectF(markPlace, markPlace - static_cast<double>(id), 1, 1));
    painter.restore();
}

std::optional<PdfStructure::Id> PdfStructure::marked(double x, double y) {
    if (x != markPlace || y > markPlace) {
        return std::nullopt;
    }
    return static_cast<Id>(std::llround(markPlace - y));
}

namespace {

/// Accepts at most this number of bytes from an unpacked stream.
class LimitedBuffer : public Pipeline {
public:
    explicit LimitedBuffer(qsizetype most) : Pipeline("attachment", nullptr), m_most(most) {}
    void write(const unsigned char* data, std::size_t length) override {
        if (m_data.size() + static_cast<qsizetype>(length) > m_most) {
            throw std::length_error("attachment");
        }
        m_data.append(reinterpret_cast<const char*>(data), static_cast<qsizetype>(length));
    }
    void finish() override {}
    [[nodiscard]] const QByteArray& data() const { return m_data; }

private:
    qsizetype m_most;
    QByteArray m_data;
};

} // namespace

PdfAttachment projectAttachment(const QString& name, const QByteArray& text) {
    const QString ending = QStringLiteral(".sparkout");
    const QString base = name.isEmpty() ? QStringLiteral("project") : name;
    return {base.endsWith(ending) ? base : base + ending, text,
            QCoreApplication::translate("Pages", "Inputs of this document")};
}

void putAttachment(QPDF& document, const PdfAttachment& attachment) {
    auto stream = QPDFEFStreamObjectHelper::createEFStream(document, attachment.data.toStdString());
    stream.setSubtype("application/json");
    auto file =
        QPDFFileSpecObjectHelper::createFileSpec(document, attachment.name.toStdString(), stream);
    file.setDescription(attachment.description.toStdString());
    QPDFEmbeddedFileDocumentHelper(document).replaceEmbeddedFile(attachment.name.toStdString(),
                                                                 file);
}

std::optional<PdfAttachment> attachmentOf(const QByteArray& pdf, const QString& ending,
                                          qsizetype mostBytes) {
    try {
        QPDF document;
        document.setSuppressWarnings(true);
        document.processMemoryFile("attached", pdf.constData(),
                                   static_cast<std::size_t>(pdf.size()));
        for (const auto& [key, file] :
             QPDFEmbeddedFileDocumentHelper(document).getEmbeddedFiles()) {
            const QString name = QString::fromStdString(file->getFilename());
            QPDFObjectHandle stream = file->getEmbeddedFileStream();
            if (!name.endsWith(ending) || !stream.isStream()) {
                continue;
            }
            LimitedBuffer buffer(mostBytes);
            if (!stream.pipeStreamData(&buffer, 0, qpdf_dl_all)) {
                return std::nullopt;
            }
            return PdfAttachment{name, buffer.data(),
                                 QString::fromStdString(file->getDescription())};
        }
    } catch (const std::exception&) { // by libqpdf, or too long
    }
    return std::nullopt;
}

namespace {

using Token = QPDFTokenizer::Token;
using Id = PdfStructure::Id;

/// The elements on one page; the number of each is its index.
using MarkedContent = std::vector<Id>;

/// Replaces the marks of one page by marked content. Qt writes a page as "q … q … Q q … Q Q": the
/// outer level has the clip, which a mark does not have, the inner one everything else. A sequence
/// begins and ends outside both, so that it contains whole levels.
class MarksToContent : public QPDFObjectHandle::TokenFilter {
public:
    explicit MarksToContent(const PdfStructure& structure) : m_structure(structure) {}
    [[nodiscard]] const MarkedContent& content() const { return m_content; }

    void handleToken(const Token& token) override {
        m_operation.push_back(token);
        switch (token.getType()) {
        case QPDFTokenizer::tt_integer:
        case QPDFTokenizer::tt_real:
            m_numbers.push_back(std::atof(token.getValue().c_str()));
            break;
        case QPDFTokenizer::tt_inline_image: m_numbers.clear(); break;
        case QPDFTokenizer::tt_word: handleOperation(token.getValue()); break;
        default: break; // operands of other kinds, spaces
        }
    }
    void handleEOF() override {
        writeOperation();
        if (m_isOpen) {
            write("\nEMC\n");
        }
    }

private:
    void handleOperation(const std::string& name) {
        if (m_isMark) { // its rectangle is filled: "f", or "f*"
            m_isMark = false;
            m_operation.clear();
        } else if (name == "re" && m_numbers.size() == 4) {
            if (const auto id = PdfStructure::marked(m_numbers[0], m_numbers[1])) {
                m_isMark = true;
                m_pending = id;
                m_operation.clear();
            }
        }
        writeOperation();
        m_numbers.clear();
        if (name == "q") {
            ++m_depth;
        } else if (name == "Q") {
            --m_depth;
            begin();
        }
    }
    void writeOperation() {
        for (const Token& token : m_operation) {
            writeToken(token);
        }
        m_operation.clear();
    }
    /// Begins the element of the last mark, if it has changed.
    void begin() {
        if (!m_pending) {
            return;
        }
        const Id id = *m_pending;
        m_pending.reset();
        if (m_isOpen && id == m_current) {
            return;
        }
        if (m_depth != 1) {
            throw std::runtime_error("a mark of the structure in an unknown place");
        }
        write(m_isOpen ? "\nQ\nEMC\n" : "\nQ\n");
        if (id == PdfStructure::artifact) {
            write("/Artifact <</Type /Layout>> BDC\nq\n");
        } else if (id == PdfStructure::pagination) {
            write("/Artifact <</Type /Pagination>> BDC\nq\n");
        } else {
            write("/" + m_structure.at(id).type.toStdString() + " <</MCID "
                  + std::to_string(m_content.size()) + ">> BDC\nq\n");
            m_content.push_back(id);
        }
        m_isOpen = true;
        m_current = id;
    }

    const PdfStructure& m_structure;
    std::vector<Token> m_operation; ///< up to its name
    std::vector<double> m_numbers;  ///< numbers among its operands
    int m_depth = 0;
    bool m_isMark = false; ///< the rectangle was removed, its fill operator follows
    bool m_isOpen = false;
    std::optional<Id> m_pending;
    Id m_current = 0;
    MarkedContent m_content;
};

/// The tree of a document: an object for each element.
class Tree {
public:
    Tree(QPDF& document, const PdfStructure& structure)
        : m_structure(structure), m_objects(structure.end()), m_shown(structure.end(), false) {
        for (Id id = PdfStructure::document; id < structure.end(); ++id) {
            m_objects[id] = document.makeIndirectObject(QPDFObjectHandle::newDictionary());
        }
    }

    /// Adds a page's parts of the elements, in their order.
    void addContent(QPDFObjectHandle& page, const MarkedContent& content) {
        for (std::size_t number = 0; number < content.size(); ++number) {
            QPDFObjectHandle& element = m_objects[content[number]];
            if (!element.hasKey("/Pg")) {
                element.replaceKey("/Pg", page);
            }
            const auto mcid = QPDFObjectHandle::newInteger(static_cast<long long>(number));
            if (element.getKey("/Pg").getObjGen() == page.getObjGen()) {
                addKid(content[number], mcid);
            } else {
                QPDFObjectHandle reference = QPDFObjectHandle::parse("<< /Type /MCR >>");
                reference.replaceKey("/Pg", page);
                reference.replaceKey("/MCID", mcid);
                addKid(content[number], reference);
            }
            for (Id id = content[number]; !m_shown[id]; id = m_structure.at(id).parent) {
                m_shown[id] = true;
                if (id == PdfStructure::document) {
                    break;
                }
            }
        }
    }

    /// The root; without elements that no page shows, but with empty cells.
    QPDFObjectHandle finished(QPDF& document) {
        QPDFObjectHandle root =
            document.makeIndirectObject(QPDFObjectHandle::parse("<< /Type /StructTreeRoot >>"));
        root.replaceKey("/K", m_objects[PdfStructure::document]);
        QPDFObjectHandle& top = m_objects[PdfStructure::document];
        top.replaceKey("/Type", QPDFObjectHandle::newName("/StructElem"));
        top.replaceKey("/S", QPDFObjectHandle::newName("/Document"));
        top.replaceKey("/P", root);
        for (Id id = PdfStructure::document + 1; id < m_structure.end(); ++id) {
            const PdfStructure::Element& element = m_structure.at(id);
            const bool isCell = element.type == "TD" || element.type == "TH";
            if (m_shown[id] || (isCell && m_shown[element.parent])) {
                describe(m_objects[id], element);
                addKid(element.parent, m_objects[id]);
            }
        }
        return root;
    }

    [[nodiscard]] const QPDFObjectHandle& object(Id id) const { return m_objects[id]; }

private:
    void addKid(Id id, const QPDFObjectHandle& kid) {
        if (!m_objects[id].hasKey("/K")) {
            m_objects[id].replaceKey("/K", QPDFObjectHandle::newArray());
        }
        m_objects[id].getKey("/K").appendItem(kid);
    }

    void describe(QPDFObjectHandle& object, const PdfStructure::Element& element) {
        object.replaceKey("/Type", QPDFObjectHandle::newName("/StructElem"));
        object.replaceKey("/S", QPDFObjectHandle::newName("/" + element.type.toStdString()));
        object.replaceKey("/P", m_objects[element.parent]);
        if (!element.alt.isEmpty()) {
            object.replaceKey("/Alt",
                              QPDFObjectHandle::newUnicodeString(element.alt.toStdString()));
        }
        if (element.type == "TH") {
            object.replaceKey("/A", QPDFObjectHandle::parse("<< /O /Table /Scope /Column >>"));
        } else if (element.span > 1) {
            object.replaceKey("/A",
                              QPDFObjectHandle::parse("<< /O /Table /ColSpan "
                                                      + std::to_string(element.span) + " >>"));
        } else if (element.box && object.hasKey("/Pg")) {
            // Converts points from the upper left corner to the lower left one.
            const double height =
                object.getKey("/Pg").getKey("/MediaBox").getArrayItem(3).getNumericValue();
            QPDFObjectHandle attributes = QPDFObjectHandle::parse("<< /O /Layout >>");
            attributes.replaceKey("/BBox", QPDFObjectHandle::newArray(QPDFObjectHandle::Rectangle(
                                               element.box->left(), height - element.box->bottom(),
                                               element.box->right(), height - element.box->top())));
            object.replaceKey("/A", attributes);
        }
    }

    const PdfStructure& m_structure;
    std::vector<QPDFObjectHandle> m_objects; ///< by number; the first ones, of artifacts, are empty
    std::vector<bool> m_shown;
};

/// Tags a document whose pages were painted with the structure's marks: the marks become marked
/// content, the elements a structure tree. Throws if a mark is not as Qt paints it, and the
/// exceptions of libqpdf. `afterPage` may throw as well.
void putTags(QPDF& document, const PdfStructure& structure,
             const std::function<void()>& afterPage) {
    Tree tree(document, structure);
    QPDFObjectHandle numbers = QPDFObjectHandle::newArray();
    long long number = 0;
    for (QPDFPageObjectHelper& page : QPDFPageDocumentHelper(document).getAllPages()) {
        MarksToContent filter(structure);
        Pl_Buffer buffer("page");
        page.filterContents(&filter, &buffer);
        QPDFObjectHandle object = page.getObjectHandle();
        object.replaceKey("/Contents", document.newStream(buffer.getBufferSharedPointer()));
        object.replaceKey("/StructParents", QPDFObjectHandle::newInteger(number));
        object.replaceKey("/Tabs", QPDFObjectHandle::newName("/S"));
        tree.addContent(object, filter.content());
        QPDFObjectHandle parents = QPDFObjectHandle::newArray();
        for (const Id id : filter.content()) {
            parents.appendItem(tree.object(id));
        }
        numbers.appendItem(QPDFObjectHandle::newInteger(number));
        numbers.appendItem(document.makeIndirectObject(parents));
        ++number;
        afterPage();
    }
    QPDFObjectHandle root = tree.finished(document);
    QPDFObjectHandle parentTree = QPDFObjectHandle::newDictionary();
    parentTree.replaceKey("/Nums", numbers);
    root.replaceKey("/ParentTree", document.makeIndirectObject(parentTree));
    root.replaceKey("/ParentTreeNextKey", QPDFObjectHandle::newInteger(number));
    document.getRoot().replaceKey("/StructTreeRoot", root);
    document.getRoot().replaceKey("/MarkInfo", QPDFObjectHandle::parse("<< /Marked true >>"));
}

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
