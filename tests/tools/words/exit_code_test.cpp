#include "tools/words/exit_code.h"

#include <new>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/errors.h"

namespace isoloop {
namespace {

template <class Error>
ExitCode code_of(const Error& error) {
  return failure_of(std::make_exception_ptr(error)).code;
}

TEST(ExitCode, FollowsTheError) {
  EXPECT_EQ(code_of(InvalidArgument("x")), ExitCode::usage);
  EXPECT_EQ(code_of(InvalidInput("x")), ExitCode::invalid_input);
  EXPECT_EQ(code_of(LimitExceeded("x")), ExitCode::limit_exceeded);
  EXPECT_EQ(code_of(std::bad_alloc()), ExitCode::limit_exceeded);
  EXPECT_EQ(code_of(SelfCheckFailed("x")), ExitCode::self_check_failed);
  EXPECT_EQ(code_of(std::runtime_error("x")), ExitCode::self_check_failed);
  EXPECT_EQ(code_of(1), ExitCode::self_check_failed);
}

TEST(ExitCode, NumbersAreThoseOfTheManual) {
  EXPECT_EQ(static_cast<int>(ExitCode::done), 0);
  EXPECT_EQ(static_cast<int>(ExitCode::usage), 2);
  EXPECT_EQ(static_cast<int>(ExitCode::invalid_input), 3);
  EXPECT_EQ(static_cast<int>(ExitCode::limit_exceeded), 4);
  EXPECT_EQ(static_cast<int>(ExitCode::self_check_failed), 5);
}

TEST(ExitCode, SentenceIsOneLineWithoutFullStop) {
  const Failure failure = failure_of(std::make_exception_ptr(InvalidInput("one\ntwo.\n")));
  EXPECT_EQ(failure.sentence, "one two");
}

TEST(ExitCode, TheSentenceSaysWhatToDoInTheFlagsOfTheCommand) {
  const auto error = std::make_exception_ptr(LimitExceeded(
      {.text = "too much", .advice = {Advice::raise_memory_limit, Advice::take_part}}));
  EXPECT_EQ(failure_of(error, "count").sentence,
            "too much; raise --max-memory or read a part of the volume (--crop)");
  EXPECT_EQ(failure_of(error, "repair").sentence,
            "too much; raise --max-memory or crop the volume");
}

TEST(ExitCode, AnImpossibleVectorIsOutOfMemory) {
  try {
    std::vector<double> v;
    v.resize(v.max_size() + 1);
    FAIL();
  } catch (...) {
    EXPECT_EQ(failure_of(std::current_exception()).code, ExitCode::limit_exceeded);
  }
}

}  // namespace
}  // namespace isoloop
