#include "shader/sealed_file.h"

#include <unistd.h>

#include <fstream>
#include <functional>
#include <system_error>
#include <thread>

#include "shader/content_hash.h"

namespace weft::shader {

namespace fs = std::filesystem;

namespace {
constexpr std::string_view kMagic = "WEFTSHD1";
constexpr size_t kHeaderBytes = 24;
constexpr uintmax_t kMaxFileBytes = 64u << 20;
}  // namespace

void PayloadWriter::number(uint64_t value) {
    for (uint32_t i = 0; i < 8; ++i) payload_ += static_cast<char>(static_cast<uint8_t>(value >> (8 * i)));
}

void PayloadWriter::text(std::string_view value) {
    number(value.size());
    payload_ += value;
}

std::optional<uint64_t> PayloadReader::number() {
    if (rest_.size() < 8) {
        rest_ = {};
        return std::nullopt;
    }
    uint64_t value = 0;
    for (uint32_t i = 0; i < 8; ++i) value |= uint64_t{static_cast<uint8_t>(rest_[i])} << (8 * i);
    rest_.remove_prefix(8);
    return value;
}

std::optional<std::string_view> PayloadReader::text() {
    const auto length = number();
    if (!length || *length > rest_.size()) {
        rest_ = {};
        return std::nullopt;
    }
    const std::string_view value = rest_.substr(0, *length);
    rest_.remove_prefix(*length);
    return value;
}

std::optional<std::string> read_sealed(const fs::path& file) {
    std::error_code error;
    const uintmax_t bytes = fs::file_size(file, error);
    if (error || bytes < kHeaderBytes || bytes > kMaxFileBytes) return std::nullopt;
    std::string whole(bytes, '\0');
    std::ifstream stream(file, std::ios::binary);
    if (!stream.read(whole.data(), static_cast<std::streamsize>(bytes))) return std::nullopt;
    if (!whole.starts_with(kMagic)) return std::nullopt;
    PayloadReader header(std::string_view(whole).substr(kMagic.size(), kHeaderBytes - kMagic.size()));
    const auto length = header.number();
    const auto hash = header.number();
    std::string payload = whole.substr(kHeaderBytes);
    if (length != payload.size() || hash != hash_of(payload)) return std::nullopt;
    return payload;
}

void write_sealed(const fs::path& file, std::string_view payload) {
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    PayloadWriter header;
    header.number(payload.size());
    header.number(hash_of(payload));

    const size_t thread = std::hash<std::thread::id>{}(std::this_thread::get_id());
    fs::path draft = file;
    draft.concat(".").concat(std::to_string(::getpid()));
    draft.concat("-").concat(std::to_string(thread)).concat(".draft");
    std::ofstream stream(draft, std::ios::binary | std::ios::trunc);
    stream << kMagic << header.payload() << payload;
    stream.close();
    if (stream) fs::rename(draft, file, error);
    if (!stream || error) fs::remove(draft, error);
}

}  // namespace weft::shader
