#pragma once

namespace softwall {

/// To be called before anything else of a program. A program may be started with its standard input, output
/// or error closed; the next file it opened would then get that number, and be written into by every message.
/// Opens what is closed: input and error on /dev/null, output on /dev/full, so that results which nobody can
/// receive are an error and not lost in silence.
void open_standard_streams();

}  // namespace softwall
