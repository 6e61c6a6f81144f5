#include "solver/stop_request.hpp"

#include <csignal>
#include <initializer_list>

namespace softwall {

namespace {

// A signal handler can reach nothing but a static flag.
volatile std::sig_atomic_t received = 0;

extern "C" void remember(int signal) { received = signal; }

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  ::sigaction(signal, &action, nullptr);
}

bool is_ignored(int signal) {
  struct sigaction now {};
  return ::sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

}  // namespace

void install_signal_handlers() {
  handle(SIGUSR1, remember);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
    if (!is_ignored(signal)) handle(signal, remember);
  }
  for (const int signal : {SIGPIPE, SIGXFSZ}) handle(signal, SIG_IGN);
}

int stop_signal() { return received; }

std::string describe_stop_signal(int signal) {
  switch (signal) {
    case SIGUSR1:  // what the manager sends
      return "stopped on request";
    case SIGINT:
      return "stopped on request (Ctrl-C)";
    case SIGHUP:
      return "stopped because its terminal was closed (SIGHUP)";
    case SIGTERM:
      return "ended from outside (SIGTERM)";
    default:
      return "stopped by signal " + std::to_string(signal);
  }
}

}  // namespace softwall
