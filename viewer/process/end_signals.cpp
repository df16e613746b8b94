#include "viewer/process/end_signals.h"

#include <poll.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <ctime>

namespace weft::viewer {
namespace {

sigset_t end_signals() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    return set;
}

}  // namespace

EndSignals::EndSignals(bool watch_stdin) : watch_stdin_(watch_stdin && isatty(STDIN_FILENO) == 0) {
    const sigset_t set = end_signals();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
    signals_ = signalfd(-1, &set, SFD_NONBLOCK | SFD_CLOEXEC);
}

EndSignals::~EndSignals() {
    // Read all pending signals. Otherwise, a pending signal would end the program when the signals are
    // unblocked below.
    signalfd_siginfo taken{};
    while (signals_ >= 0 && read(signals_, &taken, sizeof taken) > 0) {
    }
    if (signals_ >= 0) close(signals_);
    const sigset_t set = end_signals();
    pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

bool EndSignals::within(std::chrono::nanoseconds time) {
    std::array<pollfd, 2> sources{pollfd{signals_, POLLIN, 0}, pollfd{STDIN_FILENO, POLLIN, 0}};
    const auto whole = std::chrono::floor<std::chrono::seconds>(std::max(time, std::chrono::nanoseconds(0)));
    const timespec most{whole.count(), std::max<long>((time - whole).count(), 0)};
    const int ready = ppoll(sources.data(), watch_stdin_ ? 2 : 1, &most, nullptr);
    if (ready <= 0) return false;
    if (sources[0].revents != 0) return true;
    if (sources[1].revents == 0) return false;
    // The text that arrives on stdin is ignored. Only the end of stdin is a request to end.
    std::array<char, 256> text{};
    return read(STDIN_FILENO, text.data(), text.size()) <= 0;
}

}  // namespace weft::viewer
