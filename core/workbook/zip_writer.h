// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

struct z_stream_s;

namespace sparkout {

/// A ZIP archive that is made in memory, file after file; equal content gives equal bytes. It holds
/// less than 4 GB.
class ZipWriter {
public:
    ZipWriter();
    ZipWriter(const ZipWriter&) = delete;
    ZipWriter& operator=(const ZipWriter&) = delete;
    ~ZipWriter();

    void begin(std::string_view name); ///< a name in ASCII
    void add(std::string_view bytes);  ///< to the file that was begun last
    void end();
    /// A small file that is not compressed.
    void addStored(std::string_view name, std::string_view bytes);

    /// Version of the library that compresses: "1.2.13".
    [[nodiscard]] static const char* libraryVersion();

    /// The archive, which is handed over; empty when it would be too large, or the memory did not
    /// suffice.
    [[nodiscard]] std::string finish();

private:
    struct Entry {
        std::string name;
        std::uint32_t crc = 0;
        std::uint64_t size = 0;
        std::uint64_t packed = 0;
        std::uint64_t offset = 0;
        bool isStored = false; ///< as it is, else compressed
    };
    void deflate(std::string_view bytes, int flush);
    [[nodiscard]] static std::string headerOf(const Entry& entry, bool central);

    std::string m_bytes;
    std::vector<Entry> m_entries;
    std::vector<unsigned char> m_room; ///< what the compressor fills
    z_stream_s* m_stream = nullptr;    ///< while a file is open
    bool m_failed = false;
};

} // namespace sparkout
