#include "campaign/launch/make_launcher.hpp"

#include <gtest/gtest.h>

#include "campaign/core/spec.hpp"
#include "solver/case/bad_input.hpp"

namespace softwall::campaign {
namespace {

TEST(MakeLauncher, KnowsEveryNameOfTheSchemaAndNoOther) {
  const auto* node = campaign_schema().part(nlohmann::json::json_pointer("/execution/launcher"));
  ASSERT_NE(node, nullptr);
  EXPECT_EQ(node->at("enum").get<std::vector<std::string>>(), launcher_names());
  for (const std::string& name : launcher_names()) {
    Execution execution;
    execution.launcher = name;
    EXPECT_GE(cores_to_use(0, *make_launcher(execution)), 1) << name;
  }
  Execution execution;
  execution.launcher = "pigeons";
  EXPECT_THROW((void)make_launcher(execution), BadInput);
}

}  // namespace
}  // namespace softwall::campaign
