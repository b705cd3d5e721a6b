// CLI11's App and Option by name alone: its header takes long to compile and is for .cpp files
// only.
#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): another library's name
class App;
class Option;
}  // namespace CLI
