// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pdf/pdf_attachment.h"

#define POINTERHOLDER_TRANSITION 4 // libqpdf with std::shared_ptr only
#include <qpdf/Pipeline.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFEFStreamObjectHelper.hh>
#include <qpdf/QPDFEmbeddedFileDocumentHelper.hh>
#include <qpdf/QPDFFileSpecObjectHelper.hh>

#include <exception>
#include <stdexcept>

namespace sparkout {

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

} // namespace sparkout
