// Purpose: the compiler's worker as its caller sees it: a process that is spawned without a shell, has no
// descriptor but its socket and an empty environment, and is killed when it takes too long, takes too much
// memory, or says what makes no sense. Memory is bounded by the worker's own address-space limit and, because
// sanitizers do without one, watched from here as well. Time is the worker's processor time, or time that it
// sleeps while an answer is due: a busy machine, which lets it wait for a processor, does not use it up.
// Errors: X570 the worker cannot be started, or is of another version.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "shader/worker/protocol.h"
#include "weft/limits.h"
#include "weft/result.h"

namespace weft::shader {

enum class WorkerEnd : uint8_t { running, out_of_memory, out_of_time, crashed, babbled };

class WorkerProcess {
 public:
    // `version`: the compiler_version() that it shall have.
    [[nodiscard]] static Result<std::unique_ptr<WorkerProcess>> start(const std::filesystem::path& program,
                                                                      const ShaderLimits& limits,
                                                                      const std::string& version);
    ~WorkerProcess();
    WorkerProcess(const WorkerProcess&) = delete;
    WorkerProcess& operator=(const WorkerProcess&) = delete;

    // From now on it may use this much time.
    void allow(std::chrono::milliseconds time);
    // Processor time since it was started.
    [[nodiscard]] std::chrono::milliseconds used();

    // Both fail for good: the process is gone then, and end() says why.
    [[nodiscard]] bool send(const Message& message);
    [[nodiscard]] std::optional<Message> receive();
    [[nodiscard]] WorkerEnd end() const { return end_; }
    [[nodiscard]] int signal() const { return signal_; }  // of a crash; 0: it left by itself

    // It said what no worker says.
    void give_up_on();

 private:
    WorkerProcess(pid_t pid, int socket, const ShaderLimits& limits)
        : pid_(pid), socket_(socket), limits_(limits) {}

    [[nodiscard]] bool ready(short events);
    [[nodiscard]] bool read_exactly(char* to, size_t bytes);
    // Reads used_ from the system. True: the process sleeps.
    bool observe();
    [[nodiscard]] uint64_t resident_bytes() const;
    void wait_for_end();
    void kill_for(WorkerEnd reason);

    pid_t pid_ = -1;
    int socket_ = -1;
    ShaderLimits limits_;
    WorkerEnd end_ = WorkerEnd::running;
    int signal_ = 0;
    std::chrono::milliseconds used_{0}, most_used_{0};
    std::chrono::milliseconds asleep_{0}, most_asleep_{0};
};

}  // namespace weft::shader
