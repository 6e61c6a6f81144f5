#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "campaign/store/sqlite.hpp"

/// The format of the store and its versions. A change of schemas/results.sql that touches existing stores
/// raises kSchemaVersion and adds schemas/migrations/from_<old>.sql with its entry in migrations(), for the
/// tables; the views are rebuilt from schemas/results.sql by every migration.
namespace softwall::campaign {

inline constexpr std::int32_t kApplicationId = 0x73667477;  ///< "sftw", in the header of the file
inline constexpr int kSchemaVersion = 5;                    ///< user_version, in the header of the file

/// The SQL that turns a store of one format into the next.
struct Migration {
  int from;
  std::string_view sql;
};
[[nodiscard]] std::span<const Migration> migrations();

/// Schema, its documentation, application_id and user_version, all in one transaction.
void create_schema(Connection& connection);

/// The format of an open store. Throws SqliteError when the file is a database of another kind, or of a
/// format newer than `known`; says both numbers then.
[[nodiscard]] int schema_version(Connection& connection, int known = kSchemaVersion);

/// Whether a store was refused because a newer softwall made it.
[[nodiscard]] bool is_of_newer_format(const SqliteError& error);

/// Takes the store step by step to format `target` in one transaction: after a crash it is the old or the
/// new. Does nothing when it is there already. Throws SqliteError when a step is missing or fails.
void migrate(Connection& connection, std::span<const Migration> steps, int target);

}  // namespace softwall::campaign
