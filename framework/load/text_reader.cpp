#include "load/text_reader.h"

namespace weft {

FileReader reader_of(const LoadSettings& settings) {
    return settings.reader ? settings.reader : disk_reader(settings.limits.graph.json_bytes);
}

bool reads_disk(const LoadSettings& settings) {
    return settings.reads_disk || !settings.reader;
}

}  // namespace weft
