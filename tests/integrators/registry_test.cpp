// The table of integrators.
#include "integrators/registry.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "integrators/normals.h"

namespace umbral::test {
namespace {

TEST(Registry, MakesEveryIntegratorThatItLists) {
  ASSERT_GE(integrators().size(), 3u);
  for (const IntegratorEntry& entry : integrators()) {
    EXPECT_NE(entry.make(), nullptr) << entry.kind;
    EXPECT_NE(make_integrator(entry.kind), nullptr) << entry.kind;
    EXPECT_FALSE(entry.doc.empty()) << entry.kind;
  }
  EXPECT_EQ(make_integrator("radiosity"), nullptr);
}

TEST(Registry, TakesNewOnesOnce) {
  const IntegratorEntry entry{"of_this_test", "a stranger",
                              [] { return std::make_unique<NormalsIntegrator>(); }};
  const std::size_t before = integrators().size();
  register_integrator(entry);
  EXPECT_EQ(integrators().size(), before + 1);
  EXPECT_NE(make_integrator("of_this_test"), nullptr);
  EXPECT_THROW(register_integrator(entry), std::invalid_argument);
  EXPECT_THROW(register_integrator({"path", "", entry.make}), std::invalid_argument);
  EXPECT_EQ(integrators().size(), before + 1);
}

}  // namespace
}  // namespace umbral::test
