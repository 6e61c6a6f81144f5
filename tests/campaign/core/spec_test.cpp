#include "campaign/core/spec.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "solver/case/case_schema.hpp"
#include "tests/campaign/core/examples.hpp"

namespace softwall::campaign {
namespace {

using nlohmann::json;
using tests::complaint_about;
using tests::elastic_campaign;

CampaignSpec spec_of(const json& document) { return check_spec(document.dump(), "campaign").spec; }

TEST(Spec, FillsWhatIsItsOwn) {
  const CampaignSpec spec = spec_of(elastic_campaign());
  EXPECT_EQ(spec.name, "walls");
  EXPECT_EQ(spec.description, "");
  EXPECT_EQ(spec.execution.launcher, "local");
  EXPECT_EQ(spec.execution.ranks, 1);
  EXPECT_EQ(spec.execution.precursor_ranks, 1);
  EXPECT_EQ(spec.execution.cores, 0);
  EXPECT_FALSE(spec.execution.walltime_seconds);
  EXPECT_EQ(spec.execution.max_failures_without_progress, 2);
  EXPECT_EQ(spec.text, elastic_campaign().dump());
}

TEST(Spec, PrecursorRanksFollowRanks) {
  json document = elastic_campaign();
  document["execution"] = {{"ranks", 4}, {"walltime_seconds", 60}};
  EXPECT_EQ(spec_of(document).execution.precursor_ranks, 4);
  EXPECT_EQ(spec_of(document).execution.walltime_seconds, 60.0);
  document["execution"]["precursor_ranks"] = 2;
  EXPECT_EQ(spec_of(document).execution.precursor_ranks, 2);
}

TEST(Spec, TellsMistakesOfAllKindsAtOnce) {
  json document = elastic_campaign();
  document["execution"] = {{"corse", 2}, {"ranks", 0}};
  document["physics"]["grid"]["ny_solid"] = 17;  // only the cases show this one
  document["sweep"]["grid"]["G"] = {1, -1};      // and this one
  document["desciption"] = "x";
  const std::string message = complaint_about(document);
  for (const char* part : {"/execution/corse: unknown key; did you mean \"cores\"?", "/execution/ranks: 0",
                           "/physics/grid/ny_solid: 17", "ny_solid must be 16", "/physics/solid/G: -1",
                           "/desciption: unknown key; did you mean \"description\"?"})
    EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
}

TEST(Spec, CoresMustHoldTheRanks) {
  json document = elastic_campaign();
  document["execution"] = {{"ranks", 2}, {"precursor_ranks", 8}, {"cores", 4}};
  const std::string message = complaint_about(document);
  EXPECT_NE(message.find("/execution/precursor_ranks: 8; at most the 4 cores"), std::string::npos) << message;
  EXPECT_EQ(message.find("/execution/ranks"), std::string::npos) << message;
}

void collect_numbers(const json& node, const std::string& at, std::map<std::string, json>& found) {
  const json members = node.value("properties", json::object());
  for (const auto& [key, child] : members.items()) {
    const json type = child.value("type", json());
    if (type == "number" || type == "integer") found[at + "/" + key] = child;
    collect_numbers(child, at + "/" + key, found);
  }
}

TEST(Spec, EveryNumberHasALargestValue) {
  std::map<std::string, json> numbers;
  collect_numbers(*campaign_schema().part(json::json_pointer()), "", numbers);
  EXPECT_GT(numbers.size(), 30u);
  for (const auto& [pointer, node] : numbers) EXPECT_TRUE(node.contains("maximum")) << pointer;
}

TEST(Spec, RefusesNumbersThatTheProgramsCannotHold) {
  json document = elastic_campaign();
  document["execution"]["walltime_seconds"] = 1e19;
  document["physics"]["statistics"]["interval_steps"] = 4294967297;
  document["run"]["end_time"] = 1e300;
  const std::string message = complaint_about(document);
  for (const char* part : {"/execution/walltime_seconds: 1e+19",
                           "/physics/statistics/interval_steps: 4294967297", "/run/end_time: 1e+300"})
    EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
}

TEST(Spec, RanksOfAPrecursorNeedOne) {
  json document = elastic_campaign();
  document["execution"] = {{"ranks", 2}, {"precursor_ranks", 2}};
  EXPECT_EQ(complaint_about(document), "");
  document.erase("precursor");
  EXPECT_NE(complaint_about(document).find("/execution/precursor_ranks: 2; has no effect"),
            std::string::npos);
}

json for_slurm(const json& slurm) {
  json document = elastic_campaign();
  document["execution"] = {{"launcher", "slurm"}, {"slurm", slurm}};
  return document;
}

TEST(Spec, ReadsWhatAJobAsksOfSlurm) {
  const SlurmOptions plain = spec_of(for_slurm(json::object())).execution.slurm;
  EXPECT_EQ(plain.start_with, "mpirun");
  EXPECT_EQ(plain.signal_seconds, 120);
  EXPECT_TRUE(plain.account.empty() && plain.partition.empty() && plain.options.empty());
  EXPECT_FALSE(plain.time_limit_minutes || plain.nodes);
  json without = for_slurm(json::object());
  without["execution"].erase("slurm");
  EXPECT_EQ(spec_of(without).execution.slurm.signal_seconds, 120) << "defaults, also without the member";
  const SlurmOptions full = spec_of(for_slurm({{"account", "flow"},
                                               {"partition", "a,b"},
                                               {"time_limit_minutes", 60},
                                               {"nodes", 2},
                                               {"start_with", "srun"},
                                               {"start_options", {"--mpi=pmix"}},
                                               {"options", {"--exclusive", "--mem-per-cpu=2G"}}}))
                                .execution.slurm;
  EXPECT_EQ(full.account, "flow");
  EXPECT_EQ(full.partition, "a,b");
  EXPECT_EQ(full.time_limit_minutes, 60);
  EXPECT_EQ(full.nodes, 2);
  EXPECT_EQ(full.start_options, std::vector<std::string>{"--mpi=pmix"});
  EXPECT_EQ(full.options, (std::vector<std::string>{"--exclusive", "--mem-per-cpu=2G"}));
}

TEST(Spec, RefusesWhatSlurmShallNotBeAsked) {
  const auto complaint = [](const json& slurm) { return complaint_about(for_slurm(slurm)); };
  EXPECT_EQ(complaint(json::object()), "");
  for (const char* option : {"--job-name=x", "--output=x", "--time=5", "--part=x", "--requeue", "-p main",
                             "mem=5", "--mem=5\nx", "--wrap=true", ""})
    EXPECT_NE(complaint({{"options", {option}}}).find("/execution/slurm/options/0"), std::string::npos)
        << option;
  EXPECT_NE(complaint({{"account", "a b"}}).find("/execution/slurm/account"), std::string::npos);
  EXPECT_NE(complaint({{"acount", "a"}}).find("did you mean \"account\"?"), std::string::npos);
  EXPECT_NE(
      complaint({{"time_limit_minutes", 2}, {"signal_seconds", 120}}).find("/execution/slurm/signal_seconds"),
      std::string::npos);
  EXPECT_NE(complaint({{"nodes", 2}, {"cases_per_job", 4}}).find("share one node"), std::string::npos);
  EXPECT_EQ(complaint({{"nodes", 1}, {"cases_per_job", 4}}), "");
  EXPECT_NE(complaint({{"nodes", 4294967297}}).find("/execution/slurm/nodes"), std::string::npos);
}

TEST(Spec, WhatIsForSlurmHasNoEffectElsewhere) {
  json document = for_slurm({{"account", "flow"}});
  document["execution"].erase("launcher");
  EXPECT_NE(complaint_about(document).find("/execution/slurm: an object; has no effect"), std::string::npos)
      << complaint_about(document);
  json limited = for_slurm({{"time_limit_minutes", 10}});
  limited["execution"]["walltime_seconds"] = 600;
  EXPECT_NE(complaint_about(limited).find("/execution/walltime_seconds: 600"), std::string::npos);
}

TEST(Spec, WhereACaseRunsIsNoPartOfItsIdentity) {
  const Campaign here = tests::campaign_of(elastic_campaign());
  const Campaign there = tests::campaign_of(for_slurm({{"account", "flow"}}));
  ASSERT_EQ(here.cases.size(), there.cases.size());
  for (std::size_t i = 0; i < here.cases.size(); ++i)
    EXPECT_EQ(here.cases[i].definition.id, there.cases[i].definition.id);
}

/// The campaign's schema must know every parameter of a case that a person sets.
TEST(Spec, SchemaCoversTheCase) {
  const json& physics = *case_schema().part(json::json_pointer("/physics"));
  for (const auto& [group, node] : physics.at("properties").items()) {
    const json::json_pointer here("/physics/" + group);
    ASSERT_NE(campaign_schema().part(here), nullptr) << group;
    if (!node.contains("properties") || group == "initial") continue;
    for (const auto& [key, child] : node.at("properties").items()) {
      const json* ours = campaign_schema().part(here / key);
      ASSERT_NE(ours, nullptr) << group << "/" << key;
      if (key == "dt_plus") {  // a campaign has a default of its own
        for (const char* bound : {"type", "unit", "minimum", "maximum"})
          EXPECT_EQ(ours->at(bound), child.at(bound)) << bound;
        continue;
      }
      EXPECT_EQ(*ours, child) << group << "/" << key;
    }
  }
  for (const auto& [key, child] : case_schema().part(json::json_pointer("/run"))->at("properties").items()) {
    if (key == "initial_checkpoint") continue;  // the manager's own
    for (const char* place : {"/run/", "/precursor/run/"}) {
      const json* ours = campaign_schema().part(json::json_pointer(place + key));
      ASSERT_NE(ours, nullptr) << place << key;
      EXPECT_EQ(*ours, child) << place << key;
    }
  }
}

TEST(Spec, DamagedTextGivesOneMessage) {
  const std::string text = elastic_campaign().dump();
  std::mt19937 random(7);
  for (int i = 0; i < 2000; ++i) {
    std::string damaged = text;
    for (unsigned edits = 1 + random() % 4; edits > 0; --edits) {
      const std::size_t at = random() % damaged.size(), from = random() % text.size();
      if (random() % 2 == 0)
        damaged.replace(at, random() % 4, text.substr(from, random() % 12));
      else
        damaged[at] = static_cast<char>(random() % 256);
      if (damaged.empty()) damaged = "x";
    }
    try {
      EXPECT_FALSE(parse_campaign(damaged).cases.empty());
    } catch (const BadInput& error) {
      EXPECT_FALSE(error.mistakes.empty());
    }
  }
}

/// Editors complete and check a file that names its schema.
TEST(Spec, MayNameItsSchema) {
  nlohmann::json document = elastic_campaign();
  document["$schema"] = "/usr/local/share/softwall/campaign.schema.json";
  EXPECT_EQ(complaint_about(document), "");
  document["$schema"] = 7;
  EXPECT_NE(complaint_about(document).find("/$schema: 7; must be"), std::string::npos)
      << complaint_about(document);
}

}  // namespace
}  // namespace softwall::campaign
