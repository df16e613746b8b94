#include "shader/compile/sealed_file.h"

#include <fstream>
#include <system_error>

#include "file/write_file.h"
#include "shader/compile/content_hash.h"
#include "shader/worker/payload.h"

namespace weft::shader {

namespace fs = std::filesystem;

namespace {
constexpr std::string_view kMagic = "WEFTSHD1";
constexpr size_t kHeaderBytes = 24;  // Magic, payload length and hash: 8 bytes each.
constexpr uintmax_t kMaxFileBytes = 64u << 20;
}  // namespace

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
    std::string whole(kMagic);
    whole += header.payload();
    whole += payload;
    static_cast<void>(write_file(file.string(), whole, Durability::cached));
}

}  // namespace weft::shader
