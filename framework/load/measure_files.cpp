#include "load/measure_files.h"

#include "graph/diagnostics/quantity_text.h"
#include "load/data_file.h"
#include "load/picture_file.h"

namespace weft {
namespace {

// The header of a picture lies in these first bytes of the file. Only a JPEG may have large data before it.
constexpr uint64_t kHeaderBytes = 1 << 20;

std::string folder_of(const GraphDesc& graph, const SourceLoc& loc) {
    if (loc.file >= graph.sources.files.size()) return {};
    return std::filesystem::path(graph.sources.files[loc.file].path).parent_path().string();
}

class Measure {
 public:
    Measure(GraphDesc& graph, const LoadSettings& settings, std::set<std::filesystem::path>* searched,
            Diagnostics& faults)
        : graph_(graph), settings_(settings), searched_(searched), faults_(faults) {}

    void run() {
        for (auto& [name, resource] : graph_.resources) {
            if (!resource.file.name.empty()) measure(resource, resource.file);
            for (FileDesc& texture : resource.textures)
                if (!texture.name.empty()) measure(resource, texture);
        }
    }

 private:
    void fail(const ResourceDesc& resource, const FileDesc& desc, const std::string& fault,
              const std::string& help) {
        faults_.push_back(unusable_file(graph_.sources, desc.loc, desc.name, resource.name, fault, help));
    }

    void measure(const ResourceDesc& resource, FileDesc& desc) {
        const DataFile file =
            find_data_file(folder_of(graph_, desc.loc), desc.name, kHeaderBytes, settings_, searched_);
        if (!file.fault.empty()) return fail(resource, desc, file.fault, file.help);
        if (file.size_bytes == 0)
            return fail(resource, desc, "the file is empty", "write the data into the file");
        uint64_t content_bytes = file.size_bytes;
        if (!resource.is_buffer) {
            const PictureHeader header = read_picture_header(file.bytes);
            if (!header.fault.empty())
                return fail(resource, desc, header.fault, "save the picture again with another program");
            desc.width_px = header.width_px;
            desc.height_px = header.height_px;
            if (header.width_px > 0) content_bytes += decoding_bytes(header);
        }
        desc.size_bytes = file.size_bytes;
        const uint64_t limit_bytes = settings_.limits.graph.file_bytes;
        if (content_bytes > limit_bytes - used_bytes_)
            return fail(resource, desc,
                        "all files of the graph together need " + bytes_text(used_bytes_ + content_bytes) +
                            "; the limit is " + limit_bytes_text(limit_bytes),
                        "use smaller files, " + raise_limit_text("graph.fileBytes"));
        used_bytes_ += content_bytes;
        desc.path = file.path;
    }

    GraphDesc& graph_;
    const LoadSettings& settings_;
    std::set<std::filesystem::path>* searched_;
    Diagnostics& faults_;
    uint64_t used_bytes_ = 0;
};

}  // namespace

void measure_files(GraphDesc& graph, const LoadSettings& settings, std::set<std::filesystem::path>* searched,
                   Diagnostics& faults) {
    Measure(graph, settings, searched, faults).run();
}

}  // namespace weft
