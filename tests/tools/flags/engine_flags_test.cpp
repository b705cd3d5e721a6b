#include "tools/flags/engine_flags.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"

namespace isoloop {
namespace {

TEST(EngineFlags, ChooseTheDualEngineByDefault) {
  EXPECT_EQ(engine_of({}), Engine::dual);
  EXPECT_NO_THROW(pair_options({}));
}

TEST(EngineFlags, ChooseBothRefinementsByDefault) {
  EXPECT_EQ(pair_options({.engine = "pair", .refine = "", .dump_pairs = ""}).refinement,
            Refinement::both);
}

TEST(EngineFlags, SpellRefinementsAsTheyAreRead) {
  for (const Refinement refinement :
       {Refinement::none, Refinement::first, Refinement::second, Refinement::both}) {
    const EngineFlags flags{
        .engine = "pair", .refine = refinement_text(refinement), .dump_pairs = ""};
    EXPECT_EQ(pair_options(flags).refinement, refinement);
  }
}

TEST(EngineFlags, OfThePairEngineAreRefusedWithTheOther) {
  EXPECT_THROW(pair_options({.engine = "dual", .refine = "both", .dump_pairs = ""}),
               InvalidArgument);
  EXPECT_THROW(pair_options({.engine = "dual", .refine = "", .dump_pairs = "p.csv"}),
               InvalidArgument);
}

TEST(EngineFlags, TightenByDefaultUnlessThePapersOwnLoopsAreAskedFor) {
  EngineFlags flags;
  EXPECT_EQ(tighten_of(flags, Boundary::closed), Tighten::basis);
  flags.engine = "pair";
  EXPECT_EQ(tighten_of(flags, Boundary::closed), Tighten::none);
  for (const Tighten tighten : {Tighten::none, Tighten::basis, Tighten::curve}) {
    flags.tighten = tighten_text(tighten);
    EXPECT_EQ(tighten_of(flags, Boundary::closed), tighten);
  }
}

TEST(EngineFlags, TightenNothingWithAnOpenBoundary) {
  EngineFlags flags;
  EXPECT_EQ(tighten_of(flags, Boundary::open), Tighten::none);
  flags.tighten = "none";
  EXPECT_EQ(tighten_of(flags, Boundary::open), Tighten::none);
  for (const char* tighten : {"basis", "curve"}) {
    flags.tighten = tighten;
    EXPECT_THROW(tighten_of(flags, Boundary::open), InvalidArgument);
  }
}

TEST(EngineFlags, TheGradingIsOfAnOctree) {
  EngineFlags flags;
  EXPECT_EQ(complex_of(flags), ComplexKind::automatic);
  EXPECT_EQ(grading_of(flags), 1);
  flags.grading = 0;
  for (const ComplexKind complex : {ComplexKind::automatic, ComplexKind::octree}) {
    flags.complex = complex_text(complex);
    EXPECT_EQ(complex_of(flags), complex);
    EXPECT_EQ(grading_of(flags), 0);
  }
  flags.complex = complex_text(ComplexKind::grid);
  EXPECT_THROW(complex_of(flags), InvalidArgument);
  flags.grading.reset();
  EXPECT_EQ(complex_of(flags), ComplexKind::grid);
}

}  // namespace
}  // namespace isoloop
